"""The proof kernel on this machine: whether it is here, and compiling files with it into the user's cache.

What is compiled is kept in one folder a file, named by the file's key. The compiler works in a temporary folder that gets
that name only when it has finished: an interrupted run leaves nothing that could be taken for a proof.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from functools import cache
from graphlib import TopologicalSorter
from pathlib import Path

from numerics import files
from paper_checks.proofs.sources import LIBRARY, Source, digest, keys, needed

PACKAGES = "coq libcoq-coquelicot libcoq-interval"
TESTED_VERSION = "8.16"
_LIBRARIES = ("Coquelicot", "Interval")
_FOLDERS = 500  # how many are kept, beside those of the last day: five whole libraries
_PATIENCE = 900  # seconds for one file; the longest takes less than a tenth of that

Progress = Callable[[int, int], None]
"""Called with the number of files done, and that of all files that have to be compiled."""


def why_not() -> str:
    """Why the kernel cannot run, in one line; empty if it can."""
    return _missing(os.environ.get("PATH")) or _cannot_keep()


@cache
def _said(option: str, search_path: str | None) -> str:
    """What the compiler answers to an option; empty where it is not there."""
    coqc = shutil.which("coqc", path=search_path)
    if coqc is None:
        return ""
    return subprocess.run([coqc, option], capture_output=True, encoding="utf-8", check=False).stdout.strip()


def _missing(search_path: str | None) -> str:
    where = _said("-where", search_path)
    missing = [name for name in _LIBRARIES if not (Path(where) / "user-contrib" / name).is_dir()] if where else ["coqc"]
    return f"kernel not run: {' and '.join(missing)} is not installed (Debian: {PACKAGES})" if missing else ""


def _cannot_keep() -> str:
    if files.cache_refused():
        return (
            "kernel not run: the user's cache is not used, as others can change it; its folder must be the user's alone"
        )
    try:
        files.make_private(cache_folder())
        with tempfile.TemporaryFile(dir=cache_folder()) as file:
            file.write(b"a full disk refuses this")
    except OSError as error:  # the folder itself is not named: a report says the same everywhere
        remedy = "set XDG_CACHE_HOME to a folder that can"
        return f"kernel not run: the user's cache cannot be written ({error.strerror}); {remedy}"
    return ""


def cache_folder() -> Path:
    """Where compiled proofs are kept: `inertial-pair/proofs` in the user's cache."""
    return files.cache_folder() / "proofs"


def version(search_path: str | None) -> str:
    """What the compiler calls itself: two numbers, its own and OCaml's."""
    return _said("--print-version", search_path)


@cache
def identity(search_path: str | None) -> str:
    """The compiler's version and a hash of the compiled libraries beside it: a proof rests on those that it requires."""
    seen = (path for path in (Path(_said("-where", search_path)) / "user-contrib").rglob("*.vo"))
    sizes = (f"{path.parent.name}/{path.name} {path.stat().st_size} {path.stat().st_mtime_ns}" for path in seen)
    return f"{version(search_path)} {digest(sorted(sizes))}"


@dataclass
class Compiled:
    """What compiling has come to: the folder of each file that compiles, and one line for each that does not."""

    folders: dict[str, Path] = field(default_factory=dict)
    broken: dict[str, str] = field(default_factory=dict)

    def arguments(self) -> list[str]:
        """The compiler's options that make every compiled file known."""
        return [word for folder in self.folders.values() for word in ("-Q", str(folder), LIBRARY)]


def compile_files(
    wanted: Iterable[str],
    sources: Mapping[str, Source],
    progress: Progress | None = None,
    jobs: int = 2,
    store: Path | None = None,
) -> Compiled:
    """Compile files and what they rest on, `jobs` at a time; what is kept is not compiled.

    A file that fails does not stop those that do not rest on it. On an interrupt the compilers that run are ended.
    """
    store = store or cache_folder()
    files.make_private(store)
    order = needed(wanted, sources)
    kept = {
        name: store / key
        for name, key in keys({name: sources[name] for name in order}, identity(os.environ.get("PATH"))).items()
    }
    missing = [name for name in order if not (kept[name] / f"{name}.vo").exists()]
    compiled, running = Compiled(), dict[Future[str], str]()
    sorter = TopologicalSorter({name: sources[name].requires for name in order})
    sorter.prepare()
    with ThreadPoolExecutor(jobs) as pool, _ending(pool) as processes:
        while sorter.is_active():
            for name in sorter.get_ready():
                if lost := [one for one in sources[name].requires if one in compiled.broken]:
                    compiled.broken[name] = f"{name}.v rests on {lost[0]}.v, which does not compile"
                elif name in missing:
                    arguments = compiled.arguments()
                    running[pool.submit(_coqc, sources[name], kept[name], arguments, processes)] = name
                    continue
                else:
                    compiled.folders[name] = kept[name]
                    with suppress(OSError):  # another process has forgotten it
                        os.utime(kept[name])
                sorter.done(name)
            for future in wait(running, return_when=FIRST_COMPLETED).done:
                name = running.pop(future)
                if complaint := future.result():
                    compiled.broken[name] = complaint
                else:
                    compiled.folders[name] = kept[name]
                sorter.done(name)
            if progress and missing:
                progress(sum(one in compiled.folders or one in compiled.broken for one in missing), len(missing))
    files.forget_unused(store, _FOLDERS)
    return compiled


@contextmanager
def _ending(pool: ThreadPoolExecutor) -> Iterator[set[subprocess.Popen[str]]]:
    """Yield a set for processes; whatever ends the block, an interrupt among it, ends those that are in it."""
    processes: set[subprocess.Popen[str]] = set()
    try:
        yield processes
    finally:
        pool.shutdown(wait=False, cancel_futures=True)
        for process in tuple(processes):
            process.kill()


def _coqc(source: Source, kept: Path, arguments: list[str], processes: set[subprocess.Popen[str]]) -> str:
    """Compile one file into the folder where it is kept; return in one line what is wrong with it."""
    with tempfile.TemporaryDirectory(prefix=".compiling-", dir=kept.parent, ignore_cleanup_errors=True) as folder:
        Path(folder, f"{source.name}.v").write_text(source.text, "utf-8")
        command = ["coqc", "-q", "-w", "none", *arguments, "-Q", ".", LIBRARY, f"{source.name}.v"]
        # a session of its own: Ctrl-C in the terminal reaches us, and we end it
        process = subprocess.Popen(
            command,
            cwd=folder,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            encoding="utf-8",
            start_new_session=True,
        )
        processes.add(process)
        try:
            _, errors = process.communicate(timeout=_PATIENCE)
        except subprocess.TimeoutExpired:
            errors = f"after {_PATIENCE} s it was ended"
        finally:
            process.kill()
            processes.discard(process)
        if process.wait():
            return complaint(source, errors)
        with suppress(OSError):  # another process was quicker; its result is the same
            Path(folder).rename(kept)
    return "" if kept.is_dir() else f"{source.name}.v: its folder in the cache cannot be written"


def complaint(source: Source, errors: str) -> str:
    """What the compiler says, as one line that begins with the name of the statement it is about."""
    lines = errors.splitlines()
    places = [number for number, line in enumerate(lines) if line.startswith("File ") and ", line " in line]
    if not places:
        return f"{source.name}.v does not compile: {' '.join(errors.split())[:200] or 'the compiler was ended'}"
    line = int(lines[places[-1]].split(", line ")[1].split(",")[0])
    said = " ".join(" ".join(lines[places[-1] + 1 :]).split())
    return f"{source.declared_before(line)} is not proved (line {line} of {source.name}.v): {said[:200]}"
