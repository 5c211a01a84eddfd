"""How a merging map is come by: processes, checkpoints, windows that are none, and the command."""

import sys
from fractions import Fraction

import pytest

from numerics.errors import InvalidMap, MissingTool
from numerics.free import quadtree as tree
from numerics.free.merging_map import Window, merging_cells


@pytest.fixture(scope="module")
def chart():
    return merging_cells(Window(), 4)


@pytest.mark.parametrize(("module", "road"), [("joblib", {"jobs": 2}), ("distributed", {"dask": "tcp://127.0.0.1:1"})])
def test_a_missing_package_is_named(monkeypatch, module, road):
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(MissingTool, match=module):
        merging_cells(Window(), 4, **road)
    assert merging_cells(Window(), 1).leaves


def test_a_run_goes_on_where_it_stopped(tmp_path, chart):
    file, counts = tmp_path / "cells.jsonl", []
    assert merging_cells(Window(), 4, resume=file) == chart
    lines = file.read_text().splitlines(keepends=True)
    assert len(lines) == 65
    file.write_text("".join(lines[:41]) + lines[41][:30])  # 40 blocks and a torn line
    assert merging_cells(Window(), 4, resume=file, progress=lambda *done: counts.append(done)) == chart
    assert counts == [(n, 64) for n in range(41, 65)]
    assert sorted(file.read_text().splitlines()) == sorted("".join(lines).splitlines())
    assert merging_cells(Window(), 4, resume=file, progress=lambda *_: pytest.fail("nothing is left to do")) == chart


def test_a_foreign_or_damaged_checkpoint_is_refused(tmp_path):
    file = tmp_path / "cells.jsonl"
    merging_cells(Window(), 4, resume=file)
    with pytest.raises(InvalidMap, match="another map"):
        merging_cells(Window(), 3, resume=file)
    lines = file.read_text().splitlines(keepends=True)
    uncut = next(k for k, line in enumerate(lines) if "+" in line)
    for damaged in ("{}\n", "nonsense\n", lines[uncut].replace("+", ""), lines[uncut].replace('"}', 'm"}')):
        file.write_text("".join([*lines[:uncut], damaged, *lines[uncut + 1 :]]))
        with pytest.raises(InvalidMap, match=r"damaged|finished part"):
            merging_cells(Window(), 4, resume=file)


# command line


def test_command_line(output, record, tmp_path):
    picture = tmp_path / "map.png"
    found = record("map", "--depth", 4, "--ratio", 1, 8, "--out", picture)
    assert picture.read_bytes().startswith(b"\x89PNG")
    assert (found["ratio"], found["energy"], found["depth"]) == (["1", "8"], ["101/100", "101"], 4)
    assert sum(found["shares"].values()) == pytest.approx(1)
    for low, high, least, most, name in found["cells"]:
        assert 1 <= Fraction(low) < Fraction(high) <= 8
        assert 1 < Fraction(least) < Fraction(most) <= 101
        assert name in {"merges", "creeps", "undecided"}
    assert "of the window" in output("map", "--depth", 2)


def test_an_interrupted_command_says_how_to_go_on(monkeypatch, run, tmp_path):
    road = tree.run_tasks

    def interrupted(function, tasks, **roads):
        yield from road(function, tasks[:5], **roads)
        raise KeyboardInterrupt

    monkeypatch.setattr(tree, "run_tasks", interrupted)
    file = tmp_path / "cells.jsonl"
    code, _, err = run("map", "--depth", 4, "--resume", file)
    assert (code, "goes on" in err) == (130, True)
    assert len(file.read_text().splitlines()) == 6
    code, _, err = run("map", "--depth", 4)
    assert (code, "nothing was written" in err) == (130, True)
