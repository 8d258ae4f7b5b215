"""The TextMate grammar, for VS Code and other editors that read such grammars."""

from __future__ import annotations

import json
from collections.abc import Mapping

from aseme_dsl.grammar.syntax.contexts import FILE, Context, Kind
from aseme_dsl.grammar.syntax.patterns import compact
from aseme_dsl.grammar.syntax.rules import COMMENTS, STRAY, Rule, rules

SCOPES: dict[Kind, str] = {
    Kind.DECLARATION: "keyword.control.declaration.aseme",
    Kind.CLAUSE: "keyword.other.clause.aseme",
    Kind.CHOICE: "storage.modifier.aseme",
    Kind.TRUTH: "constant.language.aseme",
    Kind.LOGIC: "keyword.operator.logical.aseme",
    Kind.BUILT_IN: "support.type.aseme",
    Kind.BLOCK: "entity.name.type.aseme",
    Kind.NAME: "entity.name.function.aseme",
    Kind.TYPE: "entity.name.type.reference.aseme",
    Kind.CALL: "support.function.aseme",
    Kind.REFERENCE: "variable.other.aseme",
    Kind.TEXT: "string.quoted.double.aseme",
    Kind.NUMBER: "constant.numeric.aseme",
    Kind.OPERATOR: "keyword.operator.aseme",
    Kind.PUNCTUATION: "punctuation.aseme",
}
"""The scope of each kind of token."""


def textmate_grammar(contexts: tuple[Context, ...]) -> str:
    """The grammar as JSON. Its rules see one line at a time: a phrase that is broken keeps its beginning."""
    file = contexts[0]
    assert file.name == FILE
    by_name = {context.name: context for context in contexts}
    repository: dict[str, dict[str, object]] = {
        _key(context.name): {"patterns": _patterns(context, by_name)} for context in contexts[1:]
    }
    repository["comments"] = {"patterns": [_comment(*comment) for comment in COMMENTS]}
    repository["stray"] = {
        "patterns": [
            *({"match": pattern, **({"name": SCOPES[kind]} if kind else {})} for pattern, kind in STRAY),
            {"begin": r"\{", "end": r"\}", "patterns": [_include("comments"), _include("stray")]},
        ]
    }
    made = {
        "$schema": "https://raw.githubusercontent.com/martinring/tmlanguage/master/tmlanguage.json",
        "comment": "Made from aseme_dsl/grammar/*.tx: python3 dev.py syntax",
        "name": "ASEME",
        "scopeName": "source.aseme",
        "fileTypes": ["aseme"],
        "patterns": _patterns(file, by_name),
        "repository": repository,
    }
    return json.dumps(made, indent=2, ensure_ascii=False) + "\n"


def _key(name: str) -> str:
    return name.replace(" ", "-").lower()


def _include(key: str) -> dict[str, str]:
    return {"include": f"#{key}"}


def _comment(pattern: str, kind: str) -> dict[str, object]:
    if kind == "line":
        return {"name": "comment.line.double-slash.aseme", "match": pattern}
    return {"name": "comment.block.aseme", "begin": r"/\*", "end": r"\*/"}


def _patterns(context: Context, contexts: dict[str, Context]) -> list[Mapping[str, object]]:
    made: list[Mapping[str, object]] = [
        _include("comments"),
        *(_rule(rule, contexts) for rule in rules(context)),
    ]
    return [*made, _include("stray")] if context.is_body else made


def _captures(rule: Rule) -> dict[str, dict[str, str]]:
    return {
        str(number): {"name": SCOPES[kind]}
        for number, kind in enumerate(rule.kinds, start=1)
        if kind is not None
    }


def _rule(rule: Rule, contexts: dict[str, Context]) -> dict[str, object]:
    captures = _captures(rule)
    if rule.rest is not None:
        return {
            "begin": rule.pattern,
            "beginCaptures": captures,
            "end": rf"{rule.rest.pattern}|(?!\s|//|/\*)(?=\S)",
            "endCaptures": _captures(rule.rest),
            "patterns": [_include("comments")],
        }
    if not rule.enters:
        return {"match": rule.pattern, "captures": captures}
    entered = contexts[rule.enters]
    end = entered.end()
    region: dict[str, object] = {
        "begin": rule.pattern,
        "beginCaptures": captures,
        "end": compact(end) if end is not None else r"\}",
        "patterns": [_include(_key(entered.name))],
    }
    if end is None:
        region["endCaptures"] = {"0": {"name": SCOPES[Kind.PUNCTUATION]}}
    return region
