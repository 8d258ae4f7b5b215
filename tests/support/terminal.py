"""A pseudo-terminal; a test that asks for one is left out where the machine gives none."""

from __future__ import annotations

import os
import subprocess
from contextlib import suppress
from pathlib import Path

import pytest


def shown(
    command: list[str], env: dict[str, str] | None = None, cwd: Path | None = None, columns: int | None = None
) -> str:
    """What somebody sees who starts the command at a terminal, of a width if that matters."""
    try:
        import pty

        controller, terminal = pty.openpty()
    except (ImportError, OSError) as error:
        pytest.skip(f"there is no pseudo-terminal here: {error}")
    if columns is not None:
        import termios

        termios.tcsetwinsize(terminal, (40, columns))
    with subprocess.Popen(command, stdout=terminal, stderr=terminal, env=env, cwd=cwd):
        os.close(terminal)
        said = b""
        with suppress(OSError):  # Linux says so that nobody writes any more
            while part := os.read(controller, 65536):
                said += part
    os.close(controller)
    return said.decode().replace("\r\n", "\n")
