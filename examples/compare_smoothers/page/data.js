// SPDX-License-Identifier: GPL-3.0-or-later
// What the program has written into the page.

/// The numbers behind 16 bits each: 0 stands for the least, 65535 for the largest
function unpacked({ low, high, data }) {
  const bytes = atob(data), numbers = new Float32Array(bytes.length / 2);
  const step = (high - low) / 65535;
  for (let i = 0; i < numbers.length; ++i)
    numbers[i] = low + step * (bytes.charCodeAt(2 * i) | (bytes.charCodeAt(2 * i + 1) << 8));
  return numbers;
}

/// A cloud with arrays that the renderer draws
function read_cloud(packed) {
  const cloud = {
    name: packed.name, title: packed.title, shown: packed.shown,
    points: packed.points, drawn: packed.drawn, spacing: packed.spacing, values: {},
  };
  const columns = ["x", "y", "z", "normal_x", "normal_y"].map(name => unpacked(packed[name]));
  const [x, y, z, nx, ny] = columns;
  if (columns.some(column => column.length !== cloud.drawn))
    throw new Error(`the points of "${cloud.title}" are not complete`);
  cloud.positions = new Float32Array(3 * cloud.drawn);
  cloud.normals = new Float32Array(3 * cloud.drawn);
  for (let i = 0; i < cloud.drawn; ++i) {
    cloud.positions.set([x[i], y[i], z[i]], 3 * i);
    cloud.normals.set([nx[i], ny[i], Math.sqrt(Math.max(0, 1 - nx[i] ** 2 - ny[i] ** 2))], 3 * i);
  }
  for (const name of ["error", "curvature", "feature"])
    if (packed[name])
      cloud.values[name] = unpacked(packed[name]);
  return cloud;
}

function read_data() {
  const data = JSON.parse(document.getElementById("data").textContent);
  return {
    input: data.input, radius: data.radius, noise: data.noise === undefined ? null : data.noise,
    clouds: data.clouds.map(read_cloud), columns: data.table[0], rows: data.table.slice(1),
  };
}

/// The value that a share of the numbers does not exceed
function quantile(numbers, share) {
  const sorted = Float32Array.from(numbers).sort();
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
}
