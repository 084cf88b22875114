#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds, smooths a laser scan of CGAL's sample data and makes a picture
# of the surface reconstructed from it before and after. Everything is left in build/scan.
set -eu
cd "$(dirname "$0")/.."
sh cmake/install_packages.sh g++ make cmake libcgal-dev libcgal-demo libeigen3-dev libtbb-dev \
  libboost-program-options-dev nlohmann-json3-dev f3d xvfb xauth libgl1-mesa-dri imagemagick fonts-dejavu-core

cmake --preset release -D POINT_SET_FLOW_BUILD_TESTS=OFF
cmake --build build/release --parallel 2 --target balanced-flow-smooth reconstruction_example

mkdir -p build/scan
scan=build/release/libcgal-demo/data/points_3/building.ply
programs=build/release/examples
echo "== smoothing $scan"
$programs/balanced_flow_smooth/balanced-flow-smooth "$scan" build/scan/smoothed.ply

$programs/reconstruction_example "$scan" build/scan/before.off --raw
$programs/reconstruction_example "$scan" build/scan/after.off
for which in before after; do
  xvfb-run -a f3d build/scan/$which.off --output build/scan/$which.png --resolution 1000,700 \
    --camera-view-angle 12 --up +Z --color 0.75,0.72,0.66
done
montage -font DejaVu-Sans -pointsize 28 -label 'raw scan' build/scan/before.png -label 'smoothed' build/scan/after.png \
  -tile 2x1 -geometry +4+4 build/scan/before_after.png
echo "== the smoothed points: build/scan/smoothed.ply"
echo "== the picture:         build/scan/before_after.png"
