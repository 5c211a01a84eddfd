"""Where what is needed again is kept, and files that are written whole or not at all."""

import os
import sys

import pytest

from numerics.files import NOWHERE, cache_folder, cache_refused, make_private, whole_file
from numerics.scene.file import load_scene, parse_scene

SCENE = "[pair]\nm1 = 1\nm2 = 1\na2 = 200\nb = 0.05\n[run]\nuntil = 5\n"


def test_a_file_appears_whole_or_not_at_all(tmp_path):
    target = tmp_path / "result"
    target.write_bytes(b"before")
    with pytest.raises(RuntimeError), whole_file(target) as file:  # noqa: PT012
        file.write(b"half of it")
        raise RuntimeError
    assert target.read_bytes() == b"before"
    assert list(tmp_path.iterdir()) == [target]


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


def test_a_relative_cache_is_ignored(nobody, tmp_path):
    nobody.setenv("HOME", str(tmp_path))
    nobody.setenv("XDG_CACHE_HOME", "beside")
    assert cache_folder() == tmp_path / ".cache" / "inertial-pair"


def test_a_user_without_a_home_keeps_nothing(nobody):
    def unknown(*_, **__):
        raise RuntimeError("Could not determine home directory.")

    nobody.setattr("platformdirs.user_cache_path", unknown)
    assert cache_refused() == ""
    with pytest.raises(OSError, match=os.path.basename(os.devnull)):
        make_private(cache_folder())


def test_without_the_extras_nothing_is_kept(monkeypatch):
    monkeypatch.setitem(sys.modules, "platformdirs", None)
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


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="the system has no owners of this kind")
@pytest.mark.parametrize(
    ("place", "mode", "said"),
    [
        (".", 0o720, "others can write"),
        (".", 0o702, "others can write"),
        ("..", 0o777, "anybody can write"),
        ("../..", 0o777, "anybody can write"),
        (".", 0o755, ""),
        ("..", 0o770, ""),
        ("..", 0o1777, ""),
    ],
)
def test_a_cache_that_others_can_change_is_refused(cache, place, mode, said):
    make_private(cache)
    (cache / place).resolve().chmod(mode)
    assert said in cache_refused()
    assert bool(said) == bool(cache_refused()) == (cache_folder() != cache)
    (cache / place).resolve().chmod(0o700)
    assert cache_folder() == cache


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="the system has no owners of this kind")
def test_so_is_one_that_belongs_to_another_user_by_a_link_too(cache, tmp_path, nobody):
    make_private(tmp_path / "theirs")
    cache.parent.mkdir()
    cache.symlink_to(tmp_path / "theirs")
    assert cache_folder() == cache
    owner = os.getuid()
    nobody.setattr(os, "getuid", lambda: owner + 1)
    assert "theirs belongs to another user" in cache_refused()
    assert cache_folder() != cache


def test_a_byte_order_mark_is_no_part_of_a_scene(tmp_path):
    path = tmp_path / "Über den Tisch.toml"
    path.write_bytes(b"\xef\xbb\xbf" + SCENE.replace("\n", "\r\n").encode())
    assert load_scene(path) == parse_scene(SCENE)
