"""Control: what an operator can ask of a running team, as JSON requests and replies.

A request is an object with `version` (1), `request`, and what it needs; a reply has `version`, `ok`, and
either what was asked for or `reasons`. How they travel is not known here.

    {"version": 1, "request": "status"}
        system, model, time (ns), agents: name, role, model, over, failure, steps, configuration, activities
    {"version": 1, "request": "select", "agent": "robot2", "plan": "goalie"}
    {"version": 1, "request": "stop"}
    {"version": 1, "request": "swap", "phase": "ready", "folder": "…/monas/Kouretes", "model": "…"}
        `folder` is a generated package; `model`, if given, must be its hash. `agents` (names) and
        `activities` (a folder) may be given, else it is all of them and the activities that run.
        state: "ready", or "busy" with the reasons
    {… "phase": "prepare", "within": 0.3, "hold": 2.0}
        waits `within` s for a moment at which all agents here can change, and holds them there, `hold` s at
        the most. state: "prepared", with an `id`; or "busy"
    {… "phase": "commit", "id": 3}
        it will be done: if nothing more is heard, when `hold` is over
    {… "phase": "finish", "id": 3} · {… "phase": "rollback", "id": 3, "reason": "…"}
        it is done; or everybody goes on as before, as also if nothing is heard before a commit
    {… "phase": "refuse", "reasons": […]}
        it could not be prepared everywhere: this is traced here

So a team in several processes changes as one: prepare everywhere, commit everywhere, finish everywhere; and
roll back everywhere if one of them does not confirm.
"""

from __future__ import annotations

import itertools
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from queue import Empty, SimpleQueue
from typing import TYPE_CHECKING, Any

from aseme_dsl.runtime.loading import LoadError, activities_in, load_beside, package_like
from aseme_dsl.runtime.swap import Swap, Version, version_of

if TYPE_CHECKING:
    from aseme_dsl.runtime.team import Team

FORMAT = 1
"""The version of the requests and replies."""
HOLD = 2.0
"""How long, in seconds, agents are held for a commit or a finish, if the request does not say."""
LONGEST = 60.0
"""Agents are held so long, in seconds, at the most."""
_LOOK_SECONDS = 0.002

Reply = dict[str, Any]


class Refused(Exception):
    """A request cannot be fulfilled; the arguments are the reasons."""


@dataclass(frozen=True, slots=True)
class Changed:
    """A swap that is done: to which generated package, with the activities of which other folder if any, and
    whether it was the whole team's."""

    folder: Path
    activities: Path | None
    whole_team: bool


class Control:
    """Answers the requests of operators for a team that runs in real time. May be used from any thread."""

    def __init__(
        self, team: Team, activities: Path | None = None, changed: Callable[[Changed], None] | None = None
    ) -> None:
        """`activities` is the folder of the team's activities, and of those of new versions.

        `changed` is told of each swap that is done.
        """
        self._team = team
        self._activities = activities
        self._changed = changed or (lambda what: None)
        self._lock = threading.Lock()
        self._numbers = itertools.count(1)
        self._held: _Held | None = None
        self._versions: dict[tuple[Path, Path | None], Version] = {}

    def handle(self, request: dict[str, Any]) -> Reply:
        """The reply to a request. Never raises for what is in the request."""
        answers: dict[str, Callable[[dict[str, Any]], Reply]] = {
            "status": self._status,
            "select": self._select,
            "swap": self._swap,
            "stop": self._stop,
        }
        try:
            if request.get("version") != FORMAT:
                raise Refused(f"requests of version {request.get('version')!r} are not known, but {FORMAT}")
            answer = answers.get(str(request.get("request")))
            if answer is None:
                known = ", ".join(answers)
                raise Refused(f"there is no request {request.get('request')!r}; there are {known}")
            return {"version": FORMAT, "ok": True, **answer(request)}
        except Refused as problem:
            return {"version": FORMAT, "ok": False, "reasons": list(problem.args)}

    # ---- asking ------------------------------------------------------------------------------

    def _status(self, request: dict[str, Any]) -> Reply:
        team = self._team
        held = self._held
        agents = []
        for agent in team.agents:
            chart = agent.chart
            names = agent.plan.by_label
            labels = chart.configuration() if chart.started else ()
            agents.append(
                {
                    "name": agent.name,
                    "role": agent.role,
                    "system": agent.plan.system,
                    "model": agent.plan.model,
                    "over": agent.over,
                    "failure": chart.failure,
                    "steps": agent.steps,
                    "configuration": list(labels),
                    "activities": [names[x].activity for x in labels if x in names and names[x].activity],
                }
            )
        return {
            "system": team.system,
            "model": team.version.model,
            "plans": list(team.version.charts),
            "time": team.driver.clock.now(),
            "agents": agents,
            "elsewhere": sorted(team.elsewhere),
            "swap": None if held is None or not held.is_alive() else {"id": held.number, "state": held.state},
        }

    # ---- changing ----------------------------------------------------------------------------

    def _in_real_time(self) -> None:
        if self._team.driver.clock.virtual:
            raise Refused("the team plays in virtual time: changes are scheduled before the run")

    def _select(self, request: dict[str, Any]) -> Reply:
        self._in_real_time()
        name, plan = str(request.get("agent")), str(request.get("plan"))
        agent = next((item for item in self._team.agents if item.name == name), None)
        if agent is None:
            known = ", ".join(item.name for item in self._team.agents)
            raise Refused(f"there is no agent {name} here; there are {known}")
        with self._lock, agent.driver.guard(agent):
            reason = self._team.choose(agent, plan, "operator")
        if reason is not None:
            raise Refused(reason)
        return {"agent": name, "plan": f"{agent.plan.system}.{agent.plan.name}", "model": agent.plan.model}

    def _stop(self, request: dict[str, Any]) -> Reply:
        self._team.driver.stop("stopped")
        return {}

    def _swap(self, request: dict[str, Any]) -> Reply:
        self._in_real_time()
        phase = request.get("phase")
        match phase:
            case "ready" | "prepare":
                with self._lock:
                    return self._ready(request) if phase == "ready" else self._prepare(request)
            case "refuse":
                with self._lock:
                    self._new_swap(request).refuse(map(str, request.get("reasons", ())))
                return {"state": "refused"}
            case "commit" | "finish" | "rollback":
                held = self._held
                if held is None or not held.is_alive() or held.number != request.get("id"):
                    raise Refused(f"the swap {request.get('id')} is not held here any more")
                return held.say(str(phase), str(request.get("reason", "the operator said so")))
        raise Refused(f"there is no phase {phase!r} of a swap")

    def _new_swap(self, request: dict[str, Any]) -> Swap:
        if self._held is not None and self._held.is_alive():
            raise Refused("another swap is under way")
        folder = Path(str(request.get("folder")))
        given = request.get("activities")
        activities = Path(str(given)) if given else self._activities
        version = self._versions.get((folder, activities))
        if version is None:
            try:
                running = self._team.version
                project = [entry for entry in running.path if entry != _root(running)]
                package = package_like(folder, running.folder)
                loaded = load_beside(package, running.modules, project, running.mixture)
            except LoadError as problem:
                raise Refused(str(problem)) from problem
            find = activities_in(activities) if activities is not None else lambda name: None
            version = version_of(loaded, find)
            self._versions = {(folder, activities): version}
        if request.get("model") not in (None, version.model):
            raise Refused(f"{folder} has the model {version.model}, not {request['model']}")
        agents = request.get("agents")
        if agents is not None and not isinstance(agents, list):
            raise Refused("agents is a list of names")
        mine = [agent.name for agent in self._team.agents if agents is None or agent.name in agents]
        return Swap(self._team, version, None if agents is None else mine)

    def _checked(self, request: dict[str, Any]) -> Swap:
        swap = self._new_swap(request)
        if not swap.check():
            raise Refused(*swap.reasons)
        return swap

    def _ready(self, request: dict[str, Any]) -> Reply:
        swap = self._checked(request)
        reasons = list(swap.busy())
        return {"state": "busy" if reasons else "ready", "reasons": reasons, "notes": list(swap.notes)}

    def _prepare(self, request: dict[str, Any]) -> Reply:
        swap = self._checked(request)
        within, hold = _seconds(request, "within", 0.0), _seconds(request, "hold", HOLD)
        given = request.get("activities")
        what = Changed(
            Path(str(request["folder"])), Path(str(given)) if given else None, request.get("agents") is None
        )
        finished = partial(self._changed, what)
        self._held = held = _Held(swap, next(self._numbers), within, hold, finished)
        held.start()
        held.prepared.wait()
        if held.state == "refused":
            raise Refused(*swap.reasons)
        return {
            "state": held.state,
            "id": held.number,
            "reasons": list(swap.reasons),
            "notes": list(swap.notes),
        }


def _seconds(request: dict[str, Any], name: str, usual: float) -> float:
    value = request.get(name, usual)
    if not isinstance(value, int | float) or not 0 <= value <= LONGEST:
        raise Refused(f"{name} is a number of seconds up to {LONGEST:g}")
    return float(value)


def _root(version: Version) -> Path | None:
    """Where the package of a version is imported from, which is not where its functions are."""
    return version.path[0] if version.path else None


@dataclass
class _Said:
    """Something that is said to who holds the agents, and the reply."""

    phase: str
    reason: str
    reply: Reply = field(default_factory=dict)
    refused: str = ""
    done: threading.Event = field(default_factory=threading.Event)


class _Held(threading.Thread):
    """Holds the agents between prepare and finish: locks are for one thread."""

    def __init__(
        self, swap: Swap, number: int, within: float, hold: float, finished: Callable[[], None]
    ) -> None:
        super().__init__(name="aseme swap", daemon=True)
        self.number = number
        self.state = "waiting"
        self.prepared = threading.Event()
        self._swap = swap
        self._within = within
        self._hold = hold
        self._finished = finished
        self._said: SimpleQueue[_Said] = SimpleQueue()

    def say(self, phase: str, reason: str) -> Reply:
        """Say what comes next, and wait until it has been done."""
        said = _Said(phase, reason)
        self._said.put(said)
        if not said.done.wait(self._hold + 5.0) or said.refused:
            raise Refused(said.refused or "no answer")
        return said.reply

    def run(self) -> None:
        try:
            if self._prepare():
                self._obey()
        finally:
            self.prepared.set()
            while True:  # nobody waits for ever
                try:
                    late = self._said.get_nowait()
                except Empty:
                    return
                late.refused = f"the swap {self.number} is {self.state}"
                late.done.set()

    def _prepare(self) -> bool:
        swap = self._swap
        deadline = time.monotonic() + self._within
        while not swap.hold():
            if swap.state != "waiting":
                self.state = swap.state
                return False
            if time.monotonic() >= deadline:
                self.state = "busy"
                return False
            time.sleep(_LOOK_SECONDS)
        self.state = "prepared"
        self.prepared.set()
        return True

    def _obey(self) -> None:
        until = time.monotonic() + self._hold
        while self.state in ("prepared", "committed"):
            try:
                said = self._said.get(timeout=max(0.0, until - time.monotonic()))
            except Empty:
                silence = f"nobody has confirmed it within {self._hold:g} s"
                said = _Said("finish" if self.state == "committed" else "rollback", silence)
            try:
                if said.phase == "commit":
                    self.state = "committed"
                    until = time.monotonic() + self._hold
                elif said.phase == "finish" and self.state == "committed":
                    self.state = "done"
                    self._swap.finish()
                    self._finished()
                elif said.phase == "finish":
                    said.refused = "it has not been committed"
                else:
                    self.state = "rolled back"
                    self._swap.roll_back(said.reason)
            except Exception as error:  # of a new version's code, say: the operator must hear of it
                said.refused = f"{type(error).__name__}: {error}"
            said.reply = {"state": self.state}
            said.done.set()
