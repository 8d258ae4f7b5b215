"""`asemec explain`."""

from __future__ import annotations

import pytest

from aseme_dsl.diagnostics import CODES, GROUPS
from tests.cli.support import Here


def test_the_page_of_a_code(here: Here) -> None:
    done = here("explain", "E200")
    assert (done.code, done.err) == (0, "")
    lines = done.out.splitlines()
    assert lines[0] == "error[E200]: unknown name"
    wrong, right = lines.index("Wrong:"), lines.index("Right:")
    assert "        leave  Look : [pases >= 3]" in lines[wrong:right]
    assert "  team.aseme:7:20: error[E200]: there is no variable or let `pases`" in lines[wrong:right]
    assert "        leave  Look : [passes >= 3]" in lines[right:]


@pytest.mark.parametrize("written", ["e200", "error[E200]", "[e200]"])
def test_a_code_as_people_copy_it(here: Here, written: str) -> None:
    assert here("explain", written).out == here("explain", "E200").out


def test_several_codes_each_once(here: Here) -> None:
    done = here("explain", "W300", "E200", "W300")
    assert [line for line in done.out.splitlines() if line.startswith(("error[", "warning["))] == [
        f"warning[W300]: {CODES['W300'].title}",
        f"error[E200]: {CODES['E200'].title}",
    ]


def test_an_example_of_several_files_names_them(here: Here) -> None:
    out = here("explain", "E005").out
    assert "\n  team.aseme:\n" in out
    assert "\n  messages.aseme:\n" in out


def test_commands_are_shown_with_what_they_say(here: Here) -> None:
    out = here("explain", "E001").out
    assert "    $ asemec check taem.aseme\n    taem.aseme: error[E001]" in out


def test_the_text_is_as_wide_as_the_terminal(here: Here, monkeypatch: pytest.MonkeyPatch) -> None:
    for columns, widest in (("60", 60), ("300", 100)):
        monkeypatch.setenv("COLUMNS", columns)
        lines = here("explain", "E200").out.split("Wrong:")[0].splitlines()
        assert widest - 25 < max(map(len, lines)) <= widest


def test_all_codes_by_group(here: Here) -> None:
    lines = here("explain").out.splitlines()
    assert [line for line in lines if line in GROUPS.values()] == list(GROUPS.values())
    for code, item in CODES.items():
        assert f"  {code}  {item.title}" in lines


@pytest.mark.parametrize(("written", "words"), [("E2000", "Did you mean 'E200'?"), ("misspelt", "lists all")])
def test_an_unknown_code_is_wrong_use(here: Here, written: str, words: str) -> None:
    done = here("explain", written)
    assert done.code == 2
    assert words in done.err
    assert done.out == ""


def test_json(here: Here) -> None:
    (entry,) = here("explain", "--json", "E200").json["codes"]
    assert (entry["code"], entry["severity"], entry["title"]) == ("E200", "error", "unknown name")
    assert entry["group"] == "Names and declarations"
    (found,) = entry["wrong"]["diagnostics"]
    assert found["fix"] == "passes"
    assert entry["right"]["diagnostics"] == []
    assert [item["code"] for item in here("explain", "--json").json["codes"]] == list(CODES)


def test_colour_is_only_added(here: Here) -> None:
    done = here("explain", "E200", "--color", "always")
    assert "\x1b[31m\x1b[1merror[E200]" in done.out
    assert "\x1b" not in here("explain", "E200", "--color", "auto").out


def test_a_group_of_codes(here: Here) -> None:
    done = here("explain", "W41", "--json")
    assert [item["code"] for item in done.json["codes"]] == ["W410", "W411", "W412"]
    assert here("explain", "W9").code == 2
