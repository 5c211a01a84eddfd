"""Maps on several processes and on a cluster: the same cells, and nothing is lost when a worker is killed."""

import json
import os
import signal
from fractions import Fraction

import pytest
from dying_worker import squared

from numerics import Pair, response_map
from numerics.free.quadtree import CellMap
from numerics.tasks import run_tasks

PAIR = Pair(1, 1, 200, "0.5", 3)
AMPLITUDE, OMEGA = (Fraction(1, 10), Fraction(10)), (Fraction(4), Fraction(40))


def charted(**roads: object) -> CellMap:
    return response_map(PAIR, AMPLITUDE, OMEGA, 4, **roads)


@pytest.mark.slow
def test_what_a_killed_process_held_is_done_by_another_one(tmp_path):
    pytest.importorskip("joblib")
    mark = tmp_path / "mark"
    tasks = [(number, str(mark)) for number in range(40)]
    assert sorted(run_tasks(squared, tasks, jobs=2)) == [(number, number * number) for number in range(40)]
    assert mark.exists()


def test_processes_change_nothing():
    pytest.importorskip("joblib")
    assert charted(jobs=2) == charted()


@pytest.mark.long
@pytest.mark.filterwarnings("ignore")  # the scheduler tells of the worker that is gone
def test_three_workers_one_of_which_is_killed_draw_the_same_map(tmp_path):
    """Real processes: one of them is killed when 10 of 64 blocks are done; its checkpoint has every block once."""
    distributed = pytest.importorskip("distributed")
    file, counts = tmp_path / "cells.jsonl", []
    with distributed.LocalCluster(n_workers=3, threads_per_worker=1, processes=True, dashboard_address=None) as cluster:
        victim = next(iter(cluster.workers.values())).pid

        def progress(done: int, blocks: int) -> None:
            counts.append(done)
            if done == 10:
                os.kill(victim, signal.SIGKILL)

        found = charted(dask=cluster.scheduler_address, resume=file, progress=progress)
    assert counts == list(range(1, 65))
    assert found == charted()
    parts = [json.loads(line)["part"] for line in file.read_text("utf-8").splitlines()[1:]]
    assert sorted(parts, key=int) == [str(one) for one in range(64)]
