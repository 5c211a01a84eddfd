/* The first root of a function, with no root ever stepped over: where a bound of the third derivative is known, the
   cubic below the function says how far it is certainly positive. The step is that far; near a root it converges. */

/* How far g + g1 h + g2 h^2/2 - bound h^3/6 stays >= 0 from h = 0 on, at most `span`. */
function certainStep(g, g1, g2, bound, span) {
  const below = (h) => g + h * (g1 + h * (g2 / 2 - h * bound / 6));
  const lean = g2 * g2 + 2 * bound * g1;
  let low = 0, high = span;
  if (bound > 0 && lean > 0) {
    const root = Math.sqrt(lean);
    // both extrema of the cubic, the smaller one without cancellation
    const far = g2 >= 0 ? (g2 + root) / bound : -2 * g1 / (g2 - root);
    const near = g2 >= 0 ? -2 * g1 / (g2 + root) : (g2 - root) / bound;
    if (near > 0 && near < span && below(near) <= 0) high = near;
    else if (far > 0 && near < span) low = Math.min(far, span);
  }
  if (below(high) > 0) return high;
  for (let turn = 0; turn < 60 && low < high; turn += 1) {
    const middle = (low + high) / 2;
    if (middle === low || middle === high) break;
    if (below(middle) > 0) low = middle; else high = middle;
  }
  return low;
}

const TOUCH = 1e-13;

/* How far beyond a root where the function only touches 0 it has left rounding behind; 0 where it goes through. */
function beyondTouch([, g1, g2]) {
  return g2 > 0 && g1 * g1 <= 2 * g2 * TOUCH ? 2 * (Math.abs(g1) / g2 + Math.sqrt(2 * TOUCH / g2)) : 0;
}

/* The first t in (0, end] where one of several guards goes through 0: {t, which}; null if none does.
   jets(t) returns for each guard [g, g', g'', bound of |g'''| for the next `span`]; `done` may stop the search. */
function firstRoot(jets, end, span, done = () => false) {
  let t = 0;
  for (let count = 0; count < 100000 && t < end; count += 1) {
    const all = jets(t);
    if (done(t)) return null;
    let step = Math.min(span, end - t), which = -1;
    all.forEach(([g, g1, g2, bound], index) => {
      const certain = g <= 0 && t > 0 ? 0 : certainStep(Math.max(g, 0), g1, g2, bound, step);
      if (certain < step) { step = certain; which = index; }
    });
    if (which < 0 && t + step >= end) return null;
    if (which >= 0 && step <= 4e-16 * t) {
      const over = beyondTouch(all[which]);
      if (!over) return { t: polished(t, all[which], end), which };
      step = over;
    }
    t += step;
  }
  if (t >= end) return null;
  throw new Error("a motion has too many pieces");
}

/* One step of Newton's method from next to the root, where that is a small one. */
function polished(t, [g, g1], end) {
  const step = -g / g1;
  return Number.isFinite(step) && Math.abs(step) < 1e-12 * t ? Math.min(t + step, end) : t;
}
