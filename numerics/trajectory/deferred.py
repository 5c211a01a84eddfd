"""A sequence whose items are made when somebody asks for them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeVar, overload

Item = TypeVar("Item")


class Deferred(Sequence[Item]):
    """`length` items, each made once by `make(index)`, when first looked at; slices are tuples."""

    def __init__(self, make: Callable[[int], Item], length: int) -> None:
        """Keep what makes the items."""
        self._make, self._length = make, length
        self._made: dict[int, Item] = {}

    def __len__(self) -> int:
        """Return how many items there are, made or not."""
        return self._length

    def __eq__(self, other: object) -> bool:
        """Return whether another sequence has equal items, as two tuples would."""
        return isinstance(other, Sequence) and tuple(self) == tuple(other)

    __hash__ = None  # type: ignore[assignment]

    def __add__(self, other: Sequence[Item]) -> tuple[Item, ...]:
        """Return the tuple of both."""
        return (*self, *other)

    def __repr__(self) -> str:
        """Return what the tuple of all items would show."""
        return repr(tuple(self))

    @overload
    def __getitem__(self, index: int) -> Item: ...

    @overload
    def __getitem__(self, index: slice) -> tuple[Item, ...]: ...

    def __getitem__(self, index: int | slice) -> Item | tuple[Item, ...]:
        """Return an item, or the items of a slice."""
        if isinstance(index, slice):
            return tuple(self[one] for one in range(self._length)[index])
        at = range(self._length)[index]
        if at not in self._made:
            self._made[at] = self._make(at)
        return self._made[at]
