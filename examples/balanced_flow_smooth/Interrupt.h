// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_INTERRUPT_H
#define BALANCED_FLOW_SMOOTH_INTERRUPT_H

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <initializer_list>

namespace balanced_flow_smooth {

/// What Ctrl-C (SIGINT) and SIGTERM ask for: the number of the signal, or 0
inline std::atomic<int> interrupt(0);

/// Whether nothing has to be put away, so that the program can end in the middle of what it does
inline std::atomic<bool> may_end_at_once(false);

extern "C" inline void on_interrupt(int signal)
{
  if (may_end_at_once) {
    const char message[] = "\ninterrupted, nothing written\n";
    [[maybe_unused]] const auto ignored = ::write(STDERR_FILENO, message, sizeof message - 1);
    ::_exit(128 + signal);
  }
  interrupt = signal;
  std::signal(signal, SIG_DFL); // the second one ends the program, whatever it does
}

/// Bytes of a file that is mapped are gone: another program has shortened it, or the disk fails.
extern "C" inline void on_lost_bytes(int)
{
  const char message[] = "a file was shortened by another program while it was read\n";
  [[maybe_unused]] const auto ignored = ::write(STDERR_FILENO, message, sizeof message - 1);
  ::_exit(2);
}

inline void listen_for_interrupts()
{
  std::signal(SIGBUS, on_lost_bytes);
  for (const int signal : {SIGINT, SIGTERM})
    if (std::signal(signal, on_interrupt) == SIG_IGN)
      std::signal(signal, SIG_IGN); // nohup, or a background job of a shell without job control
}

/// May end at once as long as this lives.
struct Nothing_at_stake {
  Nothing_at_stake() { may_end_at_once = true; }
  ~Nothing_at_stake() { may_end_at_once = false; }
};

} // namespace balanced_flow_smooth

#endif // BALANCED_FLOW_SMOOTH_INTERRUPT_H
