"""The port through which every body is reached: sense, act, say and hear, and the world that moves it.

An agent sees its robot only through :class:`Body`. The robot may be a wheeled one, a humanoid in a
three-dimensional simulator, a device behind a socket, or a player of the embedded field. That world defines
what a percept and a command contain; the port fixes only how they are passed.

* Time is an ``int`` of nanoseconds since the world began.
* None of the four methods waits: they give or take what is there now. A body behind a wire keeps its newest
  percept and its inbox up to date on its own.
* All four may be called from any thread.
* A body that can no longer be reached raises :class:`BodyConnectionError` from each of them.

A real robot is a body without a world: its time passes by itself. A simulated one comes with a
:class:`World`, whose time passes only in ``advance``, so that a virtual clock can drive it to the bit.
A simulator that runs in lock step with its players is a world, too: all commands in, one step, all percepts
out. Its ``advance`` exchanges the messages of as many steps as fit into the time.
"""

from __future__ import annotations

import pickle
from collections.abc import Mapping
from typing import Any, Protocol, TypeAlias, TypeVar, runtime_checkable

from aseme_dsl.records import dataclass

PerceptT_co = TypeVar("PerceptT_co", covariant=True)
CommandT_contra = TypeVar("CommandT_contra", contravariant=True)


class BodyConnectionError(ConnectionError):
    """The body can no longer be reached: the wire is cut, the simulator has ended, the robot is off."""


def fit_to_travel(error: Exception) -> Exception:
    """What a body has raised, for another process: as it is, or as text if that process cannot read it."""
    try:
        pickle.loads(pickle.dumps(error))
    except Exception:
        return BodyConnectionError(f"{type(error).__name__}: {error}")
    return error


@dataclass(frozen=True, slots=True)
class RadioMessage:
    """One radio message as it was received.

    ``sender`` is the name of the robot that said it. It is ``""`` where the medium does not tell, as in a
    simulator that gives only the direction of the sound. Then the payload must carry the sender itself.
    """

    sender: str
    payload: bytes


@runtime_checkable
class Body(Protocol[PerceptT_co, CommandT_contra]):
    """One robot's body: senses, motors and radio."""

    @property
    def name(self) -> str:
        """The robot's name, as on the team sheet."""
        ...

    @property
    def payload_limit(self) -> int:
        """The longest payload in bytes that :meth:`say` takes."""
        ...

    def sense(self) -> PerceptT_co:
        """The newest percept. It is immutable, and sensing changes nothing: two calls at one time agree."""
        ...

    def act(self, command: CommandT_contra) -> None:
        """Put a command in force. It stays so until it is replaced; of two at one time the last one counts.

        What goes beyond the strength of the body is done as well as it can. A command that means nothing
        (a speed that is not a number) raises ValueError here, where the mistake is.
        """
        ...

    def say(self, payload: bytes) -> bool:
        """Send a message to the team mates by radio; whether the radio took it.

        False: refused, because too much was said lately; the sender may try later. True promises only that
        it was sent: it may still get lost on its way. A payload longer than :attr:`payload_limit` raises
        ValueError.
        """
        ...

    def hear(self) -> list[RadioMessage]:
        """What arrived since the last call, oldest first; own messages are not among it."""
        ...


@runtime_checkable
class World(Protocol[PerceptT_co, CommandT_contra]):
    """A simulated world: bodies, and a time that passes only in `advance`."""

    @property
    def bodies(self) -> Mapping[str, Body[PerceptT_co, CommandT_contra]]:
        """The bodies that can be driven, by robot name, in the order of the team sheets."""
        ...

    @property
    def step_ns(self) -> int:
        """The length of one step of the simulation: nothing in the world changes between two steps."""
        ...

    @property
    def now_ns(self) -> int:
        """How far the world has been simulated: a multiple of :attr:`step_ns`."""
        ...

    def advance(self, until_ns: int) -> None:
        """Simulate every step that ends at or before ``until_ns``.

        Afterwards :attr:`now_ns` is the greatest multiple of :attr:`step_ns` that is not later; it does not
        matter in how many calls a span of time is passed. Commands and messages given before the call count
        from its first step on. Raises ValueError for a time before :attr:`now_ns`.
        """
        ...


AnyBody: TypeAlias = Body[Any, Any]
"""A body of any world: only the project's own code knows its percepts and commands."""
AnyWorld: TypeAlias = World[Any, Any]
"""A world, of which no more is known."""
