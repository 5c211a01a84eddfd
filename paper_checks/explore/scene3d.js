/* The phase space (x1, v1, v2) on a canvas: S and S0 as planes, the exit rays, and the trajectory. */

/* Sampled points of a solution for drawing: [{mode, points: [{t, X, V1, V2, x2}]}]; only pictures are made of them. */
function sampled(solution, most = 24000) {
  const total = solution.scene.until, share = most / total;
  return solution.segments.map((segment) => {
    const wanted = segment.duration * Math.min(20 * Math.max(1, segment.motion.reach), share);
    const count = Math.max(6, Math.min(4000, Math.ceil(wanted)));
    const points = Array.from({ length: count + 1 }, (_, n) => stateAt(segment, segment.duration * n / count));
    return { mode: segment.start.mode, points };
  });
}

function reachOf(parts) {
  const all = parts.flatMap(({ points }) => points);
  const most = (name) => all.reduce((found, one) => Math.max(found, Math.abs(one[name])), 0);
  return { X: Math.max(1.5, 1.08 * most("X")), V: Math.max(1.5, 1.08 * most("V1"), 1.08 * most("V2")) };
}

/* From (X, V1, V2) to the canvas: a turned box, seen from far away. */
function projector({ yaw, pitch, zoom }, reach, width, height) {
  const size = 0.33 * Math.min(width, 1.25 * height), [cy, sy, cp, sp] = [Math.cos(yaw), Math.sin(yaw), Math.cos(pitch), Math.sin(pitch)];
  return (X, V1, V2) => {
    const a = X / reach.X * zoom, b = V1 / reach.V * zoom, c = V2 / reach.V * zoom;
    const across = a * cy - b * sy, depth = a * sy + b * cy;
    return [width / 2 + size * across, height / 2 - size * (c * cp - depth * sp), depth * cp + c * sp];
  };
}

function path(context, points, close = false) {
  context.beginPath();
  points.forEach(([x, y], n) => (n ? context.lineTo(x, y) : context.moveTo(x, y)));
  if (close) context.closePath();
}

function line(context, points, color, width, dash = []) {
  context.setLineDash(dash);
  context.strokeStyle = color;
  context.lineWidth = width;
  path(context, points);
  context.stroke();
  context.setLineDash([]);
}

function area(context, points, color) {
  context.fillStyle = color;
  path(context, points, true);
  context.fill();
}

/* The strip S0 at a time, cut to the box: its edges are X = f -+ 1 - 2 zeta V. */
function stripCorners({ pair, force }, t, box) {
  const cut = (X) => Math.max(-box.X, Math.min(box.X, X));
  const edge = (side) => [-box.V, box.V].map((V) => [cut(forceAt(force, t) + side - 2 * pair.zeta * V), V]);
  return [...edge(-1), ...edge(1).reverse()];
}

/* Everything, from back to front: what is behind S, S itself, what is before it. */
function drawScene(context, width, height, { solution, parts, reach, camera, now, colors }) {
  const box = { X: reach.X / camera.zoom, V: reach.V / camera.zoom };
  const to = projector(camera, reach, width, height), onS = ([X, V]) => to(X, V, V);
  const before = to(0, 1, -1)[2] > 0 ? 1 : -1, strip = stripCorners(solution, now.t, box);
  context.clearRect(0, 0, width, height);
  drawAxes(context, to, box, colors);
  drawTrajectory(context, to, parts, now, colors, (mode) => mode === -before);
  area(context, [[-box.X, -box.V], [box.X, -box.V], [box.X, box.V], [-box.X, box.V]].map(onS), colors.plane);
  area(context, strip.map(onS), colors.strip);
  drawEdges(context, onS, solution, now.t, box, colors);
  drawTrajectory(context, to, parts, now, colors, (mode) => mode !== -before);
  drawState(context, to, solution, now, colors);
  context.fillStyle = colors.ink;
  for (const [name, corner] of [["S", [box.X, box.V]], ["S\u2080", strip[2]]]) {
    const [x, y] = onS(corner);
    context.fillText(name, x, y - 6);
  }
}

/* Edges of S0, thick where sliding motion leaves by them: the exit rays. Dotted: the orbit of stick with E = E_cr. */
function drawEdges(context, onS, { pair, force, scene }, t, box, colors) {
  for (const side of [1, -1]) { // the load on this edge
    const edge = (V) => onS([forceAt(force, t) - side - 2 * pair.zeta * V, V]), end = -side * box.V;
    line(context, [edge(-end), edge(end)], colors.soft, 1);
    const level = forceRate(force, t, 1) - 2 * pair.zeta * side, from = Math.max(-box.V, Math.min(box.V, level));
    if (!scene.literal && side * (from - end) > 0) line(context, [edge(from), edge(end)], colors.ray, 4);
  }
  if (pair.zeta > 0 || force.amplitude !== 0) return;
  const ring = Array.from({ length: 73 }, (_, n) => n * Math.PI / 36);
  line(context, ring.map((angle) => onS([force.constant + Math.cos(angle), Math.sin(angle)])), colors.ink, 1, [2, 3]);
}

const LABELS = [["x\u2081/L", (box) => [1.18 * box.X, 0, 0]], ["v\u2081/(L\u03a9)", (box) => [0, 1.18 * box.V, 0]], ["v\u2082/(L\u03a9)", (box) => [0, 0, 1.12 * box.V]]];

function drawAxes(context, to, box, colors) {
  context.fillStyle = colors.soft;
  context.font = colors.font;
  context.textAlign = "center";
  for (const [name, place] of LABELS) {
    const tip = place(box), end = to(...tip);
    line(context, [to(...tip.map((one) => -one)), end], colors.line, 1);
    context.fillText(name, end[0], end[1] - 4);
  }
}

/* The parts of the trajectory that `chosen` takes by their mode: faint as a whole, strong up to now. */
function drawTrajectory(context, to, parts, now, colors, chosen) {
  for (const { mode, points } of parts) {
    if (!chosen(mode)) continue;
    const place = ({ X, V1, V2 }) => to(X, V1, V2), [color, width, dash] = colors.modes[mode];
    const passed = points.filter(({ t }) => t <= now.t), whole = passed.length === points.length;
    context.globalAlpha = 0.25;
    if (!whole) line(context, points.map(place), color, 1);
    context.globalAlpha = 1;
    if (passed.length) line(context, [...passed, ...(whole ? [] : [now])].map(place), color, width, dash);
  }
}

/* Where the pair began, a ring, and where it is now, a disc. */
function drawState(context, to, solution, now, colors) {
  const disc = (state, radius) => {
    const [x, y] = to(state.X, state.V1, state.V2);
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
  };
  context.lineWidth = 1.5;
  context.strokeStyle = colors.ink;
  disc(solution.segments[0].start, 5);
  context.stroke();
  disc(now, 6);
  context.fillStyle = colors.modes[now.mode][0];
  context.fill();
  context.strokeStyle = colors.paper;
  context.stroke();
}
