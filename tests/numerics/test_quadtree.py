"""Maps of proved cells: a cell is where its place says, a run goes on where it stopped, and no damage passes."""

import sys
from enum import Enum
from fractions import Fraction

import pytest

from numerics.errors import InvalidMap, MissingTool
from numerics.free import quadtree as tree
from numerics.free.quadtree import _read, map_of

WINDOW = ((Fraction(1), Fraction(16)), (Fraction(1), Fraction(256)))


class Letter(Enum):
    LEFT = "l"
    RIGHT = "r"
    OPEN = "u"


def left_or_right(sides):
    """By the first quantity alone, with a border at 4: half of the window's logarithmic width."""
    (low, high), _ = sides
    return Letter.LEFT if high <= 4 else Letter.RIGHT if low >= 4 else Letter.OPEN


def charted(depth=4, **roads):
    return map_of(WINDOW, depth, left_or_right, Letter.OPEN, {}, **roads)


def test_a_raster_has_the_first_quantity_to_the_right_and_the_second_upwards():
    found = charted()
    grid = found.raster(Letter)
    assert (grid[:, :8] == 0).all()
    assert (grid[:, 8:] == 1).all()
    assert len(found.leaves) == 64  # no block is cut further
    assert found.shares() == {Letter.LEFT: 0.5, Letter.RIGHT: 0.5, Letter.OPEN: 0.0}


@pytest.mark.parametrize("text", ["", "ulr", "ulrlrl", "x", "ulrulrulrlrll"])
def test_a_text_that_is_not_one_tree_is_refused(text):
    block, *_ = map_of(WINDOW, 1, lambda _: Letter.OPEN, Letter.OPEN, {}).leaves
    with pytest.raises(ValueError, match=r"letters|Letter"):
        _read(text, block, 3)
    assert len(_read("ulrulrlrl", block, 3)) == 7


@pytest.mark.parametrize(("module", "road"), [("joblib", {"jobs": 2}), ("distributed", {"dask": "tcp://127.0.0.1:1"})])
def test_a_missing_package_is_named(monkeypatch, module, road):
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(MissingTool, match=module):
        charted(**road)


def test_a_run_goes_on_where_it_stopped(tmp_path):
    file, counts = tmp_path / "cells.jsonl", []
    assert charted(resume=file) == charted()
    lines = file.read_text().splitlines(keepends=True)
    assert len(lines) == 65
    file.write_text("".join(lines[:41]) + lines[41][:10])  # 40 blocks and a torn line
    assert charted(resume=file, progress=lambda *done: counts.append(done)) == charted()
    assert counts == [(n, 64) for n in range(41, 65)]
    assert file.read_text().splitlines() == "".join(lines).splitlines()
    assert charted(resume=file, progress=lambda *_: pytest.fail("nothing is left to do")) == charted()
    with pytest.raises(InvalidMap, match="another map"):
        charted(depth=3, resume=file)
    head = "".join(lines[:9])
    for text in ("a letter", head + "{}\n", head + "nonsense\n", head + lines[9].replace('"}', 'm"}')):
        file.write_text(text)
        with pytest.raises(InvalidMap, match=r"damaged|another map"):
            charted(resume=file)
        assert file.read_text() == text


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
