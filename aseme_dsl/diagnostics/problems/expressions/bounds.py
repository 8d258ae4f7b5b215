"""Problems of bounds: `var n : int 0..10` (E516, E518)."""

from __future__ import annotations

from aseme_dsl.diagnostics.problem import Problem
from aseme_dsl.diagnostics.wording import a


class OutsideBounds(Problem):
    """`is_given`: the value is written, and not what a variable holds when nothing is said."""

    code = "E516"
    name: str
    value: str
    bounds: str
    least: str
    is_given: bool

    @property
    def message(self) -> str:
        if self.is_given:
            return f"`{self.name}` cannot be {self.value}: its bounds are {self.bounds}"
        return f"`{self.name}` would begin with {self.value}, outside of its bounds {self.bounds}"

    @property
    def hint(self) -> str:
        if self.is_given:
            return "write a number within the bounds, or widen them"
        return f"give it a first value: `= {self.least}`"


class BoundsOfOther(Problem):
    code = "E518"
    type: str

    @property
    def message(self) -> str:
        return f"{a(self.type)} has no bounds"

    hint = "remove them: only an int or a double is bounded"


class BoundsOfElements(Problem):
    """`var xs : list of int 0..9`"""

    code = "E518"
    name: str
    type: str

    @property
    def message(self) -> str:
        return f"the elements of the list `{self.name}` have no bounds"

    @property
    def hint(self) -> str:
        return f"remove them; how many elements it has is limited so: `{self.name} : list[10] of {self.type}`"


class FractionAsBound(Problem):
    code = "E518"
    name: str

    @property
    def message(self) -> str:
        return f"the bounds of the int `{self.name}` have a fraction"

    hint = "write whole numbers, or declare it as a double"


class BoundsReversed(Problem):
    code = "E518"
    bounds: str
    turned: str

    @property
    def message(self) -> str:
        return f"no number is within {self.bounds}"

    @property
    def hint(self) -> str:
        return f"write the least first: `{self.turned}`"


class LengthOfList(Problem):
    code = "E518"
    length: int
    most: int

    @property
    def message(self) -> str:
        if self.length < 1:
            return "a list of this length holds nothing"
        return f"a list has at most {self.most} elements"

    @property
    def hint(self) -> str:
        return f"write a length from 1 to {self.most}, or leave it out: then it is 1000"


class ListOfAgents(Problem):
    code = "E500"
    message = "a list does not hold agents"
    hint = "use a list of strings: an agent is assigned to a string as its name"


class ListNotEmpty(Problem):
    code = "E514"
    name: str

    @property
    def message(self) -> str:
        return f"the list `{self.name}` begins empty"

    @property
    def hint(self) -> str:
        return f"fill it in an action: `{self.name} = [...]`"


class ChangeOfOther(Problem):
    """`word`: append, remove, or an assignment to an element."""

    code = "E535"
    word: str
    written: str

    @property
    def message(self) -> str:
        return f"`{self.word}` changes a variable that is a list, not `{self.written}`"

    hint = "declare a list: `var names : list of string`"


class NeverEmpty(Problem):
    """`clear` of what always holds a value; `type` where it is a variable, `instead` what empties a list."""

    code = "E507"
    written: str
    type: str | None
    instead: str | None

    @property
    def message(self) -> str:
        what = f"`{self.written}`" + (f", which is {a(self.type)}" if self.type is not None else "")
        return f"`clear` empties a variable that holds a message or an agent, not {what}"

    @property
    def hint(self) -> str | None:
        if self.instead is not None:
            return f"a list is emptied by `{self.instead}`"
        if self.type is not None:
            return f"it always holds a value: assign one, `{self.written} = ...`"
        return "name the variable alone: `clear(now)`"


class ResultWithOtherBounds(Problem):
    """`bounds` and `own` are those of the result and of the variable, empty where it has none."""

    code = "E591"
    result: str
    name: str
    bounds: str
    own: str

    @property
    def message(self) -> str:
        said = f"has the bounds {self.own}" if self.own else "has no bounds"
        wanted = f"has {self.bounds}" if self.bounds else "has none"
        return f"`{self.name}` {said}, while the result `{self.result}` {wanted}"

    hint = "declare both with the same bounds"
