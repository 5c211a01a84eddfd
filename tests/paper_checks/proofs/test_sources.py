import re

import pytest

from paper_checks.proofs.sources import AUDIT, FOLDER, LIBRARY, Source, needed, read

HIGH = Source("High", "From InertialPair Require Import\n  Low.\n")
LOOP = Source("Low", "From InertialPair Require Import High.")


@pytest.mark.parametrize(("sources", "said"), [([HIGH], "there is no Low.v"), ([LOOP, HIGH], "cycle")])
def test_an_order_that_cannot_be_is_refused(sources, said):
    with pytest.raises(ValueError, match=said):
        needed(["High"], {source.name: source for source in sources})


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
