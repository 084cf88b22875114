// SPDX-License-Identifier: GPL-3.0-or-later
// How mouse, fingers and keys move the camera.

/// \param stage what they act on
/// \param view has `camera`, `panel_at(x, y)` (its box, or the first), `positions()` and `changed()`
function follow_pointers(stage, view) {
  const pointers = new Map();
  const middle = () => {
    const all = [...pointers.values()];
    const mean = k => all.reduce((sum, p) => sum + p[k], 0) / all.length;
    const spread = all.length > 1 ? Math.hypot(all[0].x - all[1].x, all[0].y - all[1].y) : 1;
    return { x: mean("x"), y: mean("y"), spread, fingers: all.length };
  };
  const move = (dx, dy) => {
    const { width, height } = view.panel_at(0, 0), camera = view.camera;
    const pixels = camera.zoom * camera.pixels_per_radius(width, height);
    camera.move(dx / pixels, -dy / pixels);
  };
  const zoom = (factor, x, y) => {
    const box = view.panel_at(x, y);
    const pixels = view.camera.pixels_per_radius(box.width, box.height);
    view.camera.zoom_by(factor, (x - box.left - box.width / 2) / pixels,
      (box.top + box.height / 2 - y) / pixels);
  };

  stage.addEventListener("pointerdown", event => {
    stage.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (pointers.size === 1)
      view.camera.pivot_on(view.positions());
  });
  stage.addEventListener("pointermove", event => {
    if (!pointers.has(event.pointerId))
      return;
    const before = middle();
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    const after = middle(), dx = after.x - before.x, dy = after.y - before.y;
    if (after.fingers > 1) {
      move(dx, dy);
      zoom(after.spread / (before.spread || 1), after.x, after.y);
    } else if (event.shiftKey || event.buttons & 6)
      move(dx, dy);
    else
      view.camera.turn(dx / 150, dy / 150);
    view.changed();
  });
  for (const end of ["pointerup", "pointercancel"])
    stage.addEventListener(end, event => pointers.delete(event.pointerId));
  stage.addEventListener("contextmenu", event => event.preventDefault());
  stage.addEventListener("wheel", event => {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 30 : 1; // Firefox counts lines
    zoom(Math.exp(-.0015 * lines * event.deltaY), event.clientX, event.clientY);
    view.changed();
  }, { passive: false });
}

/// \param press what to do for a key, with shift or without; returns whether it knew the key
function follow_keys(press) {
  document.addEventListener("keydown", event => {
    const has_own_keys = /^(input|select|textarea)$/i.test(event.target.tagName);
    if (event.ctrlKey || event.altKey || event.metaKey ||
        (has_own_keys && event.key.startsWith("Arrow")))
      return;
    if (event.key.startsWith("Arrow") && event.target.id !== "stage")
      return; // they scroll the page
    if (press(event.key, event.shiftKey))
      event.preventDefault();
  });
  for (const button of document.querySelectorAll("[data-key]"))
    button.addEventListener("click", () => press(button.dataset.key, false));
}

/// What the keys do to the camera.
function press_camera_key(key, shift, camera, panel) {
  const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  const lower = key.toLowerCase();
  if (arrows[key] && shift)
    camera.move(.06 / camera.zoom * arrows[key][0], -.06 / camera.zoom * arrows[key][1]);
  else if (arrows[key])
    camera.turn(.1 * arrows[key][0], .1 * arrows[key][1]);
  else if (key === "+" || key === "=")
    camera.zoom_by(1.2);
  else if (key === "-")
    camera.zoom_by(1 / 1.2);
  else if (key === "0")
    camera.reset(panel.width, panel.height);
  else if (lower === "x" || lower === "y" || lower === "z")
    camera.look_along(lower);
  else
    return false;
  return true;
}
