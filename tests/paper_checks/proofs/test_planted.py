"""Every planted false statement, and every tie with a planted factor, breaks a proof; the long tests try most."""

import re
import tomllib
from pathlib import Path

import pytest

from paper_checks.proofs import kernel, library
from paper_checks.proofs.sources import Source, all_required, in_order

TIES = ["tie_critical_energy", "tie_non_stop_damped"]
THEOREM = re.compile(r"^Theorem .*? Qed\.\n", re.MULTILINE | re.DOTALL)

PLANTED = tomllib.loads((Path(__file__).parents[2] / "planted_proofs.toml").read_text("utf-8"))["planted"]

pytestmark = [pytest.mark.slow, pytest.mark.usefixtures("needs_kernel")]


@pytest.fixture(scope="session")
def compiled():
    store = kernel.cache_folder()
    with kernel.locked(store):
        sources, _ = library._sources(library.FOLDER, store)
        assert not kernel.compile_all(sources, store=store).broken
    return sources


def first_broken(changed, sources, store):
    """What breaks first when a file is replaced: itself, or a file that rests on it."""
    sources = sources | {changed.name: changed}
    for name in in_order(sources):
        below = all_required(name, sources) | {name}
        if changed.name in below:
            found = kernel.compile_all({one: sources[one] for one in below}, store=store)
            if found.broken:
                return found.broken[name]
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
    ties = compiled[library.TIES].text
    blocks = {tie_name(block): block for block in THEOREM.findall(ties)}
    assert len(blocks) > 20
    for name in some or sorted(blocks.keys() - {"tie_solution", "tie_captive", "tie_stick_rotation"}):
        wanted = [name]
        for one in wanted:
            wanted += [other for other in blocks if other not in wanted and re.search(rf"\b{other}\b", blocks[one])]
        kept = [made_wrong(block) if one == name else block for one, block in blocks.items() if one in wanted]
        text = THEOREM.sub("", ties) + "".join(kept)
        assert first_broken(Source("Wrong", text), compiled, store).startswith(f"Wrong.{name} ")


def made_wrong(block):
    """A tie with twice the right side of its last equation, 1 in place of 0, or with one more in its last bound."""
    statement, proof = block.split(".\nProof.", maxsplit=1)
    before, sign, after = max((statement.rpartition(sign) for sign in (" = ", " <= F")), key=lambda cut: len(cut[0]))
    right = "1" if after.strip() == "0" else f"2 * {after}"
    changed = f"{sign}{right}" if sign == " = " else f"{sign} + 1{after}"
    return f"{before}{changed}.\nProof.{proof}"
