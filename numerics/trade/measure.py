"""The whole trade at one of three sizes: every contender at its settings on every scene, each in a fresh process."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from importlib.util import find_spec
from typing import Any, NamedTuple

from numerics.errors import NumericsError
from numerics.trade.contenders import CONTENDERS, Contender
from numerics.trade.recorded import Run, Trade, machine
from numerics.trade.scenes import FORCED, LONG, NAMES, kind, why


class Size(NamedTuple):
    """How much is measured."""

    scenes: Sequence[str]
    settings: int
    """Of each peer at most, the finest."""
    limit: float
    """How long one of them may take, s, compiling and repeating included."""


SIZES = {
    "small": Size(("relative-motion-b05", "near-critical-1e-6", "forced-stick-slip"), 1, 60),
    "default": Size(NAMES, 2, 120),
    "large": Size(NAMES, 10, 900),
}


class NoSuchContender(NumericsError):
    """A name that fits no contender and no scene; the message lists them."""


def trade(size_name: str, only: Sequence[str] = (), progress: Callable[[str], None] = lambda _: None) -> Trade:
    """Measure everybody on every scene; `only` keeps those whose names contain one of its words.

    "free" and "forced" name the scenes without a force and with one. Raises NoSuchContender if a word fits no name.
    """
    size, of = SIZES[size_name], machine()
    everyone, scenes = selected(only, size.scenes)
    left_out = {one.label: missing for one in everyone if (missing := one.missing()) is not None}
    if not find_spec("pyperf"):
        left_out["all times"] = "pyperf (extra `comparisons`)"
    runs: list[Run] = []
    for scene in scenes:
        for one in everyone:
            progress(f"{scene}: {one.label}")
            runs += [] if one.label in left_out else runs_of(one, scene, size)
    return Trade(size_name, of, left_out, {name: why(name) for name in scenes}, tuple(runs))


def selected(only: Sequence[str], scenes: Sequence[str]) -> tuple[list[Contender], list[str]]:
    """Return the contenders and the scenes that `only` names, all of a kind of which it names none."""
    names = [one.label for one in CONTENDERS] + [f"{kind(name)}: {name}" for name in scenes]
    kept: set[str] = set()
    for word in only:
        fits = {name for name in names if word.strip() and word.lower() in name.lower()}
        if not fits:
            raise NoSuchContender(f"--only {word[:40]!r} fits no contender and no scene; they are: {'; '.join(names)}")
        kept |= fits
    some = [one for one in CONTENDERS if one.label in kept] or list(CONTENDERS)
    return some, [name for name in scenes if f"{kind(name)}: {name}" in kept] or list(scenes)


def runs_of(one: Contender, scene: str, size: Size) -> Iterator[Run]:
    """Yield a run at every setting of a contender, from coarse to fine; after one that was stopped none is tried."""
    settings = [setting for setting in one.settings if setting <= 100 or not scene.startswith((FORCED, LONG))]
    for setting in settings if one.ours else settings[-size.settings :]:
        answer = answered([sys.executable, "-m", "numerics.trade.fresh", one.label, scene, str(setting)], size.limit)
        note = answer.get("note") or answer.get("difference") or ""
        numbers = (answer.get("seconds"), answer.get("deviation"), answer.get("digits"))
        yield Run(scene, one.label, one.ours, setting, *numbers, None if "note" in answer else not note, note)
        if note.startswith("stopped"):
            return


def answered(command: list[str], limit: float) -> dict[str, Any]:
    """Run a command and return the JSON of its last line; after `limit` s it is ended with all it has started."""
    pipes: dict[str, Any] = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "encoding": "utf-8"}
    with subprocess.Popen(command, start_new_session=True, **pipes) as process:
        try:
            out, complaints = process.communicate(timeout=limit)
            return dict(json.loads(out.splitlines()[-1]))
        except subprocess.TimeoutExpired:
            return {"note": f"stopped after {limit:g} s"}
        except (IndexError, ValueError):
            return {"note": f"ended with code {process.returncode}: {complaints.strip()[-200:]}"}
        finally:
            if process.poll() is None:
                os.killpg(process.pid, signal.SIGKILL) if hasattr(os, "killpg") else process.kill()
