"""Absences: names that are none of those that can stand there, in the order of their codes."""

from __future__ import annotations

from typing import ClassVar, Literal

from aseme_dsl.diagnostics.problem import Problem, by_name
from aseme_dsl.diagnostics.wording import declared_by, did_you_mean, first_of, listed, there_are

_LISTED = 8
"""How many names a hint lists at most."""

Verb = Literal["sends", "receives"]


class Unknown(Problem):
    """A name that is none of those that can stand there: `others`, of which `close` is spelt alike."""

    name: str
    close: str | None
    others: tuple[str, ...]
    what: ClassVar[str]
    """What the message says before the name."""

    @property
    def message(self) -> str:
        return f"{self.what} `{self.name}`"

    @property
    def hint(self) -> str | None:
        if self.certain is not None:
            return self.certain
        return did_you_mean(self.close) if self.close is not None else self.advice

    @property
    def certain(self) -> str | None:
        """A hint that is better than any name that is spelt alike."""
        return None

    @property
    def advice(self) -> str | None:
        """The hint where no name is spelt alike."""
        return there_are(self.others) if 0 < len(self.others) <= _LISTED else None


class Absent(Unknown):
    """A name that nothing declares: it may be misspelt, or unreadable, where it is declared.

    `unused` is a declared name that is spelt alike and that nothing uses: then that one is misspelt.
    """

    unused: str | None = by_name(default=None, kw_only=True)

    @property
    def hint(self) -> str | None:
        if self.unused is not None:
            return f"nothing uses `{self.unused}`: is `{self.name}` meant there?"
        return super().hint

    @property
    def cause(self) -> tuple[object, ...]:
        """What is not there, wherever it is named: its kind, its name, and that in which it is missing."""
        kind = next(one for one in reversed(type(self).__mro__) if "code" in vars(one))
        given = (name for name in self._fields if not hasattr(type(self), name))
        return (kind, *(getattr(self, name) for name in given if name not in ("close", "others")))

    @property
    def is_elsewhere(self) -> bool:
        """Whether the name is known, but is not what is wanted here: then nothing is missing."""
        return False


class Importable(Absent):
    """A name that `libraries`, files of the standard library, declare."""

    libraries: tuple[str, ...] = by_name(default=(), kw_only=True)

    @property
    def certain(self) -> str | None:
        return declared_by(self.libraries)


# ---- E200 --------------------------------------------------------------------------------------


class NoType(Importable):
    code = "E200"
    what = "there is no type"
    spelling: str | None = None
    """What the language calls a type that has this name in others."""

    @property
    def certain(self) -> str | None:
        if self.spelling is not None:
            return f"it is called `{self.spelling}` here"
        return super().certain


class NoDeclaredType(NoType):
    """Where enums and messages can stand, too."""

    advice = "declare it or import it"


class NoKindOfActivity(Absent):
    code = "E200"
    what = "there is no kind of activity"


class NoActor(Absent):
    code = "E200"
    what = "there is no actor"


class NoRoleOfUseCase(Absent):
    code = "E200"
    what = "there is no role"


class NoPublisher(Absent):
    code = "E200"
    what = "there is no role, agent or activity"

    @property
    def advice(self) -> str:
        return super().advice or f"if it is not part of the system: `suc {{ role {self.name} : external }}`"


# ---- E204 to E212 ------------------------------------------------------------------------------


class NoActivityInFormulas(Absent):
    code = "E204"
    what = "no formula has the activity"


class NoActivityOfRole(Absent):
    code = "E204"
    role: str

    @property
    def message(self) -> str:
        return f"{self.role} has no activity `{self.name}`"


class NoProtocol(Absent):
    code = "E205"
    what = "there is no protocol"


class NoParticipant(Absent):
    code = "E205"
    protocol: str

    @property
    def message(self) -> str:
        return f"{self.protocol} has no participant `{self.name}`"


class NoPartner(Absent):
    """In the control of a protocol. `participants` are listed, `others` may be variables as well."""

    code = "E205"
    what = "the protocol has no participant"
    participants: tuple[str, ...] = ()

    @property
    def advice(self) -> str | None:
        return f"there are {listed(self.participants)}" if self.participants else super().advice


class NoActivityToBind(Absent):
    code = "E206"
    protocol: str
    participant: str

    @property
    def message(self) -> str:
        return f"{self.protocol}.{self.participant} has no activity, input or result `{self.name}`"

    @property
    def advice(self) -> str:
        return "it has " + ", ".join(self.others)


class NoActivityToSend(Absent):
    code = "E565"
    participant: str

    @property
    def message(self) -> str:
        return f"`{self.participant}` has no activity `{self.name}`"

    @property
    def advice(self) -> str:
        return "its activities are " + (", ".join(self.others) or "none")


class NoRole(Absent):
    code = "E207"
    what = "there is no role"


class NoRoleOfAgent(NoRole):
    advice = "a role is an `srm` or a `statechart`"


class NoParticipantOfClause(Absent):
    """`owners` are the participants that have an activity or formula of this name."""

    code = "E212"
    protocol: str
    owners: tuple[str, ...] = ()

    @property
    def message(self) -> str:
        return f"{self.protocol} has no participant `{self.name}`"

    @property
    def is_elsewhere(self) -> bool:
        return self.close is None and bool(self.owners)

    @property
    def advice(self) -> str | None:
        spelled = (f"{self.name}@{owner}" for owner in self.owners)
        return f"say whose: {listed(spelled, 'or')}" if self.owners else super().advice


class NoPlaceOfClause(Absent):
    """`owners` are the other participants that have an activity or formula of this name."""

    code = "E212"
    participant: str
    owners: tuple[str, ...] = ()

    @property
    def message(self) -> str:
        return f"the process of {self.participant} has no activity or formula `{self.name}`"

    @property
    def is_elsewhere(self) -> bool:
        return self.close is None and bool(self.owners)

    @property
    def advice(self) -> str | None:
        return f"it is in the process of {listed(self.owners)}" if self.owners else super().advice


# ---- E400 to E430 ------------------------------------------------------------------------------


class NoTerm(Absent):
    """`formulas` are others that have it, `protocol` and `participant` one that the role plays.

    With `is_abandon` it is said of a formula that is not a participant's process.
    """

    code = "E400"
    title: str
    formulas: tuple[str, ...] = ()
    protocol: str | None = None
    participant: str | None = None
    is_abandon: bool = False

    @property
    def message(self) -> str:
        return f"`{self.title}` has no term `{self.name}`"

    @property
    def certain(self) -> str | None:
        if self.is_abandon:
            return "`on abandon` stands in the control of a participant: write it in the `aip`"
        if self.formulas:
            name = self.formulas[0]
            where = first_of(self.formulas, _LISTED)
            return f"it stands in {where}: write this line in `control {name} {{ … }}`, if that one is meant"
        if self.protocol is not None:
            owner = f"{self.protocol}.{self.participant}"
            return f"it stands in {owner}, whose control is the protocol's: say it in `aip {self.protocol}`"
        return None

    @property
    def advice(self) -> str:
        return f"its terms are {first_of(self.others, _LISTED)}"


class NoOccurrence(Absent):
    """`A#3` of a term that stands `len(others)` times in the formula."""

    code = "E400"
    title: str

    @property
    def message(self) -> str:
        times = "once" if len(self.others) == 1 else f"{len(self.others)} times"
        return f"there is no `{self.name}`: the term stands {times} in `{self.title}`"

    @property
    def advice(self) -> str:
        return ("there is " if len(self.others) == 1 else "there are ") + first_of(self.others, _LISTED)


class NoFormulaOfRole(Absent):
    code = "E403"
    role: str

    @property
    def message(self) -> str:
        return f"{self.role} has no formula `{self.name}`"

    @property
    def advice(self) -> str:
        return "its formulas are " + ", ".join(self.others) if self.others else "it has no formulas"


class NoFormulaOfProtocol(Absent):
    """`is_process`: the name is the one that the process of each participant has."""

    code = "E403"
    protocol: str
    is_process: bool = False

    @property
    def message(self) -> str:
        return f"{self.protocol} has no participant and no formula called `{self.name}`"

    @property
    def certain(self) -> str | None:
        return (
            "the process of a participant is controlled by the participant's name"
            if self.is_process
            else None
        )

    @property
    def advice(self) -> str:
        return "its participants are " + ", ".join(self.others)


# ---- E501 and E502 -----------------------------------------------------------------------------


class NoMessage(Importable):
    code = "E502"
    what = "there is no message"
    is_enum: bool = False

    @property
    def certain(self) -> str | None:
        return "it is an enum" if self.is_enum else super().certain


class NoTopic(Importable):
    code = "E502"
    what = "there is no topic"


# ---- E503 to E611 ------------------------------------------------------------------------------


class NoCommunicationClass(Unknown):
    code = "E503"
    what = "unknown channel kind"


class NotListed(Absent):
    """`others` are what the participant sends or receives, `close` another type with this performative.

    One that lists nothing receives what its lines take.
    """

    code = "E511"
    participant: str
    verb: Verb
    performative: str
    lists: bool = True

    @property
    def message(self) -> str:
        if not self.lists:
            return f"no line of `{self.participant}` takes `{self.performative} {self.name}`"
        return f"`{self.participant}` does not list `{self.verb} {self.performative} {self.name}`"

    @property
    def advice(self) -> str:
        if not self.lists:
            return f"write a line in its control that takes it: `{self.performative} {self.name} from …`"
        rest = f"; it {self.verb} {', '.join(self.others)}" if self.others else ""
        return f"write `{self.verb} {self.performative} {self.name}` there{rest}"


class NoPerformative(Absent):
    code = "E512"
    what = "FIPA has no performative"

    @property
    def advice(self) -> str:
        return f"it has {listed(self.others)}"


class NoVariableOfRole(Unknown):
    code = "E611"
    role: str

    @property
    def message(self) -> str:
        return f"the role `{self.role}` has no variable `{self.name}`"

    @property
    def advice(self) -> str | None:
        return super().advice if self.others else f"declare it in the role: `var {self.name} : …`"


# ---- W230 --------------------------------------------------------------------------------------


class NoFunctionality(Unknown):
    code = "W230"
    what = "there is no functionality"
