/* Joins controls, solver and pictures. */

const root = document.getElementById("explore"), part = (name) => document.getElementById(`explore-${name}`);
const space = part("space"), strips = part("strips"), dark = matchMedia("(prefers-color-scheme: dark)");
const state = { solution: null, parts: [], reach: null, units: null };

const player = playerOf(part, { until: () => state.solution.scene.until, next: (t) => nextStart(state.solution, t), show: drawAt });
const controls = controlsOf(root, () => { state.units = null; pressed(null); renew(); });
const view = cameraOf(space, draw);

/* The scene that the controls say. */
function sceneNow() {
  const value = (name) => controls.value(name), kind = part("force").value;
  return {
    ratio: value("ratio"), zeta: value("zeta"), X: value("X"), V1: value("V1"), V2: value("V2"), until: value("until"),
    constant: kind === "constant" ? value("size") : 0, amplitude: kind === "sine" ? value("size") : 0, omega: value("omega"),
    literal: part("literal").checked,
  };
}

/* Solve anew, from the start of time. */
function renew() {
  player.stop();
  const kind = part("force").value;
  controls.show("size", kind !== "none");
  controls.show("omega", kind === "sine");
  try {
    state.solution = solve(sceneNow());
  } catch (error) {
    part("regime").textContent = `This scene cannot be solved here: ${error.message}.`;
    return;
  }
  state.parts = sampled(state.solution);
  state.reach = reachOf(state.parts);
  tell();
  player.go(player.t);
}

function tell() {
  const { title, text, row } = regimeOf(state.solution), { segments } = state.solution;
  const strong = Object.assign(document.createElement("strong"), { textContent: `${title}.` });
  part("regime").replaceChildren(strong, ` ${text} `, ...(row ? proofIn(row) : []));
  part("units").textContent = state.units || "";
  part("units").hidden = !state.units;
  part("file").textContent = sceneFile(state.solution.scene);
  part("rows").replaceChildren(...segments.slice(0, 200).map(rowOf));
  part("more").textContent = segments.length > 200 ? `${segments.length - 200} more are not listed.` : "";
  const modes = segments.slice(0, 12).map(({ start }) => MODE_NAMES[start.mode]).join(", ");
  space.setAttribute("aria-label", `Phase space x1, v1, v2. ${title}. ${segments.length} motions: ${modes}${segments.length > 12 ? ", \u2026" : "."}`);
  strips.setAttribute("aria-label", `Velocities, load, itinerary and energy over time. ${title}. The table of motions below has the numbers.`);
}

/* Where a sentence is proved: a link, if the report beside this page has the claim. */
function proofIn(row) {
  const name = EXPLORE.beside.includes(row) ? Object.assign(document.createElement("a"), { href: `report.html#${row}` }) : document.createElement("code");
  name.textContent = row;
  return ["See claim ", name, "."];
}

const MODE_NAMES = { 1: "slip+", 0: "stick", "-1": "slip\u2212" };

function rowOf({ start }) {
  const row = document.createElement("tr"), energy = energyAbout(state.solution, start);
  const cells = [MODE_NAMES[start.mode], ...[start.t, start.X, start.V1, start.V2, energy].map((one) => shown(one, 9))];
  row.append(...cells.map((text) => Object.assign(document.createElement("td"), { textContent: text })));
  return row;
}

/* The colours and the font of the page, as it is now: light, dark or printed. */
function colorsNow() {
  const style = getComputedStyle(root), color = (name) => style.getPropertyValue(`--explore-${name}`).trim();
  const named = Object.fromEntries(["ink", "soft", "line", "paper", "plane", "strip", "ray"].map((name) => [name, color(name)]));
  const modes = { 1: [color("plus"), 1.6, []], 0: [color("stick"), 3, []], "-1": [color("minus"), 1.8, [7, 3]] };
  return { ...named, modes, font: "12px system-ui, sans-serif" };
}

function canvasOf(canvas) {
  const scale = devicePixelRatio || 1, { clientWidth: width, clientHeight: height } = canvas;
  if (canvas.width !== Math.round(width * scale)) canvas.width = Math.round(width * scale);
  if (canvas.height !== Math.round(height * scale)) canvas.height = Math.round(height * scale);
  const context = canvas.getContext("2d");
  context.setTransform(scale, 0, 0, scale, 0, 0);
  return [context, width, height];
}

function draw() {
  if (state.solution) player.show();
}

/* Everything at a time; returns what it says of that time. */
function drawAt(t) {
  const now = stateOf(state.solution, t), picture = { ...state, camera: view.camera, now: { ...now, t }, colors: colorsNow() };
  drawScene(...canvasOf(space), picture);
  drawStrips(...canvasOf(strips), picture);
  const energy = energyAbout(state.solution, now), load = loadOf(state.solution.pair, state.solution.force, now);
  part("now").textContent = `\u03c4 = ${shown(t)}: ${MODE_NAMES[now.mode]}; x\u2081/L = ${shown(now.X)}, v\u2081 = ${shown(now.V1)}, v\u2082 = ${shown(now.V2)}; E/E_cr = ${shown(energy)}; sticking needs ${shown(load)} b`;
  return `\u03c4 = ${shown(t)}, ${MODE_NAMES[now.mode]}`;
}

function pressed(button) {
  for (const one of root.querySelectorAll("[data-scene]")) one.setAttribute("aria-pressed", String(one === button));
}

function load(button) {
  const { scene, units } = EXPLORE.scenes[button.dataset.scene];
  for (const name of ["ratio", "zeta", "X", "V1", "V2", "until", "omega"]) controls.set(name, scene[name]);
  controls.set("size", scene.amplitude || scene.constant);
  part("force").value = scene.amplitude ? "sine" : scene.constant ? "constant" : "none";
  part("literal").checked = scene.literal;
  state.units = units;
  player.t = 0;
  pressed(button);
  view.reset();
  renew();
}

for (const button of root.querySelectorAll("[data-scene]")) button.addEventListener("click", () => load(button));
for (const name of ["force", "literal"]) part(name).addEventListener("change", () => { pressed(null); renew(); });
part("closer").addEventListener("click", () => view.turn(0, 0, 1.5));
part("farther").addEventListener("click", () => view.turn(0, 0, 1 / 1.5));
part("reset").addEventListener("click", view.reset);
strips.addEventListener("click", (event) => {
  const share = (event.offsetX - MARGIN.left) / (strips.clientWidth - MARGIN.left - MARGIN.right);
  player.jump(() => share * state.solution.scene.until);
});
new ResizeObserver(draw).observe(root);
part("body").hidden = false;
load(root.querySelector("[data-scene]"));
player.go(state.solution.scene.until);
dark.addEventListener("change", draw);
addEventListener("beforeprint", () => { root.classList.add("explore-print"); draw(); });
addEventListener("afterprint", () => { root.classList.remove("explore-print"); draw(); });
