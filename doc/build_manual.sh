#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs missing packages and builds the manual, build/manual/html/index.html. Any warning is an error.
# Only Debian packages are loaded from the network.
set -eu
cd "$(dirname "$0")/.."
sh cmake/install_packages.sh make cmake doxygen texlive-binaries libjs-mathjax
cmake -S doc -B build/manual
cmake --build build/manual --target doc
