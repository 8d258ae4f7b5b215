"""Drawn: a drawing in one file, or where Graphviz cannot draw it whole, in several with an index."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager

from aseme_dsl.diagrams.look.drawing import Drawing
from aseme_dsl.diagrams.rendering.layout import TIME_LIMIT, DrawingFailed, GraphvizMissing, end_all, render
from aseme_dsl.records import dataclass

WHOLE = 1500
"""The most states that are tried in one picture: a larger one takes minutes, and is unreadable."""


@dataclass(frozen=True, slots=True)
class Drawn:
    """Files by name, and what must be said of them: nothing if the drawing is in one file."""

    files: tuple[tuple[str, bytes], ...]
    notes: tuple[str, ...] = ()


def draw(drawing: Drawing, format: str, *, time_limit: float = TIME_LIMIT) -> Drawn:
    """The drawing as `svg`, `png`, `pdf` or `dot`: one file, or an index and more where it must be divided.

    `time_limit` is for one run of Graphviz, in seconds. Raises DrawingFailed if not even the pieces can be
    drawn, GraphvizMissing without Graphviz.
    """
    files: list[tuple[str, bytes]] = []
    notes: list[str] = []
    waiting = [drawing]
    if drawing.note:
        notes.append(drawing.note)
    while waiting:
        item = waiting.pop(0)
        reason = f"{item.name} has {item.states} states, which is too much for one picture"
        if format == "dot" or item.states <= WHOLE or item.pieces is None:
            try:
                files.append((f"{item.name}.{format}", render(item, format, time_limit=time_limit)))
                continue
            except GraphvizMissing:
                raise
            except DrawingFailed as failure:
                if item.pieces is None:
                    raise
                reason = str(failure)
        pieces = item.pieces()
        waiting[:0] = pieces
        notes.append(f"{reason}; it is drawn in {len(pieces)} files, {item.name}.{format} is where to begin")
    return Drawn(tuple(files), tuple(notes))


Result = Drawn | DrawingFailed
"""What came of a drawing."""


def _silently(number: int, of: int) -> None:
    """No progress is shown."""


@contextmanager
def drawing(
    drawings: Sequence[Drawing], format: str = "svg", done: Callable[[int, int], None] = _silently
) -> Iterator[Callable[[], list[Result]]]:
    """Draw while something else is done; what is given waits, and says what came of each drawing.

    As many are drawn at a time as there are processors: Graphviz is what takes long. While they are
    waited for, `done` is called with how many are there, and of how many.
    """
    if not drawings:
        yield list
        return
    with ThreadPoolExecutor(min(len(drawings), os.cpu_count() or 1)) as workers:
        waiting = [workers.submit(_result, item, format) for item in drawings]
        try:
            yield lambda: list(_results(waiting, done))
        except BaseException:  # Ctrl-C, say: the other drawings are not needed any more
            workers.shutdown(wait=False, cancel_futures=True)
            end_all()
            raise


def _results(waiting: Sequence[Future[Result]], done: Callable[[int, int], None]) -> Iterator[Result]:
    for number, item in enumerate(waiting):
        done(number, len(waiting))
        yield item.result()


def _result(drawing: Drawing, format: str) -> Result:
    try:
        return draw(drawing, format)
    except DrawingFailed as failure:
        return failure
