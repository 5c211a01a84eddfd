"""A file is written whole or not at all."""

import os
from pathlib import Path

import pytest

from paper_checks import atomic


def test_it_writes_text_and_bytes_and_makes_the_folder(tmp_path):
    atomic.write(tmp_path / "new" / "a.txt", "ü")
    atomic.write(tmp_path / "new" / "b", b"\x00")
    assert (tmp_path / "new" / "a.txt").read_bytes() == "ü".encode()
    assert (tmp_path / "new" / "b").read_bytes() == b"\x00"
    assert sorted(os.listdir(tmp_path / "new")) == ["a.txt", "b"]


@pytest.mark.parametrize("interruption", [KeyboardInterrupt, OSError])
def test_an_interruption_leaves_the_old_file_and_no_other(tmp_path, monkeypatch, interruption):
    target = tmp_path / "report.html"
    target.write_text("old")

    def interrupted(self, target):
        raise interruption

    monkeypatch.setattr(Path, "replace", interrupted)
    with pytest.raises(interruption):
        atomic.write(target, "new")
    assert target.read_text() == "old"
    assert os.listdir(tmp_path) == ["report.html"]
