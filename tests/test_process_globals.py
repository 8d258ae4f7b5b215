"""A call of the library changes nothing of the whole process, also while several threads call."""

from __future__ import annotations

import gc
import locale
import logging
import os
import signal
import sys
import threading
import warnings
from pathlib import Path

import aseme_dsl
from aseme_dsl.cli.program import run_program
from aseme_dsl.grammar import parse
from aseme_dsl.source import Source

PROGRAM = "system S\nsrm r { liveness { r = A . B } activities { A takes 1s B takes 1s } }\n"


def globals_of_the_process() -> dict[str, object]:
    mask = os.umask(0)
    os.umask(mask)
    return {
        "collector": (gc.get_threshold(), gc.isenabled(), gc.get_freeze_count()),
        "recursion": sys.getrecursionlimit(),
        "switch interval": sys.getswitchinterval(),
        "signals": [signal.getsignal(number) for number in signal.valid_signals()],
        "locale": locale.setlocale(locale.LC_ALL),
        "warnings": list(warnings.filters),
        "logging": (logging.root.level, list(logging.root.handlers), logging.root.manager.disable),
        "environment": dict(os.environ),
        "folder": Path.cwd(),
        "mask": mask,
        "path": list(sys.path),
        "hooks": (sys.excepthook, threading.excepthook, sys.unraisablehook),
    }


def test_no_call_changes_one_even_while_it_works() -> None:
    before = globals_of_the_process()["collector"]
    seen: set[object] = set()
    over = threading.Event()

    def watch() -> None:
        while not over.is_set():
            seen.add((gc.get_threshold(), gc.isenabled(), gc.get_freeze_count()))

    def call() -> None:
        for _ in range(5):
            parse(Source("s.aseme", PROGRAM))
            aseme_dsl.analyse(Source("s.aseme", PROGRAM))

    threads = [threading.Thread(target=call) for _ in range(3)]
    watcher = threading.Thread(target=watch)
    watcher.start()
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    over.set()
    watcher.join()
    assert seen == {before}


def test_a_call_leaves_all_as_it_was(tmp_path: Path) -> None:
    path = tmp_path / "s.aseme"
    path.write_text(PROGRAM, "utf-8")
    aseme_dsl.analyse(path)
    before = globals_of_the_process()
    aseme_dsl.analyse(path)
    parse(Source("s.aseme", PROGRAM))
    assert globals_of_the_process() == before


def test_a_command_puts_it_back(tmp_path: Path) -> None:
    path = tmp_path / "s.aseme"
    path.write_text(PROGRAM, "utf-8")
    before = gc.get_threshold()
    run_program(["check", str(path)])
    assert gc.get_threshold() == before
