"""Stepping: the commands of `asemec sim`, and the lines that answer them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from aseme_dsl.diagnostics import closest

if TYPE_CHECKING:
    from aseme_dsl.project.stepping.stepper import Stepper

COMMANDS = (
    ("step [N]", "go to the next instant in which something happens; N of them"),
    ("back [N]", "go back to the last one"),
    ("to TIME", "go to a moment: to 12.5s"),
    ("go", "go to the next halt, or to the end"),
    ("halt CONDITION", "halt where it occurs: halt robot1 in Kick, halt sent Pass p [p.to == 2]"),
    ("halts", "list the halts"),
    ("clear N", "remove a halt"),
    ("do INPUT", "give an input now: do robot1 receives eyes.state.Ball { visible = true }"),
    ("add STATEMENT", "add a statement from the beginning on: add crash robot2 at 3s"),
    ("undo", "take the last `do` or `add` back"),
    ("show [AGENT]", "states, values, agent messages and timers"),
    ("source [AGENT]", "the lines of the active states"),
    ("save FILE", "write what was done as a scenario"),
    ("help", "this list"),
    ("quit", "leave"),
)
"""What may be typed, and what it does."""


class WrongCommand(Exception):
    """A command that is none; the text says why."""


def obey(stepper: Stepper, line: str) -> Iterator[str]:
    """Do what a line says, and tell what came of it.

    Raises:
        WrongCommand: it cannot be done; all is as it was.
    """
    from aseme_dsl.project.stepping.running import NotPlayable
    from aseme_dsl.project.stepping.session import NotUnderstood

    word, _, rest = line.strip().partition(" ")
    rest = rest.strip()
    moves = _moves(stepper, word, rest)
    if moves is not None:
        try:
            moves()
        except (NotPlayable, NotUnderstood) as problem:
            raise WrongCommand(str(problem)) from problem
        yield from news(stepper)
        return
    match word:
        case "halts":
            for number, condition in enumerate(stepper.session.halts, 1):
                yield f"{number}  {condition}"
        case "show":
            yield from shown_agents(stepper, rest)
        case "source":
            yield from source_lines(stepper, rest)
        case "save":
            yield _saved(stepper, rest)
        case "help":
            yield from (f"{form:16}  {meaning}" for form, meaning in COMMANDS)
        case _:
            near = closest(word, [form.split()[0] for form, _ in COMMANDS])
            raise WrongCommand(
                f"{word!r} is not a command. {f'Did you mean {near!r}? ' if near else ''}See help."
            )


def _moves(stepper: Stepper, word: str, rest: str) -> Callable[[], None] | None:
    """What a command does to the run, if it does anything to it. Raises WrongCommand."""
    from aseme_dsl.project.files.duration import duration

    match word:
        case "step":
            count = _number(rest, 1)
            return lambda: stepper.step(count)
        case "back":
            count = _number(rest, 1)
            return lambda: stepper.back(count)
        case "go":
            return stepper.go
        case "undo":
            return lambda: _undone(stepper)
        case "to":
            try:
                moment = duration(rest)
            except ValueError as problem:
                raise WrongCommand(f"{problem}.") from problem
            return lambda: stepper.to(moment)
        case "clear":
            place = _number(rest, 0)
            if not 1 <= place <= len(stepper.session.halts):
                raise WrongCommand("Give the number of a halt; see halts.")
            return lambda: stepper.clear(place - 1)
        case "halt" | "do" | "add":
            if not rest:
                raise WrongCommand(f"Say what to {word}; see help.")
            if word == "do" and stepper.instant.over:
                raise WrongCommand("The run is over: go back first.")
            does = {"halt": stepper.halt, "do": stepper.do, "add": stepper.add}[word]
            return lambda: does(rest)
        case _:
            return None


def _undone(stepper: Stepper) -> None:
    if not stepper.undo():
        raise WrongCommand("Nothing was done or added.")


def _number(text: str, usual: int) -> int:
    if not text:
        return usual
    if not text.isdecimal() or not 1 <= int(text[:9]) <= 100_000:
        raise WrongCommand(f"{text!r} is not a number from 1 to 100000.")
    return int(text)


def _saved(stepper: Stepper, rest: str) -> str:
    """Write the session as a scenario, in a new file."""
    from aseme_dsl.project.files.write import write_new
    from aseme_dsl.project.stepping.session import saved_text

    if not rest:
        raise WrongCommand("Say into which file: save kick.aseme")
    path = Path(rest)
    if path.suffix != ".aseme" or not path.parent.is_dir():
        raise WrongCommand("Name a .aseme file in a directory that exists.")
    written = write_new({path: saved_text(stepper.session, path).encode()})
    if written.diagnostics:
        raise WrongCommand(written.diagnostics[0].message)
    return f"The scenario is in {rest}: asemec test {rest}"


# ---- what is shown ---------------------------------------------------------------------------------


def news(stepper: Stepper) -> Iterator[str]:
    """Where the run stands, what happened on the way there, and the states of all agents."""
    from aseme_dsl.project.stepping.telling import states_of, told
    from aseme_dsl.runtime.time.clock import shown

    instant = stepper.instant
    happened = list(told(instant.happened, stepper.plans))
    if len(happened) > LAST:
        yield "    …"
    width = max((len(agent.name) for agent in instant.picture.agents), default=0)
    for name, text in happened[-LAST:]:
        yield f"    {name:{width}}  {text}"
    for place in instant.halts:
        yield f"    halt {place + 1}: {stepper.session.halts[place]}"
    over = f"  {OVER.get(instant.over, instant.over)}" if instant.over else ""
    yield f"{shown(instant.picture.moment)}{over}"
    for agent in instant.picture.agents:
        yield f"  {agent.name:{width}}  {states_of(agent)}{f'  ({agent.ended})' if agent.ended else ''}"


OVER = {
    "time": "time limit reached",
    "finished": "all agents have ended",
}
"""Why a run is over."""
LAST = 20
"""So many of the things that happened are shown, the newest."""


def shown_agents(stepper: Stepper, name: str) -> Iterator[str]:
    """The outline and the values of an agent, or of all."""
    from aseme_dsl.project.stepping.telling import state_line, value_line

    agents = [item for item in stepper.instant.picture.agents if name in ("", item.name)]
    if not agents:
        names = ", ".join(item.name for item in stepper.instant.picture.agents)
        raise WrongCommand(f"There is no agent {name!r}: {names}.")
    for agent in agents:
        yield f"{agent.name} : {agent.role}"
        for item in agent.states:
            yield f"  {state_line(item)}"
        for value in agent.values:
            yield f"  {value_line(value)}"


def source_lines(stepper: Stepper, name: str) -> Iterator[str]:
    """The lines of the source in which the innermost active states are written."""
    from aseme_dsl.project.stepping.telling import inner_states

    for agent in stepper.instant.picture.agents:
        if name not in ("", agent.name):
            continue
        found: dict[tuple[str, int, str], list[str]] = {}
        for item in inner_states(agent):
            found.setdefault(stepper.line_at(item.at), []).append(item.text)
        for (path, line, text), names in found.items():
            yield f"{agent.name}  {path}:{line}  {text.strip()}"
            yield f"{'':{len(agent.name)}}    active: {', '.join(names)}"


__all__ = ["WrongCommand", "news", "obey"]
