"""Random protocols of two or three participants, small enough for any checker, often with a mistake."""

from __future__ import annotations

from random import Random

from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import has_errors
from aseme_dsl.source import Source

_ACTS = ("request", "inform", "agree", "refuse", "propose")


def talk_of(chance: Random, *, timed: bool = True) -> str:
    """The text of a protocol without errors; `timed`: with deadlines in some of them."""
    while True:
        text = _talk(chance, timed)
        found = analyse(Source("talk.aseme", text), {})
        if found.system is not None and not has_errors(found.diagnostics):
            return text


def _talk(chance: Random, timed: bool) -> str:
    names = ["alice", "bob", "carol"][: chance.choice((2, 2, 2, 3))]
    acts = chance.sample(_ACTS, chance.randint(2, 4))
    parts: list[str] = []
    controls: list[str] = []
    for place, name in enumerate(names):
        others = [other for other in names if other != name]
        process, lines = _process(chance, name, others, acts, starts=place == 0, timed=timed)
        flag = "    var free : bool\n" if any("[free]" in line for line in lines) else ""
        parts.append(f"  participant {name} {{\n{flag}    process = {process}\n  }}\n")
        controls.append(f"  control {name} {{\n" + "".join(f"    {line}\n" for line in lines) + "  }\n")
    whole = "".join(parts) + "".join(controls)
    return f"system Talks\nmessage Word {{ int n }}\naip talk {{\n{whole}}}\n"


def _process(
    chance: Random, name: str, others: list[str], acts: list[str], *, starts: bool, timed: bool
) -> tuple[str, list[str]]:
    terms: list[str] = []
    lines: list[str] = []

    def said() -> str:
        return f"send {chance.choice(acts)} Word {{ n = {chance.randint(1, 2)} }} to {chance.choice(others)}"

    def heard() -> str:
        return f"{chance.choice(acts)} Word from {chance.choice(others)}"

    for place in range(chance.randint(2, 3)):
        one, two = f"{name[0].upper()}{place}x", f"{name[0].upper()}{place}y"
        action = f" / {said()}" if chance.random() < 0.6 else ""
        form = chance.choice(("one", "choice", "option"))
        if place == 0:
            terms.append(one)
            lines.append(f"enter {one} : / {said()}" if starts else f"enter {one} : {heard()}")
        elif form == "one":
            terms.append(one)
            if chance.random() < 0.6:
                lines.append(f"enter {one} : {heard()}{action}")
            elif action:
                lines.append(f"enter {one} : {action}")
        elif form == "choice":
            terms.append(f"({one} | {two})")
            if chance.random() < 0.4:
                lines += [f"enter {one} : [free]{action}", f"enter {two} : else / {said()}"]
            else:
                late = "after(5s)" if timed and chance.random() < 0.4 else heard()
                lines += [f"enter {one} : {heard()}{action}", f"enter {two} : {late}"]
        else:
            terms.append(f"[{one}]")
            if chance.random() < 0.5:
                lines += [f"enter {one} : [free]{action}", f"skip {one} : else"]
            else:
                late = "after(5s)" if timed and chance.random() < 0.5 else heard()
                lines += [f"enter {one} : {heard()}{action}", f"skip {one} : {late}"]
    return " . ".join(terms), lines


__all__ = ["talk_of"]
