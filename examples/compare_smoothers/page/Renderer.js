// SPDX-License-Identifier: GPL-3.0-or-later

/// Each point is a small disc in its plane, an octagon, lit on both sides.
const vertex_shader = `#version 300 es
precision highp float;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float value;
uniform mat3 rotation;
uniform vec3 center;
uniform vec2 pan, clip_per_unit; // in the unit of the data
uniform float depth_per_unit, radius, unit_of_pixel;
uniform vec2 range;
uniform bool colored;
uniform sampler2D colors;
out vec3 color;

void main() {
  vec3 n = normalize(rotation * normal);
  n = n.z < 0. ? -n : n; // sides are not known
  float angle = radians(45.) * float(gl_VertexID);
  vec3 u = normalize(abs(n.x) < .8 ? cross(n, vec3(1., 0., 0.)) : cross(n, vec3(0., 1., 0.)));
  vec3 disc = radius * (cos(angle) * u + sin(angle) * cross(n, u));
  vec3 p = rotation * (position - center) + disc;
  p.xy += pan + .6 * unit_of_pixel * vec2(cos(angle), sin(angle)); // never thinner than a pixel
  gl_Position = vec4(p.xy * clip_per_unit, -p.z * depth_per_unit, 1.);

  vec3 light = normalize(vec3(-.55, .62, .56)), fill = normalize(vec3(.8, .1, .6));
  float diffuse = max(dot(n, light), 0.);
  float shine = pow(max(dot(n, normalize(light + vec3(0., 0., 1.))), 0.), 40.);
  float t = (value - range.x) / (range.y - range.x);
  vec3 base = colored ? texture(colors, vec2((clamp(t, 0., 1.) * 255. + .5) / 256., .5)).rgb
                      : vec3(.95, .89, .79);
  float lit = diffuse + .3 * max(dot(n, fill), 0.);
  lit = colored ? .68 + .34 * lit : .12 + .84 * lit;
  color = base * lit + (colored ? .05 : .12) * shine;
}`;

const fragment_shader = `#version 300 es
precision mediump float;
in vec3 color;
out vec4 fragment;
void main() { fragment = vec4(color, 1.); }`;

class Renderer {
  /// Throws an error with the reason if the browser can not draw.
  constructor(canvas, clouds) {
    const gl = canvas.getContext("webgl2", { antialias: true, alpha: true });
    if (!gl)
      throw new Error("This browser does not offer WebGL 2");
    this.canvas = canvas;
    this.gl = gl;
    this.program = gl.createProgram();
    for (const [type, text] of [[gl.VERTEX_SHADER, vertex_shader], [gl.FRAGMENT_SHADER, fragment_shader]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(this.program, shader);
    }
    gl.linkProgram(this.program);
    if (!gl.getProgramParameter(this.program, gl.LINK_STATUS))
      throw new Error("The shaders do not work here: " + gl.getProgramInfoLog(this.program));
    gl.useProgram(this.program);
    this.buffers = new Map(clouds.map(cloud => [cloud, this.make_buffers(cloud)]));
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.SCISSOR_TEST);
  }

  make_buffers(cloud) {
    const gl = this.gl, buffers = {};
    for (const [name, numbers] of Object.entries(
      { positions: cloud.positions, normals: cloud.normals, ...cloud.values })) {
      buffers[name] = gl.createBuffer();
      gl.bindBuffer(gl.ARRAY_BUFFER, buffers[name]);
      gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.STATIC_DRAW);
    }
    return buffers;
  }

  uniform(kind, name, ...values) {
    this.gl["uniform" + kind](this.gl.getUniformLocation(this.program, name), ...values);
  }

  /// An attribute of which each point has one
  attribute(location, buffer, size) {
    const gl = this.gl;
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(location, size, gl.FLOAT, false, 0, 0);
    gl.vertexAttribDivisor(location, 1);
  }

  /// \param panels pairs of a cloud and where it is drawn: left, top, width and height in pixels of the page
  /// \param radius of the discs
  draw(panels, camera, mode, contrast, radius) {
    const gl = this.gl, ratio = Math.min(2, window.devicePixelRatio || 1);
    const width = Math.round(this.canvas.clientWidth * ratio);
    const height = Math.round(this.canvas.clientHeight * ratio);
    if (this.canvas.width !== width || this.canvas.height !== height)
      Object.assign(this.canvas, { width, height });
    gl.scissor(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);

    this.uniform("Matrix3fv", "rotation", false, camera.matrix());
    this.uniform("3fv", "center", camera.center);
    this.uniform("2fv", "pan", camera.pan.map(x => x * camera.radius));
    this.uniform("1f", "depth_per_unit", .2 / camera.radius); // room for what lies far off
    this.uniform("1f", "radius", radius);
    this.uniform("1i", "colored", mode.colors ? 1 : 0);
    if (mode.colors) {
      this.uniform("2f", "range", mode.low / contrast, mode.high / contrast);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, 256, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE,
        color_table(mode.colors));
    }
    for (const { cloud, box } of panels) {
      const [left, top, w, h] = box.map(x => Math.round(x * ratio));
      gl.viewport(left, height - top - h, w, h);
      gl.scissor(left, height - top - h, w, h);
      const pixels = camera.pixels_per_unit(w, h);
      this.uniform("2f", "clip_per_unit", 2 * pixels / w, 2 * pixels / h);
      this.uniform("1f", "unit_of_pixel", 1 / pixels);
      const buffers = this.buffers.get(cloud);
      this.attribute(0, buffers.positions, 3);
      this.attribute(1, buffers.normals, 3);
      if (buffers[mode.name])
        this.attribute(2, buffers[mode.name], 1);
      else
        gl.disableVertexAttribArray(2);
      gl.drawArraysInstanced(gl.TRIANGLE_FAN, 0, 8, cloud.drawn);
    }
  }

  /// How many pixels of a place are drawn, of 64 x 64. Only right after drawing.
  drawn_pixels([left, top, width, height]) {
    const copy = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
    const ratio = this.canvas.width / this.canvas.clientWidth;
    copy.canvas.width = copy.canvas.height = 64;
    copy.drawImage(this.canvas, left * ratio, top * ratio, width * ratio, height * ratio, 0, 0, 64, 64);
    return copy.getImageData(0, 0, 64, 64).data.filter((byte, i) => i % 4 === 3 && byte > 0).length;
  }
}
