"""The proof kernel on this machine: whether it is here, and compiling files with it into the user's cache.

What is compiled is kept in one folder a file, named by the file's key. The compiler works in a temporary folder that gets
that name only when it has finished: an interrupted run leaves nothing that could be taken for a proof.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

from numerics import files
from paper_checks.proofs.sources import LIBRARY, Source, all_required, digest, in_order, keys

try:
    import fcntl
except ImportError:  # not a POSIX system
    fcntl = None  # type: ignore[assignment]

PACKAGES = "coq libcoq-coquelicot libcoq-interval"
TESTED_VERSION = "8.16"
_LIBRARIES = ("Coquelicot", "Interval")
_FOLDERS = 400  # how many are kept, beside those of the last day: five whole libraries
_PATIENCE = 900  # seconds for one file; the longest takes less than a tenth of that

Progress = Callable[[int, int, str], None]
"""Called with the number of files done, that of all files, and the name of the last one; (0, 0, why) while waiting."""


@cache
def why_not(search_path: str | None) -> str:
    """Why the kernel cannot run with this PATH, in one line; empty if it can."""
    coqc = shutil.which("coqc", path=search_path)
    if coqc is None:
        return f"kernel not run: coqc is not installed (Debian: {PACKAGES})"
    asked = subprocess.run([coqc, "-where"], capture_output=True, encoding="utf-8", check=False)
    if asked.returncode:
        return f"kernel not run: coqc -where fails: {asked.stderr.strip()[:200]}"
    folders = [Path(asked.stdout.strip()) / "user-contrib" / name for name in _LIBRARIES]
    missing = [folder.name for folder in folders if not folder.is_dir()]
    return f"kernel not run: {' and '.join(missing)} not installed (Debian: {PACKAGES})" if missing else ""


def cannot_keep(store: Path) -> str:
    """Why nothing that is compiled can be kept in a store, in one line; empty if it can."""
    if store == cache_folder() and files.cache_refused():
        return (
            "kernel not run: the user's cache is not used, as others can change it; its folder must be the user's alone"
        )
    try:
        files.make_private(store)
        with tempfile.TemporaryFile(dir=store) as file:
            file.write(b"a full disk refuses this")
    except OSError as error:  # the folder itself is not named: a report says the same everywhere
        remedy = "set XDG_CACHE_HOME to a folder that can"
        return f"kernel not run: the user's cache cannot be written ({error.strerror}); {remedy}"
    return ""


@cache
def version(search_path: str | None) -> str:
    """What the compiler calls itself: two numbers, its own and OCaml's."""
    coqc = shutil.which("coqc", path=search_path) or "coqc"
    return subprocess.run([coqc, "--print-version"], capture_output=True, encoding="utf-8", check=True).stdout.strip()


@cache
def identity(search_path: str | None) -> str:
    """The compiler's version and a hash of the compiled libraries beside it: a proof rests on those that it requires."""
    coqc = shutil.which("coqc", path=search_path) or "coqc"
    asked = subprocess.run([coqc, "-where"], capture_output=True, encoding="utf-8", check=True)
    seen = (path for path in (Path(asked.stdout.strip()) / "user-contrib").rglob("*.vo"))
    sizes = (f"{path.parent.name}/{path.name} {path.stat().st_size} {path.stat().st_mtime_ns}" for path in seen)
    return f"{version(search_path)} {digest(sorted(sizes))}"


def cache_folder() -> Path:
    """Where compiled proofs are kept: `inertial-pair/proofs` in the user's cache."""
    return files.cache_folder() / "proofs"


@contextmanager
def locked(store: Path, progress: Progress | None = None) -> Iterator[None]:
    """Let one process at a time compile into a store, where the system can: a second one waits, says so, and finds all done."""
    files.make_private(store)
    with (store / "lock").open("wb") as file:
        if fcntl is not None:
            try:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                if progress:
                    progress(0, 0, "waiting for another process that compiles the proofs")
                fcntl.flock(file, fcntl.LOCK_EX)
        yield
        files.forget_unused(store, _FOLDERS)


@dataclass
class Compiled:
    """What compiling has come to: the folder of each file that compiles, and one line for each that does not."""

    folders: dict[str, Path] = field(default_factory=dict)
    broken: dict[str, str] = field(default_factory=dict)
    anew: int = 0
    """How many files were not in the cache."""

    def arguments(self) -> list[str]:
        """The compiler's options that make every compiled file known."""
        return [word for folder in self.folders.values() for word in ("-Q", str(folder), LIBRARY)]


def compile_all(
    sources: Mapping[str, Source],
    progress: Progress | None = None,
    jobs: int = 2,
    store: Path | None = None,
) -> Compiled:
    """Compile the files in the order of their requirements, `jobs` at a time; what the store holds is taken from it.

    A file that fails does not stop those that do not rest on it. On an interrupt the compilers that run are ended.
    """
    store = cache_folder() if store is None else store
    files.make_private(store)
    named = keys(sources, identity(os.environ.get("PATH")))
    found = Compiled()
    waiting = list(in_order(sources))
    running: list[_Run] = []

    def settled(name: str) -> bool:
        return all(one in found.folders for one in sources[name].requires)

    try:
        while waiting or running:
            for name in list(waiting):
                lost = [one for one in sources[name].requires if one in found.broken]
                if lost:
                    found.broken[name] = f"{name}.v rests on {lost[0]}.v, which does not compile"
                elif settled(name) and (store / named[name] / f"{name}.vo").exists():
                    found.folders[name] = store / named[name]
                    os.utime(found.folders[name])
                elif settled(name) and len(running) < jobs:
                    running.append(_Run(sources, name, store, named))
                else:
                    continue
                waiting.remove(name)
                if progress is not None and (name in found.folders or name in found.broken):
                    progress(len(found.folders) + len(found.broken), len(sources), name)
            for run in [one for one in running if one.finished()]:
                running.remove(run)
                _take(run, found)
                if progress is not None:
                    progress(len(found.folders) + len(found.broken), len(sources), run.source.name)
            if running:
                time.sleep(0.02)
    finally:
        for run in running:
            run.end()
    return found


def _take(run: _Run, found: Compiled) -> None:
    found.anew += 1
    complaint = run.keep()
    if complaint:
        found.broken[run.source.name] = complaint
    else:
        found.folders[run.source.name] = run.kept


class _Run:
    """One file being compiled, in a temporary folder beside the kept ones."""

    def __init__(self, sources: Mapping[str, Source], name: str, store: Path, named: Mapping[str, str]) -> None:
        self.source = sources[name]
        self.kept = store / named[name]
        self._began = time.monotonic()
        self._folder = Path(tempfile.mkdtemp(prefix=".compiling-", dir=store))
        (self._folder / f"{name}.v").write_text(self.source.text, "utf-8")
        below = [
            word for one in sorted(all_required(name, sources)) for word in ("-Q", str(store / named[one]), LIBRARY)
        ]
        command = ["coqc", "-q", "-w", "none", *below, "-Q", ".", LIBRARY, f"{name}.v"]
        self._errors = (self._folder / "errors").open("w+", encoding="utf-8")
        try:
            # a session of its own: Ctrl-C in the terminal reaches us, and we end it
            self._process = subprocess.Popen(
                command, cwd=self._folder, stdout=subprocess.DEVNULL, stderr=self._errors, start_new_session=True
            )
        except BaseException:  # an interrupt while it starts: nobody else knows the folder yet
            self._errors.close()
            shutil.rmtree(self._folder, ignore_errors=True)
            raise

    def finished(self) -> bool:
        """Whether the compiler has ended; one that takes far too long is ended."""
        if self._process.poll() is None and time.monotonic() - self._began > _PATIENCE:
            self._process.kill()
            self._process.wait()
        return self._process.poll() is not None

    def keep(self) -> str:
        """Give the folder its lasting name if the file compiled; otherwise say in one line what is wrong with it."""
        self._errors.seek(0)
        errors = self._errors.read()
        self._errors.close()
        if self._process.returncode:
            shutil.rmtree(self._folder, ignore_errors=True)
            return complaint(self.source, errors)
        try:
            self._folder.rename(self.kept)
        except OSError:  # another process was quicker; its result is the same
            shutil.rmtree(self._folder, ignore_errors=True)
        return "" if self.kept.is_dir() else f"{self.source.name}.v: its folder in the cache cannot be written"

    def end(self) -> None:
        """End the compiler and leave nothing behind."""
        self._process.kill()
        self._process.wait()
        self._errors.close()
        shutil.rmtree(self._folder, ignore_errors=True)


def complaint(source: Source, errors: str) -> str:
    """What the compiler says, as one line that begins with the name of the statement it is about."""
    lines = errors.splitlines()
    places = [number for number, line in enumerate(lines) if line.startswith("File ") and ", line " in line]
    if not places:
        return f"{source.name}.v does not compile: {' '.join(errors.split())[:200] or 'the compiler was ended'}"
    line = int(lines[places[-1]].split(", line ")[1].split(",")[0])
    said = " ".join(" ".join(lines[places[-1] + 1 :]).split())
    return f"{source.declared_before(line)} is not proved (line {line} of {source.name}.v): {said[:200]}"
