#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Draws meshes that `benchmark_pipelines --output meshes` wrote: raw, jet and ours side by side.
#   draw.sh meshes picture.png
# Needs f3d, xvfb, xauth, imagemagick and fonts-dejavu-core.
set -eu
meshes=$1
picture=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

draw() { # scan, then where the camera is and what it looks at
  for method in raw jet ours; do
    cp "$meshes/$1, advancing front, $method.off" "$work/mesh.off" # f3d takes no comma in a name
    xvfb-run -a f3d "$work/mesh.off" --output "$work/$1-$method.png" --resolution 420,300 \
      --bg-color 1,1,1 --color 0.75,0.72,0.66 --camera-position="$2" --camera-focal-point="$3" \
      --camera-view-up=0,"$4" --camera-view-angle=30
    set -- "$@" -label "$1, $method" "$work/$1-$method.png"
  done
  shift 4
  montage -font DejaVu-Sans -pointsize 15 "$@" -tile 3x1 -geometry +3+3 "$work/row$row.png"
  row=$((row + 1))
}
row=0
draw fandisk 1.35,1.3,1.75 0,0,0 1,0
draw building -0.8,1.6,1.3 0,0.2,0 0,1
convert "$work"/row*.png -append -colors 128 "$picture"
