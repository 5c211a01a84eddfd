// The solver PROGRAM on SCENES, and with each of FAULTY in its place.
const made = (text) => new Function(`${text}
  return (scene) => {
    const { segments } = solve(scene, 20000), last = segments[segments.length - 1];
    const { X, V1, V2, x2 } = stateAt(last, last.duration);
    const modes = segments.map(({ start }) => start.mode), times = segments.map(({ start }) => start.t);
    const events = segments.slice(1).map(({ start }) => [start.t, start.X, start.V1]);
    return { modes, times, events, final: [X, V1, x2, V2] };
  };`)();
const tried = (run, scene) => { try { return run(scene); } catch (error) { return String(error); } };
const mirrored = (scene) => {
  const turned = ["X", "V1", "V2", "constant", "amplitude"].map((name) => [name, -scene[name]]);
  return { ...scene, ...Object.fromEntries(turned) };
};
const each = (text) => ({
  grid: SCENES.map((scene) => tried(made(text), scene)),
  catalogue: FORCED.map((scene) => tried(made(text), scene)),
  mirrored: FORCED.map((scene) => tried(made(text), mirrored(scene))),
});
return { right: each(PROGRAM), faulty: FAULTY.map(each) };
