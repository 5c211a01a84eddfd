"""Invalid scene texts tried, and how each was refused.

Half of the texts carry a fault of a known kind, so they describe no scene by construction. The others have random
characters changed; whether they still describe one is decided by `describes_a_scene`, a second reading that shares no
code with scene/.
"""

from __future__ import annotations

import re
import time
import tomllib
from collections import Counter
from collections.abc import Callable, Iterator
from fractions import Fraction
from random import Random
from typing import Any

from numerics.audit.table import Progress, Row, counted
from numerics.errors import InvalidScene
from numerics.scene.file import parse_scene

MOST_SECONDS = 1.0
_KEPT = 5
_SECTIONS = {"pair": ("m1", "m2", "a1", "a2", "b"), "initial": ("x1", "v1", "x2", "v2"), "run": ("law", "until")}
_POSITIVE = ("m1", "m2", "a2", "b", "until")
_LAWS = ("filippov", "three-valued-sgn")

Tables = dict[str, dict[str, str]]
Reader = Callable[[str], object]

_NO_NUMBERS = (
    *("nan", "inf", "-inf", "true", "1979-05-27", "12:00:00", "[1]", '["1","2"]', "{}", "{x=1}", "", "+", "--1"),
    *("1e1001", "-1e-1001", "1e999999999", "1e99999999999999999999", "1e", ".5", "1.", "01", "1__0", "1,5", "1 kg"),
    *('""', '" "', '"', '"nan"', '"inf"', '"sNaN"', '"0x10"', '"1,5"', '"1 kg"', '"1_000"', '"1e1.5"', '"e5"'),
    *('"1/0"', '"1/"', '"/2"', '"1/2/3"', '"1//2"', '"1/0e9"', '"1/nan"', '"0x1/2"', "1/2", '"1e1001/3"', '"½"'),
    *('"٣"', '"१"', '"--1"', '"+-1"', '"1e1001"', '"__import__"', '"1\\n2"', '"\\u0000"', '"$(reboot)"'),
)
_NO_LAWS = ('"Filippov"', '""', "1", "true", "[]", "nan", '"filippov "', '"three_valued_sgn"', "{}")
_NO_TOML = (
    "[pair",
    "m1 == 1",
    "= 3",
    "\x00",
    "[[pair]]\nm1 = 1",
    "]",
    '"""',
    "a.b.c",
    "\x1b[2J",
    "pair.m1 = 3",
    "\ufeff",
)


def audit_refusals(seed: int, cases: int, progress: Progress, reader: Reader | None = None) -> Iterator[Row]:
    """Yield a row for texts with a known fault and one for texts with random characters changed, `cases` each."""
    ways: dict[str, tuple[Callable[[Random], str], Callable[[str], bool]]] = {
        "a known fault": (_faulty, lambda _: False),
        "characters changed at random": (_scrambled, describes_a_scene),
    }
    for name, (draw, is_scene) in ways.items():
        random = Random(f"{seed} {name}")
        texts = (draw(random) for _ in counted(cases, f"invalid scenes: {name}", progress))
        yield _refusal_row(name, texts, is_scene, reader or parse_scene)


def _refusal_row(name: str, texts: Iterator[str], is_scene: Callable[[str], bool], reader: Reader) -> Row:
    reasons, accepted, wrongly_refused, other_errors, slow = Counter[str](), [], [], [], 0
    tried = valid = 0
    for text in texts:
        tried += 1
        expected, start = is_scene(text), time.process_time()
        try:
            reader(text)
        except InvalidScene as error:
            reasons[reason(str(error))] += 1
            wrongly_refused += [text] if expected else []
        except Exception as error:  # noqa: BLE001  # whatever it is, it is what this row looks for
            other_errors.append(f"{type(error).__name__}: {text}")
        else:
            valid += expected
            accepted += [] if expected else [text]
        slow += time.process_time() - start > MOST_SECONDS
    measured = {
        "refused": reasons.total(),
        "still valid": valid,
        "accepted wrongly": len(accepted),
        "refused wrongly": len(wrongly_refused),
        "other errors": len(other_errors),
        f"over {MOST_SECONDS:g} s": slow,
    }
    details = [
        {
            "reasons": dict(sorted(reasons.items())),
            "accepted_wrongly": accepted[:_KEPT],
            "refused_wrongly": wrongly_refused[:_KEPT],
            "other_errors": other_errors[:_KEPT],
        }
    ]
    passed = reasons.total() > 0 and not (accepted or wrongly_refused or other_errors or slow)
    return Row("refusals", name, tried, measured, "only InvalidScene, none wrongly, none slow", passed, details)


def reason(message: str) -> str:
    """Return the kind of a refusal: its message with what belongs to the one scene taken out."""
    if message.startswith("not a TOML scene"):
        return "not a TOML scene"
    head = re.split(r"[;:]", re.sub(r"'[^']*'|\"[^\"]*\"", "...", message))[0]
    head = re.sub(r"\b(m1|m2|a1|a2|b|x1|v1|x2|v2|until)\b", "NAME", head)
    head = re.sub(r"[0-9]+ characters", "too many characters", head)
    head = re.sub(r"not (?!one of).*", "not ...", head)
    return re.sub(r"= .*?(must|has an|is not)", r"= ... \1", head)[:80].strip()


def _scene(random: Random) -> Tables:
    """Return a valid scene, its numbers as TOML text in any of the forms that are allowed."""

    def number() -> str:
        digits = f"{random.randint(1, 9)}.{random.randint(1, 999)}"
        text = random.choice((str(random.randint(1, 99)), digits, f"{digits}e{random.randint(-200, 200)}"))
        return random.choice((text, f'"{text}"', f'"{text}/{random.randint(1, 99)}"'))

    return {
        "pair": {name: number() for name in _SECTIONS["pair"]},
        "initial": {name: random.choice(("", "-")) * (text[0] != '"') + text for name, text in _initial(number)},
        "run": {"law": f'"{random.choice(_LAWS)}"', "until": number()},
    }


def _initial(number: Callable[[], str]) -> list[tuple[str, str]]:
    return [(name, number()) for name in _SECTIONS["initial"]]


def _text(tables: Tables) -> str:
    return "\n".join(
        f"[{table}]\n" + "\n".join(f"{key} = {value}" for key, value in content.items())
        for table, content in tables.items()
    )


def _faulty(random: Random) -> str:
    """Return a text with exactly one fault, of one of the kinds below: no scene, whatever `describes_a_scene` says."""
    tables = _scene(random)
    kind = random.choice(("number", "sign", "zero", "missing", "unknown", "table", "law", "toml", "long", "nested"))
    table = random.choice(("pair", "initial", "run"))
    key = "until" if table == "run" else random.choice(_SECTIONS[table])
    positive = random.choice(_POSITIVE)
    home = "run" if positive == "until" else "pair"
    if kind == "number":
        tables[table][key] = random.choice(_NO_NUMBERS)
    elif kind == "sign":
        tables[home][positive] = f'"-{tables[home][positive].strip(chr(34))}"'
    elif kind == "zero":
        tables[home][positive] = random.choice(("0", "0.0", "-0.0", '"0e5"', '"0/7"', '"-.0"', "0e-1000"))
    elif kind == "missing":
        del tables[home][positive]
    elif kind == "unknown":
        tables[table][random.choice(("m3", "M1", "mass", "'a b'", '"x1 "', "µ", "until_"))] = "1"
    elif kind == "table":
        tables[random.choice(("pairs", "Initial", "'run '", "output", "pair.more"))] = {"m1": "1"}
    elif kind == "law":
        tables["run"]["law"] = random.choice(_NO_LAWS)
    elif kind == "long":
        tables[table][key] = f'"{"9" * random.randint(1001, 9000)}"'
    elif kind == "nested":
        depth = random.randint(2, 3000)
        tables[table][key] = "[" * depth + "]" * depth
    broken = random.choice(_NO_TOML) if kind == "toml" else ""
    return random.choice((f"{broken}\n{_text(tables)}", f"{_text(tables)}\n{broken}")) if broken else _text(tables)


def _scrambled(random: Random) -> str:
    """Return a valid text with one to four characters changed, doubled, taken out or swapped."""
    characters = list(_text(_scene(random)))
    for _ in range(random.randint(1, 4)):
        at = random.randrange(len(characters) - 1)
        kind = random.randrange(4)
        if kind == 0:
            characters[at] = random.choice("0123456789/.-+eE_\"'[]{}=#,\n \\xnµ٣\x00abmv")
        elif kind == 1:
            characters.insert(at, characters[at])
        elif kind == 2:
            del characters[at]
        else:
            characters[at], characters[at + 1] = characters[at + 1], characters[at]
    return "".join(characters)


class _FloatText(str):
    """The text of a TOML float, in which underscores are allowed."""


def describes_a_scene(text: str) -> bool:
    """Return whether a text is a scene: every key known, every number in the grammar and its bound, the law named."""
    try:
        tables: dict[str, Any] = tomllib.loads(text, parse_float=_FloatText)
    except (ValueError, RecursionError):
        return False
    if not all(name in _SECTIONS and isinstance(content, dict) for name, content in tables.items()):
        return False
    values = {key: value for content in tables.values() for key, value in content.items()}
    if not all(key in _SECTIONS[name] for name, content in tables.items() for key in content):
        return False
    law = values.pop("law", _LAWS[0])
    if isinstance(law, _FloatText) or law not in _LAWS or not set(_POSITIVE) <= set(values):
        return False
    numbers = {key: _read(value) for key, value in values.items()}
    exact = {key: number for key, number in numbers.items() if number is not None}
    return len(exact) == len(numbers) and all(exact[key] > 0 for key in _POSITIVE) and exact.get("a1", Fraction(0)) >= 0


def _read(value: object) -> Fraction | None:
    """Return a decimal in the allowed range, or a ratio of two of them; None for everything else."""
    if type(value) is int:
        return Fraction(value) if abs(value) < 10**2000 else None
    if not isinstance(value, str):
        return None
    parts = [value.replace("_", "")] if isinstance(value, _FloatText) else value.split("/")
    read = [_decimal(part.strip()) for part in parts]
    above, below = read[0], read[1] if len(read) > 1 else Fraction(1)
    return above / below if len(read) <= 2 and above is not None and below else None


def _decimal(text: str) -> Fraction | None:
    """Return a decimal in the allowed range, None for everything else: read character by character."""
    mantissa, mark, exponent = text.lower().partition("e")
    sign = mantissa[:1] if mantissa[:1] in ("+", "-") else ""
    whole, _, part = mantissa[len(sign) :].partition(".")
    digits = whole + part
    power = exponent[1:] if exponent[:1] in ("+", "-") else exponent
    plain = set(digits + power) <= set("0123456789")
    if len(text) > 1000 or not plain or not digits or bool(mark) != bool(power) or len(exponent) > 6:
        return None
    shift = int(exponent or "0")
    if abs(shift) > 1000:
        return None
    return Fraction(int(digits) * (-1 if sign == "-" else 1)) * Fraction(10) ** (shift - len(part))
