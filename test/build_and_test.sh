#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds everything and runs all tests: first as a user would, then the
# core tests once more with another compiler, with assertions and without TBB.
set -eu
cd "$(dirname "$0")/.."
sh cmake/install_packages.sh g++ clang make cmake binutils libcgal-dev libcgal-demo libeigen3-dev libtbb-dev \
  libboost-test-dev libboost-program-options-dev nlohmann-json3-dev python3

cmake --preset debug-clang-no-tbb -D BALANCED_FLOW_BUILD_EXAMPLES=OFF
cmake --build build/debug-clang-no-tbb --parallel 2 --target core_tests
ctest --test-dir build/debug-clang-no-tbb --output-on-failure -L core

cmake --preset release -D BALANCED_FLOW_BUILD_TESTS=ON -D BALANCED_FLOW_BUILD_BENCHMARKS=ON
cmake --build build/release --parallel 2
ctest --test-dir build/release --output-on-failure
