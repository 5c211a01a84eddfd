/* Time that passes: Play, Next event, To start, To end and a slider, the elements that `find` finds by their names.
   `run` knows how long it lasts, the next event, and how a time is shown; that returns the time in words. */

const calm = matchMedia("(prefers-reduced-motion: reduce)");

function playerOf(find, run) {
  const clock = find("time"), playing = find("play"), player = { t: 0 };
  let timer = 0;
  const show = () => {
    clock.setAttribute("aria-valuetext", run.show(player.t));
    clock.value = Math.round(1000 * player.t / run.until());
  };
  const go = (t) => { player.t = Math.max(0, Math.min(t, run.until())); show(); };
  const stop = () => {
    clearInterval(timer);
    cancelAnimationFrame(timer);
    timer = 0;
    playing.textContent = "Play";
  };
  const step = (t) => { go(t); if (player.t >= run.until()) stop(); };
  // smoothly in half a minute at most; from event to event where the reader wants less motion
  const play = () => {
    if (player.t >= run.until()) go(0);
    playing.textContent = "Pause";
    if (calm.matches) {
      timer = setInterval(() => step(run.next(player.t)), 1000);
      return;
    }
    const speed = Math.max(1.5, run.until() / 30);
    let before = performance.now();
    const frame = (instant) => {
      const passed = Math.min(0.1, (instant - before) / 1000);
      before = instant;
      step(player.t + speed * passed);
      if (timer) timer = requestAnimationFrame(frame);
    };
    timer = requestAnimationFrame(frame);
  };
  const jump = (to) => { stop(); go(to()); };
  playing.addEventListener("click", () => (timer ? stop() : play()));
  find("next").addEventListener("click", () => jump(() => run.next(player.t)));
  find("start").addEventListener("click", () => jump(() => 0));
  find("end").addEventListener("click", () => jump(run.until));
  clock.addEventListener("input", () => jump(() => run.until() * clock.value / 1000));
  return Object.assign(player, { go, stop, show, jump });
}

/* The first start of a motion after t, or the end. */
function nextStart({ segments, scene }, t) {
  const next = segments.find(({ start }) => start.t > t * (1 + 1e-12) + 1e-12);
  return next ? next.start.t : scene.until;
}
