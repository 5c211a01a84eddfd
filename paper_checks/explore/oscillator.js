/* y'' + 2 delta y' + k y = gain A sin(omega t + phase): exact flow from any state, for every damping and at resonance.
   All numbers are dimensionless. */

const sinc = (x) => (Math.abs(x) < 1e-4 ? 1 - x * x / 6 : Math.sin(x) / x);

/* An oscillator: delta, k, gain as above; the sine that drives it is {amplitude, omega, phase}. */
function oscillator(delta, k, gain, sine) {
  return { delta, k, gain, sine, square: k - delta * delta };
}

/* C and S of the free motion y = y0 C + v0 S; S' = C - 2 delta S and C' = -k S. */
function freeMotion({ delta, k, square }, t) {
  if (square > 0) {
    const rate = Math.sqrt(square), fade = Math.exp(-delta * t), S = fade * t * sinc(rate * t);
    return [fade * Math.cos(rate * t) + delta * S, S];
  }
  // the two rates are slow and slow + 2 lean; their product is k, so that neither is a difference of like numbers
  const lean = Math.sqrt(-square), slow = k / (delta + lean), fade = Math.exp(-slow * t);
  const S = lean * t < 1e-9 ? t * fade : fade * -Math.expm1(-2 * lean * t) / (2 * lean);
  return [fade + slow * S, S];
}

/* Response from rest to gain A sin(omega t + phase): [y, y'].  Undamped it is the beat, which knows no resonance. */
function response(of, t) {
  const { delta, k, gain, sine: { amplitude, omega, phase } } = of;
  if (amplitude === 0) return [0, 0];
  if (delta === 0) {
    const rate = Math.sqrt(k), sum = (rate + omega) * t / 2, gap = (rate - omega) * t / 2;
    const fast = sinc(sum), slow = sinc(gap), size = gain * amplitude * t / 2;
    return [
      size / rate * (fast * Math.cos(gap - phase) - slow * Math.cos(sum + phase)),
      size * (slow * Math.sin(sum + phase) + fast * Math.sin(phase - gap)),
    ];
  }
  const [y0, v0] = steadyResponse(of, 0), [y1, v1] = steadyResponse(of, t), [y, v] = homogeneous(of, -y0, -v0, t);
  return [y1 + y, v1 + v];
}

/* The response that repeats with the sine: [y, y', its largest |y|] at t; infinite at an undamped resonance. */
function steadyResponse({ delta, k, gain, sine: { amplitude, omega, phase } }, t) {
  const re = k - omega * omega, im = 2 * delta * omega, scale = gain * amplitude / (re * re + im * im);
  const sine = Math.sin(omega * t + phase), cosine = Math.cos(omega * t + phase);
  return [scale * (re * sine - im * cosine), scale * omega * (re * cosine + im * sine), Math.abs(scale) * Math.hypot(re, im)];
}

function homogeneous(of, y0, v0, t) {
  const [C, S] = freeMotion(of, t);
  return [y0 * C + v0 * S, v0 * (C - 2 * of.delta * S) - of.k * y0 * S];
}

/* The n-th derivative of the sine at t. */
function sineDerivative({ amplitude, omega, phase }, t, n) {
  return amplitude === 0 ? 0 : amplitude * omega ** n * Math.sin(omega * t + phase + n * Math.PI / 2);
}

/* y and its first `count` - 1 derivatives at t after a start (y0, v0); from the second on by the equation. */
function derivatives(of, y0, v0, t, count) {
  const [y, v] = homogeneous(of, y0, v0, t), [driven, speed] = response(of, t);
  return continued(of, [y + driven, v + speed], t, count);
}

/* The list of derivatives at t, begun with y and y', continued by the equation. */
function continued(of, list, t, count) {
  while (list.length < count) {
    const n = list.length;
    list.push(of.gain * sineDerivative(of.sine, t, n - 2) - 2 * of.delta * list[n - 1] - of.k * list[n - 2]);
  }
  return list;
}

/* A bound of the derivative after the last in `list`'s pair (a, a') for a time `span`: a'^2 + k a^2 grows only by the
   force, whose derivative in the equation of a is bounded by `drive`. */
function laterBound(of, a, rate, drive, span) {
  return Math.hypot(rate, Math.sqrt(of.k) * a) + (drive === 0 ? 0 : span * of.gain * drive);
}
