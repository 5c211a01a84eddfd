"""Where what is needed again is kept, and files that are written whole or not at all, also when somebody interrupts."""

import os
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from interruption import interrupted
from three_scenes import PAPER

from numerics import load_scene, scene_text
from numerics.files import A_DAY, NOWHERE, cache_folder, cache_refused, forget_unused, make_private, whole_file


def test_a_file_appears_whole_or_not_at_all(tmp_path):
    target = tmp_path / "result"
    target.write_bytes(b"before")
    with pytest.raises(RuntimeError), whole_file(target) as file:  # noqa: PT012
        file.write(b"half of it")
        raise RuntimeError
    assert target.read_bytes() == b"before"
    assert list(tmp_path.iterdir()) == [target]


def test_a_link_stays_and_a_device_takes_the_bytes(tmp_path):
    (tmp_path / "link").symlink_to("result")
    with whole_file(tmp_path / "link") as file:
        file.write(b"whole")
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "result").read_bytes() == b"whole"
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    with ThreadPoolExecutor(1) as other:
        read = other.submit(pipe.read_bytes)
        with whole_file(pipe) as file:
            file.write(b"whole")
        assert read.result() == b"whole"
    assert pipe.is_fifo()


@pytest.mark.parametrize("name", ["", "nowhere/result"])
def test_what_cannot_be_written_is_called_by_the_name_that_was_asked_for(tmp_path, name):
    target = tmp_path / name
    with pytest.raises(OSError, match=r".") as found, whole_file(target):
        raise AssertionError
    assert found.value.filename == str(target)
    assert found.value.strerror
    assert not list(tmp_path.iterdir())


@pytest.fixture
def nobody(monkeypatch):
    """No variable says where the user's cache or home is."""
    for name in ("XDG_CACHE_HOME", "LOCALAPPDATA", "HOME"):
        monkeypatch.delenv(name, raising=False)
    return monkeypatch


def test_a_user_without_a_home_or_without_the_extras_keeps_nothing(nobody):
    def unknown(*_, **__):
        raise RuntimeError("Could not determine home directory.")

    nobody.setattr("platformdirs.user_cache_path", unknown)
    assert cache_refused() == ""
    with pytest.raises(OSError, match=os.path.basename(os.devnull)):
        make_private(cache_folder())
    nobody.setitem(sys.modules, "platformdirs", None)
    assert (cache_folder(), cache_refused()) == (NOWHERE, "")


@pytest.fixture
def cache(nobody, tmp_path):
    nobody.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return tmp_path / "cache" / "inertial-pair"


def test_what_is_made_in_the_cache_is_the_user_s_alone(cache):
    before = os.umask(0)
    try:
        make_private(cache / "rows")
    finally:
        os.umask(before)
    assert [place.stat().st_mode & 0o777 for place in (cache, cache / "rows")] == [0o700] * 2
    assert (cache_folder(), cache_refused()) == (cache, "")


owners = pytest.mark.skipif(not hasattr(os, "getuid"), reason="the system has no owners of this kind")


@owners
@pytest.mark.parametrize(
    "row", [". 720 no", ". 702 no", ". 1777 no", ".. 720 no", "../.. 777 no", ". 755 yes", ".. 1777 yes"]
)
def test_a_cache_that_others_can_change_is_refused(cache, row):
    (place, mode, is_right), said = row.split(), "others can write"
    make_private(cache)
    (cache / place).resolve().chmod(int(mode, 8))
    assert (said in cache_refused(), cache_folder() == cache) == (is_right == "no", is_right == "yes")
    (cache / place).resolve().chmod(0o700)
    assert (cache_folder(), cache_refused()) == (cache, "")


@owners
def test_so_is_one_by_a_link_in_a_folder_that_others_can_write(cache, tmp_path, nobody):
    make_private(cache)
    (tmp_path / "open").mkdir()
    (tmp_path / "open" / "link").symlink_to(cache.parent)
    nobody.setenv("XDG_CACHE_HOME", str(tmp_path / "open" / "link"))
    assert cache_refused() == ""
    (tmp_path / "open").chmod(0o777)
    assert f"others can write {tmp_path / 'open'};" in cache_refused()


@owners
@pytest.mark.parametrize(
    ("place", "owner", "refused"), [(0, 0, True), (0, 12345, True), (1, 12345, True), (2, 12345, True), (1, 0, False)]
)
@pytest.mark.parametrize("by_link", [False, True])
def test_every_folder_above_belongs_to_the_user_or_to_the_system(
    cache, tmp_path, nobody, place, owner, refused, by_link
):
    """Whoever owns a folder can put another one in the place of what is in it, and what is kept is believed."""
    make_private(cache)
    theirs = (cache, *cache.parents)[place]
    if by_link:
        (tmp_path / "link").symlink_to(cache.parent)
        nobody.setenv("XDG_CACHE_HOME", str(tmp_path / "link"))
    stat, us = Path.stat, 54321

    def owned(path, **how):
        found = stat(path, **how)
        uid = owner if path == theirs else us if path.is_relative_to(tmp_path) else 0
        return os.stat_result((*found[:4], uid, *found[5:10]))

    nobody.setattr(os, "getuid", lambda: us)
    nobody.setattr(Path, "stat", owned)
    assert bool(cache_refused()) == refused == (f"{theirs} belongs to another user" in cache_refused())
    assert (cache_folder() != cache) == (refused or by_link)


def test_a_byte_order_mark_is_no_part_of_a_scene(tmp_path):
    (tmp_path / "Über den Tisch.toml").write_bytes(b"\xef\xbb\xbf" + scene_text(PAPER).replace("\n", "\r\n").encode())
    assert load_scene(tmp_path / "Über den Tisch.toml") == PAPER


def test_a_cache_forgets_what_was_used_longest_ago_but_nothing_of_the_last_day(tmp_path):
    for age in range(6):  # days and a bit
        folder = tmp_path / str(age)
        folder.mkdir()
        (folder / "kept").write_text("")
        os.utime(folder, (0, time.time() - age * A_DAY - 60))
    (tmp_path / "lock").write_text("")
    forget_unused(tmp_path / "nowhere", 1)
    forget_unused(tmp_path, 3)
    assert sorted(one.name for one in tmp_path.iterdir()) == ["0", "1", "2", "lock"]
    (tmp_path / "3").mkdir()
    forget_unused(tmp_path, 1)
    assert {one.name for one in tmp_path.iterdir()} == {"0", "3", "lock"}


@pytest.mark.parametrize(
    ("program", "words", "module", "said"),
    [
        ("numerics", "solve velocities --npz run.npz", "flint", "error: interrupted"),
        # not at its first module: mpmath, which it imports next, takes whatever happens then for a gmpy not there
        ("paper_checks", "report --out out", "sympy.core", "error: interrupted"),
    ],
)
def test_ctrl_c_leaves_nothing(tmp_path, program, words, module, said):
    code, _, errors = interrupted(program, words.split(), module, tmp_path)
    assert (code, len(errors.splitlines()), list(tmp_path.iterdir())) == (130, 1, [])
    assert errors.startswith(said)


HALF_WRITTEN = """
import time
from pathlib import Path
from paper_checks import atomic

def wait(*_):
    print("half", flush=True)
    time.sleep(60)

Path.replace = wait
atomic.write(Path("result"), "x" * 10**6)
"""


def test_kill_in_mid_export_leaves_what_was_there(tmp_path):
    (tmp_path / "result").write_bytes(b"before")
    process = subprocess.Popen([sys.executable, "-c", HALF_WRITTEN], cwd=tmp_path, stdout=subprocess.PIPE)
    assert process.stdout.readline() == b"half\n"
    process.kill()
    process.communicate(timeout=20)
    assert (tmp_path / "result").read_bytes() == b"before"
