"""Maps of proved cells: a cell is where its place says, and what is not exactly a tree is no checkpoint."""

from enum import Enum
from fractions import Fraction

import pytest

from numerics.errors import InvalidMap
from numerics.free.quadtree import Verdicts, _decode, map_of

WINDOW = ((Fraction(1), Fraction(16)), (Fraction(1), Fraction(256)))


class Letter(Enum):
    LEFT = "l"
    RIGHT = "r"
    OPEN = "u"


def left_or_right(sides):
    """By the first quantity alone, with a border at 4: half of the window's logarithmic width."""
    (low, high), _ = sides
    return Letter.LEFT if high <= 4 else Letter.RIGHT if low >= 4 else Letter.OPEN


VERDICTS = Verdicts(left_or_right, Letter, Letter.OPEN)


def test_a_raster_has_the_first_quantity_to_the_right_and_the_second_upwards():
    found = map_of(WINDOW, 4, VERDICTS, {})
    grid = found.raster(Letter)
    assert (grid[:, :8] == 0).all()
    assert (grid[:, 8:] == 1).all()
    assert len(found.leaves) == 64  # no block is cut further
    assert found.shares() == {Letter.LEFT: 0.5, Letter.RIGHT: 0.5, Letter.OPEN: 0.0}


@pytest.mark.parametrize("tree", ["", "+lr", "+lrlrl", "ll", "x", "+lr+lrl", "+lr+lr+lrlrll"])
def test_a_text_that_is_not_one_tree_is_refused(tree):
    block, *_ = map_of(WINDOW, 1, Verdicts(lambda _: Letter.OPEN, Letter, Letter.OPEN), {}).leaves
    with pytest.raises(InvalidMap, match="damaged block"):
        _decode(tree, block, 3, VERDICTS)
    assert len(_decode("+lr+lrlrl", block, 3, VERDICTS)) == 7
