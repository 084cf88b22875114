// SPDX-License-Identifier: GPL-3.0-or-later
// What the points can be colored by. Lengths are in thousandths of the radius of the data.

const blue_to_red = ["#103e9c", "#3b7dd8", "#a3cdf0", "#f7f5ef", "#f5b99a", "#d94f3d", "#8e0f2a"];
const dark_to_bright = ["#1c2358", "#2c4f8c", "#23808f", "#3fae7e", "#a5d351", "#fdeb4a"];
const gray_to_orange = ["#d9d9d4", "#e6c99a", "#ee9f4b", "#dd5f2a", "#a51d3a", "#5a0f4b"];

/// The modes for the data: name, what the color bar says, range of values, and colors
function color_modes({ clouds, noise, radius }) {
  const modes = [{ name: "shaded", title: "plain", help: "Lit from the upper left. Each point is a disc in the plane of its neighbors: what glitters is rough." }];
  const smoothed = clouds.filter(cloud => cloud.name !== "none" && cloud.name !== "truth");
  const typical = name => Math.max(...(smoothed.length ? smoothed : clouds).map(
    cloud => quantile(cloud.values[name], .98)));
  if (noise !== null) {
    const range = noise > 0 ? 2 * noise : 1e-3;
    modes.push({
      name: "error", title: "error", colors: blue_to_red, low: -range, high: range, factor: 1000,
      scale: "Signed distance to the true surface",
      help: `thousandths of the radius, which is ${short(radius)} in the unit of the data. ` +
        "Blue: inside, red: outside.",
    });
  }
  modes.push({
    name: "curvature", title: "curvature", colors: dark_to_bright, low: 0,
    high: typical("curvature") || 1e-6, factor: 1, scale: "Surface variation",
    help: "the part of the variance of 19 nearest points that is across their plane: " +
      "0 where it is flat and free of noise, at most 1/3.",
  });
  modes.push({
    name: "feature", title: "feature strength", colors: gray_to_orange, low: 0, high: 1, factor: 1,
    scale: "Feature strength", help: "what the flow takes for a feature: 0 where it is flat, 1/2 at a crease of 60 degrees.",
  });
  return modes;
}

const short = number => String(+number.toPrecision(3));

const rgb = color => [1, 3, 5].map(i => parseInt(color.slice(i, i + 2), 16));

/// 256 colors as bytes
function color_table(colors) {
  const table = new Uint8Array(4 * 256), stops = colors.map(rgb);
  for (let i = 0; i < 256; ++i) {
    const at = i / 255 * (stops.length - 1), k = Math.min(Math.floor(at), stops.length - 2);
    for (let c = 0; c < 3; ++c)
      table[4 * i + c] = Math.round(stops[k][c] + (at - k) * (stops[k + 1][c] - stops[k][c]));
    table[4 * i + 3] = 255;
  }
  return table;
}
