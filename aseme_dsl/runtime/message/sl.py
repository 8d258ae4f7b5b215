"""Contents in FIPA's semantic language SL (SC00008), as far as agent management uses it, both ways.

That is SL0 – actions, `result`, `done`, predicates, terms – and the referential expressions of subscriptions:

    ((action (agent-identifier :name df)
       (search (df-agent-description :services (set (service-description :type weather)))
               (search-constraints :max-results 3))))
    ((iota ?x (result (action (agent-identifier :name df) (search (df-agent-description))) ?x)))

A content is one or several expressions in parentheses. A string that is a word stands without quotes.
"""

from __future__ import annotations

import math
import re
from datetime import datetime

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.message.acl import Span, Word
from aseme_dsl.runtime.message.acl_text import DEEPEST, AclTextError, Reader, moment_text, shown, string_text

SL0, SL = "fipa-sl0", "fipa-sl"
LANGUAGES = (SL0, "fipa-sl1", "fipa-sl2", SL)
LONGEST = 1_000_000
"""So many bytes a content may have."""


class Variable(str):
    """A variable, such as `?x`; the value is its name."""

    __slots__ = ()


@dataclass(frozen=True, slots=True)
class Form:
    """What stands in parentheses: a name with terms, or with named parameters, but not with both."""

    name: str
    terms: tuple[Term, ...] = ()
    parameters: tuple[tuple[str, Term], ...] = ()

    def parameter(self, name: str) -> Term | None:
        """The value of a parameter; None if it is not given."""
        return next((value for key, value in self.parameters if key == name), None)


Term = str | bytes | int | float | datetime | Span | Form

OPERATORS = {"action": 2, "result": 2, "done": 1, "=": 2, "iota": 2, "any": 2, "all": 2}
"""What is not a name of the ontology, and how many terms it has."""
_PROPOSITIONS = ("result", "done", "=")
_REFERENCES = ("iota", "any", "all")
_WORD = re.compile(r'[^\x00-\x20()#0-9:\-?"][^\x00-\x20()]*')
_HEXADECIMAL = re.compile(r"[+-]?0[xX][0-9A-Fa-f]+")
_NAME = re.compile(r"[^\x00-\x20()]+")


def loads(text: str) -> tuple[Term, ...]:
    """The expressions of a content.

    Raises:
        AclTextError: it is not a content in SL; the error says why, and where.
    """
    data = text.encode("utf-8", "surrogatepass")
    if len(data) > LONGEST:
        raise AclTextError(f"the content has {len(data)} bytes; {LONGEST} are read at the most")
    reader = _Reader(data)
    found = reader.expressions()
    reader.end()
    return found


class _Reader(Reader):
    """The terms of SL, with the strings, numbers and moments of messages."""

    def expressions(self) -> tuple[Term, ...]:
        self.open("a content begins with '('")
        found: list[Term] = []
        while True:
            self.blanks()
            place = self.at
            if self.take(b")"):
                break
            found.append(self.term())
            if not _is_expression(found[-1]):
                self.fail("an action or a proposition is wanted here", place)
        self.depth -= 1
        if not found:
            self.fail("the content has no expression", place)
        return tuple(found)

    def term(self) -> Term:
        self.blanks()
        string = self.string()
        if string is not None:
            return string
        place = self.at
        if self.data[self.at : self.at + 1] == b"(":
            return self.form(place)
        token = self.token("a term")
        if token.startswith("?") and len(token) > 1:
            return Variable(token[1:])
        return self.constant(token, place)

    def constant(self, token: str, place: int) -> Term:
        if (moment := self.as_moment(token, place)) is not None:
            return moment
        if _HEXADECIMAL.fullmatch(token):
            return int(token, 16)
        if (number := self.as_number(token, place)) is not None:
            return number
        return self.as_word(token, place, "a term")

    def as_word(self, token: str, place: int, wanted: str) -> Word:
        if not _WORD.fullmatch(token):
            self.fail(f"{wanted} is wanted here, not {shown(token)}", place)
        return Word(token)

    def form(self, place: int) -> Form:
        self.open("")
        self.blanks()
        if self.data[self.at : self.at + 1] == b"(":
            self.fail("a name is wanted here, not '('", self.at)
        name = str(self.as_word(self.token("a name"), self.at, "a name"))
        terms: list[Term] = []
        parameters: dict[str, Term] = {}
        while True:
            self.blanks()
            here = self.at
            if self.take(b")"):
                break
            if self.data[here : here + 1] == b":":
                key = self.token("a parameter")[1:]
                if not key or key in parameters:
                    self.fail(f":{shown(key)} is given twice" if key else "the parameter has no name", here)
                parameters[key] = self.term()
            else:
                terms.append(self.term())
        self.depth -= 1
        found = Form(name, tuple(terms), tuple(parameters.items()))
        if problem := _problem(found):
            self.fail(problem, place)
        return found


def _problem(form: Form) -> str:
    """What is wrong with a form; empty if nothing is."""
    wanted = OPERATORS.get(form.name)
    if form.terms and form.parameters:
        return f"{shown(form.name)} has terms and parameters; it can have one of both"
    if form.name in ("set", "sequence") and form.parameters:
        return f"a {form.name} has no parameters"
    if wanted is None:
        return ""
    if form.parameters or len(form.terms) != wanted:
        return f"{form.name} has {len(form.terms)} terms; it takes {wanted}"
    if form.name in _REFERENCES:
        if not isinstance(form.terms[0], Variable):
            return f"{form.name} begins with a variable, such as ?x"
        if not _is_proposition(form.terms[1]):
            return f"{form.name} ends with a proposition"
    if form.name == "done" and not _is_action(form.terms[0]):
        return "done takes an action"
    return ""


def _is_action(term: Term) -> bool:
    return isinstance(term, Form) and term.name == "action"


def _is_proposition(term: Term) -> bool:
    if isinstance(term, Form):
        is_predicate = (
            term.name not in OPERATORS and term.name not in ("set", "sequence") and bool(term.terms)
        )
        return term.name in _PROPOSITIONS or is_predicate
    return isinstance(term, str) and not isinstance(term, Variable) and _WORD.fullmatch(term) is not None


def _is_expression(term: Term) -> bool:
    if isinstance(term, Form) and term.name in _REFERENCES:
        return True
    return _is_action(term) or _is_proposition(term)


# ---- writing -----------------------------------------------------------------------------------


def dumps(*expressions: Term) -> str:
    """The text of a content.

    Raises:
        AclTextError: it has none: a name is not a word, a text not UTF-8, a number not finite, or it is
                nested too deep.
    """
    return "(" + " ".join(_text(item, 1) for item in expressions) + ")"


def _text(term: Term, depth: int) -> str:
    match term:
        case Form():
            return _form(term, depth + 1)
        case Variable():
            return "?" + _name(term)
        case str():
            quoted = string_text(term).decode()
            return str(term) if _is_bare(term) else quoted
        case bytes():
            raise AclTextError(f"{shown(repr(term))} is not a text in UTF-8")
        case datetime() | Span():
            return moment_text(term).decode()
        case float() if not math.isfinite(term):
            raise AclTextError(f"{term} is not a number of SL")
        case _:
            return repr(term)


def _form(form: Form, depth: int) -> str:
    if depth > DEEPEST:
        raise AclTextError(f"it is nested more than {DEEPEST} deep")
    if problem := _problem(form):
        raise AclTextError(problem)
    if not _WORD.fullmatch(form.name):
        raise AclTextError(f"{shown(form.name)!r} is not a word, as the name of a form has to be")
    pieces = [form.name, *(_text(item, depth) for item in form.terms)]
    for name, value in form.parameters:
        pieces += [f":{_name(name)}", _text(value, depth)]
    return "(" + " ".join(pieces) + ")"


def _name(name: str) -> str:
    if not _NAME.fullmatch(name):
        raise AclTextError(f"{shown(name)!r} cannot be a name: it has blanks or parentheses, or is empty")
    return str(name)


def _is_bare(text: str) -> bool:
    """Whether a string can stand without quotes, and is read as a string then."""
    if not _WORD.fullmatch(text) or any(map(str.isspace, text)):  # so that no reader takes it for a blank
        return False
    try:
        return isinstance(_Reader(b"").constant(text, 0), str)
    except AclTextError:
        return False


__all__ = ["LANGUAGES", "SL", "SL0", "Form", "Term", "Variable", "dumps", "loads"]
