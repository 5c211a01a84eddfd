// The solver PROGRAM of the second tab on SCENES, and with each of FAULTY in its place; the scenes as files.
const made = (text) => new Function(`${text}
  return (scene) => {
    const solution = solveAbove(scene), { X, V1, V2, x2 } = stateOfAbove(solution, scene.until);
    const modes = solution.segments.map(({ mode }) => mode), times = solution.segments.slice(1).map(({ start }) => start.t);
    return { modes, times, final: [X, V1, x2, V2], turning: turningAnswer(solution.pair, scene), file: surfaceFile(scene) };
  };`)();
const tried = (run, scene) => { try { return run(scene); } catch (error) { return String(error); } };
const each = (text) => SCENES.map((scene) => tried(made(text), scene));
return { right: each(PROGRAM), faulty: FAULTY.map(each) };
