"""The checker accepts the certificate that is shipped, and rejects every damaged one."""

import ast
import json
from fractions import Fraction
from pathlib import Path

import pytest

from paper_checks.certificates import checker, prove_critical_ratio

TEXT = checker.CERTIFICATE.read_text("utf-8")


def damaged(change):
    """Return the certificate after `change` has been done to its data."""
    data = json.loads(TEXT)
    change(data)
    return json.dumps(data)


def test_the_shipped_certificate_is_accepted():
    assert checker.objections(TEXT) == []


def test_the_prover_writes_it_again(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(prove_critical_ratio, "CERTIFICATE", tmp_path / "again.json")
    prove_critical_ratio.main()
    assert (tmp_path / "again.json").read_text("utf-8") == TEXT


def test_the_checker_shares_no_code_with_the_prover():
    tree = ast.parse(Path(checker.__file__).read_text("utf-8"))
    modules = {node.module for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
    modules |= {alias.name for node in ast.walk(tree) if isinstance(node, ast.Import) for alias in node.names}
    allowed = {
        "__future__",
        "json",
        "sys",
        "itertools",
        "collections.abc",
        "contextlib",
        "fractions",
        "pathlib",
        "typing",
    }
    assert modules - allowed == {"flint"}


def cells(part):
    return (lambda data: data["turning"]) if part == "turning" else (lambda data: data["surface"]["cells"])


@pytest.mark.parametrize("part", ["turning", "surface"])
@pytest.mark.parametrize("index", [0, 5, 12, -1])
def test_a_removed_cell_is_missed(part, index):
    assert checker.objections(damaged(lambda data: cells(part)(data).pop(index))) != []


@pytest.mark.parametrize("part", ["turning", "surface"])
@pytest.mark.parametrize("index", [0, 5, 12, -1])
def test_a_moved_cell_is_seen(part, index):
    def move(data):
        cell = cells(part)(data)[index]
        cell[:2] = [str(Fraction(end) + Fraction(1, 1000)) for end in cell[:2]]

    assert checker.objections(damaged(move)) != []


@pytest.mark.parametrize("part", ["turning", "surface"])
@pytest.mark.parametrize("index", [0, 5, 12, -1])
def test_a_tightened_bound_is_refused(part, index):
    def tighten(data):
        cell = cells(part)(data)[index]
        cell[3] = str(100 * Fraction(cell[3]))

    assert any("is not proved" in one for one in checker.objections(damaged(tighten)))


@pytest.mark.parametrize("part", ["turning", "surface"])
@pytest.mark.parametrize("bound", ["0", "-1"])
def test_a_bound_that_says_nothing_is_refused(part, bound):
    assert checker.objections(damaged(lambda data: cells(part)(data)[3].__setitem__(3, bound))) != []


def test_two_cells_in_the_other_order_are_seen():
    assert checker.objections(damaged(lambda data: data["turning"].reverse())) != []


@pytest.mark.parametrize("name", ["half_angle", "share", "m1_over_m2", "m2_over_m1"])
@pytest.mark.parametrize("end", [0, 1])
def test_a_tightened_constant_is_refused(name, end):
    def tighten(data):
        bounds = data["constants"][name]
        bounds[end] = bounds[1 - end]

    assert any("constants" in one for one in checker.objections(damaged(tighten)))


def test_a_share_beyond_the_threshold_is_refused():
    assert checker.objections(damaged(lambda data: data["surface"].update(share="558/1000"))) != []


def test_a_removed_band_is_missed():
    assert checker.objections(damaged(lambda data: data["bands"].pop())) == ["bands: there are not as many as stated"]


def first_long_band(data):
    return next(band for band in data["bands"] if len(band["slips"]) > 2 and band["slips"][-1][2] == "merges")


BAND_FAULTS = {
    "a slip removed": lambda band: band["slips"].pop(0),
    "the last slip removed": lambda band: band["slips"].pop(),
    "no slips": lambda band: band["slips"].clear(),
    "an angle moved": lambda band: band["slips"][1].__setitem__(0, band["slips"][1][1]),
    "a bracket moved": lambda band: band["slips"][0].__setitem__(slice(0, 2), ["1", "2"]),
    "creeps for merges": lambda band: band["slips"][-1].__setitem__(2, "creeps"),
    "merges too early": lambda band: band["slips"][0].__setitem__(2, "merges"),
    "the other ray": lambda band: band["slips"][1].__setitem__(2, "same"),
    "other excesses": lambda band: band.update(excess=["1", "40"]),
    "another share": lambda band: band.update(share=["1/10", "1/5"]),
    "no excess": lambda band: band.update(excess=["-1", "1"]),
    "an empty interval": lambda band: band.update(excess=band["excess"][::-1]),
    "an unknown outcome": lambda band: band["slips"][-1].__setitem__(2, "rests"),
}


@pytest.mark.parametrize("fault", BAND_FAULTS)
def test_a_damaged_band_is_refused(fault):
    assert checker.objections(damaged(lambda data: BAND_FAULTS[fault](first_long_band(data)))) != []


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"turning": []}', TEXT[:-100], TEXT.replace('"bands"', '"sands"')])
def test_what_is_no_certificate_is_said_to_be_none(text):
    assert checker.objections(text)[0].startswith("not a certificate")


def test_the_command_tells_by_its_exit_code(tmp_path, capsys):
    assert checker.main([]) == 0
    path = tmp_path / "damaged.json"
    path.write_text(damaged(lambda data: data["turning"].pop()))
    assert checker.main([str(path)]) == 1
    assert "beyond pi" in capsys.readouterr().out


def test_a_band_that_merges_does_not_creep():
    """Below E_cr the excess is below every level, too: to creep it has to be proved positive."""

    def relabel(data):
        band = next(one for one in data["bands"] if one["slips"][-1][2] == "merges")
        band["slips"][-1][2] = "creeps"
        data["outcomes"]["merges"] -= 1
        data["outcomes"]["creeps"] += 1

    assert any("creeps is not proved" in one for one in checker.objections(damaged(relabel)))
