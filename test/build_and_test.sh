#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds everything and runs all tests: first those of the library with another
# compiler, with assertions and without TBB, then all as a user would, and the manual.
# Arguments are passed to cmake.
set -eu
cd "$(dirname "$0")/.."
sh cmake/install_packages.sh g++ clang make cmake binutils libcgal-dev libcgal-demo libeigen3-dev libtbb-dev \
  libboost-test-dev libboost-program-options-dev liblzf-dev nlohmann-json3-dev python3 pkgconf \
  pybind11-dev python3-dev python3-numpy python3-pytest python3-distributed parallel
# shellcheck disable=SC2046 # not in Debian 12, see test/laz.sh
sh cmake/install_packages.sh $(apt-cache search --names-only '^liblaszip-dev$' | cut -d' ' -f1)

cmake --preset debug-clang-no-tbb -D POINT_SET_FLOW_BUILD_EXAMPLES=OFF "$@"
cmake --build build/debug-clang-no-tbb --parallel 2 --target core_tests_in_short
ctest --test-dir build/debug-clang-no-tbb --output-on-failure --parallel 2 --label-regex in_short

# The Python of the packages above, whatever other one comes first in the path
cmake --preset release -D POINT_SET_FLOW_BUILD_TESTS=ON -D POINT_SET_FLOW_BUILD_BENCHMARKS=ON \
  -D POINT_SET_FLOW_BUILD_PYTHON=ON -D Python_EXECUTABLE=/usr/bin/python3 "$@"
cmake --build build/release --parallel 2
ctest --test-dir build/release --output-on-failure --parallel 2

sh doc/build_manual.sh
