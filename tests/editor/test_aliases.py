"""Files behind an alias in an editor: what is offered, shown and renamed."""

from __future__ import annotations

import pytest

from aseme_dsl.editor.answers.hover import hover
from aseme_dsl.editor.changes.rename import Refused, Renaming, edited, rename
from aseme_dsl.editor.files.known import known_in
from aseme_dsl.editor.files.view import View
from aseme_dsl.editor.files.workspace import Workspace
from aseme_dsl.editor.typing.completion import complete
from aseme_dsl.source import Source
from tests.compiler.test_aliases import BOTH, FILES

PATH = "/nowhere/both.aseme"


def opened(text: str) -> tuple[Workspace, View]:
    workspace = Workspace()
    for name, content in FILES.items():
        workspace.open(f"/nowhere/{name}", content)
    workspace.open(PATH, text)
    view = workspace.view(PATH)
    assert view is not None
    return workspace, view


def test_a_name_behind_an_alias_is_renamed_in_both_files() -> None:
    workspace, view = opened(BOTH)
    at = BOTH.index("alice.attacker") + len("alice.")
    shown = hover(view, at)
    assert shown is not None and "srm alice_attacker" in shown.text
    found = rename(workspace, view, at, "striker")
    assert isinstance(found, Renaming)
    assert sorted(found.edits) == ["/nowhere/alice.aseme", PATH]
    assert "x, y : alice.striker  z : bob.attacker" in edited(BOTH, found.edits[PATH])
    alice = edited(FILES["alice.aseme"], found.edits["/nowhere/alice.aseme"])
    assert "srm striker {" in alice and "one : striker" in alice


def test_what_an_alias_stands_for_is_shown() -> None:
    _, view = opened(BOTH)
    for place in (BOTH.index("alice.attacker") + 2, BOTH.index("as alice") + 3):
        found = hover(view, place)
        assert found is not None and found.span.text == "alice"
        assert 'import "alice.aseme" as alice' in found.text and "behind `alice.`" in found.text


@pytest.mark.parametrize(
    ("old", "new", "offered"),
    [
        ("x, y : alice.attacker", "x, y : ‸", {"alice.attacker", "bob.attacker", "judge"}),
        ("x, y : alice.attacker", "x, y : alice.‸", {"attacker"}),
        ("alice.Near near", "bob.‸", {"Near", "Side"}),
        ("&& alice.sees", "&& alice.‸", {"mates", "Side", "sees", "near"}),
        ("&& alice.sees", "&& alice.mates.‸", {"state"}),
    ],
)
def test_what_stands_behind_an_alias_is_offered(old: str, new: str, offered: set[str]) -> None:
    text = BOTH.replace(old, new, 1)
    _, view = opened(BOTH)
    offset = text.index("‸")
    items = complete(Source(PATH, text.replace("‸", "")), offset, known_in(view))
    assert {item.label for item in items} == offered


def test_an_alias_gets_another_name() -> None:
    workspace, view = opened(BOTH)
    for at in (BOTH.index("as alice") + 3, BOTH.index("x, y : alice") + len("x, y : ")):
        found = rename(workspace, view, at, "home")
        assert isinstance(found, Renaming)
        assert list(found.edits) == [PATH]
        after = edited(BOTH, found.edits[PATH])
        assert 'import "alice.aseme" as home' in after and "alice." not in after.replace("alice.aseme", "")
        assert after.count("home.") == BOTH.replace("alice.aseme", "").count("alice.")


@pytest.mark.parametrize("name", ["bob", "judge", "2nd"])
def test_an_alias_that_is_taken(name: str) -> None:
    workspace, view = opened(BOTH)
    assert isinstance(rename(workspace, view, BOTH.index("as alice") + 3, name), Refused)
