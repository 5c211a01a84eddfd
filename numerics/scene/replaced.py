"""The same scene with other parts or numbers."""

from __future__ import annotations

from inspect import signature
from typing import Any, TypeVar

from numerics.habits import right_word

_S = TypeVar("_S")


def replaced(scene: _S, changes: dict[str, object], inner: tuple[str, ...]) -> _S:
    """Return a scene with other parts; a number goes to the one of its `inner` parts that has it."""
    owners = {key: name for name in inner for key in _parts(getattr(scene, name))}
    own, new = _parts(scene), dict(changes)
    for word in changes:
        if word not in own and word not in owners:
            raise TypeError(f"replace has no {word!r}: {right_word(word, [*own, *owners])}")
    if "belt" in new and any(getattr(one, "pieces", ()) for one in (own["belt"], new["belt"])):
        new.setdefault("v2", 0)  # a belt gives body 2 its velocity
    for name in inner:
        given = {key: new.pop(key) for key in list(new) if key not in own and owners[key] == name}
        if given:
            part = new.get(name, own[name])
            new[name] = type(part)(**_parts(part) | given)
    return type(scene)(**own | new)


def _parts(record: Any) -> dict[str, Any]:
    """Return what a record is built of."""
    return {name: getattr(record, name) for name in signature(type(record)).parameters}
