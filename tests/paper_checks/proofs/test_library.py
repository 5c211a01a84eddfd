"""The shipped theorems: all proved as pinned, and every kind of fault turns one by its name."""

import dataclasses
import re
import shutil
import subprocess
from pathlib import Path

import pytest

import theory
from paper_checks.proofs import cited, graph, kernel, library, pins, questions, tied, ties
from paper_checks.proofs.__main__ import main
from paper_checks.proofs.library import build
from paper_checks.proofs.sources import Source

MACHINERY = {"Dini.cont", "Dini.little", "Dini.rderiv"}


@pytest.fixture(scope="module")
def built():
    return build()


@pytest.fixture
def planted(monkeypatch):
    """Build with what the kernel printed of a name, or the axioms below it, changed."""

    def plant(part, name, change):
        real = library._facts

        def facts(*given):
            found = real(*given)
            known = getattr(found, part)
            return dataclasses.replace(found, **{part: known | {name: change(known.get(name))}})

        monkeypatch.setattr(library, "_facts", facts)
        return build()

    return plant


def test_where_nothing_can_be_kept_the_kernel_is_not_run(monkeypatch, tmp_path):
    (tmp_path / "no folder").touch()
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "no folder"))
    monkeypatch.setattr(kernel, "why_not", lambda _: "")
    found = build()
    assert (found.ran, {one.holds for one in found.theorems.values()}) == (False, {None})
    assert found.kernel.startswith("kernel not run: the user's cache cannot be written (")
    assert str(tmp_path) not in found.kernel  # the report says it, and is the same everywhere


def test_without_the_kernel_nothing_is_proved_and_nothing_is_broken(monkeypatch, tmp_path, capsys):
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr("sys.argv", ["paper_checks.proofs"])
    found = build()
    assert (found.ran, found.problems) == (False, ())
    assert {(one.holds, one.problem) for one in found.theorems.values()} == {(None, found.kernel)}
    law = found.theorem("sharp-law")
    assert "is_lim" in law.statement
    assert "first-re-entry" in law.uses
    assert "Stick.Ecr" in law.definitions
    assert (main(), capsys.readouterr().out) == (3, "")
    with pytest.raises(KeyError):
        found.theorem("no-such-theorem")


@pytest.mark.slow
@pytest.mark.usefixtures("needs_kernel")
def test_every_cited_theorem_is_proved_as_pinned_about_the_theory_and_on_no_axiom_but_the_reals(
    built, planted, monkeypatch, capsys
):
    theorems = built.theorems
    assert built.problems == ()
    assert [one.id for one in theorems.values() if one.holds is not True] == []
    assert set(theorems) >= set(cited.CITED)
    assert len({name for name, _ in cited.CITED.values()}) == len(cited.CITED) > 90
    assert pins.read(pins.written(pins.pinned())) == pins.pinned()

    beyond = {one.file for one in theorems.values() if set(one.axioms) - questions.CLASSICAL_REALS}
    assert theorems["margin"].file in beyond  # where intervals are computed
    assert not {theorems[one].file for one in ("sharp-law", "first-adhesion", "switching-iff", "filippov-iff")} & beyond
    assert all(one.axioms for one in theorems.values())

    law = theorems["sharp-law"]
    assert set(law.definitions) - {name for one in theorems for name in pins.pinned().tied.get(one, ())} <= MACHINERY
    assert {"tie-solution", "tie-energy", "tie-critical-energy", "tie-rate"} <= set(law.ties)

    def below(one, above=()):
        assert one not in above
        return {one}.union(*(below(other, (*above, one)) for other in theorems[one].uses))

    assert set().union(*map(below, theorems)) == set(theorems)
    assert {"first-re-entry", "uniqueness"} <= below("sharp-law")
    assert "follow-forced-arc" in theorems["trajectory-velocities"].uses  # by way of an applied functor

    monkeypatch.setattr("sys.argv", ["paper_checks.proofs"])
    assert main() == 0
    assert f"{len(theorems)} of {len(theorems)} theorems proved as pinned, 0 files" in capsys.readouterr().out
    planted("axioms", "Pair.contraction", lambda _: ["Pair.easy"])
    assert main() == 1
    assert capsys.readouterr().err == "Pair.contraction rests on Pair.easy, which nobody has proved\n"


@pytest.mark.slow
@pytest.mark.usefixtures("needs_kernel")
def test_the_kernel_itself_finds_the_same_lemmas_below_a_theorem(tmp_path):
    store = kernel.cache_folder()
    compiled = kernel.compile_all(library._sources(library.FOLDER, store)[0], store=store)
    references, definitions = graph.references(compiled.folders)
    name = "Stick.capture"
    text = f"From InertialPair Require Stick.\nPrint Opaque Dependencies {name}.\n"
    (tmp_path / "Ask.v").write_text(text, "utf-8")
    command = ["coqc", "-q", "-w", "none", *compiled.arguments(), "Ask.v"]
    said = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True).stdout
    ours = set(compiled.folders)
    seen = {one for one in re.findall(r"^ *(\w+\.\w+) :", said, re.MULTILINE) if one.split(".")[0] in ours}
    read = {one for one in graph.everything_below(name, references) if one in references} - definitions
    parts = {
        one for one in read if one.count(".") > 1 or one.startswith(("Pair.s_", "Pair.q_"))
    }  # of sections, records
    assert seen - {name} == read - parts


@pytest.mark.usefixtures("needs_kernel")
def test_a_definition_that_is_not_the_pinned_one_turns_all_that_rest_on_it_and_no_other(planted):
    turned = planted("printed", "Sharp.rate", lambda said: said.replace("9", "8"))
    assert "Law.sharp_law rests on Sharp.rate, which is not defined as pinned" in turned.problems
    assert (turned.theorem("trichotomy").holds, turned.theorem("contraction").holds) == (False, True)


def test_definitions_beneath_definitions_belong_to_a_statement():
    """What a definition names is found in its text, at any depth; what is not of this library, or unknown, is not."""
    printed = {"One.a": "fun x => Two.b x + Reals.R", "Two.b": "fun x => Three.c' x", "Three.c'": "0", "Four.d": "1"}
    assert library.definitions_of("forall x, One.a x = x", printed) == {
        one: printed[one] for one in ("One.a", "Three.c'", "Two.b")
    }


@pytest.mark.parametrize("changed", ["gallina.py", "ties_pair.py", "theory", "sympy"])
def test_the_text_of_the_ties_is_made_again_where_what_it_was_made_from_changes(tmp_path, monkeypatch, changed):
    """@example of a found fault: it was kept though gallina.py had changed."""
    made = []
    monkeypatch.setattr(ties, "text", lambda: made.append(1) or f"Tie {len(made)}")
    assert [tied.text(tmp_path), tied.text(tmp_path)] == [("Tie 1", "")] * 2
    if changed == "sympy":
        monkeypatch.setattr(tied, "version", lambda _: "0.0")
    else:
        folder = Path(theory.__file__).parent if changed == "theory" else Path(tied.__file__).parent
        target, content = folder / "energy.py" if changed == "theory" else folder / changed, Path.read_bytes
        monkeypatch.setattr(Path, "read_bytes", lambda path: content(path) + b" " * (path == target))
    assert tied.text(tmp_path) == ("Tie 2", "")


def test_another_library_beside_the_kernel_is_another_kernel(tmp_path):
    coqc, beside = tmp_path / "coqc", tmp_path / "user-contrib" / "Interval" / "One.vo"
    beside.parent.mkdir(parents=True)
    coqc.write_text(f"#!/bin/sh\necho {tmp_path}\n")
    coqc.chmod(0o700)
    found = []
    for text in ("1", "12"):
        beside.write_text(text)
        found.append(kernel.identity.__wrapped__(str(tmp_path)))
    assert found[0] != found[1]


def test_no_statement_or_definition_is_pinned_in_part_and_what_is_not_checked_counts_as_an_axiom():
    assert "..." not in pins.PINS.read_text("utf-8")  # what the kernel's printer leaves out could change unseen
    told = "Axioms:\nClassical_Prop.classic : forall P : Prop,\n  P \\/ ~ P\nbad is assumed to be guarded.\n"
    assert questions._axioms(told) == ("Classical_Prop.classic", "bad is assumed to be guarded.")
    with pytest.raises(RuntimeError, match="in part only"):
        questions._trimmed("Merging.merging_set", "Merging.merging_set\n     : forall t, v1 (...) = v2 t")


def test_what_nobody_read_turns_a_theorem():
    """A statement, a sentence, a definition, and an axiom wherever it stands."""
    there, fine = pins.pinned(), sorted(questions.CLASSICAL_REALS)
    pin = there.theorems["capture"]
    definitions = {name: there.definitions[name] for name in pin.definitions}

    def problem(axioms, one="capture", found=pin, **more):
        known = dataclasses.replace(there, theorems={one: pin})
        return library._problem("Stick.capture", found, definitions | more, axioms, known, one)

    assert not problem(fine)
    assert "does not say what is pinned" in problem(fine, found=dataclasses.replace(pin, statement="True"))
    assert "not signed" in problem(fine, "sharp-law")
    assert "not defined as pinned" in problem(fine, another="fun x => x")
    for wrong in ("Critical.easy", "Classical_Prop.another", "bad is assumed to be guarded."):
        assert wrong in problem([wrong, *fine])
        assert wrong in problem([*fine, wrong])


@pytest.fixture
def facts(tmp_path, monkeypatch):
    """What is known of a library of one file, and how often its kernel was asked."""
    answers, asked = questions.Answers({"Low.two": "one", "Low.one": "0 = 0"}, {}), []
    monkeypatch.setattr(kernel, "identity", lambda _: "one of a kind")
    monkeypatch.setattr(graph, "references", lambda _: ({}, frozenset()))
    monkeypatch.setattr(questions, "ask", lambda *_: asked.append(1) or answers)

    def known(text="Lemma."):
        compiled = kernel.Compiled({"Low": tmp_path})
        library._facts(compiled, {"Low": Source("Low", text)}, tmp_path)
        return len(asked)

    return known


@pytest.mark.parametrize("changed", ["questions", "graph", "library", "a proof file", "the kernel"])
def test_the_kernel_is_asked_again_where_what_its_answers_rest_on_changes(facts, monkeypatch, changed):
    assert [facts(), facts()] == [1, 1]
    kind = {"questions": questions, "graph": graph, "library": library}.get(changed)
    if changed == "the kernel":
        monkeypatch.setattr(kernel, "identity", lambda _: "another")
    elif kind:
        content = Path.read_text
        monkeypatch.setattr(Path, "read_text", lambda path, *a: content(path, *a) + " " * (path == Path(kind.__file__)))
    assert facts("Lemma. " if changed == "a proof file" else "Lemma.") == 2


@pytest.mark.slow
@pytest.mark.usefixtures("needs_kernel")
@pytest.mark.parametrize(
    ("true", "false", "said"),
    [
        ("13 decimals", "13 decimals", ""),
        ("interval", "idtac", "Critical.decimals is not proved (line "),
        ("Qed.", "Admitted.", "Critical.decimals: Admitted stands where a proof is needed"),
        (
            "Definition lo :=",
            "Axiom easy : False.\nDefinition lo :=",
            "Critical.easy: Axiom stands where a proof is needed",
        ),
    ],
)
def test_a_damaged_file_is_reported_by_the_name_of_its_theorem(tmp_path, monkeypatch, built, store, true, false, said):
    shutil.copytree(library.FOLDER, tmp_path / "proofs")
    damaged = tmp_path / "proofs" / "free" / "Critical.v"
    damaged.write_text(damaged.read_text("utf-8").replace(true, false), "utf-8")
    _, known = known_here(store)
    monkeypatch.setattr(
        library, "_facts", lambda compiled, *_: only(known, lambda one: one.split(".")[0] in compiled.folders)
    )
    found = build(store=store, folder=tmp_path / "proofs")
    assert bool(found.problems) == bool(said)
    assert not said or any(line.startswith(said) for line in found.problems)
    assert found.theorem("contraction").holds is True


@pytest.mark.slow
@pytest.mark.usefixtures("needs_kernel")
def test_a_fault_in_the_theory_breaks_its_tie_and_no_other(monkeypatch, built, store):
    sources, known = known_here(store)
    fault = re.sub(r"(Theorem tie_half_width .*? = )", r"\1 2 * ", sources[library.TIES].text)
    monkeypatch.setattr(tied, "text", lambda store: (fault, ""))
    monkeypatch.setattr(library, "_facts", lambda *_: only(known, lambda one: one != "Tie.tie_half_width"))
    found = build(store=store)
    assert len(found.problems) == 1
    assert found.problems[0].startswith("Tie.tie_half_width is not proved")
    assert [one.id for one in found.theorems.values() if not one.holds] == ["tie-half-width"]
    assert {one.id: one.holds for one in found.ties("ellipse-iff")}["tie-critical-energy"] is True
    assert {one.id: one.holds for one in found.ties("slips-beyond")}["tie-half-width"] is False


def known_here(store):
    """The sources, and the facts about them."""
    sources, _ = library._sources(library.FOLDER, store)
    return sources, library._facts(kernel.compile_all(sources, store=store), sources, store)


def only(facts, known):
    """The facts about the names that are known."""
    return dataclasses.replace(facts, printed={name: text for name, text in facts.printed.items() if known(name)})
