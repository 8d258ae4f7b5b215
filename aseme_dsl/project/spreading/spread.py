"""Spread: many runs in virtual time, in processes beside each other or on a cluster."""

from __future__ import annotations

import os
import signal
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from contextlib import contextmanager
from multiprocessing import get_context, resource_tracker
from typing import TYPE_CHECKING, TypeVar

from aseme_dsl.project.spreading.cluster import Cluster, Copied, play_there

if TYPE_CHECKING:
    from multiprocessing.connection import Connection

JobT = TypeVar("JobT")
ResultT = TypeVar("ResultT")


def spread(
    play: Callable[[JobT], ResultT],
    jobs: Sequence[JobT],
    crew: int | Cluster,
    copied: Sequence[Copied],
    told: Callable[[], None],
) -> list[ResultT]:
    """What `play` makes of the jobs, in their order; `told` is called after each.

    The crew is a number of processes, or a cluster, whose workers get the folders `copied`.

    Raises:
        ClusterError: the cluster cannot be used.
    """
    if isinstance(crew, Cluster):
        return play_there(crew, play, jobs, copied, told)
    if crew == 1:
        found = []
        for job in jobs:
            found.append(play(job))
            told()
        return found
    # Spawned, not forked: a run leaves imported modules and threads behind.
    spawned = get_context("spawn")
    end, ours = spawned.Pipe(duplex=False)
    pool = ProcessPoolExecutor(crew, spawned, _begin_worker, (end,))
    try:
        with _interrupts_wait():
            futures = [pool.submit(play, job) for job in jobs]
        for future in _as_they_end(futures):
            future.result()
            told()
        return [future.result() for future in futures]
    except BaseException:
        ours.close()  # what is being played is of no use any more, and may never end
        raise
    finally:
        pool.shutdown(wait=True, cancel_futures=True)
        ours.close()
        end.close()


@contextmanager
def _interrupts_wait() -> Iterator[None]:
    """Inside, Ctrl-C waits, and processes that start never hear of it: it would break that off."""
    if not hasattr(signal, "pthread_sigmask"):  # Windows
        yield
        return
    resource_tracker.ensure_running()  # which would let it through in between
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _as_they_end(futures: Sequence[Future[ResultT]]) -> Iterator[Future[ResultT]]:
    waiting = set(futures)
    while waiting:
        done, waiting = wait(waiting, return_when=FIRST_COMPLETED)
        yield from done


def _begin_worker(end: Connection[object, object]) -> None:
    """Ctrl-C is for the one who started the runs; when that closes its side, or has ended, we end, too."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)

    def wait_for_end() -> None:
        end.poll(None)
        os._exit(1)

    threading.Thread(target=wait_for_end, name="aseme end of runs", daemon=True).start()


__all__ = ["spread"]
