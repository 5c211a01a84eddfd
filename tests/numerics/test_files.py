"""Where what is needed again is kept, and files that are written whole or not at all."""

import os
from pathlib import Path

import pytest

from numerics.files import cache_folder, whole_file
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
    def unknown(*_):
        raise RuntimeError("Could not determine home directory.")

    nobody.setattr(Path, "home", unknown)
    with pytest.raises(OSError, match=os.path.basename(os.devnull)):
        cache_folder().mkdir(parents=True)


def test_a_byte_order_mark_is_no_part_of_a_scene(tmp_path):
    path = tmp_path / "Über den Tisch.toml"
    path.write_bytes(b"\xef\xbb\xbf" + SCENE.replace("\n", "\r\n").encode())
    assert load_scene(path) == parse_scene(SCENE)
