#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the program with LASzip, and runs the tests of LAS and LAZ: laz.sh [WORK_DIR]. Where the
# distribution has no LASzip, as Debian 12, that of Debian 13 is unpacked below WORK_DIR, not installed.
set -eu
cd "$(dirname "$0")/.."
work=${1:-build/laz}
mkdir -p "$work"
work=$(cd "$work" && pwd)
sh cmake/install_packages.sh g++ make cmake libcgal-dev libcgal-demo libeigen3-dev libtbb-dev libboost-test-dev \
  libboost-program-options-dev nlohmann-json3-dev python3
found=$(apt-cache search --names-only '^liblaszip-dev$' | cut -d' ' -f1)
# shellcheck disable=SC2086
sh cmake/install_packages.sh $found

[ -n "$found" ] || sh test/unpack_packages.sh "$work" trixie liblaszip-dev liblaszip8
cmake -S . -B "$work/build" -D CMAKE_BUILD_TYPE=Release -D CMAKE_PREFIX_PATH="$work/usr" -D POINT_SET_FLOW_BUILD_EXAMPLES=OFF \
  -D POINT_SET_FLOW_BUILD_PROGRAM=ON
cmake --build "$work/build" --parallel 2 --target balanced-flow-smooth convert_las
ctest --test-dir "$work/build" --output-on-failure -R 'balanced_flow_smooth_la[sz]'
