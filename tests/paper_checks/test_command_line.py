"""The command line: its default, its exit codes, its one clear line for each mistake."""

import json
import shlex
import subprocess
import sys

import pytest
from planted_trades import MACHINE, planted

import numerics.trade.recorded as recorded_module
import paper_checks.__main__ as command_line
import paper_checks.claims as claims_module
import paper_checks.report.output.pictures as pictures_module
import paper_checks.running.planting as planting_module
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


@pytest.fixture
def command(ended):
    """Exit code, output and errors of a command line."""
    return lambda line: ended(main, shlex.split(line))


RUNS = """
energy-rate                         | 0
run energy-rate stiction-bracket    | 0
--seed 3 energy-rate                | 0
rate-one-over-t                     | 1
hostile                             | 3
                                    | 1
--json stiction-bracket energy-rate | 0
"""


@pytest.mark.parametrize("row", RUNS.strip().splitlines())
def test_run_is_the_default_and_the_exit_code_tells(small, command, row):
    line, code = row.split("|")
    found, out, err = command(line)
    assert (found, err) == (int(code), "")
    assert "\x1b" not in out
    if "--json" in line:
        assert [item["id"] for item in json.loads(out)] == ["energy-rate", "stiction-bracket"]


def test_list_prints_every_claim_in_a_pipe_on_a_line_of_its_own(command):
    code, out, _ = command("list")
    assert code == 0
    assert [line.split()[0] for line in out.splitlines()][1 : 1 + len(CLAIMS)] == [claim.id for claim in CLAIMS]
    code, out, _ = command("list --json")
    assert code == 0
    assert {claim["id"]: claim["recorded"] for claim in json.loads(out)} == {
        claim.id: claim.recorded.value for claim in CLAIMS
    }


def test_the_report_tells_some_rows_or_the_whole_and_complains(small, command, tmp_path, monkeypatch):
    code, out, err = command(f"report --out {tmp_path}/all --format html,latex")
    assert (code, err) == (1, "error: the figure lost is not known\n")
    assert out.strip().startswith(str(tmp_path))
    planted(tmp_path)  # writes the file
    command(f"report --out {tmp_path}/other --trade {tmp_path}/planted.json")
    assert "Measured once: Abacus" in (tmp_path / "other" / "report.html").read_text("utf-8")
    assert command(f"report stiction-bracket --out {tmp_path}")[0] == 0
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert 'id="stiction-bracket"' in page
    assert 'id="energy-rate"' not in page
    assert "Speed and accuracy" not in page
    monkeypatch.setattr(pictures_module, "FIGURES", {})
    assert command(f"report energy-rate --out {tmp_path}")[0] == 3


def test_a_file_is_compared_with_the_source(command, tmp_path):
    (tmp_path / "other.tex").write_text("another paper", encoding="utf-8")
    code, out, _ = command(f"source {tmp_path}/other.tex")
    assert code == 1
    assert "is not the text of the paper that was checked" in out


MISTAKES = """
energy-rat                    | 2 | unknown claim 'energy-rat'; did you mean energy-rate, viscous-energy-rate?
run --nonsense                | 2 |
--jobs 0                      | 2 |
source nowhere.tex            | 2 | cannot be read: No such file or directory
report --format html,docx     | 2 |
report --out ''               | 2 |
report --out file/in          | 2 | the report cannot be written: 'file' is a file; choose another folder with --out
report --trade nowhere.json   | 2 | nowhere.json cannot be read: No such file or directory
report --format html,pdf      | 3 | pdflatex
report                        | 3 | this needs sympy
"""


@pytest.mark.parametrize("row", MISTAKES.strip().splitlines())
def test_a_mistake_is_one_line_before_anything_runs(monkeypatch, command, tmp_path, row):
    """A missing tool is one, too."""
    line, code, told = map(str.strip, row.split("|"))
    monkeypatch.chdir(tmp_path)
    (tmp_path / "file").write_text("")
    monkeypatch.setattr(command_line, "_rows", lambda *_: pytest.fail("the checks ran"))
    monkeypatch.setattr(latex, "missing", lambda: latex.REMEDY)
    if line == "report":
        monkeypatch.setitem(sys.modules, "sympy", None)
    found, out, err = command(line)
    assert (found, out, err[:7], err.count("\n")) == (int(code), "", "error: ", 1)
    assert told in err


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


@pytest.mark.parametrize("turned", [True, False])
def test_planting_fails_where_a_changed_formula_still_passes(command, monkeypatch, turned):
    one = planting_module.Planted("critical-energy", "level", "sign", "E", turned)
    monkeypatch.setattr(planting_module, "planted", lambda _: [one])
    code, out, _ = command("plant critical-energy")
    assert (code, "still passes with a changed sign" in out) == (0 if turned else 1, not turned)
