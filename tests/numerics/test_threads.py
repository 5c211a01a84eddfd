"""Threads and processes: each computes what it computes alone, the precision stays, and one compiles for all."""

import json
import os
import signal
import subprocess
import sys
import threading

import flint
import mpmath
import numpy as np
import pytest
from flint import arb
from three_scenes import DAMPED, PAPER

from numerics import load_scene, response, sensitivities, solve
from numerics.arithmetic import compiled as compiling
from numerics.arithmetic.ball import Ball
from numerics.arithmetic.compiled import can_compile
from numerics.arithmetic.precision import cached_property, is_held, precision
from numerics.errors import MissingTool
from numerics.solver.rows import in_chunks
from numerics.tasks import run_tasks
from numerics.trajectory.saved import plain

SINE, ROUND = load_scene("forced-sine-stick-slip"), load_scene("plane-circle-merges")
JOBS = [
    (PAPER, {"arithmetic": "ball", "digits": 20}),
    (SINE, {"arithmetic": "ball", "digits": 20}),
    (PAPER, {"arithmetic": "mpmath", "digits": 60}),
    (SINE, {"arithmetic": "ball", "digits": 60}),
    (PAPER, {"digits": 90}),
    (DAMPED, {"digits": 40}),
    (ROUND, {"digits": 30}),
    (PAPER, {}),
]
SECONDS = 60.0
"""A thread that waits for longer waits for one that waits for it."""


def everything(scene, how):
    """Return as text what a run wrote and what is made of it when it is looked at, to the last bit."""
    run = solve(scene, **how)
    numbers = [run.sol([0, "0.1", "1/3"]), run.energy]
    if scene is not ROUND:
        numbers += [run.dissipated, run.ledger.friction, run.reduced.final.w, run.reduced.initial.X]
    if scene is DAMPED:
        found = response(scene, amplitude=3, omega=7, digits=20)
        numbers += [sensitivities(run).final, [one for one in vars(found).values() if isinstance(one, arb)]]
    return json.dumps([run.kept(), plain(numbers)])


def test_tasks_may_be_left():
    """Without a warning of those that nobody took."""
    found = run_tasks(divmod_of, [(1, 1)] * 9, jobs=2)
    next(found)
    found.close()


def in_threads(works, seconds=SECONDS):
    """Return what functions return, each in a thread of its own; all begin at once."""
    found, begin = {}, threading.Barrier(len(works))

    def run(place, work):
        begin.wait()
        found[place] = work()

    threads = [threading.Thread(target=run, args=one, daemon=True) for one in enumerate(works)]
    for one in threads:
        one.start()
    for one in threads:
        one.join(seconds)
        assert not one.is_alive(), "a thread waits for ever"
    return [found[place] for place in range(len(works))]


@pytest.fixture(autouse=True)
def threads_change_often():
    before = sys.getswitchinterval()
    sys.setswitchinterval(2e-5)
    yield
    sys.setswitchinterval(before)


def test_eight_threads_compute_to_the_last_bit_what_one_does():
    alone = [everything(*job) for job in JOBS]
    for turn in range(2):
        order = np.roll(range(8), turn)
        together = in_threads([lambda job=JOBS[k]: everything(*job) for k in order])
        assert together == [alone[k] for k in order]
    assert (flint.ctx.prec, mpmath.mp.prec) == (53, 53)


def test_eight_threads_may_look_at_one_run():
    run, alone = solve(SINE, arithmetic="ball"), plain(solve(SINE, arithmetic="ball").ledger.friction)
    looked = in_threads([lambda: (plain(run.ledger.friction), len(run.events)) for _ in range(8)])
    assert looked == [(alone, len(run.event_times))] * 8


def test_who_looks_at_a_value_does_not_wait_for_one_who_waits_for_the_precision():
    """As the cached_property of Python 3.11 did: the first thread has its lock, the second one the precision."""
    is_looking, holds = threading.Event(), threading.Event()

    class Looked:
        @cached_property
        def value(self):
            is_looking.set()
            with precision(100):
                return 1

    def first():
        holds.wait()
        return Looked().value

    def second():
        with precision(200):
            holds.set()
            is_looking.wait()
            return Looked().value

    assert in_threads([first, second], 10) == [1, 1]


def test_a_batch_within_a_precision_does_not_wait_for_its_own_threads():
    """What is left to Python in a chunk of rows may be solved in balls, in a thread for which the first one waits."""

    def chunk(part):
        with precision(100):
            return part.stop - part.start

    def batch():
        with Ball(30).context():
            return sum(in_chunks(chunk, 512, 2))

    assert in_threads([batch], 10) == [512]


@pytest.mark.skipif(not hasattr(os, "fork"), reason="this system has no fork")
def test_a_process_that_is_forked_has_a_precision_of_its_own():
    held, go = threading.Event(), threading.Event()

    def hold():
        with precision(500):
            held.set()
            go.wait(0.2)

    other = threading.Thread(target=hold)
    other.start()
    held.wait()
    child = os.fork()
    if child == 0:  # the thread that held the precision is not there
        signal.alarm(10)  # and would be waited for
        with precision(100):
            os._exit(0 if flint.ctx.prec == 100 else 1)
    assert os.waitpid(child, 0)[1] == 0
    other.join()


def test_an_interrupt_that_meets_the_end_of_an_inner_precision_leaves_nothing_behind():
    """Once in forty Ctrl-C left the digits of a run in balls, as the block within it never ended."""

    def interrupted():
        with precision(100):
            precision(200).__enter__()
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        interrupted()
    assert (flint.ctx.prec, is_held()) == (53, False)


# work in several processes


def test_several_processes_find_what_one_finds():
    pytest.importorskip("joblib")
    tasks = [(number, 40) for number in range(8)]
    assert [*run_tasks(divmod_of, tasks, jobs=2)] == [*run_tasks(divmod_of, tasks)]


def divmod_of(task):
    return task[0], divmod(*task)


def test_a_missing_package_is_named(monkeypatch):
    monkeypatch.setitem(sys.modules, "joblib", None)
    with pytest.raises(MissingTool, match="joblib"):
        list(run_tasks(divmod_of, [(0, 1), (1, 1)], jobs=2))


# who compiles when, and says so


needs_numba = pytest.mark.skipif(not can_compile(), reason="numba is not installed")


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
from numerics.linear.table import places_of
import numpy as np
for _ in range(2):
    compiled(places_of)(np.zeros((2, 2)))
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

    assert [said("new"), said("new"), said("file")] == [1, 0, 1]
