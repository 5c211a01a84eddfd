/* The charts over time on one canvas: velocities, load, itinerary, energy. */

const MARGIN = { left: 46, right: 10 };

/* Round marks for an axis from low to high. */
function ticks(low, high, most = 5) {
  const raw = (high - low) / most, power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((one) => one * power).find((one) => one >= raw * (1 - 1e-9));
  const first = Math.ceil(low / step - 1e-9);
  return Array.from({ length: Math.floor(high / step + 1e-9) - first + 1 }, (_, n) => (first + n) * step);
}

/* A chart: where a time and a value lie on the canvas. */
function chart(top, height, width, until, low, high) {
  return {
    top, height, low, high, width, until,
    x: (t) => MARGIN.left + (width - MARGIN.left - MARGIN.right) * t / until,
    y: (value) => top + height * (1 - (value - low) / (high - low)),
  };
}

/* Grid lines, their numbers and the title; what follows a colon in it is left out where there is no room. */
function drawFrame(context, at, title, colors, marks, name = shown) {
  context.font = colors.font;
  context.textAlign = "right";
  for (const mark of marks) {
    line(context, [[MARGIN.left, at.y(mark)], [at.width - MARGIN.right, at.y(mark)]], colors.line, 1);
    context.fillStyle = colors.soft;
    context.fillText(name(mark, 3), MARGIN.left - 4, at.y(mark) + 4);
  }
  context.textAlign = "left";
  context.fillStyle = colors.ink;
  const fits = context.measureText(title).width < at.width - MARGIN.left - MARGIN.right;
  context.fillText(fits ? title : title.split(":")[0], MARGIN.left, at.top - 6);
}

function drawCurve(context, at, points, color, width, dash) {
  context.save();
  context.beginPath();
  context.rect(MARGIN.left, at.top, at.width - MARGIN.left - MARGIN.right, at.height);
  context.clip();
  line(context, points.map(([t, value]) => [at.x(t), at.y(value)]), color, width, dash);
  context.restore();
}

const curveOf = (parts, value) => parts.flatMap(({ points }) => points.map((one) => [one.t, value(one)]));

function spread(curves) {
  const values = curves.flat().map(([, value]) => value).filter(Number.isFinite);
  const low = values.reduce((a, b) => Math.min(a, b), Infinity), high = values.reduce((a, b) => Math.max(a, b), -Infinity);
  const air = 0.06 * (high - low) || 1;
  return [low - air, high + air];
}

/* All charts; returns how a place on the canvas is a time. */
function drawStrips(context, width, height, { solution, parts, now, colors }) {
  const until = solution.scene.until, unit = (height - 150) / 8;
  context.clearRect(0, 0, width, height);
  const v1 = curveOf(parts, (one) => one.V1), v2 = curveOf(parts, (one) => one.V2);
  let top = 22;
  const next = (share, low, high) => {
    const made = chart(top, share * unit, width, until, low, high);
    top += share * unit + 30;
    return made;
  };
  const speeds = next(3, ...spread([v1, v2]));
  drawFrame(context, speeds, "velocities over L\u03a9: body 1 full, body 2 dashed", colors, ticks(speeds.low, speeds.high));
  drawCurve(context, speeds, v1, colors.modes[1][0], 1.5);
  drawCurve(context, speeds, v2, colors.modes[-1][0], 1.8, [6, 3]);
  drawLoad(context, next(2, -2.5, 2.5), solution, parts, colors);
  drawItinerary(context, next(0.8, 0, 1), solution, colors);
  drawEnergy(context, next(2.2, -9, 1), solution, parts, colors);
  const axis = chart(top - 30, 0, width, until, 0, 1);
  context.textAlign = "center";
  context.fillStyle = colors.soft;
  for (const mark of ticks(0, until, 6)) context.fillText(shown(mark), Math.min(axis.x(mark), width - 14), height - 18);
  context.fillText("time \u03c4 = \u03a9 t", width / 2, height - 3);
  line(context, [[axis.x(now.t), 14], [axis.x(now.t), height - 32]], colors.ink, 1, [3, 3]);
}

/* What sticking needs of the interface, over b: friction can give it between -1 and 1. */
function drawLoad(context, at, solution, parts, colors) {
  context.fillStyle = colors.strip;
  context.fillRect(MARGIN.left, at.y(1), at.width - MARGIN.left - MARGIN.right, at.y(-1) - at.y(1));
  drawFrame(context, at, "force that sticking needs, over b: friction can give what is shaded", colors, [-2, -1, 0, 1, 2]);
  for (const { mode, points } of parts) {
    const load = points.map((one) => [one.t, loadOf(solution.pair, solution.force, one)]);
    drawCurve(context, at, load, colors.modes[mode][0], mode === STICK ? 2.5 : 1.2);
  }
}

/* The modes over time: three heights and three patterns, so that colour is not needed. */
function drawItinerary(context, at, { segments }, colors) {
  const rows = { 1: 0, 0: 1, "-1": 2 }, third = at.height / 3;
  drawFrame(context, at, "itinerary", colors, []);
  context.textAlign = "right";
  context.fillStyle = colors.soft;
  for (const [mode, name] of [[1, "slip+"], [0, "stick"], [-1, "slip\u2212"]]) {
    context.fillText(name, MARGIN.left - 4, at.top + third * (rows[mode] + 0.5) + 4);
  }
  for (const { start, duration } of segments) {
    const x = at.x(start.t), wide = Math.max(1, at.x(start.t + duration) - x);
    context.fillStyle = colors.modes[start.mode][0];
    context.fillRect(x, at.top + third * rows[start.mode] + 1, wide, third - 2);
    line(context, [[x, at.top], [x, at.top + at.height]], colors.line, 1);
  }
}

/* Without a force that changes: |E/E_cr - 1| on a logarithmic scale, above E_cr full, below dashed. Else E/E_cr itself. */
function drawEnergy(context, at, solution, parts, colors) {
  const energy = curveOf(parts, (one) => energyAbout(solution, one));
  if (solution.force.amplitude !== 0) {
    const own = chart(at.top, at.height, at.width, at.until, 0, Math.max(1.2, spread([energy])[1]));
    drawFrame(context, own, "energy E/E_cr: the dashed line is at 1", colors, ticks(0, own.high, 4));
    drawCurve(context, own, [[0, 1], [at.until, 1]], colors.ray, 1.5, [5, 3]);
    drawCurve(context, own, energy, colors.ink, 1.5);
    return;
  }
  const level = energy.map(([t, value]) => [t, Math.abs(value - 1) < 1e-15 ? NaN : Math.log10(Math.abs(value - 1))]);
  const [low, high] = spread([level]), least = Number.isFinite(low) ? Math.max(-15, Math.floor(low)) : -3;
  const own = chart(at.top, at.height, at.width, at.until, least, Number.isFinite(high) ? Math.max(least + 1, Math.ceil(high)) : 0);
  const marks = ticks(own.low, own.high, 4).filter(Number.isInteger), title = "distance from E_cr, |E/E_cr \u2212 1|: ";
  drawFrame(context, own, `${title}above full, below dashed`, colors, marks, (one) => `1e${shown(one)}`);
  for (const side of [1, -1]) {
    for (const run of runsOf(level, energy.map(([, value]) => Math.sign(value - 1) === side))) {
      drawCurve(context, own, run, side > 0 ? colors.ink : colors.ray, 1.5, side > 0 ? [] : [5, 3]);
    }
  }
}

/* The unbroken runs of finite points that `kept` keeps. */
function runsOf(points, kept) {
  const runs = [[]];
  points.forEach((point, n) => {
    if (kept[n] && Number.isFinite(point[1])) runs[runs.length - 1].push(point);
    else if (runs[runs.length - 1].length) runs.push([]);
  });
  return runs;
}
