/* Sliders, fields and buttons. A field holds the exact value; its slider shows where that lies on a scale of its own. */

const STEPS = 1000;
const SCALES = {
  linear: { to: (share, low, high) => low + share * (high - low), from: (value, low, high) => (value - low) / (high - low) },
  log: {
    to: (share, low, high) => low * (high / low) ** share,
    from: (value, low, high) => Math.log(value / low) / Math.log(high / low),
  },
  // fine about 0 and wide at the ends
  signed: {
    to: (share, low, high) => high * Math.sinh(4 * (2 * share - 1)) / Math.sinh(4),
    from: (value, low, high) => (Math.asinh(value / high * Math.sinh(4)) / 4 + 1) / 2,
  },
};

/* The controls of the scene below `root`, and `changed`, which is called after each change by the reader. */
function controlsOf(root, changed) {
  const rows = new Map();
  for (const row of root.querySelectorAll("[data-name]")) {
    const { name, scale, low, high } = row.dataset, [slider, field] = row.querySelectorAll("input");
    rows.set(name, { row, slider, field, scale: SCALES[scale], low: Number(low), high: Number(high), value: Number(field.value) });
  }
  const set = (name, value) => {
    const one = rows.get(name);
    const share = one.scale.from(value, one.low, one.high);
    one.value = value;
    one.slider.value = Math.round(STEPS * Math.max(0, Math.min(1, share)));
    one.slider.setAttribute("aria-valuetext", shown(value));
    one.field.value = String(Number(value.toPrecision(12)));
    one.field.removeAttribute("aria-invalid");
  };
  for (const [name, one] of rows) {
    one.slider.addEventListener("input", () => {
      const value = one.scale.to(one.slider.value / STEPS, one.low, one.high);
      set(name, Number(value.toPrecision(3)));
      changed();
    });
    one.field.addEventListener("change", () => {
      const value = Number(one.field.value), [least, most] = [Number(one.field.min), Number(one.field.max)];
      if (one.field.value.trim() === "" || !(value >= least && value <= most)) return one.field.setAttribute("aria-invalid", "true");
      set(name, value);
      return changed();
    });
  }
  return { set, value: (name) => rows.get(name).value, show: (name, visible) => { rows.get(name).row.hidden = !visible; } };
}

/* Turning and zooming of the phase space, by pointer and by keys. */
function cameraOf(canvas, redraw) {
  const home = { yaw: -0.6, pitch: 0.42, zoom: 1 }, camera = { ...home };
  const turn = (yaw, pitch, zoom = 1) => {
    camera.yaw += yaw;
    camera.pitch = Math.max(-1.5, Math.min(1.5, camera.pitch + pitch));
    camera.zoom = Math.max(0.5, Math.min(200, camera.zoom * zoom));
    redraw();
  };
  const keys = {
    ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1], "+": [0, 0, 1.25], "=": [0, 0, 1.25], "-": [0, 0, 0.8],
  };
  canvas.addEventListener("keydown", (event) => {
    if (!keys[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    turn(...keys[event.key]);
  });
  canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
  canvas.addEventListener("pointermove", (event) => {
    if (canvas.hasPointerCapture(event.pointerId)) turn(event.movementX / 120, event.movementY / 120);
  });
  return { camera, turn, reset: () => { Object.assign(camera, home); redraw(); } };
}
