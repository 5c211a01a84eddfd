"""A trajectory as a theorem: what the solver writes is accepted by the kernel, and nothing false is."""

import re
import subprocess
import tomllib
from pathlib import Path

import pytest
from scene_files import scenes_in

from numerics import Scene, State, load_scene, solve
from numerics.trajectory import theorem as writer
from numerics.trajectory.theorem import theorem
from paper_checks.proofs import submitted
from paper_checks.proofs.audit import CLASSICAL_REALS
from paper_checks.proofs.sources import FOLDER
from paper_checks.proofs.submitted import judged

SMALL, FORCED, EVERYTHING = (scenes_in("submitted")[name] for name in ("small", "forced", "everything"))
SHORT = scenes_in("left-open")["friction-from-a-time-that-floats-do-not-hold"].replace(until="0.2")
SCENES, EVER = scenes_in("proved") | {"a spell of 1e-400 s": SHORT}, scenes_in("proved-for-ever")


PLANTED = tomllib.loads((Path(__file__).parents[2] / "planted_trajectories.toml").read_text("utf-8"))

needs_kernel = pytest.mark.usefixtures("needs_kernel")


def proof(scene):
    return theorem(solve(scene, arithmetic="ball", digits=15))


@pytest.fixture
def judge(tmp_path):
    """What the kernel says of the text of a proof file."""

    def said(text):
        path = tmp_path / "of any-name.v"
        path.write_text(text, "utf-8")
        return judged(path)

    return said


def changed(text, pattern, new):
    found, count = re.subn(pattern, new, text, count=1, flags=re.DOTALL)
    assert count == 1
    return found


@pytest.fixture
def written(monkeypatch):
    """Proofs as the solver writes them; in that of "balls" these take the place of boxes soon."""

    def proof_of(what):
        if what == "balls":
            monkeypatch.setattr(writer, "WORN", 4.0)
        return proof(SMALL if what == "small" else FORCED)

    return proof_of


def test_the_shipped_table_is_what_the_solver_writes():
    texts = proof(load_scene("velocities")), (FOLDER / "trajectory" / "Velocities.v").read_text("utf-8")
    written, shipped = (re.sub(r"\(\*\*.*?\*\)", "", text, flags=re.DOTALL) for text in texts)  # but for its comments
    assert written == shipped


@needs_kernel
def test_a_trajectory_is_accepted_and_with_one_digit_changed_it_is_refused(judge):
    text = proof(EVERYTHING)
    said = judge(text)
    assert said.holds is True
    assert said.reason.startswith(
        "5 events until t = 0.9, sticking for ever then, of every motion with m1 = 1, m2 = 2, a1 = 20, a2 = 200"
    )
    late = "Event Stick (0.300000000099, 0.300000000101)"
    assert judge(changed(text, r"Event Stick \(0\.299999999999, 0\.300000000001\)", late)).holds is False


@pytest.mark.long
@needs_kernel
@pytest.mark.parametrize("scene", (SCENES | EVER).values(), ids=SCENES | EVER)
def test_trajectories_of_every_kind_are_accepted(judge, scene):
    said = judge(proof(scene))
    assert said.holds is True
    ever = f"until t = {scene.until}, sticking for ever then, of every motion" in said.reason
    assert ever or scene not in EVER.values()


@pytest.mark.long
@needs_kernel
def test_a_stick_that_breaks_is_not_accepted_for_ever(judge):
    """Up to 0.03 m/s it does not, where its energy is critical."""
    text = proof(Scene(FORCED.pair, State("0.004", "0.0300001", 0, "0.0300001"), "0.01"))
    assert judge(text).holds is True
    planted = changed(text, r"(Definition the_ending.*?) false\.", r"\1 true.")
    assert judge(planted).holds is False
    assert judge(changed(planted, r"  (Last \d+ \S+)\]", r"  \1; Ever 72 0.02 0.01]")).holds is False


@pytest.mark.long
@needs_kernel
@pytest.mark.parametrize("one", PLANTED["false"], ids=lambda one: one["what"])
def test_nothing_false_is_accepted(judge, written, one):
    true = written(one["of"])
    assert judge(true).holds is True
    assert one["of"] != "balls" or true.count("Renews [(") > 1  # they take the place of boxes that grow
    said = judge(changed(true, one["true"], one["false"]))
    assert said.holds is False
    assert one["of"] != "small" or said.reason.startswith("Submitted.accepted is not proved")


@pytest.mark.long
@needs_kernel
@pytest.mark.parametrize("one", PLANTED["less"])
def test_a_file_that_proves_less_is_refused(judge, one):
    found = judge(changed(proof(SMALL), one["true"], one["false"]))
    assert found.holds is False
    assert one["said"] in found.reason


@pytest.mark.parametrize("axiom", ["ProofIrrelevance.proof_irrelevance", "PrimInt63.add"])
def test_an_axiom_beyond_the_classical_reals_is_not_accepted(monkeypatch, axiom):
    taken = "Axioms:\n" + "".join(f"{one} : Prop\n" for one in (*CLASSICAL_REALS, axiom))
    monkeypatch.setattr(submitted.audit, "run", lambda *_: {"taken": taken})
    assert f"rests on {axiom}" in submitted._asked(None).reason


def test_without_the_kernel_a_file_is_unchecked_and_a_name_that_is_no_file_is_bad_usage(command, monkeypatch, tmp_path):
    (tmp_path / "a.v").write_text("", "utf-8")
    monkeypatch.setenv("PATH", str(tmp_path))
    code, out, err = command(tmp_path / "a.v")
    assert (code, out) == (3, "")
    assert err.startswith("unchecked: kernel not run: coqc is not installed")
    code, out, err = command("nowhere.v")
    assert (code, out, err.count("\n"), "nowhere.v" in err) == (2, "", 1, True)


def test_a_file_and_all_below_it_are_written_for_plain_coqc(command, tmp_path):
    path, out = tmp_path / "a.v", tmp_path / "to judge"
    path.write_text(proof(SMALL), "utf-8")
    code, said, _ = command(path, "--out", out)
    assert code == 0
    assert said.startswith(f"cd '{out}'\nfor file in Dini.v ")
    listed = (out / "_CoqProject").read_text("utf-8").split()[3:]
    assert listed[-2:] == ["Submitted.v", "Verdict.v"]
    assert {one.name for one in out.glob("*.v")} == set(listed)
    assert "Print Assumptions Submitted.trajectory." in (out / "Verdict.v").read_text("utf-8")
    code, _, err = command(path, "--out", out)
    assert (code, "is not empty" in err) == (2, True)
    assert command("check", "--out", out)[0] == 2


@pytest.mark.long
@needs_kernel
def test_plain_coqc_accepts_it_in_an_empty_folder(command, tmp_path):
    path = tmp_path / "a.v"
    path.write_text(proof(SMALL), "utf-8")
    _, commands, _ = command(path, "--out", tmp_path / "out")
    told = subprocess.run(["sh", "-c", commands], capture_output=True, encoding="utf-8", check=False).stdout
    axioms = re.findall(r"^(\S+)\s*:", told.split("Axioms:")[1], re.MULTILINE)
    assert set(axioms) == CLASSICAL_REALS
