"""What the kernel prints of the cited theorems is what is on record, and every kind of fault turns one by its name."""

import re
import shutil

import pytest

from paper_checks.proofs import audit, graph, kernel, library
from paper_checks.proofs.__main__ import script
from paper_checks.proofs.audit import CLASSICAL_REALS, recorded, register
from paper_checks.proofs.sources import AUDIT, FOLDER, read

OUT = (FOLDER / f"{AUDIT}.out").read_text("utf-8")
ONE, DIGITS = "contraction", "critical-mass-ratio-digits"


def test_the_record_has_every_theorem_and_its_sentence():
    assert recorded().theorems.keys() == register().keys()
    assert len({name for name, _ in register().values()}) == len(register()) > 200
    assert "follow-forced-arc" in recorded().theorems["trajectory-velocities"].uses  # by way of an applied functor
    texts = [path.read_text("utf-8") for path in FOLDER.rglob("*.v")]
    ids = [one for text in texts for one in re.findall(r"\(\*\* \[([\w.-]{2,})\]", text)]
    assert sorted(ids) == sorted(register()), "an id twice, or above no theorem"
    for one, (_, sentence) in register().items():
        assert f"== {one}\n{sentence}\n" in OUT, f"the sentence of {one} is not the one on record"


def test_nothing_on_record_rests_on_an_axiom_beyond_the_reals():
    theorems = recorded().theorems
    assert all(one.axioms and all(map(audit.allowed, one.axioms)) for one in theorems.values())
    beyond = {name for name, one in theorems.items() if set(one.axioms) - CLASSICAL_REALS}
    assert "margin" in beyond  # where intervals are computed
    assert not {"sharp-law", "first-adhesion", "switching-iff", "filippov-iff"} & beyond


def test_what_is_not_checked_counts_as_an_axiom_and_nothing_is_read_in_part():
    told = "Axioms:\nClassical_Prop.classic : forall P : Prop,\n  P \\/ ~ P\nbad is assumed to be guarded.\n"
    assert audit.axioms(told) == ("Classical_Prop.classic", "bad is assumed to be guarded.")
    with pytest.raises(RuntimeError, match="in part only"):
        audit.trimmed("MergingEnergies.merging_set", "MergingEnergies.merging_set\n     : forall t, v1 (...) = v2 t")


def test_an_answer_that_is_not_the_one_on_record_is_named():
    """A statement, a definition, and an axiom that is not allowed or not on record."""
    name, known = register()["capture"][0], recorded().theorems["capture"]
    printed = {name: known.statement} | recorded().definitions_of["capture"]

    def problem(changed=(), axioms=known.axioms):
        return library.difference("capture", printed | dict(changed), axioms)

    assert problem() == ""
    assert "does not say what is in Audit.out" in problem({name: "True"})
    assert "Pair.energy, which is not defined as in Audit.out" in problem({"Pair.energy": "fun x => x"})
    for wrong in ("CriticalRatioDigits.easy", "Classical_Prop.another", "bad is assumed to be guarded."):
        assert f"rests on {wrong}, which nobody has proved" in problem(axioms=[*known.axioms, wrong])
    assert "more than in Audit.out" in problem(axioms=[*known.axioms, "PrimInt63.add"])
    del printed["Pair.energy"]
    assert "Pair.energy, which is not defined as in Audit.out" in problem()


def test_without_the_kernel_nothing_is_proved_and_nothing_is_broken(monkeypatch, tmp_path, command):
    monkeypatch.setenv("PATH", str(tmp_path))
    theorems = library.prove(register())
    assert {(one.holds, one.problem) for one in theorems.values()} == {(None, kernel.why_not())}
    law = theorems["sharp-law"]
    assert "is_lim" in law.statement
    assert (law.axioms, "first-re-entry" in law.uses, "tie-rate" in law.ties) == ((), True, True)
    assert command()[:2] == (3, "")
    with pytest.raises(KeyError):
        library.prove(["no-such-theorem"])


@pytest.mark.slow
@pytest.mark.usefixtures("needs_kernel")
def test_every_cited_theorem_is_proved_as_recorded(monkeypatch, command):
    known = {one: library.prepare(register())[one] for one in register()}
    monkeypatch.setattr(library, "prove", lambda *_: known)  # which it was that found them
    code, out, _ = command()
    assert code == 0
    assert f"{len(register())} of {len(register())} theorems proved as recorded" in out


@pytest.fixture(scope="module")
def compiled(needs_kernel):
    library.prepare(register())
    sources = read()
    return kernel.compile_files(sources, sources)


@pytest.mark.slow
def test_the_record_names_what_each_theorem_uses(compiled):
    references, _ = graph.references(compiled.folders)
    ids = {name: one for one, (name, _) in register().items()}
    found = {one: {ids[other] for other in graph.nearest(name, ids, references)} for name, one in ids.items()}
    assert found == {one: set(theorem.uses) for one, theorem in recorded().theorems.items()}


@pytest.mark.long
def test_the_audit_file_asks_about_what_is_cited_and_names_what_it_uses(compiled):
    assert script(compiled) == (FOLDER / f"{AUDIT}.v").read_text("utf-8"), (
        "python -m paper_checks.proofs audit writes it"
    )


@pytest.mark.slow
@pytest.mark.usefixtures("needs_kernel")
@pytest.mark.parametrize(
    ("true", "false", "said"),
    [
        ("Qed.", "Admitted.", "CriticalRatioDigits.decimals rests on "),
        ("Theorem decimals", "Theorem digits", "CriticalRatioDigits.decimals: "),
    ],
)
def test_a_damaged_file_is_reported_by_the_name_of_its_theorem_and_costs_no_other(tmp_path, store, true, false, said):
    shutil.copytree(FOLDER, tmp_path / "rocq")
    damaged = tmp_path / "rocq" / "free" / "CriticalRatioDigits.v"
    damaged.write_text(damaged.read_text("utf-8").replace(true, false), "utf-8")
    proved = library.prove([DIGITS, ONE], store=store, folder=tmp_path / "rocq")
    assert proved[DIGITS].problem.startswith(said)
    assert proved[ONE].holds is True
