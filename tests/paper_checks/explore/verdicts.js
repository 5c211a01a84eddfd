// What PROGRAM says of each of SCENES, with each of FAULTY in its place, and of each tie (pair, force, t, V, p) of TIES.
const made = (text) => new Function(`const EXPLORE = {criticalRatio: ${inertialPair.criticalRatio}};\n${text}
  return { said: (scene) => regimeOf(solve(scene, 20000)), share: (scene) => lastPeriod(solve(scene, 20000), 2 * Math.PI / scene.omega).stuck,
    tie: ({ pair, force, t, V, p }) => modeOnSurface(pair, force, false, t, V, p) };`)();
const each = (text) => {
  const of = made(text);
  return { said: SCENES.map(of.said), shares: SCENES.map((scene) => (scene.amplitude ? of.share(scene) : null)), ties: TIES.map(of.tie) };
};
return { right: each(PROGRAM), faulty: FAULTY.map(each) };
