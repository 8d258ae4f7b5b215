"""Snippets: what is written for a word of the language, with room for what must follow it."""

from __future__ import annotations

from collections.abc import Sequence

from aseme_dsl.editor.typing.items import escaped
from aseme_dsl.grammar.parsing.expected import Blank, Expected, rest_of

WHOLE = {
    "system": "system ${1:Name}\n$0",
    "enum": "enum ${1:Name} { ${2:FIRST} ${3:SECOND} }\n$0",
    "message": "message ${1:Name} {\n  ${2:double} ${3:field}\n}\n$0",
    "topic": "topic ${1:name} {\n  ${2|state,data,signal|} ${3:Message}\n}\n$0",
    "sag": 'sag {\n  actor ${1:player} {\n    goal ${2:score} "${3:What shall hold.}"\n  }\n}\n$0',
    "suc": "suc {\n  usecase ${1:score} includes ${2:find_ball}, ${3:kick_ball}\n}\n$0",
    "aip": (
        "aip ${1:name} {\n"
        "  participant ${2:first} {\n"
        '    engage  "${3:When it takes part.}"\n'
        "    process = ${4:Ask}\n"
        "  }\n"
        "  participant ${5:second} {\n"
        '    engage  "${6:When it takes part.}"\n'
        "    process = ${7:Answer}\n"
        "  }\n"
        "}\n$0"
    ),
    "abstract": "abstract srm ${1:name} {\n  liveness {\n    ${1:name} = ${2:Work}~\n  }\n}\n$0",
    "srm": (
        "srm ${1:name} {\n"
        "  liveness {\n"
        "    ${1:name} = ${2:Work}~\n"
        "  }\n\n"
        "  activities {\n"
        "    ${2:Work} takes ${3:100ms}\n"
        "  }\n"
        "}\n$0"
    ),
    "statechart": (
        "statechart ${1:Name} {\n"
        "  state 0   OR    ${1:Name}\n"
        "  state 0.1 START\n"
        "  state 0.2 BASIC ${2:Work}\n"
        "  0.1 -> 0.2 :\n"
        "  0.2 -> 0.2 : after(${3:1s})\n"
        "}\n$0"
    ),
    "team": "team ${1:Name} {\n  ${2:robot1} : ${3:role}\n}\n$0",
}
"""Whole declarations, for words after which a name alone would not be a beginning."""

USUAL = {"var": "var ${1:name} : ${2:type} $0"}
"""What is written inside a block for words with several continuations."""

_TYPICAL = {
    "Duration": "100ms",
    "Integer": "1",
    "SignedInteger": "1",
    "Label": "0.1",
    "Count": "one",
    "FormulaToken": "A",
    "ProcessToken": "A",
    "ExpressionToken": "value",
    "TermToken": "Term",
}
"""An example of what a terminal accepts."""

_BOUND = (".", "(", ")", ",", "[", "]", "..")


def skeleton(word: str, expected: Expected) -> str:
    """The word and all that must follow it, as a snippet."""
    pieces: Sequence[str | Blank] = rest_of(expected)
    text = escaped(word)
    number = 0
    open_ = False
    for piece in pieces:
        if piece == "{":
            text += " {\n  $0\n}"
            open_ = True
            break
        if isinstance(piece, str):
            text += piece if piece in _BOUND else f" {piece}"
            continue
        if piece.terminal == "ControlToken":
            break
        number += 1
        blank = _blank(piece, number)
        text += blank if text.endswith((".", "(", "[")) else f" {blank}"
    return text if open_ else f"{text} $0" if pieces else text


def _blank(blank: Blank, number: int) -> str:
    if blank.words:
        return f"${{{number}|{','.join(blank.words)}|}}"
    if blank.terminal == "Text":
        return f'"${{{number}:{blank.attribute}}}"'
    return f"${{{number}:{_TYPICAL.get(blank.terminal, singular(blank.attribute))}}}"


def singular(attribute: str) -> str:
    """An attribute of a list as the name of one of its items."""
    if attribute.endswith("ies"):
        return attribute[:-3] + "y"
    return attribute.removesuffix("s")


def filled(snippet: str) -> str:
    """The snippet as it stands before the author fills in anything."""
    import re

    text = re.sub(r"\$\{\d+\|([^,|]*)[^|]*\|\}", r"\1", snippet)
    text = re.sub(r"\$\{\d+:((?:[^}\\]|\\.)*)\}", r"\1", text)
    text = re.sub(r"\$\d+", "", text)
    return re.sub(r"\\([\\$}])", r"\1", text)


__all__ = ["USUAL", "WHOLE", "filled", "singular", "skeleton"]
