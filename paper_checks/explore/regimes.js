/* What becomes of a motion, in a sentence, and the thresholds of a sinusoidal force. */

const shown = (value, digits = 4) => String(Number(value.toPrecision(digits))).replaceAll("-", "\u2212");

/* Amplitudes of u/b = A sin(omega tau): up to `stuck` some motion sticks permanently; one that slips without a stop, one
   way for half a period and then the other, needs at least `slipping`. */
function thresholds({ q, r, zeta }, omega) {
  const stuck = Math.hypot(1 - omega * omega, 2 * zeta * omega) / (omega * omega * r) * harmonic(zeta, omega);
  const stiff = Math.hypot(1 - q * omega * omega, 2 * zeta * omega);
  if (stiff < 1e-9) return { stuck, slipping: 4 / Math.PI };
  const half = Math.PI / omega, fade = zeta / q, drop = Math.exp(-2 * fade * half);
  const [cosine, sine] = overHalf(fade, 1 / q, half);
  // every hyperbolic function over exp(fade half), which would overflow
  const below = (1 + drop) / 2 + cosine, h = -((1 - drop) / 2 - fade * sine) / below, rate = -sine / (q * below);
  const along = half / (2 * r) - rate, across = (1 / r - h - 2 * zeta * rate) / (q * omega);
  return { stuck, slipping: stiff / omega * Math.hypot(along, across) };
}

/* Without a damper and with Omega an odd multiple of omega a free oscillation flattens the peaks of the load. */
function harmonic(zeta, omega) {
  const multiple = Math.round(1 / omega), fits = Math.abs(multiple * omega - 1) < 1e-12;
  return zeta === 0 && fits && multiple % 2 === 1 && multiple > 1 ? 1 / Math.cos(Math.PI / (2 * multiple)) : 1;
}

/* exp(-fade t) times cos and sin/rate of rate t, rate^2 = k - fade^2, or their hyperbolic counterparts. */
function overHalf(fade, k, t) {
  const [C, S] = freeMotion({ delta: fade, k, square: k - fade * fade }, t);
  return [C - fade * S, S];
}

/* {title, text, row}: what this run came to; the row of the ledger has what is said of all runs, and its proof. */
function regimeOf(solution) {
  const { scene, force, segments, capped } = solution;
  if (capped) return { title: "Too many events", text: `The first ${segments.length} events are shown. Choose a shorter run.` };
  if (scene.literal) return literalRegime(solution);
  return force.amplitude === 0 ? freeRegime(solution) : drivenRegime(solution);
}

function literalRegime({ segments }) {
  const last = segments[segments.length - 1];
  if (last.start.mode !== STICK) return { title: "Still slipping", text: "The bodies have not yet had the same velocity." };
  return { title: "Stuck by definition", text: `From τ = ${shown(last.start.t)} on the bodies stick: with sgn(0) = 0 read literally, v1 = v2 is never left, whatever force that takes.` };
}

function freeRegime(solution) {
  const { scene, pair, segments } = solution, last = segments[segments.length - 1];
  const energy = energyAbout(solution, last.start), from = `From τ = ${shown(last.start.t)} on`;
  if (last.start.mode === STICK && (holdsForEver(last.motion, 0) || (pair.zeta === 0 && energy <= 1))) {
    const rest = pair.zeta > 0 ? "and come to rest" : `and oscillate as one body with E/E_cr = ${shown(energy)} ≤ 1`;
    return { title: segments.length > 1 ? "Merges" : "Sticks permanently", text: `${from} the bodies stick permanently ${rest}.` };
  }
  const count = `${segments.length - 1} events`;
  if (pair.zeta > 0) return { title: "Not settled yet", text: `${count} so far. Damping takes the energy; let it run longer.` };
  const touched = segments.some(({ start }) => start.V1 === start.V2), excess = energy - 1;
  if (touched && pair.q / pair.r > EXPLORE.criticalRatio) {
    return { title: "Creeps", text: `${count} so far. E/E_cr falls towards 1 and never reaches it: for m1/m2 above ${shown(EXPLORE.criticalRatio, 6)} nothing that has met S above E_cr merges.`, row: "critical-mass-ratio" };
  }
  if (segments.some(({ start }) => start.mode === STICK) && excess <= pair.q * (Math.PI / 2 - 1) ** 2) {
    return { title: "Creeps", text: `${count} so far. E/E_cr − 1 = ${shown(excess)} is at most q (π/2 − 1)² = ${shown(pair.q * (Math.PI / 2 - 1) ** 2)}: the pair never merges.`, row: "no-merging-near-critical" };
  }
  return { title: "Not merged yet", text: `${count} so far; E/E_cr = ${shown(energy)} in this run. It may merge later; let it run longer.` };
}

/* E/E_cr, the spring's part measured from where a constant force puts the centre of S0. */
function energyAbout({ pair, force }, state) {
  return energyOf(pair, { ...state, X: state.X - force.constant });
}

function drivenRegime(solution) {
  const { scene, pair } = solution, period = 2 * Math.PI / scene.omega, bound = thresholds(pair, scene.omega);
  const limits = `u/b = ${shown(Math.abs(scene.amplitude))}: at this frequency some motion sticks permanently up to ${shown(bound.stuck)}; slipping without a stop, one way for half a period and then the other, needs at least ${shown(bound.slipping)}.`;
  const known = { row: "entrainment-threshold" };
  if (scene.until < 2 * period) return { title: "Driven", text: `${limits} The run is shorter than two periods of the force.`, ...known };
  const { stuck, stops } = lastPeriod(solution, period), repeats = repetition(solution, period);
  const again = repeats < 1e-6 ? "The last two periods agree to a millionth." : `Over the last period the state has changed by ${shown(repeats, 2)}: it is still settling.`;
  const last = solution.segments[solution.segments.length - 1];
  if (stuck === 1) return { title: holdsForEver(last.motion, last.duration) ? "Entrained" : "Stuck so far", text: `The pair moves as one body throughout the last period. ${again} ${limits}`, ...known };
  if (stuck === 0) return { title: "Slips all the time", text: `No stick phase in the last period. ${again} ${limits}`, ...known };
  return { title: "Stick and slip", text: `${stops} stick phase${stops === 1 ? "" : "s"} in the last period, ${shown(100 * stuck, 3)} % of the time. ${again} ${limits}`, ...known };
}

/* The share of the last period that is stuck, and how many stick phases lie in it. */
function lastPeriod({ scene, segments }, period) {
  const from = scene.until - period, inside = segments.filter(({ start, duration }) => start.t + duration > from && start.mode === STICK);
  const time = inside.reduce((sum, { start, duration }) => sum + start.t + duration - Math.max(start.t, from), 0);
  return { stuck: inside.length === 1 && time > period * (1 - 1e-9) ? 1 : time / period, stops: inside.length };
}

/* How far the state at the end is from that one period before. */
function repetition(solution, period) {
  const now = stateOf(solution, solution.scene.until), then = stateOf(solution, solution.scene.until - period);
  return Math.max(...["X", "V1", "V2"].map((name) => Math.abs(now[name] - then[name])));
}
