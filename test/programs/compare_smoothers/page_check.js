// SPDX-License-Identifier: GPL-3.0-or-later
// Appended to a page of compare_smoothers by its test: does what a user does and looks at the pixels.
// Writes the outcome into `data-test` of the document. All at once, without waiting for the screen,
// whose clock is not to be trusted where there is none.
(() => {
  const stage = document.getElementById("stage"), canvas = stage.querySelector("canvas");
  const panels = () => [...stage.querySelectorAll("figure:not([hidden])")];
  const expect = (what, holds) => {
    if (!holds)
      throw new Error(what);
  };

  /// The pixels of each panel, drawn now
  function pictures() {
    page.draw();
    const copy = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
    copy.canvas.width = copy.canvas.height = 100;
    const ratio = canvas.width / canvas.clientWidth, from = stage.getBoundingClientRect();
    return panels().map(panel => {
      const box = panel.getBoundingClientRect();
      copy.clearRect(0, 0, 100, 100);
      copy.drawImage(canvas, ratio * (box.left - from.left), ratio * (box.top - from.top),
        ratio * box.width, ratio * box.height, 0, 0, 100, 100);
      return copy.getImageData(0, 0, 100, 100).data;
    });
  }
  const count = (picture, is_counted) => {
    let n = 0;
    for (let i = 0; i < picture.length; i += 4)
      n += is_counted(...picture.subarray(i, i + 4));
    return n;
  };
  const size = picture => count(picture, (r, g, b, a) => a > 127);
  const same = (a, b) => a.every((byte, i) => byte === b[i]);
  const all_differ = (before, after) =>
    before.length === after.length && before.every((picture, i) => !same(picture, after[i]));

  function act(what, action, holds) {
    const before = pictures();
    action();
    expect(what, holds(before, pictures()));
  }
  const press = (key, more = {}) => () =>
    stage.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true, ...more }));
  const point = (type, x, y, more = {}) =>
    stage.dispatchEvent(new PointerEvent(type, { clientX: x, clientY: y, pointerId: 1, bubbles: true, ...more }));
  const drag = (more = {}) => () => {
    stage.setPointerCapture = () => {}; // there is no such pointer
    const { left, top } = stage.getBoundingClientRect();
    point("pointerdown", left + 90, top + 90, more);
    point("pointermove", left + 130, top + 110, more);
    point("pointerup", left + 130, top + 110, more);
  };

  try {
    const first = pictures();
    expect("each panel has a picture", first.length > 1 && first.every(picture => size(picture) > 300));
    act("arrows turn all clouds", press("ArrowLeft"), all_differ);
    act("+ makes all larger", press("+"), (before, after) =>
      before.every((picture, i) => size(after[i]) > size(picture)));
    act("dragging turns all clouds", drag({ buttons: 1 }), all_differ);
    act("dragging with shift moves all clouds", drag({ buttons: 1, shiftKey: true }), all_differ);
    act("the wheel zooms", () => stage.dispatchEvent(new WheelEvent("wheel",
      { deltaY: 300, clientX: 200, clientY: 300, bubbles: true, cancelable: true })),
      (before, after) => before.every((picture, i) => size(after[i]) < size(picture)));
    act("two fingers zoom", () => {
      const { left, top } = stage.getBoundingClientRect();
      const finger = (type, id, x) => point(type, left + x, top + 90, { pointerId: id, pointerType: "touch" });
      finger("pointerdown", 1, 80), finger("pointerdown", 2, 100), finger("pointermove", 2, 130);
      finger("pointerup", 1, 80), finger("pointerup", 2, 130);
    }, (before, after) => before.every((picture, i) => size(after[i]) > size(picture)));
    act("] makes points larger", press("]"), all_differ);
    press("[")();
    press("0")();
    expect("0 goes back to the first view", pictures().every((picture, i) => same(picture, first[i])));

    const n = panels().length, radios = [...document.querySelectorAll("#modes input")], seen = [];
    for (const radio of radios) {
      radio.click();
      const now = pictures();
      expect(`color ${radio.value} differs from the others`, seen.every(others => all_differ(others, now)));
      seen.push(now);
      expect(`${radio.value} has a color bar`, radio.value === "plain" || (
        !document.getElementById("bar").hidden && document.getElementById("high").textContent !== ""));
    }
    // of the noisy cloud more is strongly colored than of ours, the last one but the truth
    const is_strong = {
      "error": (r, g, b) => Math.abs(r - b) > 100,
      "curvature": (r, g, b) => g > 1.2 * b,
      "feature strength": (r, g, b) => r > 1.6 * b,
    };
    radios.forEach((radio, k) => {
      const strong = seen[k].map(picture => count(picture, (r, g, b, a) =>
        a > 127 && is_strong[radio.value] && is_strong[radio.value](r, g, b)) / size(picture));
      if (is_strong[radio.value] && radios.some(other => other.value === "error"))
        expect(`${radio.value} is less in ours: ${strong}`,
          strong[0] > .2 && strong[0] > 1.1 * strong[n - 1] && strong[n - 1] > 0);
    });

    const switches = [...document.querySelectorAll("#shown input")];
    switches[0].click();
    const fewer = pictures();
    expect("a cloud can be hidden", fewer.length === n - 1 && fewer.every(picture => size(picture) > 300));
    switches[0].click();
    page.write_address();
    expect("the address keeps the color", location.hash.includes(`color=${page.mode.name}`));
    location.hash = "#color=curvature&clouds=" + page.data.clouds[1].name;
    window.dispatchEvent(new HashChangeEvent("hashchange"));
    expect("an address is followed", page.mode.name === "curvature" && panels().length === 1);
    document.documentElement.dataset.test = "passed";
  } catch (error) {
    document.documentElement.dataset.test = `failed: ${error.message}`;
  }
})();
