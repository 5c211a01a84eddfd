"""What is asked by mistake is refused in one sentence that says what to do: a table of expressions and answers."""

import re
from pathlib import Path

import pytest

_, NAMES, TABLE = (Path(__file__).parent / "mistakes.txt").read_text("utf-8").split("\n\n", 2)
ROWS = [re.split("  +# |: ", line, maxsplit=2) for line in TABLE.splitlines() if "  # " in line]


@pytest.fixture(scope="module")
def known():
    names = {}
    exec(NAMES, names)
    return names


@pytest.mark.parametrize(("call", "error", "said"), ROWS)
def test_a_mistake_is_answered_in_one_sentence(known, call, error, said):
    with pytest.raises(Exception, match=said) as refused:
        eval(call, known)
    assert refused.type.__name__ == error
    assert "\n" not in str(refused.value)
