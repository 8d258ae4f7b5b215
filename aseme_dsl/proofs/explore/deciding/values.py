"""Values: what those values are tried for that an activity or the surroundings decide.

What a program compares with constants is the same on both sides of each of them: so each constant, and one
value beside and between them, stand for all. What it compares with other values, or computes with, is tried
for a few values only. Every answer names these.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import field
from enum import IntEnum
from itertools import count, islice, pairwise, product
from math import ceil, floor
from types import NoneType, UnionType
from typing import Union, cast, get_args, get_origin

from aseme_dsl.amola.expression import COMPARE, TURNED
from aseme_dsl.proofs.explore.deciding.lists import Lists
from aseme_dsl.proofs.explore.deciding.order import REAL, WHOLE, Some
from aseme_dsl.proofs.explore.deciding.staging import by_lines_of
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.functions import is_of_library
from aseme_dsl.runtime.chart.plan import Plan, Transition, Variable
from aseme_dsl.runtime.message.as_json import member_types

FEW = (1, 2, 3)
"""What stands for numbers that are compared with each other."""
MOST = 64
"""So many contents of one message are tried at the most."""

_ORDER = ("==", "!=", "<", "<=", ">", ">=")
_PLAIN = frozenset(("!", "&&", "||", "has", "holds", "call", "evaluate", "age", "", "send"))
"""What reads no more of a value than whether it is true or there, or hands it to a function."""

Condition = tuple[object, str]
"""A condition, as a plan has them, and the type of the message that is `taken` in it, if there is one."""

Place = tuple[str, tuple[str, ...]]
"""Where a value stands: a variable or a type of message, and the path in it."""


@dataclass(slots=True)
class _Class:
    """Values that are compared with each other, or given to each other."""

    constants: set[object] = field(default_factory=set)
    is_read: bool = False
    """Whether anything depends on them, besides what they are given to."""
    is_compared: bool = False
    """Whether any of them is compared with another."""
    is_computed: bool = False
    near: set[float] = field(default_factory=set)
    """Constants with which something is compared that is computed from them."""
    is_ordered: bool = False
    """Whether one is compared with another by more than equality."""
    signs: set[tuple[str, float]] = field(default_factory=set)
    """The signs with which any of them is compared with constants."""


@dataclass(frozen=True, slots=True)
class Tried:
    """What is tried for a place; `is_all`: these stand for all values."""

    values: tuple[object, ...]
    is_all: bool


class Values:
    """What is tried, by what the plans of a team do with each value."""

    def __init__(
        self,
        plans: Iterable[Plan],
        types: Mapping[str, type[object]],
        agents: Sequence[str],
        fixed: Mapping[Place, frozenset[object]] | None = None,
        conditions: Sequence[Condition] = (),
        numbers: Sequence[float] | None = (),
        is_free: bool = False,
    ) -> None:
        """`types` are the classes of messages and enums by name. What may stand at the places in `fixed` is
        known. Others than the plans ask for `conditions`. Where a few numbers do not stand for all, these
        `numbers` are tried, too; None: there is one that may be any. `is_free`: what messages say to rank
        agents is not tried if nothing else asks for it."""
        self._numbers = numbers
        self.fixed: Mapping[Place, frozenset[object]] = {} if fixed is None else fixed
        self._enums = enums_of(types)
        self._messages = {name: kind for name, kind in types.items() if name not in self._enums}
        self._agents = tuple(agents)
        self._parents: dict[Place, Place] = {}
        self._classes: dict[Place, _Class] = {}
        self.bounds: dict[str, str] = {}
        """What is not tried with all values, with those that are, for readers."""
        self._shown: dict[str, dict[str, None]] = {}
        """The values that are in `bounds`."""
        self.computed: set[str] = set()
        """What the program computes with, so that a few values do not stand for all."""
        self._by_lines: set[str] = set()
        """The types of messages that lines of the document fill, publish, send or receive."""
        self.free: dict[str, frozenset[str]] = {}
        """The functions, by plans, that give an agent any place in a list."""
        for plan in plans:
            lists = Lists(plan)
            reader = _Reader(self, plan, tuple(item.term for item in lists.ranked()) if is_free else ())
            reader.learn()
            for term, taken in conditions:
                reader.read(term, taken)
            if is_free:
                self.free[plan.name] = lists.free(self.is_read, self._is_given)
                if not self.free[plan.name]:
                    _Reader(self, plan).learn()
            self._by_lines |= {channel.rpartition(".")[2] for channel in by_lines_of(plan)}
            self._by_lines |= {
                message for info in plan.branches for _, message in (*info.sends, *info.receives)
            }
        self.computes = any(item.is_computed for item in self._classes.values())
        """Whether the program computes with numbers that something depends on."""

    @property
    def may_be_any(self) -> bool:
        """Whether there are numbers that may be any."""
        return self._numbers is None

    # ---- what is asked -----------------------------------------------------------------------

    def results(self, function: str, kind: str) -> tuple[object, ...]:
        """What a function of the document may give."""
        if kind in self._messages:
            return self.contents(kind)
        return self.tried_for((f"{function}()", ()), _type(kind, self._enums))

    def of_variable(self, variable: Variable) -> tuple[object, ...]:
        """What an activity may write to a variable."""
        name = variable.name.partition("@")[0]
        kind = self._messages.get(variable.type)
        if kind is not None:
            return self.contents(variable.type)
        place = (name, ())
        if variable.type == "agent":
            return self._agents
        if variable.type.startswith("list of ") or not self.is_read(place):
            return ()
        return self.tried_for(place, _type(variable.type, self._enums), variable)

    def held(self, variable: Variable) -> tuple[object, ...]:
        """What a variable holds when an activity may have written it: what it holds at first, or one of what
        is tried that is within its bounds."""
        tried = self.of_variable(variable)
        if any(isinstance(item, Some) for item in tried):
            return tried
        initial = variable.initial
        if variable.type in self._enums:
            initial = self._enums[variable.type](cast(int, initial))
        found = (initial, *tried)
        return tuple(dict.fromkeys(item for item in found if _can_hold(variable, item)))

    def contents(self, message: str) -> tuple[object, ...]:
        """The contents that are tried for a type of message."""
        kind = self._messages[message]
        places = [(path, item) for path, item in _members(kind) if self.is_read((message, path))]
        choices = [self.tried_for((message, path), item) for path, item in places]
        found = tuple(
            _made(kind, dict(zip([path for path, _ in places], chosen, strict=True)))
            for chosen in islice(product(*choices), MOST + 1)
        )
        if len(found) > MOST:
            self.bounds[message] = f"{MOST} contents of {message}"
        return found[:MOST]

    def tried(self, message: str) -> Mapping[tuple[str, ...], tuple[object, ...]] | None:
        """What is tried for each member of a type of message that is read, by its path; None if one message
        is compared with another as a whole."""
        whole = self._classes.get(self._root((message, ())))
        if whole is not None and whole.is_compared:
            return None
        return {
            path: self._tried(item, self._classes.get(self._root((message, path)), _Class())).values
            for path, item in _members(self._messages[message])
            if self.is_read((message, path))
        }

    def naming(self, texts: Collection[str]) -> Iterator[tuple[str, ...] | None]:
        """The paths of the members of messages for which one of these texts is tried; None: of any."""
        for message in self._messages:
            tried = self.tried(message)
            if tried is None:
                yield None
                continue
            for path, some in tried.items():
                if any(isinstance(value, str) and value in texts for value in some):
                    yield path

    def may_name(self, kind: str, place: Place) -> bool:
        """Whether a value of a type that stands in a place may be the name of an agent, or have one in it."""
        if kind == "string":
            return self.is_read(place)
        return kind == "agent" or kind in self._messages or kind.startswith("list of ")

    def alike(self, message: str, path: tuple[str, ...]) -> Place | None:
        """What stands for the numbers that are only asked whether they are equal to each other.

        None if a member is not one of them, or if lines of the document fill some of them.
        """
        root = self._root((message, path))
        known = self._classes.get(root)
        if known is None or not known.is_compared or known.is_computed or known.is_ordered or known.constants:
            return None
        places = [place for place in self._parents if self._root(place) == root] + [root]
        is_free = all(place[0] in self._messages and place[0] not in self._by_lines for place in places)
        return root if is_free and dict(_members(self._messages[message]))[path] is int else None

    def like(
        self, message: str, path: tuple[str, ...], told: Collection[str]
    ) -> tuple[Place, Mapping[object, tuple[object, ...]]]:
        """What stands for the class of a member, and the numbers in it that may change places, with those
        with which each may.

        Conditions ask only how they compare with constants, and whether two are equal. There are none if
        something else asks for messages of the class, which are of types `told`. Nor if lines of the document
        fill them, compute with them or compare them as a whole.
        """
        root = self._root((message, path))
        known = self._classes.get(root, _Class())
        places = [place for place in self._parents if self._root(place) == root] + [root]
        if (
            dict(_members(self._messages[message]))[path] is not int
            or any(place[0] not in self._messages or place in self.fixed for place in places)
            or any(place[0] in self._by_lines or place[0] in told for place in places)
            or any(self.tried(place[0]) is None for place in places)
            or known.is_computed
            or known.is_ordered
            or known.near
            or not all(isinstance(item, int | float) for item in known.constants)
        ):
            return root, {}
        ends = sorted({*(cast("float", item) for item in known.constants), *(end for _, end in known.signs)})
        groups: dict[tuple[bool, ...], list[object]] = {}
        for value in self._tried(int, known).values:
            if isinstance(value, int) and value not in ends:
                groups.setdefault(tuple(value > end for end in ends), []).append(value)
        return root, {value: tuple(group) for group in groups.values() for value in group if len(group) > 1}

    def note(self, message: str, path: tuple[str, ...]) -> None:
        """One of what is tried for a member is decided: it is said if these are not all."""
        if self.alike(message, path) is None:
            kinds = dict(_members(self._messages[message]))
            self.tried_for((message, path), kinds[path])

    def is_exact(self, place: Place, value: object) -> bool:
        """Whether one of what is tried for a place, where these are few, stands for itself alone."""
        if isinstance(value, bool):
            return True
        known = self._classes.get(self._root(place))
        return known is not None and any((sign, value) in known.signs for sign in ("==", "!="))

    def _is_given(self, place: Place) -> bool:
        """Whether lines have to do with what stands in a place: they give it, or hand it on."""
        root = self._root(place)
        known = self._classes.get(root, _Class())
        return (
            bool(known.constants)
            or place in self.fixed
            or root != place
            or any(other != place and self._root(other) == root for other in self._parents)
        )

    def is_read(self, place: Place) -> bool:
        """Whether anything depends on what stands there."""
        known = self._classes.get(self._root(place))
        return known is not None and known.is_read

    def tried_for(self, place: Place, kind: object, variable: Variable | None = None) -> tuple[object, ...]:
        """What is tried for a place that holds values of a type, and of a variable within its bounds."""
        known = self._classes.get(self._root(place), _Class())
        found = self._tried(kind, known)
        values = found.values if variable is None else _within(variable, found)
        if not found.is_all:
            name = ".".join((place[0], *place[1]))
            if known.is_computed:
                self.computed.add(name)
            shown = self._shown.setdefault(name, {})  # roles may have variables of one name
            shown |= dict.fromkeys(map(str, values))
            self.bounds[name] = f"{name} in {', '.join(shown)}"
        return values

    def _tried(self, kind: object, known: _Class) -> Tried:
        found = _few(kind, known)
        found = _values(kind, known, self._agents) if found is None else found
        if found.is_all:
            return found
        return _any(kind, found) if self._numbers is None else _with(kind, found, self._numbers)

    # ---- what is learned ---------------------------------------------------------------------

    def _root(self, place: Place) -> Place:
        while (parent := self._parents.get(place, place)) != place:
            place = parent
        return place

    def use(self, place: Place) -> _Class:
        """The class of a place."""
        return self._classes.setdefault(self._root(place), _Class())

    def join(self, one: Place, other: Place) -> None:
        """A value goes from one place to the other, or is compared with it."""
        first, second = self._root(one), self._root(other)
        if first == second:
            return
        gone = self._classes.pop(second, None)
        self._parents[second] = first
        if gone is not None:
            kept = self._classes.setdefault(first, _Class())
            kept.constants |= gone.constants
            kept.is_read |= gone.is_read
            kept.is_compared |= gone.is_compared
            kept.is_computed |= gone.is_computed
            kept.is_ordered |= gone.is_ordered
            kept.near |= gone.near
            kept.signs |= gone.signs


@dataclass(frozen=True, slots=True)
class _Reader:
    """Reads the conditions and actions of one plan."""

    values: Values
    plan: Plan
    ranked: Collection[object] = ()
    """Calls whose last argument is not read."""

    @property
    def _library(self) -> frozenset[str]:
        """The functions of the library that the plan calls."""
        return frozenset(item[0] for item in self.plan.functions if is_of_library(item[1]))

    def learn(self) -> None:
        """Learn what the plan does with values."""
        for variable in self.plan.variables:
            if variable.bounds is not None and variable.type in ("int", "double"):
                least, most = variable.bounds
                place = variable.name.partition("@")[0], ()
                self.values.use(place).signs |= {(">=", least), ("<=", most)}
        for item in self.plan.transitions:
            taken = next((str(event[2]) for event in item.events if event[0] == "received"), "")
            if item.condition is not None:
                self.read(item.condition, taken)
            for action in item.actions:
                self._action(action, taken, item)
        for state in self.plan.states:
            for _, term in state.arguments:
                self.read(term, "")

    def _action(self, action: tuple[object, ...], taken: str, item: Transition) -> None:
        match action:
            case ("assign", str() as name, value):
                self._gives((name.partition("@")[0], ()), value, taken)
            case ("fill", ("member", _, str() as channel, tuple() as path), value):
                self._gives((channel.rpartition(".")[2], _path(path)), value, taken)
            case ("send", _, str() as message, _, *more):
                match more:
                    case [tuple() as filled, *_]:
                        for path, value in filled:
                            self._gives((message, _path(path)), value, taken)
                for value in more[1:3]:
                    self.read(value, taken)
            case _:
                for part in action[1:]:
                    self.read(part, taken)

    def _gives(self, place: Place, value: object, taken: str) -> None:
        source = self._place(value, taken)
        if source is not None:
            self._join(place, source)
            self._call(value, taken)
            return
        if isinstance(value, tuple) and value[:1] == ("const",):
            self.values.use(place).constants.add(value[1])
            return
        self.read(value, taken)

    def _join(self, one: Place, other: Place) -> None:
        self.values.join(one, other)
        for end in (one, other):
            kind = self.values._messages.get(self._type_of(end) or "")
            if kind is not None:
                for path, _ in _members(kind):
                    self.values.join((one[0], (*one[1], *path)), (other[0], (*other[1], *path)))
                return

    def _type_of(self, place: Place) -> str | None:
        if not place[1]:
            return place[0] if place[0] in self.values._messages else self._variable_type(place[0])
        return None

    def _variable_type(self, name: str) -> str | None:
        return next((item.type for item in self.plan.variables if item.name.partition("@")[0] == name), None)

    def read(self, term: object, taken: str, plainly: bool = True) -> None:
        """Something reads a value: `plainly`, if no more than its truth or presence matters.

        `taken` is the type of the message that the condition names, or "".
        """
        if not isinstance(term, tuple) or not term:
            return
        place = self._place(term, taken)
        if place is not None:
            known = self.values.use(place)
            known.is_read = True
            known.is_computed |= not plainly
            self._call(term, taken)
            return
        word, *parts = term
        if word in _ORDER and len(parts) == 2:
            self._compare(parts[0], parts[1], taken, word)
            return
        for part in parts:
            self.read(part, taken, word in _PLAIN)

    def _call(self, term: object, taken: str) -> None:
        """What a function is given is read, if a value comes from one."""
        match term:
            case ("call", name, *given):
                for part in given[:-1] if term in self.ranked else given:
                    if name in self._library:
                        self._computes(part, taken)
                    self.read(part, taken)
            case _:
                pass

    def _computes(self, term: object, taken: str) -> None:
        """A function of the library, which does what it does in a run, is given a value."""
        for place in self._places(term, taken):
            if (
                self.values._messages.get(self._type_of(place) or "") is None
            ):  # of a message, it gives anything
                known = self.values.use(place)
                known.is_read = known.is_computed = True

    def _compare(self, one: object, other: object, taken: str, word: str) -> None:
        """Values are compared: with a constant, with another value, or with what is computed."""
        is_ordered = word not in ("==", "!=")
        for value, against, sign in ((one, other, word), (other, one, TURNED.get(word, word))):
            place = self._place(value, taken)
            match against:
                case ("const" | "enum", *_, int(end) | float(end)) if place is not None:
                    self.values.use(place).signs.add((sign, end))
        left, right = self._place(one, taken), self._place(other, taken)
        if self._compare_known(one, other, taken, word):
            return
        for place, value, against in ((left, one, other), (right, other, one)):
            is_constant = isinstance(against, tuple) and against[:1] in (("const",), ("enum",))
            self.read(value, taken, is_constant or self._place(against, taken) is not None)
            match against:
                case ("const", constant) if place is not None:
                    self.values.use(place).constants.add(constant)
                case ("const", int(constant) | float(constant)):
                    for inner in self._places(value, taken):
                        self.values.use(inner).near.add(constant)
        if left is not None and right is not None:
            for place in (left, right):
                known = self.values.use(place)
                known.is_compared = True
                known.is_ordered |= is_ordered
            self.values.join(left, right)

    def _compare_known(self, one: object, other: object, taken: str, word: str) -> bool:
        """Whether two values are compared of which one is known, or one is the amount of the other."""
        for value, against in ((one, other), (other, one)):
            place, known = self._place(value, taken), self._place(against, taken)
            match value, against:
                case ("builtin", "abs", inner), ("const", int(constant) | float(constant)):
                    amount = self._place(inner, taken)
                    if amount is not None:
                        self.read(inner, taken)
                        known_class = self.values.use(amount)
                        known_class.constants |= {constant, -constant}
                        known_class.signs |= {(sign, end) for sign in "<>" for end in (constant, -constant)}
                        return True
                case _ if place is not None and known is not None and known in self.values.fixed:
                    for held in self.values.fixed[known]:
                        for item in (place, known):
                            self.values.use(item).constants.add(held)
                            if isinstance(held, int | float):
                                self.values.use(item).signs |= {(word, held), ("==", held)}
                    self.read(value, taken)
                    self.read(against, taken)
                    return True
        return False

    def _places(self, term: object, taken: str) -> Iterator[Place]:
        """The places in a term."""
        place = self._place(term, taken)
        if place is not None:
            yield place
        elif isinstance(term, tuple):
            for part in term:
                yield from self._places(part, taken)

    def _place(self, term: object, taken: str) -> Place | None:
        match term:
            case ("variable", str() as name):
                return name.partition("@")[0], ()
            case ("variable", str() as name, tuple() as path):
                kind = self._variable_type(name.partition("@")[0])
                owner = kind if kind in self.values._messages else name.partition("@")[0]
                return owner or "", _path(path)
            case ("member", _, str() as channel, tuple() as path):
                return channel.rpartition(".")[2], _path(path)
            case ("call", str() as name, *_):
                return f"{name}()", ()
            case ("taken", tuple() as path):
                return (taken, _path(path)) if taken else None
            case ("mean", ("member", *_) as member, _):  # of one message, it is what that says
                return self._place(member, taken)
        return None


def _within(variable: Variable, found: Tried) -> tuple[object, ...]:
    """What a variable can hold of what is tried. Of few numbers its bounds are some, and of those with a
    fraction, too: what is between others may be beyond the bounds."""
    values = found.values
    if variable.bounds is not None and not any(isinstance(item, Some) for item in values):
        if variable.type == "double":
            values = (*values, *map(float, variable.bounds))
        elif not found.is_all:
            values = (*values, *map(int, variable.bounds))
    return tuple(dict.fromkeys(item for item in values if _can_hold(variable, item)))


def _can_hold(variable: Variable, value: object) -> bool:
    """Whether a value is within the bounds of a variable."""
    if variable.bounds is None or not isinstance(value, int | float):
        return True
    least, most = variable.bounds
    return least <= value <= most


# ---- types ------------------------------------------------------------------------------------------


def _type(name: str, enums: Mapping[str, type[IntEnum]]) -> object:
    plain: dict[str, object] = {"bool": bool, "int": int, "double": float, "string": str}
    if name in plain:
        return plain[name]
    if name == "duration":
        return int
    if name == "agent":
        return str
    return enums.get(name, name)


def enums_of(types: Mapping[str, type[object]]) -> dict[str, type[IntEnum]]:
    """The enums among some types, by their names."""
    return {name: kind for name, kind in types.items() if issubclass(kind, IntEnum)}


def _path(path: Iterable[object]) -> tuple[str, ...]:
    return tuple(map(str, path))


def _members(kind: type[object], depth: int = 4) -> Iterator[tuple[tuple[str, ...], object]]:
    """The members of a message, with those of messages inside, as paths with their types."""
    for name, item in member_types(cast(type, kind)).items():
        inner = getattr(item, "__dataclass_fields__", None)
        if inner is not None and depth:
            for path, deeper in _members(cast("type[object]", item), depth - 1):
                yield (name, *path), deeper
        else:
            yield (name,), item


def _made(kind: type[object], members: Mapping[tuple[str, ...], object]) -> object:
    """A message with these members; the others have their defaults."""
    types = member_types(cast(type, kind))
    inside: dict[str, dict[tuple[str, ...], object]] = {}
    for (name, *rest), value in members.items():
        inside.setdefault(name, {})[tuple(rest)] = value
    given = {
        name: found[()] if () in found else _made(cast("type[object]", types[name]), found)
        for name, found in inside.items()
    }
    return kind(**given)


def _values(kind: object, known: _Class, agents: Sequence[str]) -> Tried:
    if kind is bool:
        return Tried((False, True), is_all=True)
    if isinstance(kind, type) and issubclass(kind, IntEnum):
        return Tried(tuple(kind), is_all=True)
    if kind is int:
        return _numbers(known, _whole(item for item in known.constants if isinstance(item, int | float)), 1)
    if kind is float:
        numbers = [float(item) for item in known.constants if isinstance(item, int | float)]
        return _numbers(known, numbers, 1.0)
    if kind is str:
        texts = sorted(item for item in known.constants if isinstance(item, str))
        return Tried(tuple(_texts(agents, texts)), is_all=not known.is_compared)
    if get_origin(kind) in (Union, UnionType):
        there = _values(next(arm for arm in get_args(kind) if arm is not NoneType), known, agents)
        return Tried((None, *there.values), there.is_all)
    return Tried((_default(kind),), is_all=False)


def _any(kind: object, found: Tried) -> Tried:
    """A number that may be any instead of a few of which there are more."""
    if kind is int or kind is float:
        return Tried((WHOLE if kind is int else REAL,), is_all=True)
    if get_origin(kind) in (Union, UnionType):
        there = _any(next(arm for arm in get_args(kind) if arm is not NoneType), found)
        return Tried((None, *there.values), is_all=True) if there.is_all else found
    return found


def _with(kind: object, found: Tried, further: Sequence[float]) -> Tried:
    """Further numbers beside a few."""
    if not further or (kind is not int and kind is not float):
        return found
    numbers = [kind(item) for item in further if kind is float or item.is_integer()]
    return Tried(tuple(dict.fromkeys((*found.values, *numbers))), is_all=False)


def _few(kind: object, known: _Class) -> Tried | None:
    """One value for each result of the comparisons with constants. None if there are other comparisons."""
    if known.is_compared or known.is_computed or known.near or not known.signs:
        return None
    ends = sorted({constant for _, constant in known.signs})
    if kind is int:
        ends = _whole(ends)
    if isinstance(kind, type) and issubclass(kind, IntEnum):
        tried: list[float] = list(kind)
    elif kind in (int, float):
        between = [] if kind is int else [(one + other) / 2 for one, other in pairwise(ends)]
        tried = [*ends, *(end + step for end in ends for step in (-1, 1)), *between]
    else:
        return None
    found: dict[tuple[bool, ...], object] = {}
    for value in tried:
        ways = tuple(COMPARE[sign](value, constant) for sign, constant in sorted(known.signs))
        found.setdefault(ways, value if isinstance(value, IntEnum) else kind(value))
    return Tried(tuple(found.values()), is_all=True)


def _whole(numbers: Iterable[float]) -> list[float]:
    """The whole numbers among some, and those beside each other one."""
    return sorted({whole for number in numbers for whole in (floor(number), ceil(number))})


def _texts(agents: Sequence[str], constants: Sequence[str]) -> dict[str, None]:
    """The names of agents and these constants, with a text that is none of the constants."""
    found = dict.fromkeys((*agents, *constants))
    if found.keys() == set(constants):
        other = next(text for text in map("other".__mul__, count()) if text not in found)
        found = {other: None, **found}
    return found


def _numbers(known: _Class, constants: Sequence[float], step: float) -> Tried:
    if known.is_compared or known.is_computed or not constants:
        ends = [constant + by for constant in known.near for by in (-step, step)]
        beside = {sign * end for end in ends for sign in (1, -1)}
        few = {type(step)(item) for item in ({0, *beside} if beside else FEW)}
        found = sorted({*few, *constants})
        return Tried(tuple(found), is_all=not (known.is_compared or known.is_computed) and not constants)
    ordered = sorted(set(constants))
    if type(step) is int:
        around = {value for item in ordered for value in (item - 1, item, item + 1)}
    else:
        between = [(one + other) / 2 for one, other in pairwise(ordered)]
        around = {ordered[0] - 1, *ordered, *between, ordered[-1] + 1}
    return Tried(tuple(sorted(around)), is_all=True)


def _default(kind: object) -> object:
    return kind() if callable(kind) else None


__all__ = ["Condition", "Place", "Tried", "Values", "enums_of"]
