"""Taking compound transitions: the first that is open, and what that does."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from aseme_dsl.amola.statechart import State
from aseme_dsl.codegen.code.tree import (
    Arm,
    Block,
    Const,
    Field,
    If,
    Negated,
    Note,
    Pass,
    Set,
    Statement,
    Update,
    all_of,
    own,
    when,
)
from aseme_dsl.codegen.plain.actions import Actions
from aseme_dsl.codegen.plain.conditions import Conditions
from aseme_dsl.codegen.plain.modes import Candidate, Mode
from aseme_dsl.codegen.plain.names import BB, PlainNames
from aseme_dsl.codegen.plain.places import Places
from aseme_dsl.codegen.program.moves import move_of


class Taking:
    """The statements by which compound transitions are taken."""

    def __init__(self, names: PlainNames, conditions: Conditions, actions: Actions, places: Places) -> None:
        self._names = names
        self._conditions = conditions
        self._actions = actions
        self._places = places

    def chain(
        self,
        mode: Mode,
        region: int,
        leaf: State,
        number: int,
        candidates: Sequence[Candidate],
        otherwise: Block = (),
    ) -> Block:
        """The first candidate that is open is taken; `otherwise` is done where none is."""
        gate = None if otherwise else self._conditions.gate(candidates)
        arms: list[Arm] = []
        for candidate in candidates:
            taken = self._take(mode, region, leaf, number, candidate) if candidate.leads_on else (Pass(),)
            notes = tuple(self._names.place(step) for step in candidate.taken)
            if not candidate.tests:
                always = (*map(Note, notes), *taken)
                return (If(tuple(arms), always),) if arms else always
            arms.append(Arm(all_of(candidate.tests), taken, before=notes))
        if gate is not None:
            still = Set((gate,), Field(BB, "tracked"))
            looked = If(tuple(arms), (still,))
            return (If((Arm(Negated(gate), (looked,), "something has changed"),), gate=True),)
        if not arms:
            return otherwise
        return (If(tuple(arms), otherwise or None),)

    def _take(self, mode: Mode, region: int, leaf: State, number: int, candidate: Candidate) -> Block:
        names, following = self._names, self._names.following
        move = move_of(names.flat, candidate.taken)
        spends = candidate.spends is True
        found: list[Statement] = []
        if mode.loops and candidate.spends is not False:
            bits = self._bits(mode, names.flat.with_around(region))
            spend = Update(own("spent"), "|", Const(bits))
            found.append(spend if candidate.spends is True else when(candidate.spends, spend))
        missed = 0
        if mode.loops and not candidate.stays:
            missed = self._bits(mode, names.events.regions_in(move.target))
        if missed:
            found.append(Update(own("spent"), "|", Const(missed), "what is entered now does not see it"))
        found += self._actions.took(move.taken)
        if candidate.stays:
            again = following.again_at(mode.event, leaf, spends)
            return (*found, *self._actions.of(region, move.taken[0]), *mode.moved(again))
        found += self._places.leave(region, move.scope, leaf, number)
        for step in move.taken:
            found += self._actions.of(region, step)
        found += self._places.enter(region, move.scope, move.target, number)
        return (*found, *mode.moved(following.again(mode.event, region, move.taken, spends)))

    def _bits(self, mode: Mode, regions: Iterable[int]) -> int:
        """The bits of those regions that wait for the event of a mode."""
        awaited = self._names.uses.awaited
        return sum(1 << number for number in regions if mode.event in awaited.get(number, ()))


__all__ = ["Taking"]
