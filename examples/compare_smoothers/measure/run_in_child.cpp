// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_in_child.h"

#include <CGAL/Real_timer.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <vector>

#if defined(__unix__) || defined(__APPLE__)
#define POINT_SET_FLOW_HAS_FORK
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#endif
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace comparison {

namespace {

Run run_here(const std::function<Smoothed()>& smooth)
{
  CGAL::Real_timer timer;
  timer.start();
  Run run{smooth(), 0., std::numeric_limits<double>::quiet_NaN()};
  timer.stop();
  run.seconds = timer.time();
  return run;
}

#ifdef POINT_SET_FLOW_HAS_FORK

double peak_megabytes()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
  return double(usage.ru_maxrss) / (1024. * 1024.);
#else
  return double(usage.ru_maxrss) / 1024.;
#endif
}

template <typename T>
void write(std::FILE* pipe, const T* values, std::size_t n)
{
  if (n != 0 && std::fwrite(values, sizeof(T), n, pipe) != n)
    throw std::runtime_error("cannot write to a pipe");
}

template <typename T>
void read(std::FILE* pipe, T* values, std::size_t n)
{
  if (n != 0 && std::fread(values, sizeof(T), n, pipe) != n)
    throw std::runtime_error("the process ended early");
}

// Points and vectors travel as plain numbers
template <typename Item>
void write(std::FILE* pipe, const std::vector<Item>& items)
{
  const std::size_t n = items.size();
  write(pipe, &n, 1);
  for (const Item& item : items) {
    const double numbers[3] = {item.x(), item.y(), item.z()};
    write(pipe, numbers, 3);
  }
}

template <typename Item>
void read(std::FILE* pipe, std::vector<Item>& items)
{
  std::size_t n = 0;
  read(pipe, &n, 1);
  items.reserve(n);
  for (double numbers[3]; items.size() < n;) {
    read(pipe, numbers, 3);
    items.emplace_back(numbers[0], numbers[1], numbers[2]);
  }
}

#endif

} // namespace

#ifdef POINT_SET_FLOW_HAS_FORK

std::optional<Run> run_in_child(const std::function<Smoothed()>& smooth,
                                const std::function<void()>& prepare)
{
#ifdef __GLIBC__
  malloc_trim(0); // or the child would take memory that is ours already, and not counted
#endif
  int ends[2];
  if (pipe(ends) != 0)
    return std::nullopt;
  std::cout.flush();
  const pid_t pid = fork();
  if (pid < 0) {
    close(ends[0]), close(ends[1]);
    return std::nullopt;
  }
  if (pid == 0) {
    int status = EXIT_FAILURE;
    try {
      close(ends[0]);
      std::FILE* const out = fdopen(ends[1], "wb");
      prepare();
      const double before = peak_megabytes();
      const Run run = run_here(smooth);
      const double numbers[2] = {run.seconds, peak_megabytes() - before};
      write(out, numbers, 2);
      write(out, &run.smoothed.same_points, 1);
      write(out, run.smoothed.points);
      write(out, run.smoothed.normals);
      status = std::fclose(out) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
    }
    catch (const std::exception& error) {
      std::cerr << error.what() << std::endl;
    }
    _exit(status); // what is to be done at the end is the parent's
  }

  close(ends[1]);
  std::FILE* const in = fdopen(ends[0], "rb");
  std::optional<Run> run(std::in_place);
  try {
    double numbers[2];
    read(in, numbers, 2);
    run->seconds = numbers[0];
    run->megabytes = numbers[1];
    read(in, &run->smoothed.same_points, 1);
    read(in, run->smoothed.points);
    read(in, run->smoothed.normals);
  }
  catch (const std::exception&) {
    run.reset();
  }
  std::fclose(in);
  waitpid(pid, nullptr, 0);
  return run;
}

#else

std::optional<Run> run_in_child(const std::function<Smoothed()>& smooth,
                                const std::function<void()>& prepare)
{
  try {
    prepare();
    return run_here(smooth);
  }
  catch (const std::exception& error) {
    std::cerr << error.what() << std::endl;
    return std::nullopt;
  }
}

#endif

} // namespace comparison
