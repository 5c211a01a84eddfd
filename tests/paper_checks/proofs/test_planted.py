"""Every planted false statement, and every tie with a planted factor, breaks a proof; the long tests try most."""

import re
import tomllib
from pathlib import Path

import pytest

from paper_checks.proofs import kernel, library
from paper_checks.proofs.audit import register
from paper_checks.proofs.sources import Source, needed, read

TIES = ["tie_critical_energy", "tie_non_stop_damped"]
THEOREM = re.compile(r"^Theorem .*? Qed\.\n", re.MULTILINE | re.DOTALL)

PLANTED = tomllib.loads((Path(__file__).parents[2] / "planted_proofs.toml").read_text("utf-8"))["planted"]

pytestmark = [pytest.mark.slow, pytest.mark.usefixtures("needs_kernel")]


@pytest.fixture(scope="session")
def compiled():
    library.prepare(register())
    sources = read()
    assert not kernel.compile_files(sources, sources).broken
    return sources


def first_broken(changed, sources, store):
    """What breaks first when a file is replaced: itself, or a file that rests on it."""
    sources = sources | {changed.name: changed}
    for name in needed(sources, sources):
        if changed.name in needed([name], sources):
            outcome = kernel.compile_files([name], sources, store=store)
            if outcome.broken:
                return outcome.broken[name]
    return None


def fault(sources, file, true, false):
    """The file with the one place of the true text replaced by the false one."""
    pattern = re.compile(r"\s+".join(re.escape(word) for word in true.split()))
    text, count = pattern.subn(lambda _: false, sources[file].text)
    assert count == 1, f"{file}.v has {count} places that read {true!r}"
    return Source(file, text)


@pytest.mark.parametrize(
    "one",
    [pytest.param(one, id=one["what"], marks=() if "quick" in one else pytest.mark.long) for one in PLANTED],
)
def test_a_false_statement_is_not_proved(compiled, store, one):
    assert first_broken(fault(compiled, one["file"], one["true"], one["false"]), compiled, store)


def tie_name(block):
    return re.match(r"Theorem (\w+) :", block)[1]


@pytest.mark.parametrize("some", [TIES, pytest.param((), marks=pytest.mark.long)], ids=["some", "all"])
def test_a_tie_to_a_wrong_expression_is_not_proved(compiled, store, some):
    """Twice the theory's side of one tie, with the ties that its proof uses."""
    texts = {
        tie_name(block): source.text
        for source in compiled.values()
        if source.name.endswith("Ties")
        for block in THEOREM.findall(source.text)
    }
    assert len(texts) > 20
    for name in some or sorted(texts.keys() - {"tie_solution", "tie_captive", "tie_stick_rotation", "tie_forced"}):
        blocks = {tie_name(one): one for one in THEOREM.findall(texts[name])}
        wanted = [name]
        for one in wanted:
            wanted += [other for other in blocks if other not in wanted and re.search(rf"\b{other}\b", blocks[one])]
        kept = [made_wrong(text) if one == name else text for one, text in blocks.items() if one in wanted]
        wrong = Source("Wrong", THEOREM.sub("", texts[name]) + "".join(kept))
        assert first_broken(wrong, compiled, store).startswith(f"Wrong.{name} ")


def made_wrong(block):
    """A tie with twice the right side of its last equation, 1 in place of 0, or with one more in its last bound."""
    statement, proof = block.split(".\nProof.", maxsplit=1)
    before, sign, after = max((statement.rpartition(sign) for sign in (" = ", " <= F")), key=lambda cut: len(cut[0]))
    right = "1" if after.strip() == "0" else f"2 * {after}"
    changed = f"{sign}{right}" if sign == " = " else f"{sign} + 1{after}"
    return f"{before}{changed}.\nProof.{proof}"
