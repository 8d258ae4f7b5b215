"""The directory: which agents there are (white pages), and what each of them offers (yellow pages).

It is that of FIPA's agent management (SC00023): entries are registered, modified, deregistered and searched,
and subscribers get the changes. Each agent of the team is in it with the participants that it plays, from the
beginning until it has ended. Agents of other processes are in it while the transport reaches them. What an
agent offers besides, it registers itself. Agents that are not of the team register at the agent `df`, which
is this directory's face for them (`management`).

Each process has its own. What agents offer besides the participants they play is known only where they said
so.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Iterable, Mapping
from dataclasses import field, replace
from typing import Protocol

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.message.acl import JSON, AgentIdentifier
from aseme_dsl.runtime.time.clock import Clock, nanoseconds
from aseme_dsl.runtime.time.timers import Scheduler, Timer
from aseme_dsl.runtime.trace.trace import Trace

REMEMBERED = 4096
"""So many changes are kept for those who look at them now and then."""
MOST = 10_000
"""So many agents may register what they offer, besides the participants that they play."""


class DirectoryError(Exception):
    """A registration that cannot be; `error` is FIPA's word for it (SC00023, 4.3.4)."""

    def __init__(self, error: str, text: str) -> None:
        super().__init__(text)
        self.error = error


def already_registered(name: str) -> DirectoryError:
    """An agent registers what it may only modify."""
    return DirectoryError("already-registered", f"{name} has registered already: it may modify that")


def not_registered(name: str) -> DirectoryError:
    """An agent modifies or takes back what it has not registered."""
    return DirectoryError("not-registered", f"{name} has registered nothing")


@dataclass(frozen=True, slots=True)
class Service:
    """What an agent offers. As a pattern, each member that is given has to be there.

    The service of playing a participant has the type `protocol.participant`.
    """

    type: str = ""
    name: str = ""
    protocols: tuple[str, ...] = ()
    ontologies: tuple[str, ...] = ()
    languages: tuple[str, ...] = ()
    ownership: str = ""
    properties: tuple[tuple[str, str], ...] = ()

    def fits(self, pattern: Service) -> bool:
        """Whether it is one that a pattern asks for."""
        return (
            pattern.type in ("", self.type)
            and pattern.name in ("", self.name)
            and pattern.ownership in ("", self.ownership)
            and _has_all(self.protocols, pattern.protocols)
            and _has_all(self.ontologies, pattern.ontologies)
            and _has_all(self.languages, pattern.languages)
            and _has_all(self.properties, pattern.properties)
        )


@dataclass(frozen=True, slots=True)
class Entry:
    """An agent with what it offers. As a pattern, each member that is given has to be there."""

    agent: AgentIdentifier = field(default_factory=lambda: AgentIdentifier(""))
    services: tuple[Service, ...] = ()
    protocols: tuple[str, ...] = ()
    ontologies: tuple[str, ...] = ()
    languages: tuple[str, ...] = ()
    until: int | None = None
    """When what the agent has registered itself ends, in ns of the run; None: not by time."""

    @property
    def name(self) -> str:
        """The agent's name."""
        return self.agent.name

    def fits(self, pattern: Entry) -> bool:
        """Whether it is one that a pattern asks for."""
        return (
            pattern.name in ("", self.name)
            and all(any(own.fits(service) for own in self.services) for service in pattern.services)
            and _has_all(self.protocols, pattern.protocols)
            and _has_all(self.ontologies, pattern.ontologies)
            and _has_all(self.languages, pattern.languages)
        )


def _has_all(there: Iterable[object], wanted: Iterable[object]) -> bool:
    return set(wanted) <= set(there)


@dataclass(frozen=True, slots=True)
class Change:
    """What has changed: an entry is `registered`, `modified` or `gone`.

    `forgotten`: more has changed than is remembered; who wants to know searches again.
    """

    number: int
    what: str
    entry: Entry
    before: Entry | None = None
    """What a modified entry was."""

    def concerns(self, pattern: Entry) -> bool:
        """Whether a pattern asks for the entry as it is or as it was."""
        return self.entry.fits(pattern) or (self.before is not None and self.before.fits(pattern))


@dataclass(frozen=True, slots=True)
class Resident:
    """An agent in the white pages: whether it is `active` or `gone`, and the role that it has."""

    name: str
    state: str
    role: str = ""


def played(name: str, plan: Plan) -> Entry:
    """The entry of an agent of the team: the participants that it plays."""
    services = {
        (info.protocol, info.participant): Service(
            service_of(info.protocol, info.participant),
            info.participant,
            (info.protocol,),
            (plan.system,),
            (JSON,),
        )
        for info in plan.branches
    }
    protocols = tuple(dict.fromkeys(protocol for protocol, _ in services))
    return Entry(AgentIdentifier(name), tuple(services.values()), protocols, (plan.system,), (JSON,))


def service_of(protocol: str, participant: str) -> str:
    """The type of the service of playing a participant."""
    return f"{protocol}.{participant}"


@dataclass(slots=True)
class _Lease:
    """What an agent has registered itself, and the timer that ends it."""

    entry: Entry
    timer: Timer | None = None


class Directory:
    """The directory of a process. May be used from any thread."""

    def __init__(self, driver: Scheduler, trace: Trace) -> None:
        self._driver = driver
        self._trace = trace
        self._team: dict[str, Entry] = {}
        """The agents of the team that are there, by what they play."""
        self._roles: dict[str, str] = {}
        """The roles of all agents of the team, in its order, also of those that are not there."""
        self._gone: set[str] = set()
        self._leases: dict[str, _Lease] = {}
        """What agents have registered themselves."""
        self._entries: dict[str, Entry] = {}
        self._changes: deque[Change] = deque(maxlen=REMEMBERED)
        self._number = 0
        self._listeners: list[Callable[[Change], None]] = []
        self._lock = threading.RLock()

    @property
    def clock(self) -> Clock:
        """The clock of the run."""
        return self._driver.clock

    # ---- who is there ------------------------------------------------------------------------

    def expect(self, name: str, plan: Plan) -> None:
        """There is such an agent in the team, maybe not yet; they come in the team's order."""
        with self._lock:
            self._roles[name] = plan.name

    def appeared(self, name: str, plan: Plan) -> None:
        """An agent of the team is there, or there again, or follows another plan now."""
        with self._lock:
            self._roles[name] = plan.name
            self._gone.discard(name)
            self._team[name] = played(name, plan)
        self._renew(name)

    def follows(self, name: str, plan: Plan) -> None:
        """An agent of the team follows a plan now, whether it is there or not."""
        self.expect(name, plan)
        if name in self._team:
            self.appeared(name, plan)

    def disappeared(self, name: str) -> None:
        """An agent is not there any more; what it has registered goes with it."""
        with self._lock:
            if name not in self._entries:
                return
            if name in self._roles:
                self._gone.add(name)
            self._team.pop(name, None)
            self._end(self._leases.pop(name, None))
        self._renew(name)

    def players(self, protocol: str, participant: str) -> list[str]:
        """The agents that have registered themselves that they play a participant."""
        wanted = service_of(protocol, participant)
        with self._lock:
            return [
                name
                for name, lease in self._leases.items()
                if any(service.type == wanted for service in lease.entry.services)
            ]

    def is_gone(self, name: str) -> bool:
        """Whether an agent was there and is not any more."""
        return name in self._gone

    def residents(self) -> tuple[Resident, ...]:
        """The white pages: the agents of the team that were ever there, then others that have registered."""
        with self._lock:
            found = {
                name: Resident(name, "gone" if name in self._gone else "active", role)
                for name, role in self._roles.items()
                if name in self._entries or name in self._gone
            }
            for name in self._entries:
                found.setdefault(name, Resident(name, "active"))
            return tuple(found.values())

    # ---- entries -----------------------------------------------------------------------------

    def register(self, entry: Entry, lease: int | None = None) -> Entry:
        """Register what an agent offers, for so long (ns) if that is said; the entry that it has now.

        Raises:
            DirectoryError: the agent has registered already, or too many have.
        """
        with self._lock:
            if entry.name in self._leases:
                raise already_registered(entry.name)
            if len(self._leases) >= MOST:
                raise DirectoryError("internal-error", f"{MOST} agents have registered already")
            self._put(entry, lease)
        return self._renew(entry.name, "register")

    def modify(self, entry: Entry, lease: int | None = None) -> Entry:
        """Replace what an agent has registered. Raises DirectoryError if it has not."""
        with self._lock:
            self._check(entry.name)
            self._end(self._leases.pop(entry.name))
            self._put(entry, lease)
        return self._renew(entry.name, "modify")

    def deregister(self, name: str) -> None:
        """An agent takes back what it has registered. Raises DirectoryError if it has not."""
        with self._lock:
            self._check(name)
            self._end(self._leases.pop(name))
        self._renew(name, "deregister")

    def has_registered(self, name: str) -> bool:
        """Whether an agent has registered something itself."""
        return name in self._leases

    def _check(self, name: str) -> None:
        if name not in self._leases:
            raise not_registered(name)

    def _put(self, entry: Entry, lease: int | None) -> None:
        """Take up what an agent registers. Called with the lock."""
        kept = _Lease(entry)
        if lease is not None:
            moment = self._driver.clock.now() + lease
            kept.entry = replace(entry, until=moment)
            kept.timer = self._driver.at(moment, lambda: self._expire(entry.name, kept), background=True)
        self._leases[entry.name] = kept
        self._gone.discard(entry.name)

    def _expire(self, name: str, lease: _Lease) -> None:
        with self._lock:
            if self._leases.get(name) is not lease:
                return
            del self._leases[name]
        self._renew(name, "expire")

    @staticmethod
    def _end(lease: _Lease | None) -> None:
        if lease is not None and lease.timer is not None:
            lease.timer.cancel()

    def _renew(self, name: str, what: str = "") -> Entry:
        """Put an agent's entry together anew, and tell the subscribers; `what` it has done itself."""
        with self._lock:
            before = self._entries.get(name)
            base, lease = self._team.get(name), self._leases.get(name)
            entry = base if lease is None else lease.entry
            if base is not None and lease is not None:
                entry = _joined(base, lease.entry)
            if entry is None:
                self._entries.pop(name, None)
            else:
                self._entries[name] = entry
            change = None
            if entry != before:
                self._number += 1
                kind = "gone" if entry is None else "registered" if before is None else "modified"
                told = entry or before
                assert told is not None
                change = Change(self._number, kind, told, before if kind == "modified" else None)
                self._changes.append(change)
            listeners = tuple(self._listeners)
        if what:
            services = None if lease is None else [as_json(service) for service in lease.entry.services]
            until = None if lease is None else lease.entry.until
            now = self._driver.clock.now()
            self._trace.write("directory", now, agent=name, what=what, services=services, until=until)
        if change is not None:
            for listener in listeners:
                listener(change)
        return entry or Entry(AgentIdentifier(name))

    def tell(self, name: str, what: str, reason: str) -> None:
        """Tell in the trace why a manager did not do what an agent asked for."""
        self._trace.write("directory", self._driver.clock.now(), agent=name, what=what, reason=reason)

    # ---- looking -----------------------------------------------------------------------------

    def search(self, pattern: Entry, most: int | None = None) -> tuple[Entry, ...]:
        """The entries that a pattern asks for: the team's in its order, then others as they registered."""
        found: list[Entry] = []
        with self._lock:
            others = (name for name in self._entries if name not in self._roles)
            for name in (*self._roles, *others):
                if most is not None and len(found) >= most:
                    break
                entry = self._entries.get(name)
                if entry is not None and entry.fits(pattern):
                    found.append(entry)
        return tuple(found)

    def changes(self, pattern: Entry, since: int) -> tuple[Change, ...]:
        """What has changed after the change of that number, as far as a pattern asks for it."""
        with self._lock:
            found = tuple(c for c in self._changes if c.number > since and c.concerns(pattern))
            if self._number - since > len(self._changes):
                return (Change(self._number, "forgotten", pattern), *found)
            return found

    def number(self) -> int:
        """The number of the last change."""
        return self._number

    def listen(self, listener: Callable[[Change], None]) -> None:
        """Report each change from now on, by the thread that makes it."""
        with self._lock:
            self._listeners.append(listener)


def _joined(base: Entry, more: Entry) -> Entry:
    """What an agent of the team plays, and what it has registered besides."""

    def both(one: tuple[str, ...], other: tuple[str, ...]) -> tuple[str, ...]:
        return tuple(dict.fromkeys((*one, *other)))

    return Entry(
        AgentIdentifier(base.name, more.agent.addresses, more.agent.resolvers, more.agent.parameters),
        (*base.services, *more.services),
        both(base.protocols, more.protocols),
        both(base.ontologies, more.ontologies),
        both(base.languages, more.languages),
        more.until,
    )


def as_json(service: Service) -> dict[str, object]:
    """A service as JSON, named as FIPA names it; what is empty is left out."""
    found: dict[str, object] = {
        "type": service.type,
        "name": service.name,
        "protocols": list(service.protocols),
        "ontologies": list(service.ontologies),
        "languages": list(service.languages),
        "ownership": service.ownership,
        "properties": dict(service.properties),
    }
    return {name: value for name, value in found.items() if value}


# ---- as an activity sees it --------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Offer:
    """An activity registers services of its agent, for so long (ns), or (`anew`) in place of those before."""

    services: tuple[Service, ...]
    lease: int | None = None
    anew: bool = False


@dataclass(frozen=True, slots=True)
class Withdraw:
    """An activity takes back what its agent has registered."""


class Window(Protocol):
    """What stands behind an activity's view of the directory."""

    @property
    def directory(self) -> Directory: ...
    def do(self, doing: Offer | Withdraw) -> None: ...


class Subscription:
    """Sees what changes in the directory. Only looks when it is asked; needs not be ended."""

    __slots__ = ("_directory", "_pattern", "_since")

    def __init__(self, directory: Directory, pattern: Entry) -> None:
        self._directory = directory
        self._pattern = pattern
        self._since = directory.number()

    def changes(self) -> tuple[Change, ...]:
        """What has changed since this was asked last, or since it was subscribed to."""
        found = self._directory.changes(self._pattern, self._since)
        self._since = max((change.number for change in found), default=self._since)
        return found


class AgentDirectory:
    """The directory as an activity sees it: it searches, and registers what its agent offers."""

    __slots__ = ("_window",)

    def __init__(self, window: Window) -> None:
        self._window = window

    def search(
        self,
        type: str = "",
        *,
        name: str = "",
        protocol: str = "",
        ontology: str = "",
        language: str = "",
        agent: str = "",
        most: int | None = None,
        properties: Mapping[str, str] | None = None,
    ) -> tuple[Entry, ...]:
        """The agents that offer such a service, `most` of them at most, the team's first, in its order.

        Who plays a participant offers a service of the type `protocol.participant`.
        """
        pattern = _pattern(type, name, protocol, ontology, language, agent, properties)
        return self._window.directory.search(pattern, most)

    def subscribe(
        self,
        type: str = "",
        *,
        name: str = "",
        protocol: str = "",
        ontology: str = "",
        language: str = "",
        agent: str = "",
        properties: Mapping[str, str] | None = None,
    ) -> Subscription:
        """A view of what changes among the agents that offer such a service."""
        pattern = _pattern(type, name, protocol, ontology, language, agent, properties)
        return Subscription(self._window.directory, pattern)

    def residents(self) -> tuple[Resident, ...]:
        """The white pages: which agents there are, and which are lost."""
        return self._window.directory.residents()

    def register(self, *services: Service, lease: float | None = None) -> None:
        """Register what this agent offers besides the participants it plays, for `lease` seconds if given.

        Raises:
            DirectoryError: the agent has registered something already.
        """
        self._window.do(Offer(services, None if lease is None else nanoseconds(lease)))

    def modify(self, *services: Service, lease: float | None = None) -> None:
        """Replace what this agent has registered. Raises DirectoryError if it has not."""
        self._window.do(Offer(services, None if lease is None else nanoseconds(lease), anew=True))

    def deregister(self) -> None:
        """Take back what this agent has registered. Raises DirectoryError if it has not."""
        self._window.do(Withdraw())


def _pattern(
    type: str,
    name: str,
    protocol: str,
    ontology: str,
    language: str,
    agent: str,
    properties: Mapping[str, str] | None,
) -> Entry:
    service = Service(
        type,
        name,
        (protocol,) if protocol else (),
        (ontology,) if ontology else (),
        (language,) if language else (),
        "",
        tuple((properties or {}).items()),
    )
    services = () if service == Service() else (service,)
    return Entry(AgentIdentifier(agent), services)
