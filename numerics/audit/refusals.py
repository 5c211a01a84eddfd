"""Spoiled scene texts tried, and how each was refused.

Half of the texts carry a fault of a known kind, so they describe no scene. The others have random characters changed:
they are refused, or read as a scene that its own text gives again.
"""

from __future__ import annotations

import re
import time
from collections import Counter
from collections.abc import Callable, Iterator
from random import Random

from numerics.audit.table import Progress, Row, counted
from numerics.errors import InvalidScene
from numerics.scene import Scene
from numerics.scene.file import parse_scene
from numerics.scene.writing import scene_text

MOST_SECONDS, _KEPT = 1.0, 5
_PAIR, _INITIAL = ("m1", "m2", "a2", "b"), ("x1", "v1", "x2", "v2")
_NO_NUMBERS = (
    "nan inf -inf true 1979-05-27 12:00:00 [1] [1,2,3,4] {} {x=1} + --1 1e1001 -1e-1001 1e999999999 1e .5 1. 01 1__0 "
    '1,5 "" "nan" "sNaN" "0x10" "1,5" "1_000" "1e1.5" "e5" "1/0" "1/" "/2" "1/2/3" "1//2" "1/nan" "0x1/2" 1/2 "½" "٣" '
    '"1e1001/3" "--1" "+-1" "1\\n2" "\\u0000" "$(reboot)" "__import__"'
)
_NOT_POSITIVE = '0 0.0 -0.0 "0e5" "0/7" "-.0" 0e-1000 -1 "-1e-300" "-2/3"'
_LINES = (  # each of them spoils any scene
    *("[pair", "m1 == 1", "= 3", "\x00", "]", '"""', "a.b.c", "\x1b[2J", "[pairs]", "[Initial]\nx1 = 1", "[output]"),
    *("[[pair]]\nm1 = 1", "law = 1", 'law = "Filippov"', "law = []", "m3 = 1", "M1 = 1", "'x1 ' = 1", "until_ = 1"),
    *("[[force]]\nfrom = -1", "[[force]]\nsines = 3", "[[friction]]\nb = 0", "[[friction]]\nfrom = 1"),
)


def audit_refusals(
    seed: int, cases: int, progress: Progress, reader: Callable[[str], Scene] = parse_scene
) -> Iterator[Row]:
    """Yield a row for texts with a known fault and one for texts with random characters changed, `cases` each."""
    for name, draw in {"a known fault": _faulty, "characters changed at random": _scrambled}.items():
        random, reasons, other, slow = Random(f"{seed} {name}"), Counter[str](), [], 0
        wrongly, valid = [], 0
        for _ in counted(cases, f"invalid scenes: {name}", progress):
            text, start = draw(random), time.process_time()
            try:
                scene = reader(text)
                valid += 1
                wrongly += [text] if draw is _faulty or parse_scene(scene_text(scene)) != scene else []
            except InvalidScene as error:
                reasons[reason(str(error))] += 1
            except Exception as error:  # noqa: BLE001  # whatever it is, it is what this row looks for
                other.append(f"{type(error).__name__}: {text}")
            slow += time.process_time() - start > MOST_SECONDS
        measured = {"refused": reasons.total(), "scenes": valid, "accepted wrongly": len(wrongly)}
        measured |= {"other errors": len(other), f"over {MOST_SECONDS:g} s": slow}
        passed = reasons.total() > 0 and not (wrongly or other or slow)
        details = [{"reasons": dict(sorted(reasons.items())), "wrongly": wrongly[:_KEPT], "other": other[:_KEPT]}]
        yield Row("refusals", name, cases, measured, "only InvalidScene, none accepted wrongly", passed, details)


def reason(message: str) -> str:
    """Return the kind of a refusal: its message with what belongs to the one scene taken out."""
    head = re.split(r"[;:]", re.sub(r"'[^']*'|\"[^\"]*\"", "...", message))[0]
    head = re.sub(r"\b(m1|m2|a1|a2|b|x1|v1|x2|v2|until)\b", "NAME", head)
    head = re.sub(r"not (?!one of|a TOML).*", "not ...", re.sub(r"[0-9]+ characters", "too many characters", head))
    return re.sub(r"= .*?(must|has an|is not)", r"= ... \1", head)[:80].strip()


def _text(random: Random, spoiled: str = "", value: str = "") -> str:
    """Return the text of a scene, its numbers in any of the forms that are allowed; one of them spoiled."""

    def line(key: str) -> str:
        sign = random.choice(("", "-")) if key in _INITIAL else ""
        digits = f"{sign}{random.randint(1, 9)}.{random.randint(1, 999)}e{random.randint(-200, 200)}"
        number = random.choice((digits, f'"{digits}"', f'"{digits}/7"'))
        return f"{key} = {value if key == spoiled else number}"

    tables = {"pair": ("a1", *_PAIR), "initial": _INITIAL, "run": ("until",)}
    return "\n".join(one for table, keys in tables.items() for one in (f"[{table}]", *map(line, keys)))


def _faulty(random: Random) -> str:
    """Return a text with exactly one fault: no scene."""
    positive, depth = random.choice((*_PAIR, "until")), random.randint(2, 3000)
    match random.randrange(5):
        case 0:
            deep = ("9" * (2001 + depth), "[" * depth + "]" * depth)
            return _text(random, random.choice((*_PAIR, *_INITIAL)), random.choice((*_NO_NUMBERS.split(), *deep)))
        case 1:
            return _text(random, positive, random.choice(_NOT_POSITIVE.split()))
        case 2:
            return re.sub(rf"^{positive} = .*$", "", _text(random), flags=re.MULTILINE)
        case 3:
            return f"{random.choice(_LINES)}\n{_text(random)}"
        case _:
            return f"{_text(random)}\n{random.choice(_LINES)}"


def _scrambled(random: Random) -> str:
    """Return the text of a scene with some characters deleted, doubled, or replaced by others."""
    characters = list(_text(random))
    for _ in range(random.randint(1, 4)):
        place = random.randrange(len(characters))
        characters[place] = random.choice(("", characters[place] * 2, *'0123456789eE+-./"=[]\n #_x\x00é'))
    return "".join(characters)
