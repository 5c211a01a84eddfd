/* The pair on a surface, seen from above, with round friction: X = x1/L, V = v/(L Omega), vectors [x, y], tau = Omega t.
   Slip, s = V1 - V2 not 0: q V1' = p - r e, V2' = e = s/|s|, so q s' = p - e. Stick: X'' = p, as long as |p| <= 1.
   p = f - X - 2 zeta V1, f = r u/b; u = b size (cos, sin)(omega tau + angle): it goes round, or stays where omega is 0.
   A slip is a chain of Taylor polynomials in time, a stick phase a closed form. */

const ORDER = 16, LEFT_OUT = 1e-12, NEAR = 1e-9, NONE = 1e-14, LOOKS = 32, MOST_PIECES = 4000;

const dot = (a, b) => a[0] * b[0] + a[1] * b[1];
const size = (a) => Math.hypot(a[0], a[1]);
const times = (k, a) => [k * a[0], k * a[1]];
const plus = (a, b, k = 1) => [a[0] + k * b[0], a[1] + k * b[1]];
const across = (a) => [-a[1], a[0]];

function turningForce({ size: most, omega, angle }, r) {
  return { size: r * most, omega, angle };
}

/* The n-th derivative of f at t. */
function turned({ size: most, omega, angle }, t, n = 0) {
  const at = omega * t + angle + n * Math.PI / 2;
  return times(most * omega ** n, [Math.cos(at), Math.sin(at)]);
}

function loadAbove(pair, force, { t, X, V1 }) {
  return plus(plus(turned(force, t), X, -1), V1, -2 * pair.zeta);
}

/* What follows on V1 = V2: {normal, rate} of the slip that begins there, |s|' = rate and 0 at the edge; null: it sticks. */
function leavesAbove(pair, force, state) {
  const p = loadAbove(pair, force, state), most = size(p), normal = times(1 / most, p);
  if (Math.abs(most - 1) > TIE) return most < 1 ? null : { normal, rate: (most - 1) / pair.q };
  const rising = plus(plus(turned(force, state.t, 1), state.V1, -1), p, -2 * pair.zeta);
  return dot(rising, p) > TIE ? { normal, rate: 0 } : null;
}

/* Taylor coefficients of a slip from a state, where s is not 0; or of one that leaves s = 0. There the direction e is
   found order by order: across the normal q s' = p - e gives it, along it |e| = 1. At the edge of the friction the series
   diverges; it is cut where its last terms are small. */
function slipSeries({ q, r, zeta }, force, { t, X, V2, S, x2 }, leaves) {
  const a = { X: [X], V2: [V2], S: [S], x2: [x2], P: [], E: [], R: [leaves ? 0 : size(S)] };
  const side = leaves && across(leaves.normal);
  for (let k = 0, factorial = 1; k < ORDER; factorial *= k += 1) {
    const V1 = plus(a.V2[k], a.S[k]);
    a.P.push(plus(plus(times(1 / factorial, turned(force, t, k)), a.X[k], -1), V1, -2 * zeta));
    const later = (from) => sumOver(from, k, (j) => times(a.R[j], a.E[k - j]));
    if (!leaves) a.E.push(times(1 / a.R[0], plus(a.S[k], later(1), -1)));
    else if (k === 0) a.E.push(leaves.normal);
    else {
      const known = dot(side, sumOver(2, k, (j) => times(a.R[j], a.E[k + 1 - j])));
      const aside = (dot(side, a.P[k]) - q * (k + 1) * known) / (1 + q * (k + 1) * a.R[1]);
      const along = -sumOver(1, k - 1, (j) => [dot(a.E[j], a.E[k - j]) / 2, 0])[0];
      a.E.push(plus(times(aside, side), leaves.normal, along));
    }
    const power = sumOver(0, k, (j) => [dot(a.P[j], a.E[k - j]), 0])[0] - (k === 0 ? 1 : 0);
    a.R.push(leaves && k === 0 ? leaves.rate : power / (q * (k + 1)));
    a.S.push(leaves && k === 0 ? times(leaves.rate, leaves.normal) : times(1 / (q * (k + 1)), plus(a.P[k], a.E[k], -1)));
    a.V2.push(times(1 / (k + 1), a.E[k]));
    a.X.push(times(1 / (k + 1), V1));
    a.x2.push(times(1 / (k + 1), a.V2[k]));
  }
  return a;
}

function sumOver(from, to, term) {
  let found = [0, 0];
  for (let j = from; j <= to; j += 1) found = plus(found, term(j));
  return found;
}

const valueAt = (list, h) => list.reduceRight((sum, one) => plus(one, sum, h), [0, 0]);
const numberAt = (list, h) => list.reduceRight((sum, one) => sum * h + one, 0);

/* How far a series reaches: its last two terms are LEFT_OUT of the first one that is there. */
function reachOfSeries(list, most, first = 0) {
  const reaches = [ORDER - 1, ORDER].map((k) => (LEFT_OUT * most / size(list[k])) ** (1 / (k - first)));
  return Math.min(...reaches);
}

/* One polynomial of a slip: {series, length, ends}. It stops where |s| falls to 0: a straight slip runs through that
   unseen, as its direction does not change, so |s| is looked at inside the step, without the root where it began. */
function slipStep(pair, force, state, leaves, left) {
  const series = slipSeries(pair, force, state, leaves), first = leaves ? (leaves.rate > 0 ? 1 : 2) : 0;
  const wide = 1 + size(state.X) + size(state.V2);
  let length = Math.min(left, reachOfSeries(series.S, size(series.S[first]), first), ...["X", "V2"].map((name) => reachOfSeries(series[name], wide)));
  const speed = series.R.slice(first);
  for (let n = 1; n <= LOOKS; n += 1) {
    if (numberAt(speed, length * n / LOOKS) > 0) continue;
    let low = length * (n - 1) / LOOKS, high = length * n / LOOKS;
    for (let turn = 0; turn < 60; turn += 1) {
      const middle = (low + high) / 2;
      if (numberAt(speed, middle) > 0) low = middle; else high = middle;
    }
    return { series, length: low, ends: true };
  }
  return { series, length, ends: false };
}

function stateOfSeries({ series, t }, h) {
  const [X, V2, S, x2] = ["X", "V2", "S", "x2"].map((name) => valueAt(series[name], h));
  return { t: t + h, X, V1: plus(V2, S), V2, S, x2 };
}

/* A slip to its end: {pieces, duration, end}; `end` is null where the run is over first, or `most` pieces are: `cut`. Close to its end
   G = |s| + p.s falls at the rate (1 - p.p)/q, which tells the time that is left to the second order in |s|. */
function slipAbove(pair, force, start, leaves, until, most) {
  const pieces = [];
  for (let state = start; ;) {
    if (pieces.length >= most) return { pieces, duration: state.t - start.t, end: null, cut: true };
    const step = slipStep(pair, force, state, pieces.length === 0 ? leaves : null, until - state.t), piece = { ...step, t: state.t };
    pieces.push(piece);
    state = stateOfSeries(piece, step.length);
    if (state.t >= until) return { pieces, duration: until - start.t, end: null };
    const p = loadAbove(pair, force, state), speed = size(state.S), falls = speed - dot(p, state.S), inside = 1 - dot(p, p);
    // where friction cannot hold the load, a slip that comes that close turns around, unless it is straight
    if (!step.ends && (speed > (inside > 0 ? NEAR : NONE) || falls <= 0)) continue;
    const left = inside > 0 ? pair.q * (speed + dot(p, state.S)) / inside : pair.q * speed * speed / falls;
    const passed = Number.isFinite(left) ? left : 0, V = plus(plus(times(pair.r, state.V2), times(pair.q, state.V1)), p, passed);
    const end = { t: state.t + passed, X: plus(state.X, V, passed), V1: V, V2: V, S: [0, 0], x2: plus(state.x2, V, passed) };
    return { pieces, duration: end.t - start.t, end };
  }
}

/* The axes of a stick phase: two oscillators, and where they rest. */
function stuckAxes(pair, force, start) {
  const moves = force.omega !== 0 && force.size !== 0;
  return [0, 1].map((axis) => {
    const phase = force.omega * start.t + force.angle + (axis === 0 ? Math.PI / 2 : 0);
    const of = oscillator(pair.zeta, 1, 1, { amplitude: moves ? force.size : 0, omega: force.omega, phase });
    const rest = moves ? 0 : turned(force, 0)[axis];
    return { of, rest, y0: start.X[axis] - rest, v0: start.V1[axis] };
  });
}

/* The greatest length of a cos + b sin: the longer half axis of an ellipse. */
function longest(a, b) {
  const [one, two] = [dot(a, a), dot(b, b)];
  return Math.sqrt((one + two + Math.hypot(one - two, 2 * dot(a, b))) / 2);
}

/* A bound of the load from t on: the free part never grows along any direction, and the rest goes round with the force. */
function mostLoad(axes, t) {
  const jets = axes.map(({ of, y0, v0 }) => derivatives(of, y0, v0, t, 4)), { amplitude, omega } = axes[0].of.sine;
  if (amplitude === 0) return longest(jets.map((y) => y[2]), jets.map((y) => y[3]));
  const steady = axes.map(({ of }) => steadyResponse(of, t)), square = omega * omega;
  const free = [2, 3].map((n) => jets.map((y, axis) => y[n] + square * steady[axis][n - 2]));
  return longest(...free) + square * steady[0][2];
}

/* The guard 1 - p.p of a stick phase: [g, g', g'', a bound of |g'''|]. */
function stuckGuard(axes, span) {
  const { amplitude, omega } = axes[0].of.sine, drive = Math.abs(amplitude) * omega * omega;
  return (t) => {
    const jets = axes.map(({ of, y0, v0 }) => derivatives(of, y0, v0, t, 6)), at = (n) => jets.map((y) => y[n]);
    const bound = (n, most) => size(axes.map(({ of }, axis) => laterBound(of, jets[axis][n], jets[axis][n + 1], most, span)));
    const low = bound(2, drive), high = bound(4, drive * omega * omega), [p, p1, p2] = [at(2), at(3), at(4)];
    return [[1 - dot(p, p), -2 * dot(p, p1), -2 * (dot(p1, p1) + dot(p, p2)), 8 * low * high]];
  };
}

/* A stick phase to its end: {axes, duration, end}; null as `end`: it lasts until the run is over. */
function stuckAbove(pair, force, start, until) {
  const axes = stuckAxes(pair, force, start), { amplitude, omega } = axes[0].of.sine, segment = { start, axes };
  const span = amplitude === 0 ? Infinity : 1 / Math.max(1, omega);
  const found = firstRoot(stuckGuard(axes, span), until - start.t, span, (t) => mostLoad(axes, t) <= 1 + TIE);
  return { ...segment, duration: found ? found.t : until - start.t, end: found && stateAbove(segment, found.t) };
}

/* The state at h after the start of a motion. */
function stateAbove({ start, axes, pieces }, h) {
  if (pieces) {
    const piece = pieces.findLast((one) => one.t <= start.t + h) || pieces[0];
    return stateOfSeries(piece, Math.min(start.t + h - piece.t, piece.length)); // what follows the last one is less than rounding to the eye
  }
  const jets = axes.map(({ of, y0, v0 }) => derivatives(of, y0, v0, h, 2));
  const X = jets.map(([y], axis) => y + axes[axis].rest), V = jets.map(([, v]) => v);
  return { t: start.t + h, X, V1: V, V2: V, S: [0, 0], x2: plus(start.x2, plus(X, start.X, -1)) };
}

/* Solve a scene: {scene, pair, force, segments, capped}; a segment is {mode, start, duration, axes or pieces}. It is
   capped after so many motions, and after MOST_PIECES of slips: a second or so.
   scene: ratio m1/m2, zeta, X, V1, V2 (vectors) at the start, size, angle, omega of the force over b, until. */
function solveAbove(scene, most = 1000) {
  const pair = pairOf(scene), force = turningForce(scene, pair.r), segments = [];
  let state = { t: 0, X: scene.X, V1: scene.V1, V2: scene.V2, S: plus(scene.V1, scene.V2, -1), x2: scene.X };
  let mode = size(state.S) > 0 ? "slip" : "", leaves = null, room = MOST_PIECES;
  while (segments.length <= most) {
    if (!mode) [leaves, mode] = [leavesAbove(pair, force, state), ""];
    const slips = mode === "slip" || leaves !== null;
    const found = slips ? slipAbove(pair, force, state, leaves, scene.until, room) : stuckAbove(pair, force, state, scene.until);
    segments.push({ mode: slips ? "slip" : "stick", start: state, ...found });
    if (!found.end) return { scene, pair, force, segments, capped: Boolean(found.cut) };
    [state, mode, leaves] = [found.end, "", null];
    if (slips) room -= found.pieces.length;
    else {
      const p = loadAbove(pair, force, state);
      [mode, leaves] = ["slip", { normal: times(1 / size(p), p), rate: 0 }];
    }
  }
  return { scene, pair, force, segments, capped: true };
}

/* The state of a solution at a time, and its mode. */
function stateOfAbove({ segments }, t) {
  const segment = segments.findLast(({ start }) => start.t <= t) || segments[0];
  return { ...stateAbove(segment, Math.max(0, t - segment.start.t)), mode: segment.mode };
}

function energyAbove({ pair, force }, { X, V1, V2 }) {
  const x = force.omega === 0 ? plus(X, turned(force, 0), -1) : X;
  return dot(x, x) + pair.q * dot(V1, V1) + pair.r * dot(V2, V2);
}

/* Under a force that goes round: |u|/b up to which a stuck circle stays, and the speed at which the pair slips above it,
   |D_M + i rho omega D|^2 = (r omega^2 size)^2. */
function turningAnswer({ q, r, zeta }, { omega, size: most }) {
  const square = omega * omega, held = (1 - square) ** 2 + 4 * zeta * zeta * square, stiff = (1 - q * square) ** 2 + 4 * zeta * zeta * square;
  const half = 2 * zeta * r * square * square, gap = held - (r * square * most) ** 2, a = square * stiff;
  const edge = Math.sqrt(held) / (r * square), speed = gap < 0 ? -gap / (half + Math.sqrt(half * half - a * gap)) : 0;
  return { edge, speed };
}
