"""Compiled code has the same bits as the plain text, or the same numbers within their bounds; who compiles when."""

import io
import threading

import numpy as np
import pytest
from hypothesis import example, given
from sixty_digits import forced_scene
from strategies import free_scenes

from numerics import OutOfRange, load_scene
from numerics.arithmetic import compiled as compiling
from numerics.arithmetic.compiled import can_compile, compiled
from numerics.arithmetic.float64 import Float64
from numerics.free.engine import begin_in_rows
from numerics.free.rows import solve_start
from numerics.linear.record import END_ROW, ROW
from numerics.trajectory.run import run_scene

FLOATS = Float64()
needs_numba = pytest.mark.skipif(not can_compile(), reason="numba is not installed")


@needs_numba
@pytest.mark.slow
def test_a_free_run_has_the_same_bits():
    @given(free_scenes())
    @example(load_scene("relative-motion-b05"))
    def check(case):
        rows, end = [[0.0] * ROW for _ in range(61)], [0.0] * END_ROW
        try:
            arguments = begin_in_rows(case)
            count = solve_start(*arguments, 60, rows, end)
        except (OutOfRange, ArithmeticError, ValueError):
            return
        fast, fast_end = np.zeros((61, ROW)), np.zeros(END_ROW)
        assert compiled(solve_start)(*arguments, 60, fast, fast_end) == count
        assert np.array_equal(rows, fast, equal_nan=True)
        assert np.array_equal(end, fast_end, equal_nan=True)

    check()


@needs_numba
@pytest.mark.parametrize("name", ["many-causes", "damping-heavy", "resonance-in-slip", "sweep", "friction-by-pieces"])
def test_a_forced_run_has_the_same_answers(name, monkeypatch):
    fast = run_scene(forced_scene(name), FLOATS, 1000)
    monkeypatch.setattr("numerics.linear.engine.compiled", lambda function: function)
    plain = run_scene(forced_scene(name), FLOATS, 1000)
    assert plain.modes == fast.modes
    assert (abs(plain.event_times - fast.event_times) <= plain.accuracy.t + fast.accuracy.t).all()
    assert (abs(plain.event_states.T - fast.event_states.T) <= plain.accuracy.y + fast.accuracy.y).all()


def test_one_process_compiles_while_the_others_wait(tmp_path):
    pytest.importorskip("fcntl")
    begins, may_end, second_is_in = threading.Event(), threading.Event(), threading.Event()

    def slow(types):
        begins.set()
        assert may_end.wait(60)
        return types

    path = tmp_path / "new" / "one.lock"  # each opens the file anew, as another process does
    first = threading.Thread(target=compiling._one_process_at_a_time(slow, path), args=((),))
    first.start()
    assert begins.wait(60)
    second = threading.Thread(target=compiling._one_process_at_a_time(lambda _: second_is_in.set(), path), args=((),))
    second.start()
    assert not second_is_in.wait(0.2)
    may_end.set()
    first.join()
    second.join()
    assert second_is_in.is_set()


def test_a_folder_that_cannot_be_written_does_not_keep_anyone_from_compiling(tmp_path):
    (tmp_path / "file").write_text("")
    assert compiling._one_process_at_a_time(str, tmp_path / "file" / "one.lock")(3) == "3"


@pytest.mark.parametrize("at_a_terminal", [True, False])
def test_who_waits_at_a_terminal_for_what_is_compiled_is_told(at_a_terminal, tmp_path, monkeypatch):
    class Terminal(io.StringIO):
        def isatty(self):
            return at_a_terminal

        def write(self, text):
            written.set()
            return super().write(text)

    written, terminal = threading.Event(), Terminal()
    monkeypatch.setattr(compiling.sys, "stderr", terminal)
    monkeypatch.setattr(compiling, "_SOON", 0)
    slow = compiling._one_process_at_a_time(lambda _: written.wait(60 if at_a_terminal else 0), tmp_path / "one.lock")
    assert slow(()) is at_a_terminal
    assert terminal.getvalue().startswith("numba compiles the solver") is at_a_terminal
