/* The pair in reduced coordinates: X = x1/L, V = v/(L Omega), tau = Omega t, load p = f - X - 2 zeta V1, S0: |p| <= 1.
   Slip of sign s: q X'' + 2 zeta X' + X = f - r s, V2' = s. Stick: X'' = p, the load itself.
   f = r u/b; u = b (constant + amplitude sin(omega tau)). The start of a motion is {t, mode, X, V1, V2, x2}. */

const STICK = 0, TIE = 1e-13;

function pairOf({ ratio, zeta }) {
  const q = ratio / (1 + ratio);
  return { q, r: 1 / (1 + ratio), zeta };
}

function forceOf({ constant, amplitude, omega }, r) {
  return { constant: r * constant, amplitude: r * amplitude, omega };
}

function forceAt(force, t) {
  return force.constant + force.amplitude * Math.sin(force.omega * t);
}

function forceRate(force, t, n) {
  return sineDerivative({ amplitude: force.amplitude, omega: force.omega, phase: 0 }, t, n);
}

/* Which motion follows on v1 = v2 where the load is p: the sign of v1 - v2. */
function modeOnSurface(pair, force, literal, t, V, p) {
  if (literal) return STICK;
  const side = Math.sign(p);
  if (Math.abs(Math.abs(p) - 1) > TIE) return Math.abs(p) < 1 ? STICK : side;
  const rate = forceRate(force, t, 1) - V - 2 * pair.zeta * p;
  if (Math.abs(rate) > TIE) return rate * side > 0 ? side : STICK;
  const bend = forceRate(force, t, 2) - p - 2 * pair.zeta * rate;
  return bend * side > 0 ? side : STICK;
}

/* A motion from its start: the oscillator, where it rests, and what is known exactly of its guard. */
function motionOf(pair, force, start) {
  const { q, r, zeta } = pair, s = start.mode, gain = s === STICK ? 1 : 1 / q;
  const sine = { amplitude: force.amplitude, omega: force.omega, phase: force.omega * start.t };
  const of = oscillator(zeta * gain, gain, gain, sine);
  const rest = force.constant - s * r, y0 = start.X - rest;
  const reach = Math.max(Math.sqrt(of.k), 2 * of.delta, force.amplitude ? force.omega : 0);
  // Taylor coefficients at the start: there the guard of a slip from the edge of S0 has a double root, which closed forms
  // would lose to rounding
  const list = continued(of, [y0, start.V1], 0, 26);
  if (start.leaves) list[2] = s;
  let factorial = 1;
  const series = list.map((value, n) => value / (factorial *= n || 1));
  const at = (t, count) => (t * reach < 1 ? taylor(series, t, count) : derivatives(of, y0, start.V1, t, count));
  return { of, at, rest, reach, series };
}

/* The first `count` derivatives at t of a series. */
function taylor(series, t, count) {
  const found = [];
  for (let order = 0, list = series; order < count; order += 1) {
    found.push(list.reduceRight((sum, one) => sum * t + one, 0));
    list = list.slice(1).map((one, n) => one * (n + 1));
  }
  return found;
}

/* The guard s (V1 - V2) of a slip: [g, g', g'', a bound of |g'''|] at t after its start. */
function slipGuard(motion, start, span) {
  const { of, at, series, reach } = motion, s = start.mode, drive = Math.abs(of.sine.amplitude) * of.sine.omega ** 3;
  const gap = start.leaves || start.V1 === start.V2 ? 0 : s * (start.V1 - start.V2);
  const coefficients = series.slice(1).map((one, n) => s * one * (n + 1));
  coefficients[0] = gap;
  coefficients[1] = start.leaves ? 0 : coefficients[1] - 1;
  return (t) => {
    const y = at(t, 5), bound = laterBound(of, y[3], y[4], drive, span);
    if (t * reach < 1) return [[...taylor(coefficients, t, 2), s * y[3], bound]];
    return [[s * (y[1] - start.V2) - t, s * y[2] - 1, s * y[3], bound]];
  };
}

/* The room 1 - p and 1 + p that the load of a stick phase has. */
function stickGuards(motion, span) {
  const { of, at } = motion, drive = Math.abs(of.sine.amplitude) * of.sine.omega ** 4;
  return (t) => {
    const y = at(t, 6), bound = laterBound(of, y[4], y[5], drive, span);
    return [[1 - y[2], -y[3], -y[4], bound], [1 + y[2], y[3], y[4], bound]];
  };
}

/* The end of a motion: {t, side} or null where it lasts until `left` is over. */
function endOf(motion, start, left, literal, force) {
  const free = force.amplitude === 0;
  const span = free ? Infinity : 1 / Math.max(Math.sqrt(motion.of.k), force.omega);
  if (start.mode !== STICK) return firstRoot(slipGuard(motion, start, span), left, span);
  if (literal) return null;
  const found = firstRoot(stickGuards(motion, span), left, span, (t) => holdsForEver(motion, t));
  return found && { t: found.t, side: found.which === 0 ? 1 : -1 };
}

/* Whether a stick phase certainly never ends. Of its load p the free part never grows, p^2 + p'^2, and the rest is the
   steady response to the sine. At the edge, on the orbit E = E_cr, the pair turns back. */
function holdsForEver({ of, at }, t) {
  const y = at(t, 4), { amplitude, omega } = of.sine;
  if (amplitude === 0) return y[2] * y[2] + y[3] * y[3] <= 1;
  const [place, speed, size] = steadyResponse(of, t), square = omega * omega;
  return Math.hypot(y[2] + square * place, y[3] + square * speed) + square * size < 1 - 1e-9;
}

/* The state at t after the start of a motion. */
function stateAt(segment, t) {
  const { start, motion } = segment, [y, v] = motion.at(t, 2), s = start.mode, X = y + motion.rest;
  const slid = s === STICK ? X - start.X : start.V2 * t + s * t * t / 2;
  return { t: start.t + t, X, V1: v, V2: s === STICK ? v : start.V2 + s * t, x2: start.x2 + slid };
}

function loadOf(pair, force, { t, X, V1 }) {
  return forceAt(force, t) - X - 2 * pair.zeta * V1;
}

/* E/E_cr of a state. */
function energyOf({ q, r }, { X, V1, V2 }) {
  return X * X + q * V1 * V1 + r * V2 * V2;
}

/* The start of the motion that follows an event, the state snapped to what it is exactly. */
function following(pair, force, literal, before, end, state) {
  const { X, V2, x2 } = state, t = state.t;
  if (before.mode === STICK) {
    const snapped = forceAt(force, t) - 2 * pair.zeta * V2 - end.side;
    return { t, mode: end.side, X: snapped, V1: V2, V2, x2, leaves: true };
  }
  const here = { t, X, V1: V2, V2, x2 };
  return { ...here, mode: modeOnSurface(pair, force, literal, t, V2, loadOf(pair, force, here)) };
}

function firstStart(pair, force, literal, { X, V1, V2 }) {
  const here = { t: 0, X, V1, V2, x2: 0 }, p = loadOf(pair, force, here);
  if (V1 !== V2) return { ...here, mode: Math.sign(V1 - V2) };
  const mode = modeOnSurface(pair, force, literal, 0, V1, p);
  return { ...here, mode, leaves: mode !== STICK && Math.abs(Math.abs(p) - 1) <= TIE };
}

/* Solve a scene: {pair, force, segments, capped}. Segments are exact motions joined by events; nothing is sampled.
   scene: ratio m1/m2, zeta, X, V1, V2 at the start, constant, amplitude (both u/b), omega, until, literal. */
function solve(scene, most = 4000) {
  const pair = pairOf(scene), force = forceOf(scene, pair.r), segments = [];
  let start = firstStart(pair, force, scene.literal, scene);
  while (segments.length <= most) {
    const motion = motionOf(pair, force, start), left = scene.until - start.t;
    const end = endOf(motion, start, left, scene.literal, force);
    const segment = { start, motion, duration: end ? end.t : left };
    segments.push(segment);
    if (!end) return { scene, pair, force, segments, capped: false };
    start = following(pair, force, scene.literal, start, end, stateAt(segment, end.t));
  }
  return { scene, pair, force, segments, capped: true };
}

/* The state of a solution at a time. */
function stateOf(solution, t) {
  const { segments } = solution;
  let low = 0, high = segments.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (segments[middle].start.t <= t) low = middle; else high = middle - 1;
  }
  return { ...stateAt(segments[low], Math.max(0, t - segments[low].start.t)), mode: segments[low].start.mode };
}
