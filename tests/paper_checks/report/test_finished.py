"""Reports from the cache: the same bytes as made anew, and never those of another state, form or row."""

import argparse
from dataclasses import replace
from itertools import count

import pytest

from paper_checks.evidence.finding import Verdict
from paper_checks.report.output import command_line, files, finished
from paper_checks.report.output.finished import Finished, name_of
from paper_checks.running.graph import proofs


def test_a_name_knows_rows_and_form_and_not_how_long_it_took(rows):
    first, another = name_of(rows, "html"), replace(rows[0], finding=rows[1].finding)
    others = [name_of(some, "html") for some in (rows[:-1], rows[::-1], [another, *rows[1:]])]
    assert len({first, *others, name_of(rows, "pdf")}) == 5
    assert name_of([replace(row, seconds=row.seconds + 1) for row in rows], "html") == first


def test_another_trade_source_or_version_is_another_state(tmp_path, monkeypatch):
    source, trade = tmp_path / "one.py", tmp_path / "trade.json"
    source.write_text("1")
    trade.write_text("{}")
    monkeypatch.setattr(finished, "all_sources", lambda: [source])
    store, found = tmp_path / "store", []

    def seen(trade=None):
        Finished(trade, store).keep("one", {"report.html": b""})
        found.append(len(list(store.iterdir())))

    seen()
    seen(trade)
    for path in (trade, source):
        path.write_text("[]")
        seen(trade)
    monkeypatch.setattr(finished, "version", lambda name: "0.0")
    seen()
    seen()
    assert found == [1, 2, 3, 4, 5, 5]


@pytest.mark.parametrize("place", ["one.html", "one.html.report.html", "one.html.figures/sine.svg"])
def test_a_damaged_form_is_not_read(tmp_path, place):
    kept, whole = Finished(folder=tmp_path), {"figures/sine.svg": b"<svg/>", "report.html": b"whole"}
    kept.keep("one.html", whole)
    assert list(kept.files("one.html").items()) == list(whole.items())
    (folder,) = tmp_path.iterdir()
    (folder / place).write_bytes((folder / place).read_bytes()[:-1])
    assert kept.files("one.html") is None


def test_a_second_report_draws_and_sets_nothing(rows, tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.setenv("PATH", "")  # no kernel: asking for its version takes a while
    rows = [replace(row, finding=replace(row.finding, figure=None)) for row in rows]
    rows = [replace(row, proofs=proofs(row.claim, row.finding)) for row in rows]
    numbers = count()

    def reported(rows=rows, *, fresh=False, program=True):
        out = tmp_path / str(next(numbers))
        options = {"trade": None, "format": ("html",), "jobs": 1}
        options |= {"program": program, "fresh": fresh, "out": out}
        complaints = []
        code = command_line.report(argparse.Namespace(**options), rows, lambda claims: rows, complaints.append)
        assert complaints == []
        return code, {path.name: path.read_bytes() for path in out.rglob("*.*")}

    def never(*_):
        raise AssertionError("made again")

    first = reported()
    with monkeypatch.context() as patch:
        patch.setattr(files, "made", never)
        assert reported() == first
        some = [row for row in rows if row.finding.verdict is not Verdict.REFUTED]
        for another in ({"fresh": True}, {"program": False}, {"rows": some}):
            with pytest.raises(AssertionError, match="made again"):
                reported(**another)
    assert reported(fresh=True) == reported(program=False) == first
