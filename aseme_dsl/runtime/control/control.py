"""Control: what an operator can ask of a running team, as JSON requests and replies.

A request is an object with `version` (1), `request`, and what it needs; a reply has `version`, `ok`, and
either what was asked for or `reasons`. How they travel is not known here.

- `{"version": 1, "request": "status"}`
  The reply has the members of `status.status_of`.
- `{"version": 1, "request": "logs", "after": 0, "most": 100}`
  The recent records after that number (of a negative one: the last so many), and `next`, which is `after` of
  the next request. `missed` of those that were asked for are only in the trace.
- `{"version": 1, "request": "select", "agent": "robot2", "plan": "goalie"}`
- `{"version": 1, "request": "stop"}`
- `{"version": 1, "request": "swap", "phase": "ready", "hash": "9f2c…"}`
  `hash` names a version in the run's own folder of versions, by all that is in it. The names in `agents`
  limit the swap to these agents. The state is "ready", or "busy" with the reasons.
- `{… "phase": "prepare", "within": 0.3, "hold": 2.0}`
  The team waits up to `within` s for a moment at which all agents here can change. It holds them there, for
  `hold` s at the most. The state is "prepared", with an `id`; or "busy".
  A swap of the whole team has the number of its `epoch`, which is larger than any before.
- `{… "phase": "commit", "id": 3}`
  A swap of the whole team over its network has the `proof` of its epoch. The epoch is kept across a restart
  from now on. The swap will be done: if no further request arrives, when `hold` is over.
- `{… "phase": "finish", "id": 3}`
  The swap is done.
- `{… "phase": "rollback", "id": 3, "reason": "…"}`
  All agents continue as before. They do so, too, if no request arrives before a commit.
- `{… "phase": "refuse", "reasons": […]}`
  The swap could not be prepared everywhere. The trace here records this.

So a team in several processes changes as one: prepare everywhere, commit everywhere, finish everywhere; and
roll back everywhere if one of them does not confirm.
"""

from __future__ import annotations

import itertools
import threading
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, TypeGuard

from aseme_dsl.outside import loads
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.control.control_log import PROGRAM, ControlLog, Origin
from aseme_dsl.runtime.control.epoch_proof import Doubt, no_doubt
from aseme_dsl.runtime.control.holding import Held, Keep, NotHeld
from aseme_dsl.runtime.control.recent import MOST_ASKED, Recent
from aseme_dsl.runtime.control.replies import HeldSwap, Reply
from aseme_dsl.runtime.control.status import status_of
from aseme_dsl.runtime.team.swap import Swap, Version, version_of
from aseme_dsl.runtime.version.epochs import Epoch, EpochFile, proof_of
from aseme_dsl.runtime.version.loading import LoadError, activities_of, load_beside, package_like
from aseme_dsl.runtime.version.versions import HASH, VersionError, read_version

if TYPE_CHECKING:
    from aseme_dsl.runtime.team.team import Team

FORMAT = 1
"""The version of the requests and replies."""
HOLD = 2.0
"""How long, in seconds, agents are held for a commit or a finish, if the request does not say."""
LONGEST = 60.0
"""Agents are held so long, in seconds, at the most."""
LARGEST = 1 << 16
"""A request has at most so many bytes."""
DEEPEST = 8
"""So many lists and objects may stand in each other in a request."""
LONGEST_TEXT = 4096
"""A text in a request has at most so many characters."""
MOST_NAMES = 10_000
"""A list in a request has at most so many texts."""


class Refused(Exception):
    """A request cannot be fulfilled; the arguments are the reasons."""


@dataclass(frozen=True, slots=True)
class Changed:
    """A swap that is done: to the version of which hash, and whether it was the whole team's."""

    hash: str
    whole_team: bool


@dataclass(frozen=True, slots=True)
class Missed:
    """A newer epoch that the agents here are held for, and why they cannot follow it now.

    It is blocked if that is not only a conversation that has to end.
    """

    epoch: Epoch
    reasons: tuple[str, ...] = ()
    is_blocked: bool = False


class Control:
    """Answers the requests of operators for a team that runs in real time. May be used from any thread."""

    def __init__(
        self,
        team: Team,
        activities: Path | None = None,
        changed: Callable[[Changed], None] | None = None,
        store: Path | None = None,
        recent: Recent | None = None,
        epochs: EpochFile | None = None,
        epoch: Epoch | None = None,
        doubt: Doubt = no_doubt,
    ) -> None:
        """`activities` is the folder of the team's activities; `store` the folder of the versions to which it
        may be changed; `recent` what listens to its trace, for `logs`.
        `epochs` keeps its epoch, which is `epoch` at first; `doubt` says why another one is not followed.

        `changed` is called with each swap that is done.
        """
        self._team = team
        self._activities = activities
        self._changed = changed or (lambda what: None)
        self.log = ControlLog(team)
        team.at_end.append(self.log.flush)
        self._lock = threading.Lock()
        self._numbers = itertools.count(1)
        self._held: Held | None = None
        self._store = store
        self._recent = recent
        self._epochs = epochs
        self._doubt = doubt
        self._coming: Epoch | None = None
        """The epoch of the swap that is under way."""
        self.doubted: dict[str, str] = {}
        """Why the epochs of agents elsewhere are not followed."""
        self.epoch = epoch or Epoch()
        """The epoch that the agents here follow."""
        self.held: Missed | None = None
        """The newer epoch that they are held for, if they are."""
        self._versions: dict[str, Version] = {}

    def read(self, data: bytes, origin: Origin) -> Reply:
        """The reply to a request as it came from outside."""
        try:
            request = loads(data, LARGEST, DEEPEST)
            if not isinstance(request, dict):
                raise ValueError("it is not an object")
        except (ValueError, RecursionError) as problem:
            return self.refuse(origin, None, f"a request is a JSON object on a line: {problem}")
        return self.handle(request, origin)

    def refuse(self, origin: Origin, request: str | None, *reasons: str) -> Reply:
        """The reply to a request that is not fulfilled."""
        self.log.note(origin, request, reasons)
        return {"version": FORMAT, "ok": False, "reasons": list(reasons)}

    def not_over_the_bus(self, agent: str, data: bytes) -> Reply:
        """The reply to each request over the bus where operators' keys are not configured."""
        return self.refuse(Origin("bus", agent=agent), None, "control over the bus is off")

    def handle(self, request: dict[str, object], origin: Origin = PROGRAM) -> Reply:
        """The reply to a request. Never raises for what is in the request."""
        kind = request.get("request")
        known = kind if isinstance(kind, str) and kind in KINDS else None
        try:
            _check(request)
            reply = self._fulfil(request)
        except Refused as problem:
            return self.refuse(origin, known, *map(str, problem.args))
        except Exception as error:  # the operator must get an answer, and no traceback
            return self.refuse(origin, known, f"internal error: {type(error).__name__}: {error}")
        self.log.note(origin, known, ())
        return reply

    def _fulfil(self, request: dict[str, object]) -> Reply:
        answers: dict[str, Callable[[dict[str, object]], Reply]] = {
            "status": self._status,
            "logs": self._logs,
            "select": self._select,
            "swap": self._swap,
            "stop": self._stop,
        }
        if request.get("version") != FORMAT:
            raise Refused(f"requests of version {request.get('version')!r} are not known, but {FORMAT}")
        answer = answers.get(str(request.get("request")))
        if answer is None:
            known = ", ".join(answers)
            raise Refused(f"there is no request {request.get('request')!r}; there are {known}")
        if request["request"] not in ("status", "logs") and not self._team.trace.begun:
            raise Refused("the run has not begun")
        return {"version": FORMAT, "ok": True, **answer(request)}

    # ---- asking ------------------------------------------------------------------------------

    def _status(self, request: dict[str, object]) -> Reply:
        held = self._held
        going: HeldSwap | None = None
        if held is not None and held.is_alive():
            going = {"id": held.number, "state": held.state}
        reply = status_of(self._team, self._activities, self._recent, going)
        missed = self.held
        reply["epoch"] = {"number": self.epoch.number, "hash": self.epoch.hash, "base": self.epoch.base}
        reply["doubted"] = dict(self.doubted)
        reply["held"] = (
            None
            if missed is None
            else {
                "number": missed.epoch.number,
                "hash": missed.epoch.hash,
                "reasons": list(missed.reasons),
            }
        )
        return reply

    def _logs(self, request: dict[str, object]) -> Reply:
        if self._recent is None:
            raise Refused("this run keeps no recent records")
        after, most = request.get("after", 0), request.get("most", MOST_ASKED)
        if not (_is_whole(after) and _is_whole(most)):
            raise Refused("after and most are whole numbers")
        found, missed = self._recent.after(after, max(0, most))
        following = found[-1].number if found else self._recent.number if after < 0 else after
        return {
            "records": [{"number": item.number, "at": item.at, "record": item.record} for item in found],
            "next": following,
            "missed": missed,
        }

    # ---- changing ----------------------------------------------------------------------------

    def _in_real_time(self) -> None:
        if self._team.driver.clock.virtual:
            raise Refused("the team plays in virtual time: changes are scheduled before the run")

    def _select(self, request: dict[str, object]) -> Reply:
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

    def _stop(self, request: dict[str, object]) -> Reply:
        self._team.driver.stop("stopped")
        return {}

    def _swap(self, request: dict[str, object]) -> Reply:
        self._in_real_time()
        phase = request.get("phase")
        match phase:
            case "ready" | "prepare":
                with self._lock:
                    return self._ready(request) if phase == "ready" else self._prepare(request)
            case "refuse":
                with self._lock:
                    reasons = request.get("reasons")
                    self._new_swap(request).refuse(map(str, reasons if isinstance(reasons, list) else ()))
                return {"state": "refused"}
            case "commit" | "finish" | "rollback":
                held = self._held
                if held is None or not held.is_alive() or held.number != request.get("id"):
                    raise Refused(f"the swap {request.get('id')} is not held here any more")
                if phase == "commit" and self._coming is not None:
                    self._coming = replace(self._coming, proof=proof_of(request.get("proof")))
                    if doubt := self._doubt(self._coming):
                        raise Refused(doubt)
                try:
                    return held.say(str(phase), str(request.get("reason", "the operator said so")))
                except NotHeld as problem:
                    raise Refused(str(problem)) from problem
        raise Refused(f"there is no phase {phase!r} of a swap")

    def _new_swap(self, request: dict[str, object]) -> Swap:
        if self._held is not None and self._held.is_alive():
            raise Refused("another swap is under way")
        name = str(request.get("hash"))
        version = self._versions.get(name)
        if version is None:
            try:
                running = self._team.version
                project = [entry for entry in running.path if entry != _root(running)]
                if self._store is None:
                    raise LoadError("this run has no folder of versions")
                code = read_version(self._store, name)
                package = package_like(code, running.system, running.folder)
                loaded = load_beside(package, running.modules, project, running.mixture, code)
            except (LoadError, VersionError) as problem:
                raise Refused(str(problem)) from problem
            version = version_of(loaded, activities_of(code))
            self._versions = {name: version}
        agents = request.get("agents")
        if agents is not None and not isinstance(agents, list):
            raise Refused("agents is a list of names")
        mine = [agent.name for agent in self._team.agents if agents is None or agent.name in agents]
        return Swap(self._team, version, None if agents is None else mine)

    def _checked(self, request: dict[str, object]) -> Swap:
        swap = self._new_swap(request)
        if not swap.check():
            raise Refused(*swap.reasons)
        return swap

    def _ready(self, request: dict[str, object]) -> Reply:
        swap = self._checked(request)
        reasons = list(swap.busy())
        return {"state": "busy" if reasons else "ready", "reasons": reasons, "notes": list(swap.notes)}

    def _prepare(self, request: dict[str, object]) -> Reply:
        whole = request.get("agents") is None
        epoch: Epoch | None = None
        if whole and (number := request.get("epoch")) is not None:
            if not _is_whole(number) or number < 1:
                raise Refused("an epoch is a whole number from 1")
            epoch = Epoch(number, str(request["hash"]), self.epoch.base)
            if number <= self.epoch.number:
                raise Refused(f"epoch {number} is not newer than {self.epoch.number}, which is followed here")
        swap = self._checked(request)
        within, hold = _seconds(request, "within", 0.0), _seconds(request, "hold", HOLD)
        what = Changed(str(request["hash"]), whole)
        self._coming = epoch
        keep = Keep(self._keep_coming, partial(self._keep, self.epoch), partial(self._finished, what))
        self._held = held = Held(swap, next(self._numbers), within, hold, keep)
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

    # ---- epochs ------------------------------------------------------------------------------

    def _keep(self, epoch: Epoch) -> None:
        """Keep an epoch across a restart. Raises OSError."""
        if self._epochs is not None:
            self._epochs.write(epoch)

    def _keep_coming(self) -> None:
        if self._coming is not None:
            self._keep(self._coming)

    def accepts(self, epoch: Epoch, name: str) -> bool:
        """Whether an epoch of an agent elsewhere may be followed here. Why not is recorded once."""
        doubt = self._doubt(epoch)
        if doubt and self.doubted.get(name) != doubt:
            self.log.note(Origin("bus"), "epoch", (f"{name} says: {doubt}",))
        self.doubted.pop(name, None)
        if doubt:
            self.doubted[name] = doubt
        return not doubt

    def _finished(self, what: Changed) -> None:
        epoch = self._coming
        if epoch is not None:
            self.epoch = epoch
            if self.held is not None and not self.held.epoch.is_newer(epoch):
                self._release()
        self._changed(what)

    def _release(self) -> None:
        self.held = None
        self._team.conversations.hold("")

    def hold(self, epoch: Epoch, reasons: tuple[str, ...] = (), blocked: bool = True) -> None:
        """The agents here have missed an epoch: they begin no conversation until they follow it."""
        if self.held is None or self.held.epoch != epoch:
            text = f"held until epoch {epoch.number} (version {epoch.hash[:12]}) is followed here"
            self._team.conversations.hold(text)
            self._team.trace.fault(self._team.driver.clock.now(), "", text)
        if reasons and (self.held is None or self.held.reasons != reasons):
            for reason in reasons:
                self._team.trace.remark(self._team.driver.clock.now(), "", f"held: {reason}")
        self.held = Missed(epoch, reasons, blocked)

    def follow(self, epoch: Epoch) -> bool:
        """Follow a newer epoch of the others, if the agents here can just now; whether nothing is left to do.

        They are held until they do.
        """
        with self._lock:
            if self._held is not None and self._held.is_alive():
                return False  # which may lead there
            if not epoch.is_newer(self.epoch):
                self._release()
                return True
            running = self._team.version.code
            if running is not None and running.hash == epoch.hash:  # only its number was missed
                self._keep(epoch)
                self.epoch = epoch
                self._release()
                return True
            if self.held is None:
                self.hold(epoch, (), False)
            try:
                swap = self._new_swap({"hash": epoch.hash})
                if not swap.check():
                    raise Refused(*swap.reasons)
            except Refused as problem:
                self.hold(epoch, tuple(map(str, problem.args)))
                return False
            if not swap.hold():
                self.hold(epoch, swap.reasons, swap.state != "waiting")
                return False
            try:
                self._keep(epoch)
            except OSError as problem:
                swap.roll_back(f"the epoch cannot be kept: {problem.strerror or problem}")
                self.hold(epoch, swap.reasons)
                return False
            swap.finish()
            self.epoch = epoch
            self._release()
        self._changed(Changed(epoch.hash, True))
        return True


KINDS = ("status", "logs", "select", "swap", "stop")
"""The requests that there are."""


def _is_text(value: object) -> bool:
    return isinstance(value, str) and 0 < len(value) <= LONGEST_TEXT and value.isprintable()


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _is_whole(value: object) -> TypeGuard[int]:
    return isinstance(value, int) and not isinstance(value, bool) and abs(value) < 1 << 53


def _is_list(value: object) -> bool:
    return isinstance(value, list) and len(value) <= MOST_NAMES and all(map(_is_text, value))


_MEMBERS: dict[str, tuple[Callable[[object], bool], str]] = {
    "version": (_is_number, "a number"),
    "request": (_is_text, "a text"),
    "phase": (_is_text, "a text"),
    "agent": (_is_text, "a text"),
    "plan": (_is_text, "a text"),
    "hash": (lambda value: isinstance(value, str) and HASH.fullmatch(value) is not None, "a hash"),
    "agents": (lambda value: value is None or _is_list(value), "a list of texts"),
    "reasons": (_is_list, "a list of texts"),
    "reason": (_is_text, "a text"),
    "within": (_is_number, "a number"),
    "hold": (_is_number, "a number"),
    "id": (_is_number, "a number"),
    "epoch": (_is_number, "a number"),
    "proof": (lambda value: proof_of(value) is not None, "a proof"),
    "after": (_is_number, "a number"),
    "most": (_is_number, "a number"),
}
"""What a request may have: whether a value fits, and what it should be."""


def _check(request: dict[str, object]) -> None:
    """Raises Refused for a request whose members are not what they should be, before any is used."""
    for name, value in request.items():
        if name not in _MEMBERS:
            raise Refused(f"a request has no member {name[:40]!r}")
        fits, expected = _MEMBERS[name]
        if not fits(value):
            raise Refused(f"{name} is not {expected} that a request may have")


def _seconds(request: dict[str, object], name: str, usual: float) -> float:
    value = request.get(name, usual)
    if not isinstance(value, int | float) or not 0 <= value <= LONGEST:
        raise Refused(f"{name} is a number of seconds up to {LONGEST:g}")
    return float(value)


def _root(version: Version) -> Path | None:
    """Where the package of a version is imported from, which is not where its functions are."""
    return version.path[0] if version.path else None
