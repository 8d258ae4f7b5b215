"""The same programs written in other ways: random blanks, line breaks and comments between the tokens."""

from __future__ import annotations

import random
import re
from typing import Any

from aseme_dsl.grammar.parsing.parse import parse_with_leaves
from aseme_dsl.source import Source

_IN_A_TOKEN = re.compile(r"\s+")


def leaves(text: str) -> list[tuple[str, str, int]]:
    """The tokens of a text that has no mistake: the terminal's name, the token, and where it begins."""
    tree, _, diagnostics = parse_with_leaves(Source("test.aseme", text))
    assert not diagnostics, diagnostics
    found: list[tuple[str, str, int]] = []
    todo: list[Any] = [tree]
    while todo:
        item = todo.pop()
        if isinstance(item, list):
            todo.extend(reversed(item))
        elif item.value:
            found.append((item.rule_name, str(item.value), item.value.start))
    return found


def tokens(text: str) -> list[str]:
    """The tokens of a text as the canonical layout has them: the sequence that formatting must not change."""
    found = []
    for terminal, token, _ in leaves(text):
        if terminal == "Separator":
            continue
        if token in ("ω", "^ω"):
            token = "~"
        found.append(token if token.startswith('"') else _IN_A_TOKEN.sub("", token))
    return found


def comments(text: str) -> list[str]:
    """The comments of a text; blanks at the ends of lines do not count."""
    _, found, _ = parse_with_leaves(Source("test.aseme", text))
    texts = (comment.text.replace("\r\n", "\n") for comment in found)
    return [text.rstrip() if text.startswith("//") else text for text in texts]


GAPS = ("", " ", "  ", "\n", "\n\n", "\n\n\n", "\t", " \n ", "\n    ")
COMMENTS = ("// c{0}\n", "/* c{0} */", "/* c{0}  \n more */", "//\n", "// asemec: allow(W300) c{0}\n", "/**/")
IN_PATHS = (" . ", ". ", " .", " /* in a path */ . ", "\n.", " // in a path\n .")


def relaid(text: str, choose: random.Random, often: float, commented: float) -> str:
    """The same tokens with other things between them: in each gap, with the probability `often`.

    Comments of the text stay; new ones are in `commented` of the changed gaps. The result need not be valid:
    in a few places a new line does mean something.
    """
    parts: list[str] = []
    end = 0
    for number, (terminal, token, start) in enumerate([*leaves(text), ("", "", len(text))]):
        gap = text[end:start]
        if choose.random() < often and "//" not in gap and "/*" not in gap:
            new = choose.choice(GAPS)
            if choose.random() < commented:
                new += choose.choice(COMMENTS).format(number) + choose.choice(GAPS)
            gap = new or (" " if gap else "")
            if gap.startswith("/") and parts and parts[-1].endswith("/"):
                gap = f" {gap}"  # behind the `/` of an action, `/*` would begin with `//`
        end = start + len(token)
        token = text[start:end]
        is_path = (terminal.endswith("Token") or terminal == "Path") and token[:1].isalpha() and "." in token
        if is_path and choose.random() < often / 2:
            token = token.replace(".", choose.choice(IN_PATHS))
        if terminal == "Separator" and choose.random() < often:
            token = choose.choice(",;")
        parts += [gap, token]
    return "".join(parts)


def lengthened(text: str, times: int) -> str:
    """The same with longer names, so that lines must be broken."""
    return re.sub(r"\b[A-Z][a-z]\w+", lambda name: name[0] * times, text)


def mutated(text: str, choose: random.Random) -> str:
    """The text with one token deleted, doubled, swapped with the next, or misspelt."""
    found = leaves(text)
    index = choose.randrange(len(found) - 1)
    _, token, start = found[index]
    end = start + len(token)
    match choose.randrange(4):
        case 0:
            return text[:start] + text[end:]
        case 1:
            return text[:end] + " " + text[start:]
        case 2:
            _, other, other_start = found[index + 1]
            return text[:start] + other + text[end:other_start] + token + text[other_start + len(other) :]
        case _:
            return text[: end - 1] + choose.choice("xyz_9") + text[end:]
