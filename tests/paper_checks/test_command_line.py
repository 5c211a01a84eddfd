"""The command line: its default, its exit codes, its one clear line for each mistake."""

import json
import subprocess
import sys

import pytest
from planted_trades import MACHINE, planted

import numerics.trade.recorded as recorded_module
import paper_checks.__main__ as command_line
import paper_checks.claims as claims_module
import paper_checks.report.output.pictures as pictures_module
from numerics.trade.recorded import recorded
from paper_checks.__main__ import main
from paper_checks.claims import CLAIMS
from paper_checks.report.content import document
from paper_checks.report.formats import latex


@pytest.fixture
def small(monkeypatch, tmp_path_factory, rows, figures):
    """The small ledger in the place of the real one, and a small trade; no chapter on forces."""
    machine = MACHINE | {"processor": "Slide rule"}
    shipped = planted(tmp_path_factory.mktemp("shipped"), machine=machine)
    monkeypatch.setattr(recorded_module, "recorded", lambda path=None: recorded(path) if path else shipped)
    monkeypatch.delitem(document.OF_ALL_CLAIMS, "under-a-force")
    monkeypatch.setattr(claims_module, "CLAIMS", tuple(row.claim for row in rows))
    monkeypatch.setattr(pictures_module, "FIGURES", figures)


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (["energy-rate"], 0),
        (["run", "energy-rate", "stiction-bracket"], 0),
        (["--seed", "3", "energy-rate"], 0),
        (["rate-one-over-t"], 1),
        (["hostile"], 3),
        ([], 1),
        (["--json", "stiction-bracket", "energy-rate"], 0),
    ],
)
def test_run_is_the_default_and_the_exit_code_tells(small, capsys, arguments, code):
    assert main(arguments) == code
    captured = capsys.readouterr()
    assert "\x1b" not in captured.out
    assert captured.err == ""
    if "--json" in arguments:
        assert [item["id"] for item in json.loads(captured.out)] == ["energy-rate", "stiction-bracket"]


def test_an_unknown_id_gets_one_line_that_suggests(small, capsys):
    assert main(["energy-rat"]) == 2
    captured = capsys.readouterr()
    assert captured.err == "error: unknown claim 'energy-rat'; did you mean energy-rate?\n"
    assert captured.out == ""


def test_list_prints_every_claim_in_a_pipe_on_a_line_of_its_own(capsys):
    assert main(["list"]) == 0
    lines = [line.split()[0] for line in capsys.readouterr().out.splitlines()]
    assert lines[1 : 1 + len(CLAIMS)] == [claim.id for claim in CLAIMS]
    assert main(["list", "--json"]) == 0
    printed = {claim["id"]: claim["recorded"] for claim in json.loads(capsys.readouterr().out)}
    assert printed == {claim.id: claim.recorded.value for claim in CLAIMS}


def test_the_report_tells_some_rows_or_the_whole_and_complains(small, capsys, tmp_path, monkeypatch):
    assert main(["report", "--out", str(tmp_path / "all"), "--format", "html,latex"]) == 1
    captured = capsys.readouterr()
    assert captured.out.strip().startswith(str(tmp_path))
    assert captured.err == "error: the figure lost is not known\n"
    planted(tmp_path)  # writes the file
    main(["report", "--out", str(tmp_path / "other"), "--trade", str(tmp_path / "planted.json")])
    assert "Measured once: Abacus" in (tmp_path / "other" / "report.html").read_text("utf-8")
    assert main(["report", "stiction-bracket", "--out", str(tmp_path)]) == 0
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert 'id="stiction-bracket"' in page
    assert 'id="energy-rate"' not in page
    assert "Speed and accuracy" not in page
    monkeypatch.setattr(pictures_module, "FIGURES", {})
    assert main(["report", "energy-rate", "--out", str(tmp_path)]) == 3


def test_a_file_is_compared_with_the_source(capsys, tmp_path):
    (tmp_path / "other.tex").write_text("another paper", encoding="utf-8")
    assert main(["source", str(tmp_path / "other.tex")]) == 1
    assert "is not the text of the paper that was checked" in capsys.readouterr().out
    assert main(["source", str(tmp_path / "nowhere.tex")]) == 2
    assert "cannot be read: No such file or directory" in capsys.readouterr().err


WRITTEN = "the report cannot be written: 'file' is a file; choose another folder with --out"


@pytest.mark.parametrize(
    ("words", "without", "code", "told"),
    [
        (["--out", "file/in"], None, 2, WRITTEN),
        (["--trade", "nowhere.json"], None, 2, "nowhere.json cannot be read: No such file or directory"),
        (["--format", "html,pdf"], "pdflatex", 3, latex.REMEDY),
        ([], "sympy", 3, "this needs sympy"),
    ],
)
def test_what_cannot_be_reported_is_one_line_before_anything_runs(
    monkeypatch, capsys, tmp_path, words, without, code, told
):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "file").write_text("")
    monkeypatch.setattr(command_line, "_rows", lambda *_: pytest.fail("the checks ran"))
    if without == "pdflatex":
        monkeypatch.setattr(latex, "missing", lambda: latex.REMEDY)
    elif without:
        monkeypatch.setitem(sys.modules, without, None)
    assert main(["report", *words]) == code
    said = capsys.readouterr().err
    assert said.startswith("error: ")
    assert told in said
    assert said.count("\n") == 1


@pytest.mark.parametrize(
    "arguments",
    [
        ["run", "--nonsense"],
        ["report", "--format", "html,docx"],
        ["--jobs", "0"],
        ["report", "--out", ""],
    ],
)
def test_usage_errors(arguments, capsys):
    with pytest.raises(SystemExit) as stop:
        main(arguments)
    assert stop.value.code == 2
    found = capsys.readouterr()
    assert (found.out, found.err[:7], found.err.count("\n")) == ("", "error: ", 1)


@pytest.mark.parametrize(
    ("output", "code", "errors"),
    [
        ("| head -n 1", 0, ""),
        ("> /dev/full", 2, "error: cannot read or write the output: No space left on device\n"),
    ],
)
def test_a_closed_pipe_is_no_error_and_an_output_that_takes_nothing_is_told_in_one_line(output, code, errors):
    command = f"{sys.executable} -m paper_checks list {output}"
    result = subprocess.run(command, shell=True, capture_output=True, text=True, check=False)
    assert (result.returncode, result.stderr) == (code, errors)
    assert code or result.stdout.startswith("claim")
