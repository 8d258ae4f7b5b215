"""Homonyms: a role that is called as a participant that it plays.

In `srm desk { plays talk.desk  liveness { desk = Think . desk~ } }`, the formula is the role's, and the
`desk` in it is the participant. It is read as if it were `plays talk.desk as talk_desk`, with that name in
the formulas.
"""

from __future__ import annotations

from dataclasses import replace

from aseme_dsl.amola.liveness import Formula, names, rewritten
from aseme_dsl.grammar.text import tree


def told_apart(role: tree.Srm) -> tree.Srm:
    """The role with another name for the participant, if it uses the name of its first formula for one."""
    if not role.formulas:
        return role
    name = role.formulas[0].name.text
    plays = [item for item in role.plays if item.alias is None and item.participant.text == name]
    if len(plays) != 1:
        return role
    if all(node.name != name for item in role.formulas for node in names(item.formula)):
        return role
    (meant,) = plays
    new = f"{meant.protocol}_{name}"
    return replace(
        role,
        plays=tuple(
            replace(item, alias=tree.Name(new, item.participant.span)) if item is meant else item
            for item in role.plays
        ),
        formulas=tuple(replace(item, formula=with_name(item.formula, name, new)) for item in role.formulas),
        controls=tuple(
            replace(item, entries=tuple(_entry(entry, name, new) for entry in item.entries))
            for item in role.controls
        ),
    )


def _entry(entry: tree.Way | tree.LabelledWay, name: str, new: str) -> tree.Way | tree.LabelledWay:
    if isinstance(entry, tree.LabelledWay):
        return entry
    return replace(entry, term=replace(entry.term, formula=with_name(entry.term.formula, name, new)))


def with_name(formula: Formula, name: str, new: str) -> Formula:
    """The formula with another name in the place of one."""
    return rewritten(formula, lambda node: replace(node, name=new) if node.name == name else node)


__all__ = ["told_apart"]
