"""Files in the user's cache: written whole or not at all, and read only as they were written, for their own state."""

import os
from pathlib import Path

import pytest

from paper_checks import atomic
from paper_checks.store import Store, digest


@pytest.fixture
def kept(tmp_path):
    """A store of one file, and the file."""
    store = Store("rows", "now", tmp_path)
    store.put("one.json", b"of a row")
    return store, tmp_path / "now" / "one.json"


@pytest.mark.parametrize("place", [0, 30, 70, -1])
def test_a_damaged_file_is_not_read(kept, place):
    store, file = kept
    assert store.get("one.json") == b"of a row"
    content = bytearray(file.read_bytes())
    content[place] ^= 1
    for damaged in (bytes(content), bytes(content[:place])):
        file.write_bytes(damaged)
        assert store.get("one.json") is None


def test_a_file_under_another_name_or_of_another_state_is_not_read(kept, tmp_path):
    store, file = kept
    other = Store("rows", "then", tmp_path)
    other.put("two.json", b"")
    for copy in (file.with_name("two.json"), tmp_path / "then" / "one.json"):
        copy.write_bytes(file.read_bytes())
    assert (store.get("two.json"), other.get("one.json"), store.get("none.json")) == (None, None, None)


def test_a_cache_that_cannot_be_written_keeps_nothing(tmp_path):
    (tmp_path / "file").write_text("")
    store = Store("rows", "now", tmp_path / "file")
    store.put("one.json", b"")
    store.forget_old()
    assert store.get("one.json") is None


def test_the_hash_of_files_tells_what_stands_where(tmp_path):
    """@example of a found fault: a file that moves to another folder, its name kept, left the hash as it was."""

    def found(**texts):
        for name, text in texts.items():
            atomic.write(tmp_path / name, text)
        return digest([tmp_path / name for name in texts], [])

    hashes = [found(a="12", b="3"), found(a="1", b="23"), found(a="12", c="3"), found(b="12", a="3")]
    hashes += [found(**{"one/a": "12", "b": "3"}), found(**{"two/a": "12", "b": "3"})]
    assert len(set(hashes)) == len(hashes)


@pytest.mark.parametrize("interruption", [KeyboardInterrupt, OSError])
def test_an_interruption_leaves_the_old_file_and_no_other(tmp_path, monkeypatch, interruption):
    target = tmp_path / "new" / "report.html"
    atomic.write(target, "ü")

    def interrupted(self, target):
        raise interruption

    monkeypatch.setattr(Path, "replace", interrupted)
    with pytest.raises(interruption):
        atomic.write(target, b"new")
    assert target.read_bytes() == "ü".encode()
    assert os.listdir(target.parent) == ["report.html"]
