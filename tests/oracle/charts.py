"""Random `.aseme` texts that compile by construction.

Everything of the language that a chart is made of occurs: formulas of every operator, every kind of
transition expression, messages of every class, variables, timers, functions that raise, protocols.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace

from tests.oracle.choices import Choices

MS = 1_000_000
PRELUDE = """\
system Random

enum Colour { RED GREEN BLUE }
message Inner { int y  optional int z }
message M { int x  bool on  double d  string s  Colour colour  Inner inner  repeated int many }
message Note { string text  int n }

topic t { state M, Note  signal M  signal Note expires 15ms  data M }
topic q { signal M queued  data Note }

function even(int n) : bool = "tests.oracle.functions:even"
function shy(int n) : bool = "tests.oracle.functions:shy"
function inverse(double d) : double = "tests.oracle.functions:inverse"
function weight(M m) : int = "tests.oracle.functions:weight"

team Team { me, ann, bob : R }
"""

STATES = ("t.state.M", "t.state.Note")
SIGNALS = ("t.signal.M", "q.signal.M", "t.signal.Note")
DATA = ("t.data.M", "q.data.Note")
CHANNELS = (*STATES, *SIGNALS, *DATA)
HELPERS = ("helper", "aid")
"""How the names of formulas begin; other names are activities and the participant `a`."""

MEMBERS: dict[str, dict[str, tuple[str, ...]]] = {
    "M": {
        "bool": ("on",),
        "int": ("x", "inner.y", "inner.z"),
        "double": ("d",),
        "string": ("s",),
        "Colour": ("colour",),
    },
    "Note": {"int": ("n",), "string": ("text",)},
}
FILLED: dict[str, dict[str, tuple[str, ...]]] = {
    "M": {**MEMBERS["M"], "int": ("x", "inner.y"), "ints": ("many",)},
    "Note": MEMBERS["Note"],
}
LISTS: dict[str, dict[str, str]] = {"M": {"int": "many"}, "Note": {}}
"""The repeated members of each message, by the type of their elements."""
HOSTS = ("ann", "bob", "me")
EVENTS = ("go", "hop", "stop")
TIMERS = ("pace", "pace", "limit")
COLOURS = ("RED", "GREEN", "BLUE")
SENT = (("cfp", "Note"), ("inform", "Note"), ("refuse", "M"))
RECEIVED = (("propose", "Note"), ("inform", "Note"), ("inform", "M"))


# ---- formulas ----------------------------------------------------------------------------------

INFIX = ("seq", "alt", "par", "dis")


@dataclass(eq=False)
class Formula:
    """A formula: `operator` is name, seq, alt, par, dis, inst, opt, star, plus or forever."""

    operator: str
    operands: list[Formula] = field(default_factory=list)
    name: str = ""
    count: int = 0
    nullable: bool = False

    def text(self) -> str:
        inner = [operand.text() for operand in self.operands]
        grouped = [
            f"({text})" if operand.operator in INFIX else text
            for text, operand in zip(inner, self.operands, strict=True)
        ]
        body = grouped[0] if grouped else ""
        if self.operands and self.operands[0].operator in ("star", "plus", "forever", "inst"):
            body = f"({body})"
        match self.operator:
            case "name":
                return self.name
            case "seq":
                return " . ".join(grouped)
            case "alt":
                return " | ".join(grouped)
            case "par":
                return " || ".join(grouped)
            case "dis":
                return " [> ".join(grouped)
            case "inst":
                return f"{body}[{self.count}]"
            case "opt":
                return f"[{inner[0]}]"
        return body + {"star": "*", "plus": "+", "forever": "~"}[self.operator]


@dataclass
class Names:
    """What the formulas of one role or participant may use."""

    helpers: dict[str, bool]
    """Formulas and participants by name, with whether they may be empty."""
    unused: list[str]
    """Those that must still be used."""
    prefix: str
    crossing: bool = False
    """Whether there are to be many concurrent parts, one in the other."""
    activities: int = 0
    here: set[str] = field(default_factory=set)
    """The activities of the formula that is being made."""

    def activity(self, choices: Choices) -> str:
        """An activity that this formula does not have yet, now and then one of another formula."""
        older = [
            name for n in range(1, self.activities + 1) if (name := f"{self.prefix}{n}") not in self.here
        ]
        if older and choices.one_in(4):
            name = choices.one_of(older)
        else:
            self.activities += 1
            name = f"{self.prefix}{self.activities}"
        self.here.add(name)
        return name


def formula(choices: Choices, names: Names, depth: int) -> Formula:
    """A formula whose names all differ, so that each of its terms has its own spelling."""
    free = list(names.helpers)
    names.here = set()
    return _formula(choices, names, depth, free)


def _formula(choices: Choices, names: Names, depth: int, free: list[str]) -> Formula:
    if depth == 0:
        return _name(choices, names, free)
    operator = choices.weighted(name=2, seq=5, alt=3, par=4, dis=4, plus=2, forever=4, opt=2, star=2, inst=1)
    if names.crossing and depth > 1 and operator in ("name", "alt", "plus", "opt", "star"):
        operator = "par"
    if operator == "name":
        return _name(choices, names, free)
    if operator in INFIX:
        count = 2 if operator == "dis" else choices.number(2, 3)
        operands = [_formula(choices, names, depth - 1, free) for _ in range(count)]
        empty = [operand.nullable for operand in operands]
        nullable = empty[0] if operator == "dis" else any(empty) if operator == "alt" else all(empty)
        return Formula(operator, operands, nullable=nullable)
    inner = _formula(choices, names, depth - 1, free)
    if operator in ("plus", "forever", "star") and inner.nullable:
        inner = Formula("seq", [inner, Formula("name", name=names.activity(choices))])
    if operator == "inst":
        return Formula(operator, [inner], count=choices.number(2, 3), nullable=inner.nullable)
    return Formula(operator, [inner], nullable=operator in ("opt", "star"))


def _name(choices: Choices, names: Names, free: list[str]) -> Formula:
    wanted = [name for name in free if name in names.unused]
    if free and (wanted or choices.one_in(3)):
        name = choices.one_of(wanted or free)
        free.remove(name)
        if name in names.unused:
            names.unused.remove(name)
        return Formula("name", name=name, nullable=names.helpers[name])
    return Formula("name", name=names.activity(choices))


def with_everything(choices: Choices, names: Names, depth: int) -> Formula:
    """A formula that uses all names which nothing has used so far."""
    found = formula(choices, names, depth)
    while names.unused:
        name = names.unused.pop()
        found = Formula("seq", [found, Formula("name", name=name, nullable=names.helpers[name])])
    return found


@dataclass(frozen=True)
class Line:
    """A way of a formula: what may be said of it, and with what it must be decided."""

    written: str
    choice: int = 0
    """Branches of one choice have one number: each must have a condition."""
    loop: int = 0
    """`repeat` and `leave` of one loop have one number: one of them must have a condition."""
    source: int = 0
    """Lines with one number start at one state: at most one is `else`."""
    cuts: bool = False
    """Whether it cuts its source short: it must have an event or `when`."""
    stays: str = ""
    """`on` or `exit` for a line that leads nowhere."""


def lines(of: Formula, name: str) -> Iterator[Line]:
    """The ways of a formula called `name`, as `control` names them."""
    numbers = iter(range(1, 1_000_000))
    if of.operator == "name" and not of.name.startswith(HELPERS):
        yield Line(f"enter {of.text()}", source=next(numbers))
        yield Line(f"leave {of.text()}", source=next(numbers))
    stack: list[Formula] = [of]
    while stack:
        node = stack.pop()
        second = node.operands[1] if node.operator == "dis" else None
        # A choice of two interrupts by its branches, one of three as a whole: no line names the former.
        separate = second is not None and second.operator == "alt" and len(second.operands) == 2
        operands = [node.operands[0], *second.operands] if second is not None and separate else node.operands
        stack += reversed(operands)
        if node is not of or (of.operator == "name" and not of.name.startswith(HELPERS)):
            state = f"({node.text()})" if node.operator in INFIX else node.text()
            for verb in ("on", "exit"):
                yield Line(f"{verb} {state}", source=next(numbers), stays=verb)
        texts = [f"({o.text()})" if o.operator in INFIX else o.text() for o in operands]
        own = name if node is of else f"({node.text()})" if node.operator in ("alt", "par") else node.text()
        here = next(numbers)
        match node.operator:
            case "seq":
                for text in texts:
                    yield Line(f"enter {text}", source=next(numbers))
                yield Line(f"leave {texts[-1]}", source=next(numbers))
            case "alt":
                yield Line(f"start {own}", source=next(numbers))
                for text in texts:
                    yield Line(f"enter {text}", choice=here, source=here)
                for text in texts:
                    yield Line(f"leave {text}", source=next(numbers))
            case "dis":
                yield Line(f"enter {texts[0]}", source=next(numbers))
                for text in texts[1:]:
                    yield Line(f"enter {text}", source=here, cuts=True)
                yield Line(f"leave {texts[0]}", source=here)
                for text in texts[1:]:
                    yield Line(f"leave {text}", source=next(numbers))
            case "par" | "inst":
                yield Line(f"start {own}", source=next(numbers))
                yield Line(f"finish {own}", source=next(numbers))
                for text in texts:
                    yield Line(f"enter {text}", source=next(numbers))
                    yield Line(f"leave {text}", source=next(numbers))
            case "opt" | "star":
                after = next(numbers)
                yield Line(f"start {own}", source=next(numbers))
                yield Line(f"enter {texts[0]}", choice=here, source=here)
                yield Line(f"skip {texts[0]}", choice=here, source=here)
                if node.operator == "star":
                    yield Line(f"repeat {texts[0]}", loop=after, source=after)
                    yield Line(f"leave {texts[0]}", loop=after, source=after)
                else:
                    yield Line(f"leave {texts[0]}", source=after)
            case "plus":
                yield Line(f"start {own}", source=next(numbers))
                yield Line(f"repeat {texts[0]}", loop=here, source=here)
                yield Line(f"leave {texts[0]}", loop=here, source=here)
            case "forever":
                yield Line(f"start {own}", source=next(numbers))
                yield Line(f"repeat {texts[0]}", source=next(numbers))


# ---- expressions -------------------------------------------------------------------------------

VARIABLES = {
    "i": ("int", "0"),
    "k": ("int", "3"),
    "b": ("bool", "false"),
    "f": ("double", "0.5"),
    "s": ("string", '"a"'),
    "c": ("Colour", "Colour.GREEN"),
    "w": ("duration", "10ms"),
}
BOUNDS = {"k": " -1..4"}
"""Those of the variables that have some."""
OWN_VARIABLES = {"i": ("int", "1"), "b": ("bool", "true"), "f": ("double", "2")}


@dataclass(frozen=True)
class Words:
    """What expressions may name: variables and lets by type; what a participant exchanges."""

    choices: Choices
    variables: dict[str, str]
    lets: dict[str, str]
    channels: tuple[str, ...]
    """Few of them in many texts, so that one transition meets what another one did."""
    is_participant: bool = False
    states: tuple[str, ...] = ()
    """What conditions may ask after."""
    counted: frozenset[str] = frozenset()
    """Those that stand in one place, so that they can be counted."""
    in_condition: bool = False
    taken: tuple[str, str] = ("", "")
    """What the agent message that is taken is called, and its type; without one an agent that is gone."""
    crossing: bool = False
    """Whether most lines read and write a few variables, and wait for few events: concurrent parts meet."""

    # ---- values -------------------------------------------------------------------------

    def value(self, kind: str, depth: int) -> str:
        """A value of a type, with parentheses where it is computed."""
        pick = self.choices
        if depth <= 0 or pick.one_in(3):
            return self._plain(kind, depth)
        if pick.one_in(9):
            other = "int" if kind == "double" and pick.one_in(2) else kind
            return (
                f"({self._bool(depth - 1)} ? {self.value(kind, depth - 1)} : {self.value(other, depth - 1)})"
            )
        match kind:
            case "bool":
                return self._bool(depth)
            case "int":
                match pick.weighted(
                    member=3, arithmetic=4, least=2, function=1, sign=1, at=1, element=2, size=1, find=1
                ):
                    case "member":
                        return self._member("int", depth)
                    case "element":
                        return f"{self._list(depth)}[{self.value('int', depth - 1)}]"
                    case "size":
                        return f"size({self._list(depth)})"
                    case "find":
                        return f"find({self._list(depth)}, {self.value('int', depth - 1)})"
                    case "arithmetic":
                        operator = pick.one_of(("+", "-", "*", "%"))
                        right = str(pick.number(0, 3)) if operator == "*" else self.value("int", depth - 1)
                        return f"({self.value('int', depth - 1)} {operator} {right})"
                    case "least":
                        name = pick.one_of(("min", "max"))
                        return f"{name}({self.value('int', depth - 1)}, {self.value('int', depth - 1)})"
                    case "function":
                        return f"weight({self._message('M')})"
                    case "sign":
                        return f"abs({self.value('int', depth - 1)})"
                return self._at("int")
            case "double":
                match pick.weighted(member=3, arithmetic=4, mean=3, function=1, division=2, at=1):
                    case "member":
                        return self._member("double", depth)
                    case "arithmetic":
                        operator = pick.one_of(("+", "-", "%"))
                        right = pick.one_of(("double", "int"))
                        return (
                            f"({self.value('double', depth - 1)} {operator} {self.value(right, depth - 1)})"
                        )
                    case "mean":
                        member = pick.one_of(("t.data.M.x", "t.data.M.d", "ann.t.data.M.x", "q.data.Note.n"))
                        return f"mean({member}, {self._duration()})"
                    case "function":
                        return f"inverse({self.value(pick.one_of(('double', 'int')), depth - 1)})"
                    case "division":
                        return f"({self.value('int', depth - 1)} / {self.value('int', depth - 1)})"
                return self._at("double")
            case "duration":
                match pick.weighted(age=4, sum=2, scaled=2, part=1):
                    case "age":
                        return self._age()
                    case "sum":
                        operator = pick.one_of(("+", "-"))
                        left, right = (self.value("duration", depth - 1) for _ in range(2))
                        return f"({left} {operator} {right})"
                    case "scaled":
                        factor = pick.one_of(("int", "double"))
                        return f"({self.value(factor, depth - 1)} * {self.value('duration', depth - 1)})"
                return f"({self.value('duration', depth - 1)} / {self.value('int', depth - 1)})"
        return self._plain(kind, depth)

    def _bool(self, depth: int) -> str:
        pick = self.choices
        agents = 3 if self.is_participant else 0
        match pick.weighted(
            member=4,
            compare=8,
            both=3,
            either=3,
            no=2,
            has=3,
            expired=4,
            function=2,
            same=1,
            contained=1,
            state=4 if self.in_condition and self.states else 0,
            agent=agents,
        ):
            case "state":
                return f"{pick.one_of(('in', 'in', 'done'))}({pick.one_of(self.states)})"
            case "agent":
                if pick.one_in(2):
                    return "(!has(who))" if pick.one_in(2) else "has(who)"
                return f"({self._agent()} {pick.one_of(('==', '!='))} {self._agent()})"
            case "member":
                return self._member("bool", depth)
            case "compare":
                return f"({self._comparison(depth)})"
            case "both":
                return f"({self._joined('&&', depth)})"
            case "either":
                return f"({self._joined('||', depth)})"
            case "no":
                return f"(!{self.value('bool', depth - 1)})"
            case "has" if pick.one_in(3):
                name, message = self.taken
                inner = f"{self._host()}{pick.one_of([c for c in CHANNELS if c.endswith('.M')])}"
                return f"has({name if message == 'M' else inner}.inner.z)"
            case "has":
                return f"has({self._host()}{pick.one_of(self.channels)})"
            case "expired":
                return f"expired({pick.one_of(TIMERS)})"
            case "contained":
                return f"contains({self._list(depth)}, {self.value('int', depth - 1)})"
            case "function":
                return f"{pick.one_of(('even', 'shy'))}({self.value('int', depth - 1)})"
        return f"({self.value('bool', depth - 1)} == {self.value('bool', depth - 1)})"

    def _joined(self, operator: str, depth: int) -> str:
        return f" {operator} ".join(self.value("bool", depth - 1) for _ in range(self.choices.number(2, 3)))

    def _comparison(self, depth: int) -> str:
        pick = self.choices
        kind = pick.weighted(int=5, double=3, string=1, Colour=2, duration=5)
        operator = pick.one_of(("==", "!=", "<", "<=", ">", ">="))
        if kind == "Colour":
            operator = pick.one_of(("==", "!="))
        if kind == "duration" and pick.one_in(2):
            sides = [self._age(), pick.one_of((self._duration(), f"2 * {self._duration()} - 3ms / 2"))]
            if pick.one_in(3):
                sides.reverse()
            return f"{sides[0]} {operator} {sides[1]}"
        if kind == "int" and pick.one_in(2):
            return f"{self._member('int', depth)} {operator} {pick.number(0, 3)}"
        other = pick.one_of(("int", "double")) if kind == "double" else kind
        return f"{self.value(kind, depth - 1)} {operator} {self.value(other, depth - 1)}"

    def _plain(self, kind: str, depth: int) -> str:
        pick = self.choices
        names = [name for name, of in (*self.variables.items(), *self.lets.items()) if of == kind]
        if names and pick.one_in(2):
            return pick.one_of(names)
        if kind != "duration" and pick.one_in(3):
            return self._member(kind, depth)
        match kind:
            case "bool":
                return pick.one_of(("true", "false"))
            case "int":
                counted = [name for name in self.states if name in self.counted]
                if counted and pick.one_in(2):
                    return f"count({pick.one_of(counted)})"
                return str(pick.number(0, 3))
            case "double":
                return pick.one_of(("0.5", "0.0", "1.5", "2.0"))
            case "string":
                return pick.one_of(('"a"', '"b"', '""', '"\\"\\\\ == "'))
            case "duration":
                return self._duration()
        return f"{kind}.{pick.one_of(COLOURS)}"

    def _member(self, kind: str, depth: int) -> str:
        pick = self.choices
        name, message = self.taken
        if kind in MEMBERS.get(message, {}) and pick.one_in(2):
            return f"{name}.{pick.one_of(MEMBERS[message][kind])}"
        channel = pick.one_of(self._with_member(kind, CHANNELS))
        if channel in DATA and depth > 0 and pick.one_in(3):
            return self._at(kind)
        return f"{self._host()}{channel}.{pick.one_of(MEMBERS[channel.split('.')[2]][kind])}"

    def _list(self, depth: int, *, written: bool = True) -> str:
        """A list of ints: a repeated member, at times as it was, or one that is written out."""
        pick = self.choices
        match pick.weighted(member=4, at=1, taken=1 if self.taken[1] == "M" else 0, literal=int(written)):
            case "at":
                return f"at({self._host()}t.data.M.many, -{self._duration()})"
            case "taken":
                return f"{self.taken[0]}.many"
            case "literal":
                return f"[{', '.join(self._plain('int', depth - 1) for _ in range(pick.number(1, 3)))}]"
        return f"{self._host()}{pick.one_of([c for c in CHANNELS if c.endswith('.M')])}.many"

    def _at(self, kind: str) -> str:
        channel = self.choices.one_of(self._with_member(kind, DATA))
        member = self.choices.one_of(MEMBERS[channel.split(".")[2]][kind])
        return f"at({self._host()}{channel}.{member}, -{self._duration()})"

    def _agent(self) -> str:
        name, message = self.taken
        if not name or self.choices.one_in(3):
            return "who"
        return f"sender({name})" if message else name

    def _message(self, name: str) -> str:
        if self.taken[1] == name and self.choices.one_in(2):
            return self.taken[0]
        return self._host() + self.choices.one_of([c for c in CHANNELS if c.endswith("." + name)])

    def _age(self) -> str:
        if self.taken[1] and self.choices.one_in(2):
            return f"age({self.taken[0]})"
        timed = (*STATES, *DATA)
        return f"age({self._host()}{self.choices.one_of([c for c in self.channels if c in timed] or timed)})"

    def _with_member(self, kind: str, among: Sequence[str]) -> list[str]:
        """The channels that have a member of a type: of those that the text prefers, where there are any."""
        found = [channel for channel in among if kind in MEMBERS[channel.split(".")[2]]]
        return [channel for channel in found if channel in self.channels] or found

    def _host(self) -> str:
        return self.choices.one_of(HOSTS) + "." if self.choices.one_in(5) else ""

    def _duration(self) -> str:
        return self.choices.one_of(("10ms", "5ms", "20ms", "0.01s", "1ms"))

    # ---- transitions --------------------------------------------------------------------

    def transition(self, *, decided: bool, otherwise: bool, cuts: bool = False) -> tuple[str, bool]:
        """An expression and whether it is `else`; `decided` ones have an event or a condition.

        One that `cuts` another short has an event or `when`.
        """
        pick = self.choices
        if self.crossing and not pick.one_in(4):
            return self._crossing(decided=decided or cuts), False
        kind = pick.weighted(
            nothing=0 if decided or cuts else 4,
            condition=0 if cuts else 5,
            event=4,
            when=4,
            otherwise=4 if otherwise and not cuts else 0,
        )
        text = ""
        asking = replace(self, in_condition=True)
        match kind:
            case "condition":
                text = f"[{asking.value('bool', 2)}]"
            case "when":
                text = f"when [{asking.value('bool', 2)}]"
            case "event" if self.is_participant and pick.one_in(2):
                text, words = self._taking()
                if pick.one_in(2):
                    text += f" [{replace(words, in_condition=True).value('bool', 2)}]"
                if pick.one_in(2):
                    text += " / " + "; ".join(words._action() for _ in range(pick.number(1, 3)))
                return text, False
            case "event":
                text = " or ".join(self._event() for _ in range(pick.number(1, 2)))
                if pick.one_in(3):
                    text += (" or when" if pick.one_in(4) else "") + f" [{asking.value('bool', 2)}]"
            case "otherwise":
                text = "else"
        if pick.one_in(2):
            text += " / " + "; ".join(self._action() for _ in range(pick.number(1, 3)))
        return text, kind == "otherwise"

    def weighted(self) -> str:
        """The expression of a branch that is taken by chance."""
        pick = self.choices
        condition = f"[{replace(self, in_condition=True).value('bool', 2)}] " if pick.one_in(2) else ""
        actions = f" / {self._action()}" if pick.one_in(3) else ""
        return f"{condition}weight {pick.number(1, 4)}{actions}"

    def _crossing(self, *, decided: bool) -> str:
        """What concurrent parts, and those around them, have to do with each other: events and variables."""
        pick = self.choices
        match pick.weighted(event=4, when=4, both=1, nothing=0 if decided else 2):
            case "event":
                text = " or ".join(pick.one_of(EVENTS[:2]) for _ in range(pick.number(1, 2)))
            case "when":
                text = f"when [{self._of_variables()}]"
            case "both":
                text = f"{pick.one_of(EVENTS[:2])} [{self._of_variables()}]"
            case _:
                text = ""
        if pick.one_in(3):
            return text
        return f"{text} / " + "; ".join(self._counting() for _ in range(pick.number(1, 2)))

    def _of_variables(self) -> str:
        """A condition that changes with the variables alone."""
        pick = self.choices
        name = pick.one_of(list(self.variables))
        match self.variables[name]:
            case "bool":
                return pick.one_of((name, f"!{name}"))
            case "int":
                read = name
                if name in BOUNDS:
                    lists = (
                        "size(line)",
                        "size(kept.many)",
                        "notes[1].x",
                        "find(notes.inner.z, k)",
                        "find(line, 2)",
                    )
                    read = pick.one_of((*lists, "kept.x", "kept.inner.z"))
                operator, number = pick.one_of(("==", ">", "!=")), pick.number(0, 3)
                if read == "notes[1].x" and number:
                    kept = "contains(notes.x, k)" if number == 3 else "contains(notes, kept)"
                    return kept if operator == ">" else f"kept {operator} notes[0]"
                return f"{read} {operator} {number}"
        return f"{name} {pick.one_of(('==', '!='))} {self._plain(self.variables[name], 0)}"

    def _counting(self) -> str:
        """An action that changes a variable."""
        pick = self.choices
        name = pick.one_of(list(self.variables))
        match self.variables[name]:
            case "bool":
                return f"{name} = {pick.one_of((f'!{name}', 'true', 'false'))}"
            case "int":
                return f"{name} = {pick.one_of((f'({name} + 1) % 4', str(pick.number(0, 3))))}"
        return f"{name} = {self._assigned(self.variables[name])}"

    def _taking(self) -> tuple[str, Words]:
        """Events that take something which the rest of the line may speak of, and the words for that."""
        pick = self.choices
        match pick.weighted(named=4, unnamed=2, lost=2):
            case "named":
                message = pick.one_of(("M", "Note", "Note"))
                kinds = [performative for performative, of in RECEIVED if of == message]
                events = [f"{pick.one_of(kinds)} {message} m from other" for _ in range(pick.number(1, 2))]
                return " or ".join(events), replace(self, taken=("m", message))
            case "unnamed":
                performative, message = pick.one_of(RECEIVED)
                words = replace(self, taken=(f"{performative}.{message}", message))
                return f"{performative} {message} from other", words
        return "lost other gone", replace(self, taken=("gone", ""))

    def staying(self, verb: str) -> str:
        """What stands on an `on` or `exit` line."""
        pick = self.choices
        if self.crossing and pick.one_in(2):
            event = f"{pick.one_of(EVENTS[:2])} " if verb == "on" else ""
            return f"{event}/ {self._counting()}"
        asking = replace(self, in_condition=True)
        text = ""
        if verb == "on" and self.is_participant and pick.one_in(4):
            text, words = self._taking()
            actions = "; ".join(words._action() for _ in range(pick.number(1, 3)))
            return f"{text} / {actions}" if len(actions) % 4 else text
        if verb == "on":
            match pick.weighted(nothing=1, condition=3, event=4, when=6):
                case "condition":
                    text = f"[{asking.value('bool', 2)}] "
                case "when":
                    text = f"when [{asking.value('bool', 2)}] "
                case "event":
                    text = " or ".join(self._event(error=False) for _ in range(pick.number(1, 2))) + " "
                    if pick.one_in(3):
                        text += ("or when " if pick.one_in(3) else "") + f"[{asking.value('bool', 2)}] "
        actions = "; ".join(self._action() for _ in range(pick.number(1, 3)))
        if verb == "on" and text[:1] in ("", "[") and len(actions) % 2:
            ignored = ", ".join(SIGNALS[len(text) % 3 :])
            return f"ignores {ignored}" + (f" / {actions}" if len(actions) % 3 else "")
        return f"{text}/ {actions}"

    def _event(self, *, error: bool = True) -> str:
        pick = self.choices
        agents = 8 if self.is_participant else 0
        failing = 2 if error else 0
        match pick.weighted(raised=4, after=3, error=failing, received=agents, lost=agents // 4):
            case "raised":
                return pick.one_of(EVENTS)
            case "after":
                return f"after({pick.one_of(('10ms', '5ms', '1ms', '0ms'))})"
            case "error":
                return "error"
            case "lost":
                return "lost other"
        performative, message = pick.one_of(RECEIVED)
        return f"{performative} {message} from other"

    def _action(self) -> str:
        pick = self.choices
        send = 4 if self.is_participant else 0
        match pick.weighted(assign=7, fill=4, publish=4, timer=4, read=2, call=1, send=send, raising=2):
            case "assign":
                name = pick.one_of(list(self.variables))
                if name in BOUNDS:  # a constant may be outside, which the compiler says
                    value = self._assigned(self.variables[name])
                    channel = pick.one_of([c for c in CHANNELS if c.endswith(".M")])
                    change = (
                        "append(line, k)",
                        f"append(line, {value})",
                        "remove(line, k)",
                        "remove(line[k])",
                        f"line[size(line) - 1] = {value}",
                        f"kept = {channel}",
                        "append(notes, M { x = k, ..kept })",
                        "kept = M { inner.y = size(line), ..notes[0] }",
                        "remove(notes[0])",
                        "remove(notes[find(notes.x, k)])",
                        "kept = notes[find(notes.x, kept.x)]",
                        "clear(kept)",
                        f"notes[0] = M {{ inner = kept.inner, many = line, x = {value}, .. }}",
                        f"{channel} = kept",
                        f"write_messages.{channel} {{ x = kept.x, ..kept }}",
                    )
                    return f"{pick.one_of(change)}; {name} += {value}; {pick.one_of(change)}"
                return f"{name} = {self._assigned(self.variables[name])}"
            case "fill":
                channel = pick.one_of(self.channels)
                members = FILLED[channel.split(".")[2]]
                kind = pick.one_of(list(members))
                target = f"{self._host()}{channel}.{pick.one_of(members[kind])}"
                return f"{target} = {self._assigned(kind)}"
            case "publish":
                channel = pick.one_of(self.channels)
                content = f" {{ {self._filled(channel.split('.')[2])} }}" if pick.one_in(3) else ""
                return f"write_messages.{channel}{content}"
            case "timer":
                return f"start_timer({pick.one_of(TIMERS)}, {self._length()})"
            case "read":
                return "read_messages"
            case "raising":
                return f"raise {pick.one_of(EVENTS)}"
            case "call":
                return f"{pick.one_of(('even', 'shy'))}({self.value('int', 1)})"
        if self.taken[0] and pick.one_in(2):
            return f"who = {self._agent()}"
        performative, message = pick.one_of(SENT)
        content = f" {{ {self._filled(message)}, {self._rest(message)} }}" if pick.one_in(2) else ""
        content += f" reply_by {self._length()}" if pick.one_in(6) else ""
        to = pick.weighted(all=3, one=2, others=1)
        if to == "one":
            return f"send {performative} {message}{content} to {self._agent()}"
        others = f" except {self._agent()}" if to == "others" else ""
        one = "one " if pick.one_in(5) else ""
        return f"send {performative} {message}{content} to {one}other{others}"

    def _rest(self, message: str) -> str:
        return f"..{self.taken[0]}" if self.taken[1] == message and self.choices.one_in(2) else ".."

    def _filled(self, message: str) -> str:
        """Some members of a message, each once."""
        kinds = {member: kind for kind, members in FILLED[message].items() for member in members}
        some = dict.fromkeys(self.choices.one_of(list(kinds)) for _ in range(self.choices.number(1, 3)))
        return ", ".join(f"{member} = {self._assigned(kinds[member])}" for member in some)

    def _length(self) -> str:
        """The length of a timer: what the compiler can compute may not be negative."""
        if self.choices.one_in(2):
            return self._duration()
        return f"age({self._host()}{self.choices.one_of(DATA)}) + {self.value('duration', 1)}"

    def _assigned(self, kind: str) -> str:
        """A value that cannot grow without bound when it is assigned again and again."""
        match kind:
            case "int":
                return f"{self.value('int', 2)} % 5"
            case "double":
                return f"{self.value(self.choices.one_of(('double', 'int')), 2)} % 4.0"
            case "ints":
                if self.choices.one_in(6):
                    return "[]"
                if self.choices.one_in(3):
                    return self._list(1, written=False)
                count = self.choices.number(1, 3)
                return f"[{', '.join(self._assigned('int') for _ in range(count))}]"
            case "duration":
                return f"max(0ms, min({self.value('duration', 1)}, 20ms))"
        return self.value(kind, 2)


def parts(of: Formula) -> Iterator[Formula]:
    """The formula and everything in it."""
    yield of
    for operand in of.operands:
        yield from parts(operand)


def countable(formulas: Sequence[tuple[str, Formula]]) -> frozenset[str]:
    """The names that stand in one place of the chart: once in all formulas, in no instances, in one such."""
    everywhere = [node.name for _, made in formulas for node in parts(made) if node.name]
    found = {formulas[0][0]}
    for name, made in formulas:  # each after one that uses it
        several = {node.name for part in parts(made) if part.operator == "inst" for node in parts(part)}
        if name in found:
            found |= {
                node.name
                for node in parts(made)
                if node.name and everywhere.count(node.name) == 1 and node.name not in several
            }
    return frozenset(found - {"A1", "P1"})


def control(words: Words, of: Formula, name: str, extra: Sequence[str] = ()) -> str:
    """A control block of a formula: nothing, or lines that decide what must be decided."""
    pick = words.choices
    words = replace(words, states=tuple(node.name for node in parts(of) if node.name))
    ways = list(lines(of, name))
    ways_written = {way.written for way in ways}
    if not extra and pick.one_in(8):
        return ""
    loops = sorted({way.loop for way in ways} - {0})
    deciding = {pick.one_of([way.written for way in ways if way.loop == loop]) for loop in loops}
    weighted = {number for number in sorted({way.choice for way in ways} - {0}) if pick.one_in(5)}
    otherwise: set[int] = set()
    written: list[str] = []
    for way in ways:
        must = way.choice > 0 or way.cuts or (way.loop > 0 and way.written in deciding)
        if not must and not pick.one_in(6 if way.stays else 3):
            continue
        if way.stays:
            written.append(f"    {way.written} : {words.staying(way.stays)}")
            continue
        for _ in range(2 if pick.one_in(5) else 1):
            if way.choice in weighted:
                text, is_else = words.weighted(), False
            else:
                text, is_else = words.transition(
                    decided=must, otherwise=way.source not in otherwise, cuts=way.cuts
                )
            if is_else:
                otherwise.add(way.source)
            verb, _, term = way.written.partition(" ")
            goes_on = verb == "repeat" or (verb == "enter" and f"repeat {term}" not in ways_written)
            if goes_on and pick.one_in(3):
                verb = "resume"
            pace = " every 5ms" if verb == "repeat" and pick.one_in(4) else ""
            written.append(f"    {verb} {term}{pace} : {text}")
    if pick.one_in(3):
        written.reverse()
    written += extra
    has_choice = any(way.choice for way in ways)
    head = f"{name} reactive" if has_choice and not weighted and pick.one_in(3) else name
    return "\n".join([f"  control {head} {{", *written, "  }"]) if written else ""


# ---- texts -------------------------------------------------------------------------------------


def _lets(words: Words, prefix: str) -> tuple[list[str], dict[str, str]]:
    """A few lets with their types."""
    texts, kinds = [], {}
    for number in range(words.choices.number(0, 2)):
        kind = words.choices.one_of(("bool", "int", "double", "duration"))
        name = f"{prefix}{number}"
        texts.append(f"let {name} = {words.value(kind, 2)}")
        kinds[name] = kind
    return texts, kinds


def _formulas(
    choices: Choices, names: Names, root: str, helpers: Sequence[str], depth: int
) -> list[tuple[str, Formula]]:
    """The root formula and its helpers, each of which is used by one before it."""
    found: list[tuple[str, Formula]] = []
    for helper in reversed(helpers):
        made = formula(choices, names, depth - 1)
        found.insert(0, (helper, made))
        names.helpers[helper] = made.nullable
        names.unused.append(helper)
    found.insert(0, (root, with_everything(choices, names, depth)))
    return found


def _some(choices: Choices, variables: dict[str, tuple[str, str]]) -> dict[str, tuple[str, str]]:
    """A few of the variables: where there are few, the same one is written and read."""
    names = [choices.one_of(list(variables)) for _ in range(choices.number(1, 4))]
    return {name: declared for name, declared in variables.items() if name in names}


def _variables(variables: dict[str, tuple[str, str]]) -> list[str]:
    lists = ["line : list[3] of int", "kept : M", "notes : list[2] of M"] if "k" in variables else []
    return [f"  var {item}" for item in lists] + [
        f"  var {name} : {kind}{BOUNDS.get(name, '')} = {initial}"
        for name, (kind, initial) in variables.items()
    ]


def _protocol(outer: Words, name: str = "p", part: str = "a", own_name: str = "P") -> tuple[str, bool]:
    """A protocol with the participant `a` that the role plays, and whether its process may be empty.

    Sometimes the participant plays one of another protocol, of which a variable is the result.
    """
    choices = outer.choices
    names = Names({}, [], own_name)
    helpers = ["aid" if part == "a" else "aided"] if choices.one_in(2) else []
    variables = _some(choices, OWN_VARIABLES)
    inner = plays = ""
    if name == "p" and choices.one_in(3):
        inner, nullable = _protocol(outer, "q", "n", "Q")
        names.helpers["n"] = nullable
        names.unused.append("n")
        results = [one for one in variables if f"  var {one} : " in inner]
        if results:
            inner = inner.replace(f"  var {results[0]} : ", f"  result {results[0]} : ")
        bound = [f"{one} = {one}" for one in results[:1]]
        bound += ["Q1 = P1"] if choices.one_in(3) and re.search(r"\bQ1\b", inner) else []
        plays = "  plays q.n" + (f" with {', '.join(bound)}" if bound else "")
    formulas = _formulas(choices, names, "process", helpers, 2)
    types = {name: kind for name, (kind, _) in variables.items()}
    words = replace(outer, variables=types, is_participant=True)
    own, kinds = _lets(words, "own")
    words = replace(words, lets=outer.lets | kinds, counted=countable(formulas))
    sends, receives = (", ".join(f"{p} {m}" for p, m in listed) for listed in (SENT, RECEIVED))
    text = [
        inner,
        f"aip {name} {{",
        f"  participant {part} {{",
        '  engage "Always."',
        plays,
        *_variables(variables),
        "  var who : agent",
        *(f"  {let}" for let in own),
        f"  sends {sends}",
        f"  receives {receives}",
        *(f"  {formula} = {made.text()}" for formula, made in formulas),
        "  }",
        f'  participant other {{ engage "Always."  sends {receives}  receives {sends}  process = X }}',
        '  outcome "Done."',
        *(
            control(
                words, made, part, [f"    on abandon : {words.staying('exit')}"] if choices.one_in(3) else ()
            )
            if formula == "process"
            else control(words, made, formula)
            for formula, made in formulas
        ),
        "}",
    ]
    return "\n".join(line for line in text if line), formulas[0][1].nullable


@dataclass(frozen=True)
class Node:
    """A state of a `statechart` block; `region` is the label of the region that it is in."""

    label: str
    kind: str
    region: str


def _nodes(choices: Choices, label: str, region: str, depth: int) -> list[Node]:
    """The states inside the OR state `label`, each before what is in it."""
    found = [Node(f"{label}.1", "START", region)]
    for number in range(2, choices.number(3, 5)):
        inside = f"{label}.{number}"
        kind = choices.weighted(BASIC=5, CONDITION=2, OR=3, AND=2) if depth else "BASIC"
        found.append(Node(inside, kind, region))
        if kind == "OR":
            found += _nodes(choices, inside, region, depth - 1)
        elif kind == "AND":
            for part in range(1, choices.number(2, 3) + 1):
                found.append(Node(f"{inside}.{part}", "OR", ""))
                found += _nodes(choices, f"{inside}.{part}", f"{inside}.{part}", depth - 1)
    if not choices.one_in(3):
        last = found[-1].label.removeprefix(label + ".").partition(".")[0]
        found.append(Node(f"{label}.{int(last) + 1}", "END", region))
    return found


def _statechart(words: Words) -> list[str]:
    """The states and transitions of a block, transitions between any two states of a region."""
    choices = words.choices
    nodes = _nodes(choices, "0", "0", 2)
    basic = tuple(f"A{number}" for number, node in enumerate(nodes) if node.kind == "BASIC")
    words = replace(words, states=basic, counted=frozenset(basic))
    texts = ["  state 0 OR"]
    for number, node in enumerate(nodes):
        texts.append(f"  state {node.label} {node.kind}" + (f" A{number}" if node.kind == "BASIC" else ""))
    for number, node in enumerate(nodes):
        if node.kind == "END" or not node.region:
            continue
        targets = [other for other in nodes if other.region == node.region and other.kind != "START"]
        if node.kind == "CONDITION":  # a cycle of choices would be refused
            targets = [
                other for other in targets if other.kind != "CONDITION" or other in nodes[number + 1 :]
            ]
        if not targets:
            continue
        count = choices.number(2, 3) if node.kind == "CONDITION" else choices.number(1, 2)
        otherwise = True
        for _ in range(count):
            text, is_else = words.transition(decided=node.kind == "CONDITION", otherwise=otherwise)
            otherwise = otherwise and not is_else
            texts.append(f"  {node.label} -> {choices.one_of(targets).label} : {text}")
    for node in nodes:
        if node.kind in ("BASIC", "OR", "AND") and choices.one_in(6):
            verb = choices.one_of(("on", "exit")) if node.region else "exit"
            texts.append(f"  {verb} {node.label} : {words.staying(verb)}")
    for node in nodes:
        outside = [other for other in nodes if other.kind in ("BASIC", "OR", "AND", "END")]
        outside = [other for other in outside if other.region and may_lead(nodes, node, other)]
        if outside and node.kind != "END" and choices.one_in(3):
            text, _ = words.transition(decided=node.kind == "CONDITION", otherwise=False)
            texts.append(f"  {node.label} -> {choices.one_of(outside).label} : {text}")
        if node.kind == "OR" and not node.region and choices.one_in(8):
            texts.append(f"  on {node.label} : {words.staying('on')}")
    for node in nodes:
        if node.kind == "AND" and not choices.one_in(3):
            texts += _several(words, nodes, node)
    return texts


def _several(words: Words, nodes: Sequence[Node], parallel: Node) -> list[str]:
    """Transitions into several regions of an AND, from outside or from inside of it."""
    choices = words.choices
    sources = [
        node
        for node in nodes
        if node.kind != "END"
        and (node.kind != "CONDITION" or node.region == parallel.region)
        and (
            node.region == parallel.region
            or node.label.startswith(f"{parallel.label}.")
            or may_lead(nodes, node, parallel)
        )
    ]
    found: list[str] = []
    for at_once in (True, False):
        targets = _in_regions(choices, nodes, parallel.label)
        if sources and len(targets) > 1:
            source = nodes[0] if at_once else choices.one_of(sources)
            text, _ = words.transition(decided=source.kind == "CONDITION", otherwise=False)
            found.append(f"  {source.label} -> ({', '.join(targets)}) : {'[true]' if at_once else text}")
    return found


def _in_regions(choices: Choices, nodes: Sequence[Node], parallel: str) -> list[str]:
    """States at any depth in several regions of an AND; of an AND inside one of them, too."""
    regions = [node.label for node in nodes if node.label.rpartition(".")[0] == parallel]
    found: list[str] = []
    for place, region in enumerate(regions):
        if place >= 2 and choices.one_in(2):
            continue
        inside = [
            node
            for node in nodes
            if node.label.startswith(f"{region}.") and node.kind in ("BASIC", "OR", "AND", "END")
        ]
        inside = [node for node in inside if node.region]
        if not inside:
            continue
        target = choices.one_of(inside)
        inner = _in_regions(choices, nodes, target.label) if target.kind == "AND" else []
        found += inner if len(inner) > 1 and choices.one_in(2) else [target.label]
    return found


def may_lead(nodes: Sequence[Node], node: Node, other: Node) -> bool:
    """Whether a transition between two states of different regions does not lead between those of one AND."""
    region = node.region or node.label
    if region == other.region:
        return False
    kinds = {"0": "OR"} | {item.label: item.kind for item in nodes}
    shared = _around(node.label) & _around(other.label)
    return kinds[max(shared, key=len)] == "OR"


def _around(label: str) -> set[str]:
    parts = label.split(".")
    return {".".join(parts[:length]) for length in range(1, len(parts))}


def text(choices: Choices, *, given: bool = False) -> str:
    """A text with a role `R`, from formulas or (always, if so `given`) state by state."""
    channels = tuple(choices.one_of(CHANNELS) for _ in range(choices.number(1, 3)))
    common = Words(choices, {}, {}, CHANNELS if choices.one_in(3) else channels)
    top, lets = _lets(common, "top")
    common = replace(common, lets=lets)
    variables = _some(choices, VARIABLES)
    crossing = choices.one_in(4)
    if crossing:
        variables |= {name: VARIABLES[name] for name in ("i", "b")}
    words = replace(common, variables={name: kind for name, (kind, _) in variables.items()})
    own, kinds = _lets(words, "own")
    words = replace(words, lets=lets | kinds, crossing=crossing)
    beginning = [*_variables(variables), *(f"  {let}" for let in own)]
    parts = [PRELUDE, *top]
    if given or choices.one_in(3):
        parts += ["statechart R {", *beginning, *_statechart(words), "}"]
    else:
        parts += _role(words, common, beginning)
    return "\n".join(part for part in parts if part) + "\n"


def _role(words: Words, common: Words, beginning: list[str]) -> list[str]:
    """The role `R` by formulas, with the protocol that it plays, if it plays one."""
    choices = words.choices
    names = Names({}, [], "A", words.crossing)
    protocol = plays = ""
    if not choices.one_in(3):
        protocol, nullable = _protocol(common)
        names.helpers["a"] = nullable
        names.unused.append("a")
        plays = "  plays p.a" + (" with P1 = A1" if choices.one_in(4) and "P1" in protocol else "")
    helpers = [f"helper{number}" for number in range(choices.number(0, 3))]
    depth = choices.number(2 if words.crossing else 1, 3)
    formulas = _formulas(choices, names, "R", helpers, depth)
    words = replace(words, counted=countable(formulas))
    return [
        protocol,
        "srm R {",
        plays,
        *beginning,
        "  liveness {",
        *(f"    {name} = {made.text()}" for name, made in formulas),
        "  }",
        *(control(words, made, name) for name, made in formulas),
        *_waiting(choices, names),
        "}",
    ]


def _waiting(choices: Choices, names: Names) -> list[str]:
    """Some activities of the role that never end by themselves."""
    if not names.activities or not choices.one_in(4):
        return []
    waiting = sorted({choices.number(1, names.activities) for _ in range(2)})
    return [f"  activities {{ {'  '.join(f'A{number} waits' for number in waiting)} }}"]
