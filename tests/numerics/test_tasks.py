"""Work in several processes: nothing is lost when one of them is killed, and a missing package is named."""

import sys

import pytest
from dying_worker import squared

from numerics.errors import MissingTool
from numerics.tasks import run_tasks


@pytest.mark.slow
def test_what_a_killed_process_held_is_done_by_another_one(tmp_path):
    pytest.importorskip("joblib")
    mark = tmp_path / "mark"
    tasks = [(number, str(mark)) for number in range(40)]
    assert sorted(run_tasks(squared, tasks, jobs=2)) == [(number, number * number) for number in range(40)]
    assert mark.exists()


def test_a_missing_package_is_named(monkeypatch):
    monkeypatch.setitem(sys.modules, "joblib", None)
    with pytest.raises(MissingTool, match="joblib"):
        list(run_tasks(squared, [(0, ""), (1, "")], jobs=2))
