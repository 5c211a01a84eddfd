"""Compiled code gives the numbers of the plain text, within their bounds; who compiles when, and says so."""

import os
import subprocess
import sys
import threading

import pytest

from numerics.arithmetic import compiled as compiling
from numerics.arithmetic.compiled import can_compile

needs_numba = pytest.mark.skipif(not can_compile(), reason="numba is not installed")


def test_one_process_compiles_while_the_others_wait(tmp_path):
    pytest.importorskip("fcntl")
    second_is_in = threading.Event()

    def wait_for_it():
        with compiling._alone(tmp_path / "one.lock"):  # opens the file anew, as another process does
            second_is_in.set()

    second = threading.Thread(target=wait_for_it)
    with compiling._alone(tmp_path / "one.lock"):
        second.start()
        assert not second_is_in.wait(0.2)
    second.join()
    assert second_is_in.is_set()


COMPILES = """
from numerics.arithmetic.compiled import compiled
from numerics.linear.table import places_of
import numpy as np
for _ in range(2):
    compiled(places_of)(np.zeros((2, 2)))
"""


@needs_numba
def test_compiling_is_said_once_and_kept_where_it_can_be(tmp_path):
    """A folder that cannot be written does not keep anyone from compiling; each time it is said."""
    (tmp_path / "file").write_text("")

    def said(cache):
        environment = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path / cache)}
        done = subprocess.run(
            [sys.executable, "-c", COMPILES], capture_output=True, text=True, check=True, env=environment
        )
        return done.stderr.count("numba compiles the solver")

    assert [said("new"), said("new"), said("file"), said("file")] == [1, 0, 1, 1]
