#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing and makes the manual, build/manual/doc/html/index.html. Any warning is an
# error. Nothing is loaded from a network but Debian packages.
set -eu
cd "$(dirname "$0")/.."
sh cmake/install_packages.sh g++ make cmake libcgal-dev libeigen3-dev doxygen texlive-binaries libjs-mathjax
cmake -B build/manual -D BALANCED_FLOW_BUILD_DOCS=ON -D BALANCED_FLOW_BUILD_TESTS=OFF -D BALANCED_FLOW_BUILD_EXAMPLES=OFF
cmake --build build/manual --target doc
