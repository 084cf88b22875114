// SPDX-License-Identifier: GPL-3.0-or-later
#include "run.h"

#include "Block_result.h"
#include "Interrupt.h"
#include "smooth_one.h"

#include <signal.h>
#include <sys/mman.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace balanced_flow_blocks {

namespace {

/// Memory that processes share
struct Shared {
  std::atomic<std::size_t> next{0}; // the block that nobody has taken yet

  static Shared* make()
  {
    void* const memory =
        ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED)
      throw std::bad_alloc();
    return new (memory) Shared;
  }
};

/// What a process does until no block is left.
/// \return its exit status
int work(const Manifest& manifest, Shared& shared)
{
  const Progress progress([](double) { return balanced_flow_smooth::interrupt == 0; });
  try {
    for (std::size_t block; (block = shared.next++) < manifest.blocks.size();)
      smooth_one(manifest, block, progress);
    return 0;
  }
  catch (const Interrupted&) {
    return 0; // the parent knows
  }
  catch (const std::exception& e) {
    std::cerr << e.what() << std::endl;
    return 2;
  }
}

/// Stops this process when its parent ends, even if that is killed.
void stop_with([[maybe_unused]] pid_t parent)
{
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) // before that call
    ::_exit(2);
#endif
}

/// The processes; those that run at the end are told to stop.
class Workers {
  std::vector<pid_t> m_running;

public:
  void start(const Manifest& manifest, Shared& shared)
  {
    std::cerr.flush();
    const pid_t parent = ::getpid(), process = ::fork();
    if (process < 0)
      throw std::runtime_error("no process can be started");
    if (process == 0) {
      stop_with(parent);
      ::_exit(work(manifest, shared));
    }
    m_running.push_back(process);
  }

  bool is_any_running() const { return !m_running.empty(); }

  /// Takes those from the list that have ended.
  void look(int options)
  {
    std::vector<pid_t> still;
    for (const pid_t process : m_running) {
      const pid_t ended = ::waitpid(process, nullptr, options);
      if (ended == 0 || (ended < 0 && errno == EINTR))
        still.push_back(process);
    }
    m_running.swap(still);
  }

  ~Workers()
  {
    for (const pid_t process : m_running)
      ::kill(process, SIGTERM);
    while (is_any_running())
      look(0);
  }
};

} // namespace

std::size_t number_of_results(const Manifest& manifest)
{
  std::size_t count = 0;
  for (std::size_t block = 0; block < manifest.blocks.size(); ++block)
    count += Block_result::exists(manifest, block) ? 1 : 0;
  return count;
}

void smooth_all(const Manifest& manifest, unsigned int jobs, const Progress& progress)
{
  const std::size_t count = manifest.blocks.size();
  if (jobs <= 1) {
    for (std::size_t block = 0; block < count; ++block)
      smooth_one(manifest, block,
                 progress.part(double(block) / double(count), double(block + 1) / double(count)));
    return;
  }
  Shared& shared = *Shared::make();
  Workers workers;
  for (unsigned int job = 0; job < jobs; ++job)
    workers.start(manifest, shared);
  while (workers.is_any_running()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    workers.look(WNOHANG);
    progress(double((std::min)(shared.next.load(), count)) / double(count));
  }
  if (number_of_results(manifest) != count)
    throw std::runtime_error(
        "not all blocks are smoothed: a process failed or was killed; the same command "
        "goes on with the others");
}

} // namespace balanced_flow_blocks
