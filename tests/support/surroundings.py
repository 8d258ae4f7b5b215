"""What the tests are surrounded by: the same however they were started."""

from __future__ import annotations

import os
import signal
import tempfile

_DECIDES = ("PYTHON", "LC_")
"""Variables that begin so change what a program does or writes."""

_REMOVED = {"NO_COLOR", "FORCE_COLOR", "CLICOLOR", "CLICOLOR_FORCE", "COLUMNS", "LINES", "LANG", "LANGUAGE"}


def settle() -> None:
    """Give this process, and what it starts, a language, a terminal, a mask and signals that are known."""
    for name in list(os.environ):
        if name.startswith(_DECIDES) or name in _REMOVED:
            del os.environ[name]
    os.environ |= {"LANG": "C.UTF-8", "TERM": "dumb"}
    os.environ.setdefault("HOME", tempfile.gettempdir())
    os.umask(0o022)
    # A shell without a terminal starts what is in the background with SIGINT ignored, which children inherit.
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)
