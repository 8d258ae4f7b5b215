"""Who takes part: the code by hand, ours in its forms, and the named peers; each in a process of its own."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections import deque
from dataclasses import dataclass, field, replace
from queue import Empty, Queue
from threading import Thread
from typing import Any, Literal

from benchmarks.peers.environment import HERE, ROOT, Environment

Group = Literal["hand", "ours", "peer"]
PATIENCE = 300
"""Seconds that an answer may take."""


@dataclass(frozen=True, slots=True)
class Contender:
    """One that takes part. `how` is what its adapter is told besides the behaviour."""

    key: str
    title: str
    group: Group
    module: str
    distribution: str = ""
    is_node: bool = False
    how: tuple[tuple[str, str], ...] = ()


BY_HAND = Contender("by_hand", "by hand", "hand", "by_hand")
BY_HAND_SLOTS = Contender(
    "by_hand_slots", "by hand, blackboard with slots", "hand", "by_hand", how=(("form", "slots"),)
)


def ours(key: str, title: str, form: str) -> Contender:
    """One of our own forms."""
    return Contender(key, title, "ours", "compiled", how=(("form", form),))


CORE_DICT = ours("core_dict", "core step, blackboard a dictionary", "dict")
CORE_TYPED = ours("core_typed", "core step, typed blackboard", "typed")
SEND = ours("send", "complete runtime (`Machine.send`)", "send")
SEND_DICT = ours("send_dict", "complete runtime, blackboard a dictionary", "send_dict")
POST = ours("post", "thread-safe (`Machine.post`)", "post")
POST_DICT = ours("post_dict", "thread-safe, blackboard a dictionary", "post_dict")
NATIVE = ours("native", "native build, typed blackboard", "native")
AGENT = ours("agent", "agent, full step", "agent")
OURS = (CORE_TYPED, CORE_DICT, SEND, SEND_DICT, POST, POST_DICT, NATIVE, AGENT)


def peer(distribution: str, title: str, module: str, is_node: bool = False) -> Contender:
    """A library."""
    return Contender(module, title, "peer", module, distribution, is_node)


STATECHART = peer("statechart", "statechart", "statechart")
XSTATE_PYTHON = peer("xstate-statemachine", "xstate-statemachine", "xstate_statemachine")
SISMIC = peer("sismic", "sismic", "sismic")
SISMIC_UNCHECKED = replace(
    SISMIC,
    key="sismic_unchecked",
    title="sismic, contracts ignored",
    how=(("form", "unchecked"),),
)
TRANSITIONS = peer("transitions", "transitions", "transitions")
PYTHON_STATEMACHINE = peer("python-statemachine", "python-statemachine", "python_statemachine")
PY_TREES = peer("py_trees", "py_trees", "py_trees")
XSTATE = peer("xstate", "XState (Node)", "xstate", is_node=True)
SCION = peer("@scion-scxml/core", "SCION (Node)", "scion", is_node=True)
PEERS = (
    STATECHART,
    XSTATE_PYTHON,
    SISMIC,
    SISMIC_UNCHECKED,
    TRANSITIONS,
    PYTHON_STATEMACHINE,
    PY_TREES,
    XSTATE,
    SCION,
)


class Failed(Exception):
    """A contender did not do what was asked; the text says why."""


@dataclass(slots=True)
class Process:
    """A contender's process, which answers orders one by one.

    Raises:
        Failed: it cannot be started.
    """

    contender: Contender
    environment: Environment
    seed: int = 0
    """Where the keys lie in a dictionary is luck, but must not be another one for each process."""
    process: subprocess.Popen[str] = field(init=False)
    answers: Queue[str] = field(init=False)
    said: deque[str] = field(init=False)

    def __post_init__(self) -> None:
        contender, environment = self.contender, self.environment
        if contender.is_node:
            assert environment.node is not None
            worker = [str(HERE / "node" / "worker.mjs"), str(environment.node_folder), contender.module]
            command = [environment.node, "--expose-gc", *worker]
        else:
            python = sys.executable if contender.group != "peer" else str(environment.python)
            command = [python, "-m", "benchmarks.peers.worker", contender.module]
        variables = dict(os.environ, PYTHONPATH=str(ROOT), PYTHONWARNINGS="ignore")
        variables["PYTHONHASHSEED"] = str(self.seed)
        pipe = subprocess.PIPE
        self.process = subprocess.Popen(
            command, cwd=ROOT, env=variables, stdin=pipe, stdout=pipe, stderr=pipe, text=True
        )
        self.answers = Queue()
        self.said = deque(maxlen=5)
        Thread(target=self._listen, daemon=True).start()
        Thread(target=self._overhear, daemon=True).start()

    def _listen(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            self.answers.put(line)
        self.answers.put("")

    def _overhear(self) -> None:
        assert self.process.stderr is not None
        self.said.extend(line.strip() for line in self.process.stderr)

    def ask(self, do: str, **further: Any) -> dict[str, Any]:
        """Give an order and wait for the answer.

        Raises:
            Failed: the contender raised something, ended or took too long.
        """
        order = {"do": do, "how": dict(self.contender.how), **further}
        assert self.process.stdin is not None
        try:
            self.process.stdin.write(json.dumps(order) + "\n")
            self.process.stdin.flush()
            line = self.answers.get(timeout=PATIENCE)
        except (OSError, Empty) as error:
            self.end()
            raise Failed(type(error).__name__) from error
        if not line:
            self.end()
            raise Failed(" / ".join(self.said) or "it has ended")
        found: dict[str, Any] = json.loads(line)
        if "error" in found:
            raise Failed(found["error"])
        return found

    def end(self) -> None:
        """End the process."""
        assert self.process.stdin is not None
        try:
            self.process.stdin.close()
            self.process.wait(timeout=5)
        except (OSError, subprocess.TimeoutExpired):
            self.process.kill()
            self.process.wait()
