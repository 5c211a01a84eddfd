import pytest

from paper_checks.proofs.sources import FOLDER, LIBRARY, Source, all_required, in_order, keys, read, without_comments

LOW = Source("Low", "Lemma one : True.\nProof. exact I. Qed.\n")
HIGH = Source("High", "From InertialPair Require Import\n  Low.\nTheorem two : True.\nProof. exact one. Qed.\n")


def named(*sources):
    return {source.name: source for source in sources}


def test_comments_go_and_lines_stay():
    assert without_comments("a (* b (* c *)\n d *) e\nf") == "a \n e\nf"


def test_what_stands_between_marks_in_quotes_is_no_comment():
    text = 'Definition a := "(*".\nUnset Guard Checking.\nDefinition b := "*)".'
    assert without_comments(text) == text
    assert without_comments('(* "*)" *) c') == " c"
    assert Source("False", text).unproved() == ("False.a: Unset Guard Checking stands where a proof is needed",)


def test_files_come_after_what_they_require():
    assert in_order(named(HIGH, LOW)) == ("Low", "High")
    assert all_required("High", named(HIGH, LOW)) == {"Low"}


@pytest.mark.parametrize(
    ("sources", "said"),
    [
        (named(HIGH), "there is no Low.v"),
        (named(Source("Low", "From InertialPair Require Import High."), HIGH), "requires itself"),
    ],
)
def test_an_order_that_cannot_be_is_refused_in_one_line(sources, said):
    with pytest.raises(ValueError, match=said):
        in_order(sources)


def test_a_change_changes_the_keys_of_all_above_and_of_none_below():
    before = keys(named(LOW, HIGH), "8")
    above = keys(named(LOW, Source("High", HIGH.text + " ")), "8")
    below = keys(named(Source("Low", LOW.text + " "), HIGH), "8")
    assert above["Low"] == before["Low"]
    assert above["High"] != before["High"]
    assert below["Low"] != before["Low"]
    assert below["High"] != before["High"]
    assert set(keys(named(LOW, HIGH), "9").values()).isdisjoint(before.values())


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("Lemma one : False.\nProof. Admitted.", "Low.one: Admitted"),
        ("Lemma one : False.\nProof. admit. Qed.", "Low.one: admit"),
        ("Axiom two : False.", "Low.two: Axiom"),
        ("Parameter three : nat.", "Low.three: Parameter"),
        ("Lemma one : True.\nProof. exact I. Qed.\nUnset Guard Checking.", "Low.one: Unset Guard Checking"),
    ],
)
def test_what_is_not_proved_is_named(text, said):
    assert [line.startswith(said) for line in Source("Low", text).unproved()] == [True]
    assert not Source("Low", f"(* {text} *)").unproved()


def test_the_shipped_files_assume_nothing():
    sources = read()
    assert len(sources) > 30
    assert not [line for source in sources.values() for line in source.unproved()]


def test_the_project_file_names_every_file_once():
    named = [path.relative_to(FOLDER).as_posix() for path in sorted(FOLDER.rglob("*.v"))]
    assert (FOLDER / "_CoqProject").read_text("utf-8").split() == ["-R", ".", LIBRARY, *named]
    assert len(read()) == len(named)
