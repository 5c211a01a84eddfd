"""The paper's pair as a file, and a command as a user meets it: exit code, output, errors, its JSON."""

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from three_scenes import SCENE

from numerics.__main__ import main


@pytest.fixture
def scene_file(tmp_path) -> Path:
    path = tmp_path / "scene.toml"
    path.write_text(SCENE)
    return path


@pytest.fixture
def run(ended) -> Callable[..., tuple[int, str, str]]:
    return lambda *arguments: ended(main, [*map(str, arguments)])


@pytest.fixture
def output(run) -> Callable[..., str]:
    """What a command prints that ends well."""

    def printed(*arguments):
        code, out, _ = run(*arguments)
        assert code == 0
        return out

    return printed


@pytest.fixture
def record(output) -> Callable[..., dict]:
    return lambda *arguments: json.loads(output(*arguments, "--json"))
