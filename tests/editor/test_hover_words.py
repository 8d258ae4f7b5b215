"""What an editor shows of the words and operators of the language."""

from __future__ import annotations

from pathlib import Path

import pytest

from aseme_dsl.amola.operators import Operator
from aseme_dsl.editor.answers.constructs import constructs, meanings, words
from aseme_dsl.editor.answers.hover import hover
from aseme_dsl.grammar.formulas.expression import BINDING
from aseme_dsl.grammar.text.lexer import Tokens
from tests.editor.authoring import opened

FORMULA_SIGNS = sorted(
    {
        sign
        for item in Operator
        for sign in (Tokens(item.value).word(index) for index in range(len(Tokens(item.value))))
        if not sign[0].isalnum() and sign not in "()"
    }
    | {"[", "?", "ω"}
)

TEXT = """\
system T // the system
enum Light { RED GREEN }
message Note { optional int number  repeated string names }
topic board { state Note every 33ms queued }
let low = !has(board.state.Note) || board.state.Note.number <= 3 and true
srm robot {
  var tries : int = 0
  liveness {
    robot = ((walk || Look) | Wait)~
    walk  = [Step] . Rest+ . Talk* [> Halt
  }
  control robot {
    enter (walk || Look) : [low && tries * 2 > 1] / tries = tries + 1; tries += index; start_timer(pace, 1s)
    enter Wait           : else
    finish walk          : when [expired(pace)] or after(5s)
  }
  activities { Step takes 1s  Rest within 5s ends held, slipped }
}
team T { one : robot }
"""


def shown(marked: str, text: str = TEXT) -> str:
    """What is shown at the `^` in a piece of the text."""
    before, _, behind = marked.partition("^")
    found = hover(opened(text), text.index(before + behind) + len(before))
    return "" if found is None else f"{found.span.text}\n{found.text}"


@pytest.mark.parametrize("word", sorted(words()))
def test_every_word_means_something(word: str) -> None:
    assert meanings(word, ()), f"a row for `{word}` in docs/reference/language/constructs.md"


@pytest.mark.parametrize("sign", FORMULA_SIGNS)
def test_every_operator_of_formulas_means_something(sign: str) -> None:
    found = meanings(sign, ("Formulas",))
    assert found and {item.section for item in found} == {"Formulas"}


@pytest.mark.parametrize("sign", sorted({*BINDING, "!", "and", "or", "not"}))
def test_every_operator_of_expressions_means_something(sign: str) -> None:
    found = meanings(sign, ("Values",))
    assert found and {item.section for item in found} == {"Values"}


def test_no_row_is_lost() -> None:
    text = (Path(__file__).parents[2] / "docs/reference/language/constructs.md").read_text("utf-8")
    assert len(constructs()) == sum(line.startswith("| `") for line in text.splitlines())


@pytest.mark.parametrize(
    ("marked", "says"),
    [
        ("walk ^|| Look) |", "||\n`A || B`: both at the same time"),
        ("Look) ^| Wait", "|\n`A | B`: one of them"),
        ("Wait)^~", "~\n`A~`: A for ever"),
        ("Step] ^. Rest", ".\n`A . B`: A, then B"),
        ("Rest^+", "+\n`A+`: A once or more"),
        ("Talk* ^[> Halt", "[>\n`A [> B`: A, which B may interrupt"),
        ("^[Step]", "[\n`[A]`: A, or nothing"),
        ("low ^&& tries", "&&\n`a && b` `a and b`: both hold"),
        ("Note) ^|| board", "||\n`a || b` `a or b`: at least one"),
        ("number ^<= 3", "<=\n`a < b`"),
        ("tries ^* 2", "*\n`a * b` `a / b` `a % b`: product"),
        ("tries ^+ 1", "+\n`a + b`"),
        ("tries ^+= index", "+=\n`tries += 1` `tries -= 1` `tries *= 2`: adding"),
        ("+= ^index", "index\n`index`: which agent"),
        ("^control robot {", "control\n`control work { … }`"),
        ("^enter Wait", "enter\n"),
        ("1] ^/ tries", "/\n`enter T : event [c] / a; b`: an event"),
        ("+ 1^; tries", ";\n`enter T : event [c] / a; b`: an event"),
        ("^else", "else\n`else`: nothing else is open"),
        ("^after(5s)", "after\n"),
        ("^liveness {", "liveness\n"),
        ("33ms ^queued", "queued\n`signal Whistle` `queued`: once"),
        ("Note ^every", "every\n`state Ball every 33ms`: at most so often"),
        ("Rest ^within", "within\n`Grasp within 5s ends held, slipped`"),
        ("^team T", "team\n`team NAME"),
        ("^optional int", "optional\n`message Ball"),
        ("^system T", "system\n`system NAME`"),
    ],
)
def test_what_is_shown(marked: str, says: str) -> None:
    assert says in shown(marked)


@pytest.mark.parametrize("marked", ["// the ^system", "GREEN ^}", "tak^es 1s}"])
def test_where_nothing_is_shown(marked: str) -> None:
    assert shown(marked, TEXT + "// it tak^es 1s}".replace("^", "")) == ""


def test_on_abandon_means_something() -> None:
    text = "system S\naip p {\n participant a { process = A }\n control a { on abandon : }\n}\n"
    assert "left before its END" in shown("on ^abandon", text)


def test_a_name_is_a_name() -> None:
    text = TEXT.replace("tries", "state")
    assert "var state" in shown("var ^state", text) or "variable" in shown("var ^state", text).lower()


def test_a_participant_without_lists_shows_what_its_lines_say() -> None:
    text = """system T
message Note { int n }
aip talk {
  participant one { process = Ask }
  participant two { process = Tell }
  control one { enter Ask : / send request Note { .. } to two  leave Ask : inform Note from two }
  control two { enter Tell : request Note from one  leave Tell : / send inform Note { .. } to one }
}
"""
    found = shown("participant ^two", text)
    assert "Sends `inform Note`" in found and "Receives `request Note`" in found
