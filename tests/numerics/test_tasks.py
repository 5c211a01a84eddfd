"""Work in several processes: a missing package is named."""

import sys

import pytest

from numerics.errors import MissingTool
from numerics.tasks import run_tasks


def test_several_processes_find_what_one_finds():
    pytest.importorskip("joblib")
    tasks = [(number, 40) for number in range(8)]
    assert sorted(run_tasks(divmod_of, tasks, jobs=2)) == [*run_tasks(divmod_of, tasks)]


def divmod_of(task):
    return task[0], divmod(*task)


def test_a_missing_package_is_named(monkeypatch):
    monkeypatch.setitem(sys.modules, "joblib", None)
    with pytest.raises(MissingTool, match="joblib"):
        list(run_tasks(divmod_of, [(0, 1), (1, 1)], jobs=2))
