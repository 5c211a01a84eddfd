/* The pair from above on a canvas, and its charts over time. */

/* Points of a solution for drawing: [{mode, points: [{t, X, V1, V2, S, x2}]}]. */
function sampledAbove(solution, most = 6000) {
  const share = most / solution.scene.until, fast = 24 * Math.max(1, solution.force.omega);
  return solution.segments.map((segment) => {
    const count = Math.max(12, Math.ceil(segment.duration * Math.min(fast, share)));
    const points = Array.from({ length: count + 1 }, (_, n) => stateAbove(segment, segment.duration * n / count));
    return { mode: segment.mode, points };
  });
}

/* The curve on which body 1 stays if the pair sticks permanently: an ellipse about the force, or the circle that goes round
   with it; null if that is not settled in this run, or if a damper lets the pair come to rest. */
function lastingCurve({ pair, force, segments }) {
  const last = segments[segments.length - 1], ring = Array.from({ length: 97 }, (_, n) => n * Math.PI / 48);
  if (last.mode !== "stick" || mostLoad(last.axes, last.duration) > 1 + TIE) return null;
  if (last.axes[0].of.sine.amplitude !== 0) {
    const radius = pair.zeta > 0 ? steadyResponse(last.axes[0].of, 0)[2] : 0;
    return radius ? ring.map((angle) => [radius * Math.cos(angle), radius * Math.sin(angle)]) : null;
  }
  if (pair.zeta > 0) return null;
  return ring.map((angle) => last.axes.map(({ rest, y0, v0 }) => rest + y0 * Math.cos(angle) + v0 * Math.sin(angle)));
}

/* Velocities are drawn as arrows of that much of their length. */
const ARROW = 0.4;

/* How far the picture has to reach from its middle. */
function reachAbove({ scene, force }, parts) {
  const all = [[1.1, 0], plus(scene.X, scene.V1, ARROW), plus(scene.X, scene.V2, ARROW), times(1.1, turned(force, 0)), ...parts.flatMap(({ points }) => points.flatMap(({ X, x2 }) => [X, x2]))];
  return 1.1 * all.reduce((most, [x, y]) => Math.max(most, Math.abs(x), Math.abs(y)), 0);
}

function discAt(context, [x, y], radius, fill, stroke) {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  if (fill) { context.fillStyle = fill; context.fill(); }
  if (stroke) { context.strokeStyle = stroke; context.stroke(); }
}

function arrow(context, from, to, color, width) {
  const along = plus(to, from, -1), length = size(along);
  if (length < 2) return;
  const back = plus(to, along, -9 / length), aside = times(4 / length, across(along));
  line(context, [from, to], color, width);
  area(context, [to, plus(back, aside), plus(back, aside, -1)], color);
}

/* Where a point of the surface is on the canvas, and back. */
function mapAbove(reach, width, height) {
  const scale = 0.5 * Math.min(width, height) / reach;
  return {
    scale,
    to: ([x, y]) => [width / 2 + scale * x, height / 2 - scale * y],
    from: ([x, y]) => [(x - width / 2) / scale, (height / 2 - y) / scale],
  };
}

/* What the reader may drag: {name, place}. */
function handlesAbove({ scene, force }) {
  const found = [{ name: "V1", place: plus(scene.X, scene.V1, ARROW) }, { name: "V2", place: plus(scene.X, scene.V2, ARROW) }];
  if (force.size) found.push({ name: "force", place: turned(force, 0) });
  return [...found, { name: "X", place: scene.X }];
}

function drawAbove(context, width, height, { solution, parts, reach, now, colors }) {
  const { scene, pair, force } = solution, { to, scale } = mapAbove(reach, width, height);
  context.clearRect(0, 0, width, height);
  for (const mark of ticks(-reach, reach, 6)) {
    line(context, [to([mark, -9 * reach]), to([mark, 9 * reach])], colors.line, mark === 0 ? 1.5 : 0.5);
    line(context, [to([-9 * reach, mark]), to([9 * reach, mark])], colors.line, mark === 0 ? 1.5 : 0.5);
  }
  const pulls = turned(force, now.t), centre = plus(pulls, now.V1, -2 * pair.zeta);
  discAt(context, to(centre), scale, colors.strip, colors.soft);
  if (force.size) arrow(context, to([0, 0]), to(pulls), colors.ray, 2);
  const curve = lastingCurve(solution);
  if (curve) line(context, curve.map(to), colors.ink, 1.2, [2, 3]);
  drawTrail(context, to, parts, now, "x2", colors, [colors.modes[-1][0], [6, 3]]);
  drawTrail(context, to, parts, now, "X", colors, [colors.modes[1][0], []]);
  if (now.t === 0) for (const [name, color] of [["V2", colors.modes[-1][0]], ["V1", colors.modes[1][0]]]) arrow(context, to(scene.X), to(plus(scene.X, scene[name], ARROW)), color, 2);
  context.lineWidth = 1.5;
  discAt(context, to(scene.X), 5, null, colors.ink);
  const [x, y] = to(now.x2);
  context.fillStyle = colors.modes[-1][0];
  context.fillRect(x - 7, y - 7, 14, 14);
  discAt(context, to(now.X), 6, colors.modes[1][0], colors.paper);
  context.font = colors.font;
  context.textAlign = "left";
  context.fillStyle = colors.soft;
  context.fillText("y/L", width / 2 + 5, 14);
  context.fillText("x/L", width - 24, height / 2 - 6);
}

/* The way of a body up to now, the rest of it faint; thick and dark where the pair sticks. */
function drawTrail(context, to, parts, now, name, colors, [color, dash]) {
  for (const { mode, points } of parts) {
    const passed = points.filter(({ t }) => t <= now.t), whole = passed.length === points.length;
    context.globalAlpha = 0.25;
    if (!whole) line(context, points.map((one) => to(one[name])), color, 1);
    context.globalAlpha = 1;
    const shownPart = [...passed, ...(whole || !passed.length ? [] : [now])].map((one) => to(one[name]));
    if (mode === "stick" && name === "X") line(context, shownPart, colors.modes[STICK][0], 2.5);
    else line(context, shownPart, color, 1.7, dash);
  }
}

/* Speed of the slip, load, modes, energy. */
function drawChartsAbove(context, width, height, { solution, parts, now, colors }) {
  const until = solution.scene.until, unit = (height - 140) / 7.5, curve = (value) => curveOf(parts, value);
  context.clearRect(0, 0, width, height);
  let top = 22;
  const next = (share, low, high) => {
    const made = chart(top, share * unit, width, until, low, high);
    top += share * unit + 30;
    return made;
  };
  const slip = curve(({ S }) => size(S)), fast = next(2, 0, Math.max(1e-3, spread([slip])[1]));
  drawFrame(context, fast, "|v\u2081 \u2212 v\u2082| over L\u03a9: the speed of the slip", colors, ticks(0, fast.high, 3));
  drawCurve(context, fast, slip, colors.modes[1][0], 1.5);
  const held = next(2, 0, 2.5);
  context.fillStyle = colors.strip;
  context.fillRect(MARGIN.left, held.y(1), width - MARGIN.left - MARGIN.right, held.y(0) - held.y(1));
  drawFrame(context, held, "force that sticking needs, over b: friction can give what is shaded", colors, [0, 1, 2]);
  for (const { mode, points } of parts) {
    const load = points.map((one) => [one.t, size(loadAbove(solution.pair, solution.force, one))]);
    drawCurve(context, held, load, colors.modes[mode === "stick" ? STICK : 1][0], mode === "stick" ? 2.5 : 1.2);
  }
  drawModesAbove(context, next(0.6, 0, 1), solution, colors);
  const energy = curve((one) => energyAbove(solution, one)), own = next(2.4, 0, Math.max(2.3, spread([energy])[1]));
  drawFrame(context, own, "energy E/E_cr: dashed at 1 and 2, between which stuck ellipses end", colors, ticks(0, own.high, 4));
  for (const level of [1, 2]) drawCurve(context, own, [[0, level], [until, level]], colors.ray, 1.5, [5, 3]);
  drawCurve(context, own, energy, colors.ink, 1.5);
  const axis = chart(top - 30, 0, width, until, 0, 1);
  context.textAlign = "center";
  context.fillStyle = colors.soft;
  for (const mark of ticks(0, until, 6)) context.fillText(shown(mark), Math.min(axis.x(mark), width - 14), height - 18);
  context.fillText("time \u03c4 = \u03a9 t", width / 2, height - 3);
  line(context, [[axis.x(now.t), 14], [axis.x(now.t), height - 32]], colors.ink, 1, [3, 3]);
}

/* Two rows, so that colour is not needed. */
function drawModesAbove(context, at, { segments }, colors) {
  const half = at.height / 2;
  drawFrame(context, at, "itinerary", colors, []);
  context.textAlign = "right";
  context.fillStyle = colors.soft;
  ["slip", "stick"].forEach((name, row) => context.fillText(name, MARGIN.left - 4, at.top + half * (row + 0.5) + 4));
  for (const { mode, start, duration } of segments) {
    const x = at.x(start.t), row = mode === "stick" ? 1 : 0;
    context.fillStyle = colors.modes[row ? STICK : 1][0];
    context.fillRect(x, at.top + half * row + 1, Math.max(1, at.x(start.t + duration) - x), half - 2);
  }
}
