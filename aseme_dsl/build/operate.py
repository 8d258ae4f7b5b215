"""Operate: what runs from an output folder is asked and changed, in all its processes at once."""

from __future__ import annotations

import time
from collections.abc import Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from aseme_dsl.build.build import Choice

if TYPE_CHECKING:
    from aseme_dsl.amola.system import System

VERSIONS = "versions"
"""The folder inside an output folder with the versions that running teams were changed to."""
WITHIN = 10.0
"""How long, in seconds, a swap waits for conversations to end."""
_ANSWER = 5.0
"""How long, in seconds, it is waited for the answer of a process."""
_HOLD = 3.0
_TRY = 0.3
_PAUSE = 0.05

Reply = dict[str, Any]


class OperateError(Exception):
    """What was asked for cannot be done; the arguments say why, a line each."""


@dataclass(frozen=True, slots=True)
class Node:
    """A process that runs agents, and what it says of itself."""

    socket: Path
    status: Reply

    @property
    def agents(self) -> tuple[str, ...]:
        return tuple(str(agent["name"]) for agent in self.status.get("agents", ()))


def look(output: Path) -> tuple[tuple[Node, ...], tuple[str, ...]]:
    """The processes that run from an output folder and answer, and why others do not.

    Raises:
        OperateError: there is none.
    """
    from aseme_dsl.runtime.control_socket import endpoints

    found = endpoints(output)
    if not found:
        raise OperateError(f"nothing runs from {output}: `asemec run … --real` does")
    replies = _try_all({path: {"request": "status"} for path in found})
    there = tuple(Node(path, reply) for path, reply in replies.items() if reply["ok"])
    return there, tuple(text for reply in replies.values() if not reply["ok"] for text in reply["reasons"])


def nodes(output: Path) -> tuple[Node, ...]:
    """The processes that run from an output folder.

    Raises:
        OperateError: there is none, or one does not answer.
    """
    there, silent = look(output)
    if silent:
        raise OperateError(*silent)
    return there


def select(output: Path, agent: str, plan: str) -> Reply:
    """Have an agent leave its plan and enter another.

    Raises:
        OperateError: there is no such agent, or it cannot.
    """
    there = nodes(output)
    node = next((node for node in there if agent in node.agents), None)
    if node is None:
        known = ", ".join(name for node in there for name in node.agents)
        raise OperateError(f"there is no agent {agent}; there are {known}")
    request = {"request": "select", "agent": agent, "plan": plan}
    return _ask_all({node.socket: request}, 10.0)[node.socket]


def generate_version(system: System, output: Path, choice: Choice) -> tuple[Path, str]:
    """Write the packages of a system beside those that run, for agents of every backend; gives the folder of
    one of them and the hash of its models.

    Raises:
        OperateError: it cannot be written.
    """
    from aseme_dsl.backends.backend import AGENTS, BackendOptions, find_backend
    from aseme_dsl.build.build import with_labels

    labelled = with_labels(system, choice.labels)
    options = BackendOptions(choice.templates)
    artefacts = [(name, item) for name in AGENTS for item in find_backend(name).generate(labelled, options)]
    package = next(item.text for _, item in artefacts if item.path == f"{system.name}/__init__.py")
    model = next(line for line in package.splitlines() if line.startswith("MODEL = ")).split("'")[1]
    home = output / VERSIONS / model
    for name, item in artefacts:
        if item.kept:
            continue
        path = home / name / item.path
        content = item.text.encode("utf-8", "backslashreplace")
        try:
            if path.is_file() and path.read_bytes() == content:
                continue
            path.parent.mkdir(parents=True, exist_ok=True)
            part = path.with_name(path.name + ".part")
            part.write_bytes(content)
            part.replace(path)
        except OSError as problem:
            raise OperateError(f"{path} cannot be written: {problem.strerror or problem}") from problem
    return home / AGENTS[0] / system.name, model


def swap(
    output: Path,
    folder: Path,
    model: str,
    *,
    within: float = WITHIN,
    activities: Path | None = None,
    agents: Iterable[str] | None = None,
) -> tuple[Reply, ...]:
    """Change what runs to the version whose package is in `folder`, in all processes or in none.

    `within` is how long, in seconds, it is waited for conversations that the new version plays differently.
    Gives what the processes have said.

    Raises:
        OperateError: one of them cannot, or did not confirm; they all go on as before.
    """
    names = None if agents is None else list(agents)
    there = nodes(output)
    concerned = [node for node in there if names is None or set(node.agents) & set(names)]
    missing = [name for name in names or () if not any(name in node.agents for node in there)]
    if missing:
        raise OperateError(f"there is no agent {missing[0]}")
    request: Reply = {
        "request": "swap",
        "folder": str(folder.resolve()),
        "model": model,
        "activities": None if activities is None else str(activities.resolve()),
        "agents": names,
    }
    sockets = [node.socket for node in concerned]
    deadline = time.monotonic() + within
    while True:
        busy, notes = _prepare(sockets, request, model)
        if not busy:
            return notes
        if time.monotonic() >= deadline:
            reasons = [f"{reason} after {within:g} s" for reason in busy]
            _try_all({path: {**request, "phase": "refuse", "reasons": reasons} for path in sockets})
            raise OperateError(*reasons)
        time.sleep(_PAUSE)


def _prepare(sockets: list[Path], request: Reply, model: str) -> tuple[list[str], tuple[Reply, ...]]:
    """One attempt; gives who is in the way, if somebody is."""
    replies = _ask_all({path: {**request, "phase": "ready"} for path in sockets}, 30.0)
    busy = [reason for reply in replies.values() for reason in reply["reasons"]]
    if busy:
        return busy, ()
    prepare = {**request, "phase": "prepare", "within": _TRY, "hold": _HOLD}
    outcome = _try_all({path: prepare for path in sockets}, 30.0)
    held = {path: reply["id"] for path, reply in outcome.items() if reply.get("state") == "prepared"}
    problems = [reason for reply in outcome.values() if not reply["ok"] for reason in reply["reasons"]]
    busy = [reason for reply in outcome.values() if reply["ok"] for reason in reply["reasons"]]
    if problems or busy:
        _roll_back(held, "; ".join(problems or busy))
        if problems:
            raise OperateError(*problems)
        return busy, ()
    for phase in ("commit", "finish"):
        replies = _try_all({path: {"request": "swap", "phase": phase, "id": n} for path, n in held.items()})
        problems = [reason for reply in replies.values() if not reply["ok"] for reason in reply["reasons"]]
        if problems and phase == "commit":
            back = _roll_back(held, "; ".join(problems))
            raise OperateError(*problems, *back)
        if problems:  # it has been confirmed everywhere: who has not finished does so by itself
            raise OperateError(*problems, "`asemec status` says who runs which model")
    return [], tuple(outcome.values())


def _roll_back(held: Mapping[Path, int], reason: str) -> list[str]:
    """Let everybody go on as before; gives who did not say that it does."""
    requests = {
        path: {"request": "swap", "phase": "rollback", "id": number, "reason": reason}
        for path, number in held.items()
    }
    return [
        f"it is not known whether it was rolled back: {text}"
        for reply in _try_all(requests).values()
        if not reply["ok"]
        for text in reply["reasons"]
    ]


def _ask_all(requests: Mapping[Path, Reply], timeout: float) -> dict[Path, Reply]:
    """The replies. Raises OperateError with all the reasons, if one is a refusal or does not come."""
    replies = _try_all(requests, timeout)
    problems = [text for reply in replies.values() if not reply["ok"] for text in reply["reasons"]]
    if problems:
        raise OperateError(*dict.fromkeys(problems))
    return replies


def _try_all(requests: Mapping[Path, Reply], timeout: float = _ANSWER) -> dict[Path, Reply]:
    """The replies; who does not answer is taken to refuse."""
    from aseme_dsl.runtime.control_socket import ControlError, ask

    def one(path: Path) -> Reply:
        try:
            return ask(path, requests[path], timeout)
        except ControlError as problem:
            return {"ok": False, "reasons": [str(problem)]}

    if not requests:
        return {}
    with ThreadPoolExecutor(len(requests)) as pool:
        return dict(zip(requests, pool.map(one, requests), strict=True))
