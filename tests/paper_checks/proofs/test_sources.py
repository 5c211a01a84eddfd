import re

import pytest

from paper_checks.proofs.sources import AUDIT, FOLDER, LIBRARY, Source, keys, needed, read

LOW = Source("Low", "Lemma one : True.\nProof. exact I. Qed.\n")
HIGH = Source("High", "From InertialPair Require Import\n  Low.\nTheorem two : True.\nProof. exact one. Qed.\n")


def named(*sources):
    return {source.name: source for source in sources}


def test_files_come_after_what_they_require_and_with_nothing_else():
    assert needed(["High"], named(HIGH, LOW)) == ("Low", "High")
    assert needed(["Low"], named(HIGH, LOW)) == ("Low",)


@pytest.mark.parametrize(
    ("sources", "said"),
    [
        (named(HIGH), "there is no Low.v"),
        (named(Source("Low", "From InertialPair Require Import High."), HIGH), "requires itself"),
    ],
)
def test_an_order_that_cannot_be_is_refused_in_one_line(sources, said):
    with pytest.raises(ValueError, match=said):
        needed(sources, sources)


def test_a_change_changes_the_keys_of_all_above_and_of_none_below():
    before = keys(named(LOW, HIGH), "8")
    above = keys(named(LOW, Source("High", HIGH.text + " ")), "8")
    below = keys(named(Source("Low", LOW.text + " "), HIGH), "8")
    assert above["Low"] == before["Low"]
    assert above["High"] != before["High"]
    assert below["Low"] != before["Low"]
    assert below["High"] != before["High"]
    assert set(keys(named(LOW, HIGH), "9").values()).isdisjoint(before.values())


def test_the_project_file_names_every_file_once():
    names = [path.relative_to(FOLDER).as_posix() for path in sorted(FOLDER.rglob("*.v")) if path.stem != AUDIT]
    project = (FOLDER / "_CoqProject").read_text("utf-8").split()
    assert project == ["-R", ".", LIBRARY, "-arg", "-w", "-arg", "none", *names]
    assert len(read()) == len(names)


ORDER = ["analysis", "pair", "forced", "surface", "free", "trajectory"]


def test_each_folder_rests_on_those_before_it():
    """As the README of the proofs draws it."""
    folders = {path.stem: ORDER.index(path.parent.name) for path in FOLDER.rglob("*.v") if path.stem != AUDIT}
    edges = [(name, required) for name, source in read().items() for required in source.requires]
    assert [edge for edge in edges if folders[edge[1]] > folders[edge[0]]] == []
    assert re.findall(r"^\| `(\w+)/` \|", (FOLDER / "README.md").read_text("utf-8"), re.MULTILINE) == ORDER


def test_the_readme_names_definitions_that_are_there():
    names = re.findall(r"^\| `([A-Z]\w+)\.(\w+)", (FOLDER / "README.md").read_text("utf-8"), re.MULTILINE)
    assert len(names) > 15
    texts = read()
    assert [
        one for one in names if not re.search(rf"(?:Definition|Fixpoint|Record) {one[1]}\b", texts[one[0]].text)
    ] == []
