"""Many scenes on a surface: the answers of `solve`, row by row, and a status where it has none."""

import signal
import subprocess
import sys
from importlib.util import find_spec

import numpy as np
import pytest
from batch_numbers import row_numbers
from hypothesis import given
from hypothesis import strategies as st
from scene_files import scenes_in
from strategies import fewer, plane_scenes

from numerics import Force, NumericsError, PlanePair, PlaneScene, solve, solve_scenes
from numerics.trajectory.comparison import distance
from numerics.trajectory.status import Status

PAIR = PlanePair(1, 1, [200, 120], ["0.5", "0.4"], 1)
PUSHED = [PlaneScene(PAIR, "0.5", x1=["0.012", "0.002"], force=[Force.sine(u, 9)]) for u in (1, 2, 3)]
ON_THE_EDGE, BEYOND_FLOATS = (scenes_in("surfaces")[name] for name in ("on-the-edge", "beyond-floats"))
needs_joblib = pytest.mark.skipif(not find_spec("joblib"), reason="joblib is not installed")


@fewer(5)
@given(st.lists(plane_scenes(), max_size=2))
def test_each_row_is_what_solve_says_of_its_scene(drawn):
    scenes = [one for one in [*drawn, PUSHED[0]] if one.pair.axes == [*drawn, PUSHED[0]][0].pair.axes]
    found = solve_scenes(scenes, keep_events=2, jobs=1)
    for row, scene in enumerate(scenes):
        if found.status[row] in {Status.SEQUENCE_OPEN, Status.OUT_OF_RANGE}:
            with pytest.raises(NumericsError) as refused:
                solve(scene)
            assert found.message[row] == str(refused.value)
            assert np.isnan(found.y[:, row]).all()
            continue
        one = solve(scene)
        assert (found.status[row], found.mode[row], found.digits[row]) == (one.status, one.final_mode, one.digits)
        assert not any(found.event_mode[row][len(one.events) :])
        with one.context():
            for _, x, bound, true in row_numbers(found, row, one):
                assert distance(x, true).upper() <= bound < 1e-12 * max(1, abs(x))


def test_what_is_not_decided_or_beyond_floats_is_a_status_of_its_row():
    scenes, heard = [PUSHED[0], ON_THE_EDGE, BEYOND_FLOATS], []
    found = solve_scenes(scenes, jobs=1, progress=lambda *one: heard.append(one))
    assert found.status.tolist() == [Status.REACHED_HORIZON, Status.SEQUENCE_OPEN, Status.OUT_OF_RANGE]
    assert found.success.tolist() == [True, False, False]
    assert "inside the friction set" in found.message[1]
    assert np.isnan(found.energy).tolist() == [False, True, True]
    assert (found.event_mode.shape, found.event_mode.dtype) == ((3, 0), object)  # texts, though none is kept
    assert heard == [(1, 3), (2, 3), (3, 3)]
    capped = [*PUSHED, PUSHED[0].replace(pair=PlanePair(1, 1, 200, "0.5", shape="box"))]
    assert {*solve_scenes(capped, jobs=1, max_events=1).status} == {Status.EVENT_LIMIT}


@needs_joblib
@pytest.mark.slow
def test_processes_change_nothing():
    alone, together = (solve_scenes(PUSHED, jobs=jobs, keep_events=3) for jobs in (1, 2))
    for name, array in alone.results.items():
        assert np.array_equal(array, together.results[name])
    assert np.array_equal(alone.event_y, together.event_y, equal_nan=True)


@needs_joblib
@pytest.mark.slow
def test_a_sweep_is_interrupted():
    code = (
        "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)\n"
        "from numerics import Force, PlanePair, PlaneScene, solve_scenes\n"
        "pair = PlanePair(1, 1, [200, 120], ['0.5', '0.4'], 1)\n"
        "scene = PlaneScene(pair, 1000, x1=['0.012', '0.002'], force=[Force.sine(3, 5)])\n"
        "short = PlaneScene(pair, '0.01', x1=['0.012', '0.002'])\n"
        "solve_scenes([short, scene, scene], jobs=2, progress=lambda *_: print('begun', flush=True))\n"
    )
    process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "begun\n"
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=60)
    assert process.returncode != 0
    assert errors.rstrip().endswith("KeyboardInterrupt")
