"""Layout: runs Graphviz as a separate program with a time limit, and checks its output."""

from __future__ import annotations

import contextlib
import os
import re
import shutil
import signal
import subprocess
import sysconfig
from collections.abc import Sequence
from pathlib import Path

from aseme_dsl.diagrams.look.dot import Kind
from aseme_dsl.diagrams.look.drawing import Drawing
from aseme_dsl.diagrams.rendering import svg
from aseme_dsl.diagrams.rendering.lines import crossed, mixed_up

TIME_LIMIT = 10.0
"""How long one run of Graphviz may take, in seconds."""

FORMATS = ("svg", "png", "pdf", "dot")

_PURE = "graphviz-pure"
"""The program of the package of that name, which writes no PDF.

To do it with svglib and reportlab instead takes 38 MB, and a font with Greek letters that not every machine
has.
"""

_TEXT = 30.0
"""A text under a line counts as much as so many px of lines on one another."""

_ATTEMPTS: Sequence[tuple[str, ...]] = ((), ("-Gnewrank=true",))
"""Graphviz' own ranking lays clusters out better; the new one survives where that breaks down."""

_HARMLESS = re.compile(r"font|pango|metrics|non-ascii|gtk|cairo|glib", re.IGNORECASE)
_SUSPICIOUS = re.compile(
    r"error|trouble|init_rank|lost|assert|syntax|not found|not in|inside|abort|fault|fail|nan\b",
    re.IGNORECASE,
)


class DrawingFailed(Exception):
    """A picture could not be made whole. The text says why, and what can be done."""


class GraphvizMissing(DrawingFailed):
    """There is no program that draws."""

    def __init__(self) -> None:
        super().__init__(
            "Graphviz is needed to draw: install it so that `dot` is on the PATH (Debian and Ubuntu: "
            "`apt install graphviz`), or `pip install graphviz-pure`. DOT files can be written without it."
        )


class _Flawed(Exception):
    """One attempt has failed, for this reason."""


def program() -> str:
    """The Graphviz to use: `dot` on the PATH, else `graphviz-pure` there or beside this Python.

    Raises GraphvizMissing if there is none.
    """
    found = shutil.which("dot") or shutil.which(_PURE)
    found = found or shutil.which(_PURE, path=sysconfig.get_path("scripts"))
    if found is None:
        raise GraphvizMissing
    return found


def writes_pdf() -> bool:
    """Whether the Graphviz to use does; raises GraphvizMissing if there is none."""
    return not Path(program()).name.startswith(_PURE)


def render(drawing: Drawing, format: str, *, time_limit: float = TIME_LIMIT) -> bytes:
    """The drawing as `svg`, `png`, `pdf` or `dot`, complete.

    For every format but `dot`, the SVG of the same layout is compared with the elements that the drawing must
    show.

    Raises:
        DrawingFailed: no attempt gave a complete picture, or Graphviz does not write the format.
        GraphvizMissing: there is no Graphviz; a subclass of `DrawingFailed`.
        ValueError: another format.
    """
    if format not in FORMATS:
        raise ValueError(f"{format!r} is not one of {', '.join(FORMATS)}")
    if drawing.picture and format == "svg":
        return drawing.picture.encode()
    if format == "dot":
        return drawing.dot.encode()
    graphviz = program()
    if format == "pdf" and not writes_pdf():
        raise DrawingFailed(
            f"{_PURE} writes no PDF: install Graphviz so that `dot` is on the PATH (Debian and Ubuntu: "
            "`apt install graphviz`); SVG and PNG files can be written without it"
        )
    reasons: list[str] = []
    for flags in _ATTEMPTS:
        try:
            if drawing.picture:
                return _run([graphviz, f"-T{format}"], drawing.dot, time_limit)
            text, picture = _clear(drawing, [graphviz, "-Tsvg", *flags], time_limit)
            if format == "svg":
                return picture
            return _run([graphviz, f"-T{format}", *flags], text, time_limit)
        except _Flawed as flaw:
            reasons.append(str(flaw))
    raise DrawingFailed(f"{drawing.name} could not be drawn: {' / then '.join(dict.fromkeys(reasons))}")


def _clear(drawing: Drawing, command: Sequence[str], time_limit: float) -> tuple[str, bytes]:
    """The DOT text and the SVG of the usual layout, or of the first wider one whose lines are clear.

    If there is none, it is the one that comes next to that. Raises _Flawed if the usual one is not whole.
    """
    lines = [item.id for item in drawing.shown if item.kind is Kind.LINE]
    text, picture = drawing.dot, _whole(drawing, drawing.dot, command, time_limit)
    if drawing.wider is None or not (least := _unclear(drawing, picture, lines)):
        return text, picture
    for other in drawing.wider():
        if not least:
            break
        with contextlib.suppress(_Flawed):
            made = _whole(drawing, other, command, time_limit)
            if (left := _unclear(drawing, made, lines)) < least:
                text, picture, least = other, made, left
    return text, picture


def _unclear(drawing: Drawing, picture: bytes, lines: Sequence[str]) -> float:
    """How much a reader cannot tell apart: texts under lines, and where there are no states, also lines."""
    outlines = [item.id for item in drawing.shown if item.kind in (Kind.LINE, Kind.GROUP)]
    texts = _TEXT * crossed(picture, outlines)
    return texts if drawing.states else texts + mixed_up(picture, lines)


def _whole(drawing: Drawing, text: str, command: Sequence[str], time_limit: float) -> bytes:
    """The SVG of a layout. Raises _Flawed if it lacks something."""
    picture = svg.cleaned(_run(command, text, time_limit), drawing.about or drawing.name)
    if faults := svg.faults(picture, drawing.shown):
        raise _Flawed("; ".join(faults[:3]) + (f" and {len(faults) - 3} more" if faults[3:] else ""))
    return picture


def _run(command: Sequence[str], text: str, time_limit: float) -> bytes:
    """What the program writes. Raises _Flawed if it fails, takes too long or complains."""
    name = Path(command[0]).name
    try:
        process = subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            start_new_session=True,  # so that what it started itself can be ended with it
        )
    except OSError as error:
        raise DrawingFailed(f"{command[0]} cannot be started: {error.strerror}") from error
    _running.add(process)
    try:
        output, errors = process.communicate(text.encode(), timeout=time_limit)
    except subprocess.TimeoutExpired:
        raise _Flawed(f"{name} was not done after {time_limit:g} s") from None
    finally:
        _running.discard(process)
        if process.returncode is None:
            _end(process)
    if process in _unwanted:
        _unwanted.discard(process)
        raise NotWanted
    complaints = [line.strip() for line in errors.decode(errors="replace").splitlines() if _complains(line)]
    said = f" and said {complaints[0]!r}" if complaints else ""
    if process.returncode < 0:
        raise _Flawed(f"{name} was ended by {signal.Signals(-process.returncode).name}{said}")
    if process.returncode > 0:
        raise _Flawed(f"{name} failed with code {process.returncode}{said}")
    if complaints:
        raise _Flawed(f"{name} said {complaints[0]!r}")
    return output


def _complains(line: str) -> bool:
    return bool(_SUSPICIOUS.search(line)) and not _HARMLESS.search(line)


class NotWanted(Exception):
    """Graphviz was ended by `end_all`."""


def end_all() -> None:
    """End every Graphviz that runs now, whichever thread waits for it (there, it raises NotWanted)."""
    for process in tuple(_running):
        _unwanted.add(process)
        with contextlib.suppress(ProcessLookupError):
            process.kill()


_running: set[subprocess.Popen[bytes]] = set()
_unwanted: set[subprocess.Popen[bytes]] = set()


def _end(process: subprocess.Popen[bytes]) -> None:
    """End the program and all that it has started; it keeps no time limit and no Ctrl-C waiting."""
    with contextlib.suppress(ProcessLookupError):
        if hasattr(os, "killpg"):
            os.killpg(process.pid, signal.SIGKILL)
        else:
            process.kill()
    for stream in (process.stdin, process.stdout, process.stderr):
        if stream is not None:
            with contextlib.suppress(OSError):
                stream.close()
    process.wait()
