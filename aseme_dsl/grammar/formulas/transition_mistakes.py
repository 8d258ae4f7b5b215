"""What can be wrong in a transition expression, with what is meant."""

from __future__ import annotations

import re

from aseme_dsl.diagnostics import Diagnostic, Edit, closest, surely
from aseme_dsl.diagnostics.problems.syntax import formulas as problems
from aseme_dsl.diagnostics.problems.syntax.entries import Wanted
from aseme_dsl.grammar.formulas.reader import Reader, is_word
from aseme_dsl.grammar.formulas.words import RESERVED, Malformed
from aseme_dsl.grammar.text.recovery import BLOCKS
from aseme_dsl.grammar.text.token import Token
from aseme_dsl.source import Span

_CONTENT = re.compile(
    r"\s*(send\s+(?P<kind>[A-Za-z_]\w*)(?:\s+(?P<message>[A-Za-z_]\w*))?"
    r"|(?P<made>new\s+)?[A-Za-z_]\w*(?:\s*\.\s*\w+)*|(?P<untyped>))\s*\{",
    re.ASCII,
)
_COLON = re.compile(
    r'(?:(?:"[^"\n]*"|[^{}":\n])*,)?\s*[A-Za-z_][\w.]*\s*:',
    re.ASCII,
)
_NESTED = re.compile(r'(?:(?:"[^"\n]*"|[^{}"\n])*,)?\s*(?P<member>[A-Za-z_][\w.]*)\s*\{', re.ASCII)
_UNCLOSED = re.compile(r"[^{}\n]*?([^\s{},;]+)[ \t,;]*(?=\bto\b(?!\s*=)|\n|\Z)", re.ASCII)
"""A message with its braces, and what may be wrong inside them."""

ASSIGNMENTS = ("=", "+=", "-=", "*=")

_IN_TERMS = frozenset("( ) . | || ~ * + ;".split())
"""What terms are made of, besides names."""


def check_content(reader: Reader) -> None:
    """What is wrong where the grammar could not read a message and its braces. Raises Malformed."""
    is_last = reader.index == len(reader.tokens)
    start = reader.tokens[-1].end if is_last else reader.tokens[reader.index].start
    text = reader.source.text
    found = _CONTENT.match(text, start)
    if found is None or any(item.end == found.end() for item in reader.tokens[reader.index :]):
        return
    place = Span(reader.source, reader.tokens[-1].start if is_last else start, found.end())
    if found["kind"] and not found["message"]:
        raise Malformed(Diagnostic(problems.SendWithoutMessage((Wanted.MESSAGE,), found["kind"], "{"), place))
    if found["made"]:
        word = Span(reader.source, found.start("made"), found.end("made"))
        raise Malformed(Diagnostic(problems.NewBeforeMessage(), place, edits=(Edit(word, ""),)))
    if found["untyped"] is not None:
        raise Malformed(Diagnostic(problems.ContentWithoutMessage(), place))
    colon = _COLON.match(text, found.end())
    if colon is not None:
        at = Span(reader.source, colon.end() - 1, colon.end())
        raise Malformed(Diagnostic(problems.MemberWithColon(), place, edits=(Edit(at, " ="),)))
    nested = _NESTED.match(text, found.end())
    if nested is not None:
        whole = Span(reader.source, place.start, nested.end())
        raise Malformed(Diagnostic(problems.MemberWithBraces(nested["member"]), whole))
    end = _UNCLOSED.match(text, found.end())
    if end is not None:
        at = Span(reader.source, end.end(1), end.end(1))
        raise Malformed(Diagnostic(problems.ContentNotClosed(end[1]), place, edits=(Edit(at, " }"),)))


def no_colon(reader: Reader, verb: Token) -> Malformed:
    """`on work [c]`: a control line of its own, if it had a colon."""
    line = reader.source.text[reader.source.text.rfind("\n", 0, verb.start) + 1 : verb.start]
    if verb == "on" and line.rstrip().endswith(":") and _is_last_event(reader, reader.index):
        return _event_after(reader, verb, reader.tokens[reader.index])
    complete = False
    while reader.index < len(reader.tokens):
        begins_operand = reader.next == "(" or is_word(reader.next)
        if (complete and begins_operand) or not (begins_operand or reader.next in _IN_TERMS):
            break
        complete = reader.next not in ("(", ".", "|", "||")
        reader.take()
    last = reader.tokens[reader.index - 1]
    found = reader.tokens[reader.index] if reader.index < len(reader.tokens) else None
    return reader.error(problems.EntryWithoutColon(verb, last, found), last)


def no_from(reader: Reader) -> Malformed:
    """`inform Offer bidder`: a word is missing or misspelt before the sender."""
    if reader.index == len(reader.tokens):
        return reader.unexpected(Wanted.SENDER)
    found = reader.tokens[reader.index]
    if is_word(found) and closest(found, ("from",)):
        return reader.error(problems.MisspeltFrom(("from",), None, found), found, "from")
    return reader.unexpected(Wanted.SENDER)


def condition_with_if(reader: Reader, word: Token) -> Malformed:
    """`if low` of other languages."""
    found = bare_condition(reader, reader.index).diagnostic
    if found.fix is None or found.span is None:
        return reader.error(problems.ConditionWithIf(None), word)
    span = Span(reader.source, word.start, found.span.end)
    bare = found.problem.meant if isinstance(found.problem, problems.BareCondition) else None
    return Malformed(Diagnostic(problems.ConditionWithIf(bare), span, fix=found.fix))


def bare_condition(reader: Reader, start: int) -> Malformed:
    """A condition without its brackets, from the token at `start` on."""
    first = reader.tokens[start]
    if start > 0 and reader.tokens[start - 1] == "when" and _is_last_event(reader, start):
        return _event_after(reader, reader.tokens[start - 1], first)
    for offset, word in enumerate(reader.tokens[start:]):
        if word in ("/", "["):
            condition = reader.tokens[start : start + offset]
            break
    else:
        condition = reader.tokens[start:]
    if condition and (is_word(first) or first in ("!", "(", "-") or first[0].isdigit()):
        if condition[-1] == "]":
            return reader.error(problems.BracketMissingBefore(first), first, f"[{first}")
        last = condition[-1]
        span = Span(reader.source, first.start, last.end)
        whole = _WHOLE_MESSAGE.fullmatch(span.text)
        meant = f"[has({span.text})]" if whole is not None else f"[{span.text}]"
        if _is_interrupt(reader):
            meant = f"when {meant}"
        return Malformed(Diagnostic(problems.BareCondition(meant), span, fix=meant))
    return reader.error(problems.UnexpectedInExpression((Wanted.EVENT, "[", "/"), None, first), first)


def _is_interrupt(reader: Reader) -> bool:
    """Whether the line is `enter T` of a T that stands right behind `[>`: it needs an event or `when`."""
    text = reader.source.text
    start = reader.tokens[0].start
    entered = _ENTERED.fullmatch(text, text.rfind("\n", 0, start) + 1, start)
    if entered is None:
        return False
    term = r"\s*".join(map(re.escape, re.findall(r"\w+|[^\w\s]+", entered["term"].strip("()"))))
    return re.search(rf"\[>\s*\(*\s*{term}(?!\w)", text) is not None


_ENTERED = re.compile(r".*\benter\s+(?P<term>[^:\n]*?)\s*:\s*")
_WHOLE_MESSAGE = re.compile(r"\w+(?:\s*\.\s*\w+)*\s*\.\s*(?:signal|state|data)\s*\.\s*\w+")
"""`panel.signal.Stop`: as a condition it asks whether the message is there."""


def _is_last_event(reader: Reader, index: int) -> bool:
    """Whether a plain name ends the expression that the file declares as no value."""
    word = reader.tokens[index]
    if index < len(reader.tokens) - 1 or not is_word(word) or "." in word or word in RESERVED:
        return False
    return re.search(rf"\b(?:var|let)\s+{re.escape(word)}\b", reader.source.text) is None


def _event_after(reader: Reader, word: Token, event: Token) -> Malformed:
    """`when stop` or `on stop`, as other languages write the event `stop`."""
    span = Span(reader.source, word.start, event.end)
    return Malformed(Diagnostic(problems.EventBehindWord(word, event), span, fix=str(event)))


def no_event(reader: Reader) -> Malformed:
    """`raise` at the end of an expression: what stands behind it begins a control line, as it is read."""
    word = reader.take()
    found = re.compile(r"[ \t]+([A-Za-z_]\w*)").match(reader.source.text, word.end)
    if found is None:
        return reader.unexpected(Wanted.EVENT)
    place = Span(reader.source, word.start, found.end(1))
    return Malformed(Diagnostic(problems.EventNamedLikeVerb(found[1]), place))


def after_transition(reader: Reader, has_actions: bool, has_condition: bool) -> Malformed:
    """What follows where the expression should have ended."""
    wanted = Wanted.END_OF_EVENTS
    if has_actions:
        wanted = Wanted.END_OF_ACTIONS
    elif has_condition:
        wanted = Wanted.END_OF_CONDITION
    verb = _misspelt_verb(reader)
    if verb is not None:
        previous, word = reader.tokens[reader.index - 1], reader.tokens[reader.index]
        problem = problems.UnexpectedInExpression((wanted,), previous, word, verb)
        return reader.error(problem, word, verb)
    if wanted is Wanted.END_OF_EVENTS and reader.next in ASSIGNMENTS:
        return _assignment_without_slash(reader)
    if wanted is Wanted.END_OF_ACTIONS and reader.index < len(reader.tokens):
        previous, found = reader.tokens[reader.index - 1 : reader.index + 1]
        if found == "reply_by":
            return reader.error(problems.ReplyByBehindReceiver((wanted,), previous, found), found)
        if (previous, found) == ("}", "."):
            return reader.error(problems.MemberOfNewMessage((wanted,), previous, found), found)
    return reader.unexpected(wanted)


def _assignment_without_slash(reader: Reader) -> Malformed:
    start = reader.tokens[0].start
    slash = Edit(Span(reader.source, start, start), "/ ")
    edits = (slash,) if reader.index == 1 else ()
    return reader.error(problems.AssignmentWithoutSlash(), reader.tokens[reader.index], edits=edits)


def _misspelt_verb(reader: Reader) -> str | None:
    """The verb for which the next token is misspelt, where it begins a line."""
    if reader.index >= len(reader.tokens):
        return None
    word = reader.tokens[reader.index]
    line = reader.source.text.rfind("\n", 0, word.start) + 1
    if reader.source.text[line : word.start].strip():
        return None
    verbs = BLOCKS["JunkControl"].words
    return None if word in verbs else surely(word, verbs)
