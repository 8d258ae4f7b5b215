"""Proofs: what is known of all runs of each system, and the processes that find out.

For each system there is one process at most: a new request replaces the one before. What is found is kept for
the text that it was found for, so that it is there again when the text is again as it was.
"""

from __future__ import annotations

import asyncio
import json
import os
import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import field
from pathlib import Path

from aseme_dsl import outside
from aseme_dsl.editor.proving.questions import Question
from aseme_dsl.records import dataclass

KEPT = 8
"""For how many texts of a system answers are kept."""

LARGEST = 16 << 20
"""The largest line, in bytes, that a process may write."""

PATIENCE = 30
"""How many times the budget a process may take, in seconds of the wall clock; and `SPARE` more."""
SPARE = 60.0

_OF_CODE = (".py", ".proto", ".toml")
"""Files beside those of models on which an answer depends."""


@dataclass(frozen=True, slots=True)
class Settings:
    """How an editor wants proofs: whether when a file is saved, and for how many robots of a role.

    `budget` is the processor time (s) for each team and protocol."""

    on_save: bool = False
    budget: float = 10.0
    robots: int = 2


@dataclass(frozen=True, slots=True)
class Text:
    """A system at one moment. `digest` says what it means; Python in the folder `code` does not count."""

    root: str
    text: str
    digest: str
    code: str


@dataclass(frozen=True, slots=True)
class Answer:
    """One result of `asemec prove`. `scenario` has its title, its roles and its text; None: there is none."""

    name: str
    of: str
    verdict: str
    reason: str
    bounds: str
    run: tuple[str, ...]
    scenario: Mapping[str, str] | None


@dataclass(slots=True)
class Known:
    """What is known of one text: answers, and why questions have none."""

    answers: list[Answer] = field(default_factory=list)
    problems: dict[str, str] = field(default_factory=dict)
    files: dict[str, tuple[int, int] | None] = field(default_factory=dict)
    is_all: bool = False

    @property
    def is_current(self) -> bool:
        """Whether the Python that it depends on is as it was."""
        return all(_look(path) == seen for path, seen in self.files.items())


@dataclass(slots=True)
class Running:
    """A process at work on a question."""

    question: Question
    begun: float
    told: str = ""
    task: asyncio.Task[None] | None = None


class Proofs:
    """The proofs of one server. It belongs to one event loop.

    `command` starts a process that proves; `changed` is called with the file of a system when there is
    something new to show of it.
    """

    def __init__(self, command: Sequence[str], changed: Callable[[str, bool], None]) -> None:
        self.settings = Settings()
        self.running: dict[str, Running] = {}
        self._command = command
        self._changed = changed
        self._known: dict[str, dict[str, Known]] = {}

    def begin(self, text: Text, question: Question) -> Running:
        """Find out; what runs for the same system is given up."""
        self.stop(text.root)
        running = Running(question, time.monotonic())
        self.running[text.root] = running
        running.task = asyncio.create_task(self._run(text, running))
        return running

    def stop(self, root: str) -> None:
        """Give up what runs for a system."""
        running = self.running.pop(root, None)
        if running is not None and running.task is not None:
            running.task.cancel()
            self._changed(root, False)

    def configure(self, settings: Settings) -> None:
        """Take over settings; what was found with others does not count as all there is to find."""
        if settings != self.settings:
            self.settings = settings
            for texts in self._known.values():
                for known in texts.values():
                    known.is_all = False

    def stop_all(self) -> None:
        for root in list(self.running):
            self.stop(root)

    def is_all_known(self, text: Text) -> bool:
        known = self._of(text.root).get(text.digest)
        return known is not None and known.is_all and known.is_current

    def found(self, root: str, digest: str, question: Question) -> tuple[list[Answer], str, bool]:
        """The answers, or why there are none, and whether they are about the text as it is now."""
        texts = self._of(root)
        now = texts.get(digest)
        for known in (*([now] if now is not None else []), *reversed(texts.values())):
            is_current = known is now and known.is_current
            answers = [item for item in known.answers if _belongs(item, question)]
            problem = known.problems.get(question.key, "") if is_current else ""
            if answers or problem:
                return answers, problem, is_current
        return [], "", True

    def _of(self, root: str) -> dict[str, Known]:
        return self._known.setdefault(root, {})

    async def _run(self, text: Text, running: Running) -> None:
        question = running.question
        process = None
        try:
            async with asyncio.timeout(PATIENCE * self.settings.budget + SPARE):
                pipe = asyncio.subprocess.PIPE
                process = await asyncio.create_subprocess_exec(
                    *self._command, stdin=pipe, stdout=pipe, limit=LARGEST
                )
                last = await self._asked(process, text, running)
                ended = await process.wait() if last is None else 0
            problem = "" if last is not None else f"the process ended with {ended}"
        except TimeoutError:
            last, problem = None, "the process took too long"
        except (OSError, ValueError) as error:
            last, problem = None, str(error)
        finally:
            if process is not None and process.returncode is None:
                with suppress(ProcessLookupError):
                    process.kill()
        self._keep(text, question, last, problem)
        if self.running.get(text.root) is running:
            del self.running[text.root]
        self._changed(text.root, True)

    async def _asked(
        self, process: asyncio.subprocess.Process, text: Text, running: Running
    ) -> Mapping[str, object] | None:
        """The last line that a process writes; None if it ends without one.

        Raises:
            ValueError: it writes something else.
        """
        assert process.stdin is not None and process.stdout is not None
        asked = {
            "path": text.root,
            "text": text.text,
            "asked": running.question.asked,
            "of": running.question.of,
            "robots": self.settings.robots,
            "seconds": self.settings.budget,
            "states": 200_000,
        }
        with suppress(ConnectionError):  # then there is nothing to read either
            process.stdin.write(json.dumps(asked).encode() + b"\n")
            await process.stdin.drain()
        while line := await process.stdout.readline():
            said = outside.loads(line, LARGEST)
            if not isinstance(said, dict):
                raise ValueError("the process does not say what was asked for")
            if "told" not in said:
                return said
            running.told = str(said["told"])
        return None

    def _keep(self, text: Text, question: Question, last: Mapping[str, object] | None, problem: str) -> None:
        texts = self._of(text.root)
        known = texts.pop(text.digest, None)
        if known is None or not known.is_current:
            known = Known()
        texts[text.digest] = known  # the newest stands last
        while len(texts) > KEPT:
            del texts[next(iter(texts))]
        known.problems.pop(question.key, None)
        if last is None or "problem" in last:
            known.problems[question.key] = problem or str((last or {}).get("problem"))
            return
        results, files = last.get("results"), last.get("files")
        assert isinstance(results, list) and isinstance(files, list)
        others = [item for item in known.answers if not _belongs(item, question)]
        known.answers = [*others, *map(_answer, results)]
        known.files |= {
            path: _look(path)
            for path in map(str, files)
            if path.endswith(_OF_CODE) and not path.startswith(f"{text.code}{os.sep}")
        }
        known.is_all = known.is_all or not (question.asked or question.of)


def _belongs(item: Answer, question: Question) -> bool:
    return (not question.asked or item.name in question.asked) and (not question.of or item.of in question.of)


def _answer(item: Mapping[str, object]) -> Answer:
    run, scenario = item["counterexample"], item["scenario"]
    name, of, verdict, reason, bounds = (
        str(item[part]) for part in ("name", "of", "verdict", "reason", "bounds")
    )
    return Answer(
        *(name, of, verdict, reason, bounds),
        run=tuple(map(str, run)) if isinstance(run, list) else (),
        scenario=scenario if isinstance(scenario, dict) else None,
    )


def _look(path: str) -> tuple[int, int] | None:
    """What changes when a file does; None if there is none."""
    try:
        found = Path(path).stat()
    except OSError:
        return None
    return found.st_mtime_ns, found.st_size


__all__ = ["Answer", "Known", "Proofs", "Running", "Settings", "Text"]
