"""The program around the commands: which there are, and what happens when one cannot continue."""

from __future__ import annotations

import atexit
import gc
import os
import signal
import sys
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from types import FrameType
from typing import NoReturn

import click

from aseme_dsl import __version__
from aseme_dsl.cli.groups import LazyGroup
from aseme_dsl.cli.terminal import protect

FINE, ERRORS, WRONG_USE, OUR_MISTAKE, INTERRUPTED, TERMINATED, BROKEN_PIPE = 0, 1, 2, 70, 130, 143, 141

COMMANDS = (
    "new",
    "check",
    "explain",
    "fmt",
    "lsp",
    "build",
    "diagram",
    "view",
    "run",
    "test",
    "prove",
    "diff",
    "sim",
    "coverage",
    "goals",
    "metrics",
    "replay",
    "observe",
    "why",
    "whynot",
    "node",
    "team",
    "key",
    "certificates",
    "deploy",
    "trace",
    "match",
    "optimise",
    "bench",
    "sniff",
    "scaffold",
    "import",
    "export",
    "doctor",
    "completion",
)
"""The commands, in the order of the help; each is the object `command` of the module of its name, with an
underscore where that is a keyword."""

MOVED = {"status": "team status", "switch": "team switch", "swap": "team swap", "select": "team switch"}
"""Commands that have another name now: nothing is done under the old one."""

PLAYING = frozenset(("run", "test", "sim", "node", "match", "optimise"))
"""The commands in which code of the user writes to the terminal as it likes."""


class _Commands(LazyGroup):
    """The commands of `asemec`."""

    package = "aseme_dsl.cli"
    names = COMMANDS
    moved = MOVED

    def invoke(self, ctx: click.Context) -> object:
        try:
            return super().invoke(ctx)
        except BrokenPipeError as error:
            raise _NobodyReads from error  # click would take it for an error of the command


@click.group(
    cls=_Commands,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    epilog="Example: asemec check team.aseme   ·   Every command has --help with an example.",
)
@click.version_option(__version__, "-V", "--version", prog_name="asemec", message="%(prog)s %(version)s")
@click.option("--debug", is_flag=True, help="Show the Python traceback of an internal error.")
@click.pass_context
def program(context: click.Context, debug: bool) -> None:
    """Compile and run teams of robots and agents that .aseme files describe.

    Exit codes: 0 success, 1 errors in the files or a failed run, 2 invalid command line.
    """
    context.obj = debug


def run_program(arguments: Sequence[str] | None = None) -> int:
    """Run the command line; return the exit code. No exception of ours reaches the user as a traceback."""
    arguments = list(sys.argv[1:] if arguments is None else arguments)
    _prepare_streams(arguments)
    try:
        with _stopping_on_termination(), _few_collections(arguments):
            result = program.main(arguments, prog_name="asemec", standalone_mode=False)
            sys.stdout.flush()
        return result if isinstance(result, int) else FINE
    except click.ClickException as error:
        error.show()
        return error.exit_code
    except (click.Abort, KeyboardInterrupt):
        _say("asemec: stopped")
        return INTERRUPTED
    except _Terminated:
        _say("asemec: terminated")
        return TERMINATED
    except (BrokenPipeError, _NobodyReads):
        _ignore_output()
        return BROKEN_PIPE
    except MemoryError:
        _say("asemec: out of memory")
        return ERRORS
    except OSError as error:
        # Only what cannot be said better where it happens comes here: the standard output of a full disk.
        _ignore_output()
        _say(f"asemec: {error.strerror or error}{f': {error.filename}' if error.filename else ''}")
        _trace(arguments)
        return ERRORS
    except Exception as error:
        _our_mistake(error, arguments)
        return OUR_MISTAKE


class _NobodyReads(BaseException):
    """Who read our output has gone."""


class _Terminated(BaseException):
    """The process was asked to end."""


@contextmanager
def _stopping_on_termination() -> Iterator[None]:
    """Let SIGTERM unwind like Ctrl-C, so that nothing half-written stays behind."""

    def terminate(number: int, frame: FrameType | None) -> NoReturn:
        raise _Terminated

    if threading.current_thread() is not threading.main_thread():
        yield  # the program that started this thread handles signals
        return
    before = signal.signal(signal.SIGTERM, terminate)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before if before is not None else signal.SIG_DFL)


_COMPILING = frozenset("build check diagram export fmt prove scaffold".split())
"""Commands that make models, and then end."""


@contextmanager
def _few_collections(arguments: Sequence[str]) -> Iterator[None]:
    """Look for cycles of objects rarely: models are many small objects without cycles.

    To look for them all the time costs a third of the time, and to look once more when Python ends 30 ms.
    Both settings are the whole process's, which only a command may change, and not the library.
    """
    if _COMPILING.isdisjoint(arguments):
        yield
        return
    atexit.unregister(gc.freeze)
    atexit.register(gc.freeze)
    threshold = gc.get_threshold()
    gc.set_threshold(100_000, 50, 100)
    try:
        yield
    finally:
        gc.set_threshold(*threshold)


def _prepare_streams(arguments: Sequence[str]) -> None:
    """A terminal that cannot show a character gets an escape for it, not a crash of ours."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")
        if PLAYING.isdisjoint(arguments[:2]):
            protect(stream)


def _ignore_output() -> None:
    """Discard the output that is still in the buffers: its reader has closed the pipe."""
    try:
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, sys.stdout.fileno())
    except (OSError, ValueError):
        pass  # standard output is closed, or is not a file


def _say(text: str) -> None:
    with suppress(OSError):  # standard error has no reader
        print(text, file=sys.stderr, flush=True)


def _our_mistake(error: Exception, arguments: Sequence[str]) -> None:
    import shlex

    if _trace(arguments):
        return
    line = str(error).partition("\n")[0]
    again = shlex.join(["asemec", "--debug", *arguments])
    _say(
        f"asemec: internal error: {type(error).__name__}: {line}\n"
        "This is a bug in asemec; please report it, with the file and the output of this command:\n"
        f"  {again}"
    )


def _trace(arguments: Sequence[str]) -> bool:
    """Show the traceback if it was asked for; whether it was."""
    if "--debug" not in arguments:
        return False
    import traceback

    _say(traceback.format_exc().rstrip())
    return True
