"""Compiled code gives the numbers of the plain text, within their bounds; who compiles when, and says so."""

import os
import subprocess
import sys
import threading

import numpy as np
import pytest
from sixty_digits import forced_scene

from numerics.arithmetic import compiled as compiling
from numerics.arithmetic.compiled import can_compile
from numerics.arithmetic.float64 import Float64
from numerics.trajectory.run import run_scene

needs_numba = pytest.mark.skipif(not can_compile(), reason="numba is not installed")


@needs_numba
@pytest.mark.parametrize("name", ["many-causes", "damping-heavy", "resonance-in-slip", "sweep", "friction-by-pieces"])
def test_a_forced_run_has_the_same_answers(name, monkeypatch):
    fast = run_scene(forced_scene(name), Float64(), 1000)
    monkeypatch.setattr("numerics.linear.engine.compiled", np.errstate(all="ignore"))
    plain = run_scene(forced_scene(name), Float64(), 1000)
    assert plain.modes == fast.modes
    assert (abs(plain.event_times - fast.event_times) <= plain.accuracy.t + fast.accuracy.t).all()
    assert (abs(plain.event_states.T - fast.event_states.T) <= plain.accuracy.y + fast.accuracy.y).all()


def test_one_process_compiles_while_the_others_wait(tmp_path):
    pytest.importorskip("fcntl")
    second_is_in = threading.Event()

    def wait_for_it():
        with compiling._alone(tmp_path / "one.lock"):  # opens the file anew, as another process does
            second_is_in.set()

    second = threading.Thread(target=wait_for_it)
    with compiling._alone(tmp_path / "one.lock"):
        second.start()
        assert not second_is_in.wait(0.2)
    second.join()
    assert second_is_in.is_set()


COMPILES = """
from numerics.arithmetic.compiled import compiled
from numerics.linear.record import END_ROW, ROW, finish
import numpy as np
for _ in range(2):
    compiled(finish)(np.zeros((2, ROW)), np.zeros(END_ROW), 0, 0, 0)
"""


@needs_numba
def test_compiling_is_said_once_and_kept_where_it_can_be(tmp_path):
    """A folder that cannot be written does not keep anyone from compiling; each time it is said."""
    (tmp_path / "file").write_text("")

    def said(cache):
        environment = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path / cache)}
        done = subprocess.run(
            [sys.executable, "-c", COMPILES], capture_output=True, text=True, check=True, env=environment
        )
        return done.stderr.count("numba compiles the solver")

    assert [said("new"), said("new"), said("file"), said("file")] == [1, 0, 1, 1]
