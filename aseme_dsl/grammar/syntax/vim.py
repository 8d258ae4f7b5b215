"""The syntax file for Vim and Neovim.

Vim chains items: each names the groups that may follow it, across blanks, lines and comments. So a phrase is
a chain, the phrases of a context that begin alike share their beginning, and only braces are regions. Where
several items match, Vim takes the one that was defined last; the lines are therefore written in reverse.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import field

from aseme_dsl.grammar.syntax.contexts import (
    CONTENT,
    FILE,
    TOKENS,
    Context,
    Kind,
    Phrase,
    Piece,
    either,
    enclosed,
)
from aseme_dsl.grammar.syntax.patterns import vim
from aseme_dsl.grammar.syntax.rules import STRAY
from aseme_dsl.records import dataclass

LINKS: dict[Kind, str] = {
    Kind.DECLARATION: "Statement",
    Kind.CLAUSE: "Keyword",
    Kind.CHOICE: "StorageClass",
    Kind.TRUTH: "Boolean",
    Kind.LOGIC: "Operator",
    Kind.BUILT_IN: "Type",
    Kind.BLOCK: "Structure",
    Kind.NAME: "Identifier",
    Kind.TYPE: "Type",
    Kind.CALL: "Function",
    Kind.REFERENCE: "asemeNone",
    Kind.TEXT: "String",
    Kind.NUMBER: "Number",
    Kind.OPERATOR: "Operator",
    Kind.PUNCTUATION: "Delimiter",
}
"""The highlight group of each kind of token."""

_HEAD = """\
" Vim syntax of ASEME. Made from aseme_dsl/grammar/*.tx: python3 dev.py syntax
" The name of a group begins with the kind of its token: asemeClause_12 is the word of a clause.
if exists("b:current_syntax")
  finish
endif
scriptencoding utf-8
" A declaration that begins a line stands in nothing else: what is before it need not be read.
syntax sync match asemeDeclarationHere grouphere NONE /\\v^%({declarations})>/
"""

_COMMENTS = (
    r"syntax match asemeComment /\v\/\/.*$/ contains=@Spell",
    r"syntax region asemeComment start=/\v\/\*/ end=/\v\*\// contains=@Spell",
)


@dataclass
class _Node:
    """A place in the phrases of a context: what has been read so far."""

    children: dict[Piece, _Node] = field(default_factory=dict)
    enters: list[str] = field(default_factory=list)
    goes_on: bool = False
    """Whether the phrase may end here."""


def vim_files(contexts: tuple[Context, ...]) -> dict[str, str]:
    """The text of each file under the folder for Vim."""
    writer = _Writer({context.name: context for context in contexts})
    writer.body(FILE)
    lines = [*reversed([*_COMMENTS, *writer.first, *writer.lines, *writer.later])]
    links = [f"highlight default link {group} aseme{kind}" for group, kind in sorted(writer.links.items())]
    groups = [f"highlight default link aseme{camel(kind)} {LINKS[kind]}" for kind in Kind]
    tail = [*links, *groups, "highlight default link asemeComment Comment", 'let b:current_syntax = "aseme"']
    words = [word for phrase in contexts[0].phrases for _, word in phrase.pieces[0].words]
    head = _HEAD.replace("{declarations}", "|".join(dict.fromkeys(words)))
    return {"syntax/aseme.vim": head + "\n".join([*lines, *tail]) + "\n"}


def camel(kind: Kind) -> str:
    """The kind in the names of groups."""
    return kind.name.title().replace("_", "")


@dataclass
class _Writer:
    contexts: dict[str, Context]
    lines: list[str] = field(default_factory=list)
    """The most important item first."""
    first: list[str] = field(default_factory=list)
    later: list[str] = field(default_factory=list)
    """The same, more and less important than all others."""
    links: dict[str, str] = field(default_factory=dict)
    heads: dict[str, tuple[str, ...]] = field(default_factory=dict)
    following: dict[tuple[str, ...], str] = field(default_factory=dict)

    def group(self, kind: str) -> str:
        """A new group for tokens of a kind."""
        name = f"aseme{kind}_{len(self.links)}"
        self.links[name] = kind
        return name

    def match(self, pattern: str, kind: Kind, following: Iterable[str], contained: bool = True) -> str:
        """An item for one token; returns its group."""
        group = self.group(camel(kind))
        then = self.then(tuple(dict.fromkeys(following)))
        spell = " contains=@Spell" if kind is Kind.TEXT else ""
        place = " contained" if contained else ""
        self.lines.append(f"syntax match {group} /\\v{vim(pattern)}/{place}{spell}{then}")
        return group

    def then(self, following: tuple[str, ...]) -> str:
        """The words for what may follow an item; comments may stand before it."""
        if not following:
            return ""
        if following not in self.following:
            group = self.group("Comment")
            then = f" nextgroup={','.join([*following, group])} skipwhite skipempty"
            self.following[following] = then
            self.lines.append(rf"syntax match {group} /\v\/\/.*$/ contained contains=@Spell{then}")
            self.lines.append(
                rf"syntax region {group} start=/\v\/\*/ end=/\v\*\// contained contains=@Spell{then}"
            )
        return self.following[following]

    def body(self, name: str) -> None:
        """Define what stands in a body, and the body itself, unless it is the file."""
        cluster = _cluster(name)
        if name in self.heads:
            return
        self.heads[name] = (cluster,)
        context = self.contexts[name]
        opened = name == FILE
        members = self.phrases(context, (), not opened)
        tokens = self.tokens(context, (), not opened) if context.tokens is not None else []
        stray = self.stray(opened)
        everything = [*members, *tokens, *stray, "asemeComment"]
        self.lines.append(f"syntax cluster {cluster[1:]} contains={','.join(dict.fromkeys(everything))}")

    def stray(self, opened: bool) -> list[str]:
        """What stands where the grammar has nothing: items of the file, and others for all bodies."""
        key = f"stray {opened}"
        if key not in self.heads:
            groups = [self.match(pattern, kind or Kind.REFERENCE, (), not opened) for pattern, kind in STRAY]
            braces = self.group("Punctuation")
            inner = _cluster(key)
            self.later.append(
                f"syntax cluster {inner[1:]} contains={','.join([*groups, braces, 'asemeComment'])}"
            )
            self.later.append(
                f"syntax region {braces} matchgroup=asemePunctuation start=/{{/ end=/}}/"
                f"{'' if opened else ' contained'} contains={inner} transparent"
            )
            self.later += self.lines[-len(groups) :]
            del self.lines[-len(groups) :]
            self.heads[key] = (*groups, braces)
        return [*self.heads[key]]

    def entry(self, name: str, after: tuple[str, ...] = ()) -> tuple[str, ...]:
        """Define what may follow in an entry or a list, and `after` it; returns the groups."""
        context = self.contexts[name]
        if context.starts:
            after = ()  # an entry ends where another begins
        key = f"{name} {''.join(after)}".strip()
        if key in self.heads:
            return self.heads[key]
        cluster = _cluster(key.replace("@", "before "))
        self.heads[key] = (cluster, *after)  # known before its members are, for they refer to it
        outer, self.lines = self.lines, []
        members = self.phrases(context, self.heads[key], True)
        tokens = self.tokens(context, self.heads[key], True) if context.tokens is not None else []
        self.lines.append(f"syntax cluster {cluster[1:]} contains={','.join([*members, *tokens])}")
        if context.tokens is not None and not context.starts:
            self.first += self.lines  # what can be in a list is not what comes after it
            self.lines = outer
        else:
            self.lines = [*outer, *self.lines]
        return self.heads[key]

    def tokens(self, context: Context, following: tuple[str, ...], contained: bool) -> list[str]:
        """The tokens of a list, each where the grammar has a token of the list."""
        assert context.tokens is not None
        language, terminal = context.tokens
        return [
            self.match(rf"(?={enclosed(terminal)}){enclosed(pattern)}", kind, following, contained)
            for pattern, kind in TOKENS[language]
        ]

    def phrases(self, context: Context, following: tuple[str, ...], contained: bool) -> list[str]:
        """The phrases of a context; `following` is what may come after one that enters nothing."""
        top = _Node()
        for phrase in context.phrases:
            _enter(top, phrase.pieces, phrase)
        found: list[str] = []
        # After a list of tokens come the phrases of its entry, unless that entry is a list itself.
        after_it = following if context.tokens is None else ()
        for piece, node in top.children.items():
            if context.is_body:
                starts = [phrase.start for phrase in context.phrases if phrase.pieces[0] == piece]
                guard = f"(?={either(starts)})"
            else:
                guard = _not_another(context, piece)
            found += self.chain(piece, node, following, after_it, guard, contained)
        return found

    def chain(
        self,
        piece: Piece,
        node: _Node,
        following: tuple[str, ...],
        after_it: tuple[str, ...],
        guard: str = "",
        contained: bool = True,
    ) -> list[str]:
        """The items of a token and of all that may follow it."""
        if piece.pattern.startswith(r"\{") and node.enters:
            return [self.braces(piece, node.enters[0], following)]
        then: list[str] = []
        for child, below in node.children.items():
            then += self.chain(child, below, following, after_it)
        if node.goes_on:
            then += following
        for name in node.enters:
            then += self.entry(name, after_it)
        after = ""
        if _is_name(piece) and node.children and not node.goes_on and not node.enters:
            # Not the beginning of something else that begins with a name, too.
            after = rf"(?=\s*(?:{either([child.pattern for child in node.children])}))"
        return [
            self.match(f"{guard}{enclosed(pattern)}{after}", kind, then, contained)
            for pattern, kind in piece.options
        ]

    def braces(self, piece: Piece, name: str, following: tuple[str, ...]) -> str:
        """The region of a body, or of the content of a message; `following` may come after content only."""
        self.body(name)
        then = self.then(following) if name == CONTENT else ""
        key = f"region {name}{then}"
        if key not in self.heads:
            group = self.group("Punctuation")
            self.heads[key] = (group,)
            fold = "" if then else " fold"
            self.lines.append(
                f"syntax region {group} matchgroup=asemePunctuation start=/\\v{vim(piece.pattern)}/ end=/}}/"
                f" contained transparent{fold} contains={_cluster(name)}{then}"
            )
        return self.heads[key][0]


def _cluster(name: str) -> str:
    return "@aseme" + "".join(part[:1].upper() + part[1:] for part in name.split())


def _enter(node: _Node, pieces: Sequence[Piece], phrase: Phrase) -> None:
    """Lay the pieces of a phrase into the tree of phrases."""
    head, *others = pieces
    child = node.children.setdefault(_met(head), _Node())
    if head.optional and others:
        _enter(node, others, phrase)
    if others:
        _enter(child, others, phrase)
    if all(piece.optional for piece in others):
        child.goes_on = child.goes_on or not phrase.enters
        if phrase.enters and phrase.enters not in child.enters:
            child.enters.append(phrase.enters)


def _met(piece: Piece) -> Piece:
    """The same token, which has been met."""
    return Piece(piece.options)


def _is_name(piece: Piece) -> bool:
    return any(kind in (Kind.NAME, Kind.BLOCK, Kind.TYPE, Kind.REFERENCE) for _, kind in piece.options)


def _not_another(context: Context, piece: Piece) -> str:
    """What keeps the beginning of another entry from being taken for a part of this one."""
    words = [start.start for start in context.starts or () if start.pieces[0].is_word]
    names = [start.start for start in context.starts or () if not start.pieces[0].is_word]
    found = [*words, *names] if _is_name(piece) else []
    return f"(?!{either(found)})" if found else ""
