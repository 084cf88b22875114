#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the Debian packages from a clean copy of this tree, in build/debian, lets lintian judge them,
# and uses them, unpacked into a folder. The core tests are run, too, with DEB_BUILD_OPTIONS= in front.
set -eu
cd "$(dirname "$0")/../.."
sh cmake/install_packages.sh build-essential debhelper fakeroot lintian cmake pkgconf libcgal-dev libeigen3-dev \
  libtbb-dev libboost-dev libboost-program-options-dev libboost-test-dev liblzf-dev nlohmann-json3-dev \
  dh-python pybind11-dev python3-dev python3-numpy python3-pytest

version=$(sed -n 's/^project(PointSetFlow VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
rm -rf build/debian
mkdir -p "build/debian/point-set-flow-$version"
# What git knows, as it is now; all there is where this is not a clone but an unpacked archive
files=$(git ls-files 2>/dev/null || true)
[ -n "$files" ] || files="include test examples doc cmake CMakeLists.txt LICENSE README.md"
# shellcheck disable=SC2086
tar -cf - $files | tar -xf - -C "build/debian/point-set-flow-$version"

cd build/debian
tar -czf "point-set-flow_$version.orig.tar.gz" "point-set-flow-$version"
cd "point-set-flow-$version"
cp -R cmake/packaging/debian debian
DEB_BUILD_OPTIONS=${DEB_BUILD_OPTIONS-nocheck} dpkg-buildpackage -us -uc
cd ..
lintian --info --fail-on error,warning ./*.changes

# As a user who installs them: their dependencies can be had, and a project builds with them
apt-get install --simulate ./*.deb >/dev/null
for package in ./*.deb; do
  dpkg -x "$package" root
done
cd "point-set-flow-$version"
AUTOPKGTEST_TMP=$PWD/../test sh debian/tests/consumer "$PWD/../root"
sh debian/tests/python "$PWD/../root"
cd ..
ls -l ./*.deb
