/* The tab of the pair on a surface: its controls, what is dragged, and what is said of a motion. */

function surfaceTab() {
  const find = (name) => part(`above-${name}`), panel = part("above"), picture = find("picture"), charts = find("charts");
  const DEGREE = Math.PI / 180, NAMES = { X: ["x", "y"], V1: ["v1x", "v1y"], V2: ["v2x", "v2y"] };
  let solution = null, parts = [], reach = 1, held = null;
  const player = playerOf(find, { until: () => solution.scene.until, next: (t) => nextStart(solution, t), show: showAt });
  const controls = controlsOf(panel, changed);

  function changed() {
    for (const one of panel.querySelectorAll("[data-above]")) one.setAttribute("aria-pressed", "false");
    renew();
  }

  function sceneNow() {
    const { value } = controls, vector = (name) => NAMES[name].map(value), kind = find("force").value, together = find("together").checked;
    return {
      ratio: value("ratio"), zeta: value("zeta"), X: vector("X"), V1: vector("V1"), V2: vector(together ? "V1" : "V2"), until: value("until"),
      size: kind === "none" ? 0 : value("size"), angle: DEGREE * value("angle"), omega: kind === "turning" ? value("omega") : 0,
    };
  }

  /* Solve anew. While something is dragged the picture keeps its scale. */
  function renew() {
    player.stop();
    const kind = find("force").value;
    for (const name of ["size", "angle"]) controls.show(name, kind !== "none");
    controls.show("omega", kind === "turning");
    for (const name of NAMES.V2) controls.show(name, !find("together").checked);
    try {
      solution = solveAbove(sceneNow());
    } catch (error) {
      find("regime").textContent = `This scene cannot be solved here: ${error.message}.`;
      return;
    }
    parts = sampledAbove(solution);
    if (!held) reach = reachAbove(solution, parts);
    tell();
    player.go(held ? 0 : player.t);
  }

  function tell() {
    const { title, text, row } = regimeAbove(solution), { segments } = solution;
    const strong = Object.assign(document.createElement("strong"), { textContent: `${title}.` });
    find("regime").replaceChildren(strong, ` ${text} `, ...(row ? proofIn(row) : []));
    find("file").textContent = surfaceFile(solution.scene);
    find("rows").replaceChildren(...segments.slice(0, 200).map(rowOf));
    find("more").textContent = segments.length > 200 ? `${segments.length - 200} more are not listed.` : "";
    const modes = segments.slice(0, 12).map(({ mode }) => mode).join(", ");
    picture.setAttribute("aria-label", `Both bodies from above. ${title}. ${segments.length} motions: ${modes}${segments.length > 12 ? ", \u2026" : "."}`);
    charts.setAttribute("aria-label", `Speed of the slip, load, itinerary and energy over time. ${title}. The table of motions below has the numbers.`);
  }

  function rowOf({ mode, start }) {
    const row = document.createElement("tr"), numbers = [start.t, ...start.X, ...start.V1, ...start.V2, energyAbove(solution, start)];
    row.append(...[mode, ...numbers.map((one) => shown(one, 6))].map((text) => Object.assign(document.createElement("td"), { textContent: text })));
    return row;
  }

  /* Draw a time, and say it. */
  function showAt(t) {
    const now = { ...stateOfAbove(solution, t), t }, drawn = { solution, parts, reach, now, colors: colorsNow() };
    if (picture.clientWidth) {
      drawAbove(...canvasOf(picture), drawn);
      drawChartsAbove(...canvasOf(charts), drawn);
    }
    const load = size(loadAbove(solution.pair, solution.force, now)), pairs = (vector) => `(${vector.map((one) => shown(one)).join(", ")})`;
    find("now").textContent = `\u03c4 = ${shown(t)}: ${now.mode}; body 1 at ${pairs(now.X)}, body 2 at ${pairs(now.x2)}; |v\u2081 \u2212 v\u2082| = ${shown(size(now.S))}; E/E_cr = ${shown(energyAbove(solution, now))}; sticking needs ${shown(load)} b`;
    return `\u03c4 = ${shown(t)}, ${now.mode}`;
  }

  /* Put a handle to a place: the start, a velocity, or the force. */
  function put(name, place) {
    const round = (value) => Number(value.toFixed(3)), from = name === "X" || name === "force" ? [0, 0] : solution.scene.X;
    const vector = plus(place, from, -1);
    if (name === "force") {
      controls.set("size", Number((size(vector) / solution.pair.r).toPrecision(3)));
      controls.set("angle", Number((Math.atan2(vector[1], vector[0]) / DEGREE).toFixed(1)));
    } else NAMES[name].forEach((one, axis) => controls.set(one, round(vector[axis] / (name === "X" ? 1 : ARROW))));
    changed();
  }

  function load(button) {
    const { scene, kind } = EXPLORE.above[button.dataset.above], together = scene.V1.every((one, axis) => one === scene.V2[axis]);
    for (const name of ["ratio", "zeta", "until"]) controls.set(name, scene[name]);
    controls.set("size", scene.size || 2); // what there is to turn once a force is chosen
    controls.set("angle", scene.angle / DEGREE);
    controls.set("omega", scene.omega || 1);
    for (const [name, list] of Object.entries(NAMES)) list.forEach((one, axis) => controls.set(one, scene[name][axis]));
    find("force").value = kind;
    find("together").checked = together;
    player.t = 0;
    changed();
    button.setAttribute("aria-pressed", "true");
    player.go(solution.scene.until);
  }

  const map = () => mapAbove(reach, picture.clientWidth, picture.clientHeight), placeOf = (event) => map().from([event.offsetX, event.offsetY]);
  EXPLORE.placeAbove = (point) => map().to(point);
  picture.addEventListener("pointerdown", (event) => {
    const { to } = map(), at = [event.offsetX, event.offsetY];
    const away = ({ place }) => size(plus(to(place), at, -1));
    const handles = handlesAbove(solution).filter(({ name }) => name !== "V2" || !find("together").checked);
    const nearest = handles.reduce((best, one) => (away(one) < away(best) - 1 ? one : best));
    // away from every handle it is the start that comes; a finger there scrolls the page
    held = away(nearest) < 24 ? nearest.name : event.pointerType === "touch" ? null : "X";
    if (!held) return;
    picture.setPointerCapture(event.pointerId);
    put(held, placeOf(event));
  });
  picture.addEventListener("touchstart", (event) => { if (held) event.preventDefault(); }, { passive: false });
  picture.addEventListener("pointermove", (event) => { if (held && picture.hasPointerCapture(event.pointerId)) put(held, placeOf(event)); });
  for (const name of ["pointerup", "pointercancel"]) {
    picture.addEventListener(name, () => {
      if (!held) return;
      held = null;
      player.t = solution.scene.until;
      renew();
    });
  }
  const KEYS = { ArrowLeft: [-0.05, 0], ArrowRight: [0.05, 0], ArrowUp: [0, 0.05], ArrowDown: [0, -0.05] };
  picture.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const turn = { "+": 5, "=": 5, "-": -5 }[event.key];
    if (KEYS[event.key]) put("X", plus(solution.scene.X, KEYS[event.key]));
    else if (turn && solution.force.size) {
      controls.set("angle", (controls.value("angle") + turn + 540) % 360 - 180);
      changed();
    } else return;
    event.preventDefault();
  });
  for (const button of panel.querySelectorAll("[data-above]")) button.addEventListener("click", () => load(button));
  for (const name of ["force", "together"]) find(name).addEventListener("change", changed);
  charts.addEventListener("click", (event) => {
    const share = (event.offsetX - MARGIN.left) / (charts.clientWidth - MARGIN.left - MARGIN.right);
    player.jump(() => share * solution.scene.until);
  });
  const draw = () => {
    if (!picture.clientWidth) return;
    if (solution) player.show(); else load(panel.querySelector("[data-above]"));
  };
  return { draw };
}

/* What became of a motion on a surface: {title, text, row}. */
function regimeAbove(solution) {
  const { scene, pair, segments, capped } = solution, last = segments[segments.length - 1];
  if (capped) return { title: "Too much for this page", text: `The run is shown up to \u03c4 = ${shown(last.start.t + last.duration)}, ${segments.length} motions. Choose a shorter one, or take the exact integrator.` };
  const round = scene.size && scene.omega ? turningSentence(solution) : "", known = round ? { row: "rotating-force" } : { row: "stuck-ellipses" };
  const most = last.mode === "stick" ? mostLoad(last.axes, last.duration) : Infinity, energy = energyAbove(solution, last.start);
  const slips = segments.filter(({ mode }) => mode === "slip").length, count = `${slips} slip${slips === 1 ? "" : "s"} so far.`;
  if (most <= 1 + TIE) {
    const title = segments.length > 1 ? "Merges" : "Sticks permanently", from = `From \u03c4 = ${shown(last.start.t)} on the bodies stick permanently:`;
    if (round) return { title, text: `${from} the load they need is at most ${shown(most)} b from the end of this run on. ${round}`, ...known };
    const rest = pair.zeta > 0 ? "they come to rest together." : `their ellipse has the longer half axis ${shown(most)} L, which is at most L, and the energy ${shown(energy)} E_cr (on the edge it is from 1 for a line to 2 for a circle).`;
    return { title, text: `${from} ${rest}`, ...known };
  }
  if (round) return { title: last.mode === "stick" ? "Stick and slip so far" : "Slips", text: round, ...known };
  if (pair.zeta > 0) return { title: "Not settled yet", text: `${count} Damping takes the energy; let it run longer.`, ...known };
  if (last.mode === "slip") return { title: "Still slipping", text: `${count} E/E_cr = ${shown(energy)} where this slip began.`, ...known };
  const above = energy > 2 ? "With more than 2 E_cr nothing sticks permanently." : "Between E_cr and 2 E_cr the ellipse decides, not the energy alone.";
  return { title: "Not merged yet", text: `${count} The last stuck ellipse has the longer half axis ${shown(most, 6)} L, more than L, and E/E_cr = ${shown(energy)}. ${above}`, ...known };
}

/* What is known of a force that goes round, and how close the run has come to it. */
function turningSentence({ scene, pair, segments }) {
  const { edge, speed } = turningAnswer(pair, scene), last = segments[segments.length - 1], most = shown(scene.size);
  if (pair.zeta === 0) return `|u|/b = ${most}; up to ${shown(edge)} a stuck circle stays. Without a damper it need not be approached.`;
  if (scene.size <= edge) return `|u|/b = ${most} is at most ${shown(edge)}: every motion tends to a permanently stuck one, on a circle.`;
  const now = size(stateAbove(last, last.duration).S), near = `at the end of this run |v\u2081 \u2212 v\u2082| = ${shown(now, 6)}`;
  return `|u|/b = ${most} is more than ${shown(edge)}: every motion tends to one that slips at the constant speed ${shown(speed, 6)} L\u03a9, round and round without a stop; ${near}.`;
}
