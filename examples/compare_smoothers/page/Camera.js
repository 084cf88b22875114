// SPDX-License-Identifier: GPL-3.0-or-later

/// An orthographic camera that turns about the middle of the data, for all panels.
class Camera {
  /// \param positions of the noisy points: x, y and z in turn
  constructor(positions, is_scan) {
    const axis = k => positions.filter((_, i) => i % 3 === k);
    const low = [], high = [];
    for (let k = 0; k < 3; ++k) { // a few outliers must not make the rest small
      low.push(quantile(axis(k), .002));
      high.push(quantile(axis(k), .998));
    }
    const sizes = low.map((x, k) => high[k] - x);
    this.middle = low.map((x, k) => (x + high[k]) / 2);
    this.radius = Math.hypot(...sizes) / 2 || 1;
    // nearly all scans have z upwards, nearly all models y
    const z_is_up = this.z_is_up = is_scan || sizes[2] < .5 * Math.min(sizes[0], sizes[1]);
    const upright = z_is_up ? axis_turn(0, -Math.PI / 2) : [1, 0, 0, 0];
    const broadside = 1.4 * sizes[0] < sizes[z_is_up ? 1 : 2] ? Math.PI / 2 : 0;
    this.home = product(product(axis_turn(0, .4), axis_turn(1, broadside - .6)), upright);
    this.center = this.middle;
    this.rotation = this.home;
    this.is_home = true; // nobody has moved it
    const seen = [[], []];
    for (let i = 0; i < positions.length; i += 3)
      this.seen(positions.slice(i, i + 3)).slice(0, 2).forEach((x, k) => seen[k].push(x));
    this.extents = seen.map(xs => [quantile(xs, .002), quantile(xs, .998)]);
  }

  /// To where it was first, in panels of a size in pixels: what fits in
  reset(width, height) {
    const [right, up] = this.extents;
    this.is_home = true;
    this.rotation = this.home;
    this.center = this.middle;
    this.pan = [right, up].map(([low, high]) => -(low + high) / 2); // in radii, to the right and up
    const pixels = Math.min(width / (right[1] - right[0]), height / (up[1] - up[0]));
    this.zoom = Math.min(4, .86 * pixels / this.pixels_per_radius(width, height));
  }

  /// Where a point is from the middle of the data: to the right, up, and to the viewer, in radii
  seen(point) {
    const m = this.matrix(), d = point.map((x, k) => (x - this.center[k]) / this.radius);
    return [0, 1, 2].map(k => m[k] * d[0] + m[k + 3] * d[1] + m[k + 6] * d[2]);
  }

  /// Turns about the foremost point in the middle of the view, if it is a part that is seen.
  pivot_on(positions) {
    let best = null, best_depth = -Infinity;
    for (let i = 0; i < positions.length && this.zoom > 1.8; i += 3) {
      const point = positions.subarray(i, i + 3), [x, y, z] = this.seen(point);
      const off = this.zoom * Math.hypot(x + this.pan[0], y + this.pan[1]);
      if (off < .15 && z > best_depth)
        [best, best_depth] = [[...point], z];
    }
    if (best) {
      const [x, y] = this.seen(best);
      this.center = best;
      this.pan = [this.pan[0] + x, this.pan[1] + y];
    }
  }

  /// Turns by angles about the axes of the screen: to the right, down
  turn(right, down) {
    this.is_home = false;
    const turned = product(product(axis_turn(0, down), axis_turn(1, right)), this.rotation);
    const length = Math.hypot(...turned);
    this.rotation = turned.map(x => x / length);
  }

  look_along(axis) {
    this.is_home = false;
    const quarter = Math.PI / 2, z_is_up = this.z_is_up;
    this.rotation = {
      x: z_is_up ? product(axis_turn(0, -quarter), axis_turn(2, -quarter)) : axis_turn(1, -quarter),
      y: axis_turn(0, z_is_up ? -quarter : quarter),
      z: [1, 0, 0, 0],
    }[axis];
  }

  move(right, up) {
    this.is_home = false;
    this.pan = [this.pan[0] + right, this.pan[1] + up];
  }

  /// Zooms around a point of the view, in radii at zoom 1 from the middle of a panel
  zoom_by(factor, right = 0, up = 0) {
    this.is_home = false;
    const zoom = Math.min(100, Math.max(.2, this.zoom * factor)), shift = 1 / zoom - 1 / this.zoom;
    this.pan = [this.pan[0] + shift * right, this.pan[1] + shift * up];
    this.zoom = zoom;
  }

  /// Columns of the rotation
  matrix() {
    const [w, x, y, z] = this.rotation;
    return [
      1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y),
      2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x),
      2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)];
  }

  /// Pixels of a panel for the unit of the data
  pixels_per_unit(width, height) {
    return this.zoom * this.pixels_per_radius(width, height) / this.radius;
  }
  pixels_per_radius(width, height) {
    return .52 * Math.min(width, height);
  }
}

/// The quaternion of a turn about an axis, 0 to 2
function axis_turn(axis, angle) {
  const turn = [Math.cos(angle / 2), 0, 0, 0];
  turn[axis + 1] = Math.sin(angle / 2);
  return turn;
}

/// The quaternion of two turns, the second one first
function product([a, b, c, d], [w, x, y, z]) {
  return [
    a * w - b * x - c * y - d * z, a * x + b * w + c * z - d * y,
    a * y - b * z + c * w + d * x, a * z + b * y - c * x + d * w];
}
