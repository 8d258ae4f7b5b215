"""The language as textX and its third-party generators see it."""

from __future__ import annotations

import subprocess
import sys
import threading
from pathlib import Path

import pytest
import textx

from tests.grammar.reading import ACCEPTANCE, read, short

BROKEN = "system X\nsrm a { liveness { a = A . . B } }\nsrmm b { }\n"


def run(*arguments: str) -> subprocess.CompletedProcess[str]:
    script = Path(sys.executable).with_name("textx")
    return subprocess.run([str(script), *arguments], capture_output=True, text=True, check=False)


def test_the_language_is_registered() -> None:
    language = textx.language_description("aseme")
    assert (language.name, language.pattern) == ("aseme", "*.aseme")
    listed = run("list-languages")
    assert "aseme (*.aseme)" in listed.stdout + listed.stderr


def test_textx_check(tmp_path: Path) -> None:
    found = run("check", *map(str, ACCEPTANCE))
    assert found.returncode == 0, found.stderr
    broken = tmp_path / "broken.aseme"
    broken.write_text(BROKEN)
    found = run("check", str(broken))
    assert found.returncode == 1
    assert f"{broken}:2:28: expected an activity" in found.stdout + found.stderr
    assert f"{broken}:3:1: 'srmm' is not a word" in found.stdout + found.stderr


def test_the_grammar_alone_refuses_mistakes_too(tmp_path: Path) -> None:
    """The recovery is the compiler's: to plain textX the grammar has no alternative that accepts junk."""
    grammar = Path(textx_grammar())
    metamodel = textx.metamodel_from_file(grammar, autokwd=True)
    for path in ACCEPTANCE:
        metamodel.model_from_file(path)
    for text in (BROKEN, "srm a {", "srm a }", "aip a { outcome 3 }", "system A }"):
        with pytest.raises(textx.TextXSyntaxError):
            metamodel.model_from_str(text)


def textx_grammar() -> str:
    import aseme_dsl.grammar

    return str(Path(aseme_dsl.grammar.__file__).with_name("aseme.tx"))


def test_a_model_for_third_parties() -> None:
    metamodel = textx.metamodel_for_language("aseme")
    model = metamodel.model_from_str("system A\nsrm r { liveness { r = A . B } }  // c")
    system, role = model.declarations
    assert (type(system).__name__, system.name) == ("System", "A")
    formula = role.entries[0].formulas[0]
    assert (formula.name, list(formula.tokens)) == ("r", ["A", ".", "B"])
    assert textx.get_location(role)["line"] == 2
    assert textx.get_children_of_type("Formula", model) == [formula]


def test_a_third_party_generator(tmp_path: Path) -> None:
    found: list[str] = []

    def generate(metamodel: object, model: object, output_path: str, overwrite: bool, debug: bool) -> None:
        found.extend(str(item.name) for item in model.declarations if hasattr(item, "name"))  # type: ignore[attr-defined]

    textx.register_generator("aseme", "names", "The names of a file", generate)
    try:
        path = ACCEPTANCE[-1]
        model = textx.metamodel_for_file(str(path)).model_from_file(str(path))
        textx.generator_for_language_target("aseme", "names")(None, model, str(tmp_path), True, False)
    finally:
        textx.clear_generator_registrations()
    assert found == ["TestBehavior", "PlayerState", "GameState", "Ball", "game", "vision", "TestBehavior"]


def test_all_mistakes_are_in_the_error() -> None:
    with pytest.raises(textx.TextXSyntaxError) as raised:
        textx.metamodel_for_language("aseme").model_from_str(BROKEN)
    assert (raised.value.line, raised.value.col) == (2, 28)
    assert raised.value.message.count("\n") == 1


def test_parsing_in_threads() -> None:
    text = ACCEPTANCE[1].read_text("utf-8")
    expected = short(read(text).declarations)
    wrong: list[object] = []

    def work() -> None:
        for _ in range(5):
            if short(read(text).declarations) != expected:
                wrong.append(text)

    threads = [threading.Thread(target=work) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong
