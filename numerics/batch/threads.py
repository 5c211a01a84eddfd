"""Chunks of a batch, in threads of compiled code."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor, as_completed

from numerics.arithmetic.telling import can_compile
from numerics.batch.parallel import available_cores
from numerics.batch.rows import Chunk, solve_chunk


def in_threads(chunks: list[Chunk], jobs: int | None) -> Iterator[int]:
    """Yield how many scenes each chunk had, as they finish; compiled code runs in threads, Python in turn."""
    if jobs == 1 or len(chunks) <= 1 or not can_compile():
        yield from map(solve_chunk, chunks)
        return
    pool = ThreadPoolExecutor(min(jobs or available_cores(), len(chunks)))
    try:
        futures: list[Future[int]] = [pool.submit(solve_chunk, chunk) for chunk in chunks]
        for future in as_completed(futures):
            yield future.result()
    finally:
        pool.shutdown(wait=True, cancel_futures=True)
