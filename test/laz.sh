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

if [ -z "$found" ] && [ ! -e "$work/usr/include/laszip/laszip_api.h" ]; then
  mirror=$(apt-cache policy libcgal-dev | awk '$2 ~ /^https?:/ { print $2; exit }')
  mkdir -p "$work/lists/partial" "$work/cache/archives/partial"
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror trixie main" > "$work/sources.list"
  (
    cd "$work"
    set -- -o "Dir::Etc::sourcelist=$PWD/sources.list" -o Dir::Etc::sourceparts=- -o "Dir::State::lists=$PWD/lists" \
      -o "Dir::Cache=$PWD/cache" -o APT::Sandbox::User=root
    apt-get "$@" -qq update
    apt-get "$@" -qq download liblaszip-dev liblaszip8
    for package in liblaszip*.deb; do dpkg -x "$package" .; done
    rm -r liblaszip*.deb lists cache
  )
fi
cmake -S . -B "$work/build" -D CMAKE_BUILD_TYPE=Release -D CMAKE_PREFIX_PATH="$work/usr" -D POINT_SET_FLOW_BUILD_EXAMPLES=OFF \
  -D POINT_SET_FLOW_BUILD_PROGRAM=ON
cmake --build "$work/build" --parallel 2 --target balanced-flow-smooth convert_las
ctest --test-dir "$work/build" --output-on-failure -R 'balanced_flow_smooth_la[sz]'
