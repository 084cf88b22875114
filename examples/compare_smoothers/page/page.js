// SPDX-License-Identifier: GPL-3.0-or-later
// Panels, switches, and what keeps them together.

const by_id = id => document.getElementById(id);

class Page {
  constructor(data) {
    this.data = data;
    this.modes = color_modes(data);
    this.mode = this.modes[data.noise === null ? 0 : 1];
    this.stage = by_id("stage");
    this.camera = new Camera((data.clouds.find(cloud => cloud.name === "none") ||
      data.clouds[0]).positions, data.noise === null);
    this.make_panels();
    this.make_switches();
    this.read_address();
    this.renderer = new Renderer(this.stage.querySelector("canvas"), data.clouds);
    this.follow_user();
    this.arrange();
    this.draw();
  }

  // ---- what is on the page ----

  make_panels() {
    for (const cloud of this.data.clouds) {
      const rms = number_of(this.data, cloud.title, "rms");
      const roughness = number_of(this.data, cloud.title, "roughness");
      const caption = element("figcaption", "", { title: cloud.title });
      cloud.label = cloud.name === "none" ? "noisy" : cloud.title;
      caption.append(element("b", cloud.label));
      if (!isNaN(rms))
        caption.append(element("span", `rms error ${short(rms)}`));
      else if (!isNaN(roughness))
        caption.append(element("span", `roughness ${short(roughness)}`));
      cloud.panel = element("figure");
      cloud.panel.append(caption);
      this.stage.append(cloud.panel);
    }
  }

  make_switches() {
    const choice = (type, name, text, checked, act) => {
      const label = element("label", "", { className: "choice" });
      const input = element("input", "", { type, name, checked, value: text });
      input.addEventListener("change", () => act(input));
      label.append(input, text);
      return label;
    };
    for (const mode of this.modes)
      by_id("modes").append(choice("radio", "mode", mode.title, mode === this.mode,
        () => this.set_mode(mode)));
    for (const cloud of this.data.clouds)
      by_id("shown").append(choice("checkbox", "cloud", cloud.name === "none" ? "noisy" : cloud.name,
        cloud.shown, input => {
          cloud.shown = input.checked;
          this.arrange();
          this.changed();
        }));
  }

  set_mode(mode) {
    this.mode = mode;
    this.changed();
  }

  write_scale() {
    const { mode } = this, factor = mode.factor / this.contrast();
    const sign = x => short(x).replace("-", "\u2212");
    for (const id of ["bar", "low", "high", "scale-name"])
      by_id(id).hidden = !mode.colors;
    by_id("contrast-label").style.visibility = mode.colors ? "" : "hidden"; // nothing else moves
    by_id("scale-help").textContent = mode.help;
    by_id("scale").setAttribute("aria-label", mode.colors ? `${mode.scale}, from ${
      short(mode.low * factor)} to ${short(mode.high * factor)}; ${mode.help}` : mode.help);
    if (!mode.colors)
      return;
    by_id("scale-name").textContent = mode.scale;
    by_id("low").textContent = sign(mode.low * factor);
    by_id("high").textContent = sign(mode.high * factor);
    by_id("bar").style.background = `linear-gradient(90deg, ${mode.colors})`;
  }

  // ---- where it is ----

  clouds() { return this.data.clouds.filter(cloud => cloud.shown); }

  /// As many columns as make the clouds largest, as they are seen first
  arrange() {
    const n = this.clouds().length, { clientWidth: width, clientHeight: height } = this.stage;
    const [across, up] = this.camera.extents.map(([low, high]) => high - low);
    const caption = this.clouds().length ? this.clouds()[0].panel.firstChild.offsetHeight : 0;
    let columns = 1, best = 0;
    for (let c = 1; c <= n; ++c) {
      const size = Math.min(width / c / across, (height / Math.ceil(n / c) - caption) / up);
      if (size > best)
        [columns, best] = [c, size];
    }
    this.stage.style.gridTemplateColumns = `repeat(${columns}, 1fr)`;
    this.stage.style.gridAutoRows = "1fr";
    for (const cloud of this.data.clouds)
      cloud.panel.hidden = !cloud.shown;
    if (this.camera.is_home)
      this.press("0"); // in panels of this size
  }

  /// The place of a panel below its caption, in pixels of the stage
  box(cloud) {
    const stage = this.stage.getBoundingClientRect(), panel = cloud.panel.getBoundingClientRect();
    const caption = cloud.panel.firstChild.offsetHeight;
    return [panel.left - stage.left, panel.top - stage.top + caption, panel.width,
      Math.max(1, panel.height - caption)];
  }

  /// In pixels of the window
  panel_at(x, y) {
    const stage = this.stage.getBoundingClientRect();
    const boxes = this.clouds().map(cloud => {
      const [left, top, width, height] = this.box(cloud);
      return { left: left + stage.left, top: top + stage.top, width, height };
    });
    return boxes.find(box => box.left <= x && x < box.left + box.width &&
      box.top <= y && y < box.top + box.height) || boxes[0] ||
      { left: 0, top: 0, width: 1, height: 1 };
  }

  positions() { return (this.clouds()[0] || this.data.clouds[0]).positions; }

  // ---- what the user does ----

  contrast() { return 2 ** +by_id("contrast").value; }

  follow_user() {
    follow_pointers(this.stage, this);
    follow_keys((key, shift) => this.press(key, shift));
    for (const id of ["size", "contrast"])
      by_id(id).addEventListener("input", () => this.changed());
    new ResizeObserver(() => { // now: the screen would show the old picture, stretched
      this.arrange();
      this.draw();
    }).observe(this.stage);
    window.addEventListener("hashchange", () => {
      if (location.hash !== this.address) {
        this.read_address();
        this.arrange();
        this.changed();
      }
    });
    const canvas = this.renderer.canvas;
    canvas.addEventListener("webglcontextlost", event => event.preventDefault());
    canvas.addEventListener("webglcontextrestored", () => {
      this.renderer = new Renderer(canvas, this.data.clouds);
      this.changed();
    });
  }

  press(key, shift = false) {
    const sliders = { "[": ["size", -1], "]": ["size", 1], "<": ["contrast", -1], ">": ["contrast", 1] };
    if (sliders[key]) {
      const slider = by_id(sliders[key][0]);
      slider.value = +slider.value + .2 * sliders[key][1];
    } else if (key === "c") {
      this.mode = this.modes[(this.modes.indexOf(this.mode) + 1) % this.modes.length];
    } else if (!press_camera_key(key, shift, this.camera, this.panel_at(0, 0)))
      return false;
    this.changed();
    return true;
  }

  // ---- the address keeps the view ----

  write_address() {
    const { rotation, center, pan, zoom } = this.camera, digits = x => +x.toFixed(4);
    const values = {
      color: this.mode.name, clouds: this.clouds().map(cloud => cloud.name),
      size: by_id("size").value, contrast: by_id("contrast").value,
    };
    if (!this.camera.is_home)
      values.view = [...rotation, ...center, ...pan, zoom].map(digits);
    this.address = "#" + Object.entries(values).map(([name, value]) => `${name}=${value}`).join("&");
    if (location.hash !== this.address)
      location.replace(this.address);
  }

  read_address() {
    const values = new URLSearchParams(location.hash.slice(1));
    this.mode = this.modes.find(mode => mode.name === values.get("color")) || this.mode;
    const view = (values.get("view") || "").split(",").map(Number);
    if (view.length === 10 && view.every(isFinite) && view[9] > 0)
      Object.assign(this.camera, { rotation: view.slice(0, 4), center: view.slice(4, 7),
        pan: view.slice(7, 9), zoom: view[9], is_home: false });
    for (const id of ["size", "contrast"])
      if (values.has(id))
        by_id(id).value = values.get(id);
    const names = (values.get("clouds") || "").split(",");
    if (this.data.clouds.some(cloud => names.includes(cloud.name)))
      this.data.clouds.forEach((cloud, i) => {
        cloud.shown = names.includes(cloud.name);
        by_id("shown").querySelectorAll("input")[i].checked = cloud.shown;
      });
  }

  // ---- drawing ----

  /// Draws with the next picture of the screen, however often it is called before.
  changed() {
    if (this.waiting)
      return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.draw();
    });
    clearTimeout(this.address_timer);
    this.address_timer = setTimeout(() => this.write_address(), 300);
  }

  draw() {
    by_id("modes").querySelectorAll("input")[this.modes.indexOf(this.mode)].checked = true;
    this.write_scale();
    for (const id of ["size", "contrast"])
      by_id(id).setAttribute("aria-valuetext", `${short(2 ** +by_id(id).value)} times`);
    const panels = this.clouds().map(cloud => ({ cloud, box: this.box(cloud) }));
    const radius = .72 * this.data.clouds[0].spacing * 2 ** +by_id("size").value;
    this.renderer.draw(panels, this.camera, this.mode, this.contrast(), radius);
    if (!document.documentElement.dataset.check)
      this.check(panels);
  }

  /// Says in `data-check` of the document whether all panels have got a picture.
  check(panels) {
    const blank = panels.filter(({ box }) => this.renderer.drawn_pixels(box) < 20);
    const points = panels.reduce((sum, { cloud }) => sum + cloud.drawn, 0);
    document.documentElement.dataset.check = blank.length === 0
      ? `passed: ${panels.length} panels, ${points} points`
      : `failed: ${blank.map(({ cloud }) => cloud.label)} blank`;
  }
}

function write_about({ input, clouds }) {
  by_id("input").textContent = input;
  const sampled = clouds.some(cloud => cloud.drawn < cloud.points);
  const add = text => by_id("about").append(element("p", text));
  add(sampled
    ? `Drawn is a random sample of ${clouds[0].drawn.toLocaleString("en")} of ${clouds[0].points.toLocaleString("en")
      } points; colors and numbers are those of all points.`
    : `All points are drawn, ${clouds[0].points.toLocaleString("en")} in each cloud.`);
  add("Each point is a disc in the plane of its 19 nearest points, found alike in all clouds: what " +
    "glitters is rough. Positions are rounded to 1/65536 of the size of the data, errors are not of the rounded ones.");
  if (clouds.some(cloud => cloud.values.error))
    add("Of a noisy cloud, the points outside hide those inside, so it looks redder than it is: make the points smaller.");
  add("Curvature and feature strength are measured alike in all clouds, too, whatever a method knows of " +
    "them: the surface variation of 19 points, and feature_strength_map of this package with k = 24 and no iterations.");
}

try {
  const data = read_data();
  write_about(data);
  write_numbers(data);
  window.page = new Page(data);
} catch (error) {
  by_id("views").replaceChildren(element("p", `${error.message}: no clouds can be shown, only numbers.`,
    { className: "message", role: "alert" }));
  document.documentElement.dataset.check = `failed: ${error.message}`;
}
