#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds, repeats the paper's experiments and leaves the pictures in doc/fig and the
# tables in doc/paper.md. With names (fig2 ... fig9) only those experiments are run again.
set -eu
cd "$(dirname "$0")/../.."
sh cmake/install_packages.sh g++ make cmake libcgal-dev libcgal-demo libeigen3-dev libtbb-dev \
  libboost-program-options-dev python3-vtk9 gnuplot-nox pngquant xvfb xauth libgl1-mesa-dri fonts-dejavu-core

cmake --preset release -D POINT_SET_FLOW_BUILD_BENCHMARKS=ON
cmake --build build/release --parallel 2 --target paper_experiments

data=build/paper
mkdir -p $data doc/fig
if [ $# = 0 ]; then
  build/release/test/paper/paper_experiments --output $data
else
  build/release/test/paper/paper_experiments --output $data --figures "$@"
fi
# Debian's python3, which its VTK belongs to
xvfb-run -a /usr/bin/python3 test/paper/render.py $data $data
gnuplot -e "data='$data'; pictures='$data'" test/paper/plots.gnuplot
for picture in "$data"/*.png; do # small files: 256 colors
  pngquant --force --skip-if-larger --output "doc/fig/$(basename "$picture")" 256 "$picture"
done
/usr/bin/python3 test/paper/insert_tables.py $data doc/paper.md
echo "== the pictures: doc/fig; the tables: doc/paper.md"
