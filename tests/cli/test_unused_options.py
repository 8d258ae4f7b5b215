"""Options that have no effect in a call, and agents that are not there, are refused and never ignored."""

from __future__ import annotations

from pathlib import Path

import pytest

from aseme_dsl.cli.run import command as run
from tests.cli.support import Here

TEAM = """system Team
srm player { liveness { player = Look }  activities { Look takes 1s } }
team Players { bob : player  ann : player }
"""


@pytest.fixture
def built(here: Here, folder: Path) -> Here:
    (folder / "team.aseme").write_text(TEAM)
    assert here("run", "team.aseme", "--quiet").code == 0
    return here


def test_a_name_for_the_agent_of_no_plan_is_refused(built: Here) -> None:
    done = built("run", "team.aseme", "--agent", "nobody")
    assert done.code == 2
    assert "error[E028]: `--agent` has no effect without `--role`" in done.err
    assert built("run", "team.aseme", "--role", "player", "--agent", "nobody", "-q").code == 0


@pytest.mark.parametrize(
    "options", [("-o", "other"), ("--templates", "other"), ("--force",), ("--backend", "jade_like")]
)
def test_what_only_a_build_takes_is_refused_of_an_output_folder(
    built: Here, folder: Path, options: tuple[str, ...]
) -> None:
    done = built("run", "out", *options)
    assert done.code == 2
    said = " ".join(options) if options[0] == "--backend" else options[0]
    assert f"out: error[E028]: `{said}` has no effect" in done.err
    assert "hint:" in done.err
    assert built("run", "out", *options, "--json").json["diagnostics"][0]["code"] == "E028"
    assert not (folder / "other").exists()


def test_a_backend_that_was_built_is_taken(built: Here) -> None:
    assert built("run", "out", "--backend", "monas", "--quiet").code == 0
    assert built("run", "out", "--backend", "player=monas", "--quiet").code == 0


@pytest.mark.parametrize("options", [(), ("--lines",), ("-o", "some.jsonl")])
def test_an_agent_that_a_trace_does_not_have_is_an_error(built: Here, options: tuple[str, ...]) -> None:
    done = built("trace", "out", "--agent", "bobb", *options)
    assert done.code == 1
    assert "error[E029]: the trace has nothing about an agent `bobb`" in done.err
    assert "did you mean `bob`?" in done.err
    assert built("trace", "out", "--agent", "bob", *options).code == 0


@pytest.mark.parametrize("command", ["build", "run"])
@pytest.mark.parametrize(("name", "what"), [("team.aseme", "is a file"), ("nowhere", "does not exist")])
def test_templates_that_are_no_folder_are_an_error(built: Here, command: str, name: str, what: str) -> None:
    done = built(command, "team.aseme", "--templates", name)
    assert done.code == 1
    assert f"{name}: error[E030]: the folder of templates {what}" in done.err


def test_templates_of_a_project_that_are_no_folder_are_an_error(built: Here, folder: Path) -> None:
    (folder / "pyproject.toml").write_text('[tool.asemec]\nfiles = ["team.aseme"]\ntemplates = "nowhere"\n')
    done = built("build")
    assert (done.code, "error[E030]" in done.err) == (1, True)


def test_an_agent_that_sniff_finds_nowhere_is_an_error(built: Here) -> None:
    for options in ((), ("--json",), ("--follow",)):
        done = built("sniff", "out", "--agent", "bobb", *options)
        said = done.out if options == ("--json",) else done.err
        assert done.code == 1
        assert "E029" in said and "did you mean `bob`?" in said
    assert built("sniff", "out", "--agent", "bob").code == 0


def test_what_cannot_be_played_or_reached_has_a_code(built: Here, folder: Path) -> None:
    (folder / "input.jsonl").write_text('\n  {"at": "soon", "event": "goal"}\n{}\n')
    (folder / "no.jsonl").write_text("nothing\n")
    for arguments, code, said in [
        (("run", "team.aseme", "--input", "input.jsonl"), 1, "input.jsonl:2:3: error[E031]: 'soon' is no"),
        (("run", "team.aseme", "--input", "input.jsonl"), 1, "input.jsonl:3:1: error[E031]: a `channel`"),
        (
            ("node", "bobb", "team.aseme"),
            2,
            "error[E032]: there is no robot `bobb`\n   hint: did you mean `bob`?",
        ),
        (("node", "bob", "out", "--system", "Tam"), 2, "error[E032]: there is no system `Tam`"),
        (
            ("run", "out", "--role", "playr"),
            2,
            "error[E032]: no plan is called `playr`\n   hint: did you mean",
        ),
        (("run", "out", "--body", "bobb=a:b"), 1, "error[E032]: there is no agent `bobb` for a body"),
        (("run", "out", "--world", "nowhere:world"), 1, "out: error[E033]: no function world"),
        (("team", "status", "-o", "out"), 1, "out: error[E034]: nothing runs from out"),
        (("team", "status", "-o", "out", "--key", "no.jsonl"), 1, "out: error[E034]: no.jsonl"),
        (("team", "switch", "bob", "player", "-o", "out"), 1, "out: error[E034]: nothing runs from out"),
        (("team", "swap", "team.aseme", "-o", "out"), 1, "out: error[E034]: nothing has changed:"),
        (("trace", "no.jsonl"), 1, "no.jsonl: error[E035]: no.jsonl:1: the header of a trace is wanted"),
        (("sniff", "no.jsonl"), 1, "no.jsonl: error[E035]: no.jsonl:1: the header of a trace is wanted"),
        (("key", "no.jsonl"), 1, "no.jsonl: error[E009]: no.jsonl is there already"),
    ]:
        done = built(*arguments)
        assert (done.code, said in done.err) == (code, True), (arguments, done.err)
    told = built("run", "team.aseme", "--input", "input.jsonl", "--json").json
    assert [item["code"] for item in told["diagnostics"]] == ["E031", "E031"]


VALUES = {
    "--output": ("other",), "--role": ("player",), "--agent": ("bob",), "--for": ("1s",), "--seed": ("1",),
    "--platform": ("zenoh",), "--input": ("i.jsonl",), "--trace": ("t.jsonl",), "--state": ("m",),
    "--activities": ("a",), "--templates": ("a",), "--world": ("a:b",), "--backend": ("monas",),
    "--body": ("a:b",), "--allow": ("waiting",), "--color": ("never",), "--network": ("delay=1s",),
}  # fmt: skip
"""What the options that take a value are given."""
LISTED = {"--list", "--output", "--templates", "--backend", "--activities", "--force", "--json", "--color"}


@pytest.mark.parametrize("option", [max(item.opts, key=len) for item in run.params if item.name != "target"])
def test_an_option_changes_the_list_of_plans_or_is_refused(built: Here, folder: Path, option: str) -> None:
    (folder / "a").mkdir()
    given = (option, *VALUES.get(option, ()))
    done = built("run", "team.aseme", "--list", *given)
    assert ("error[E028]" in done.err) == (option not in LISTED), done.err
    assert (done.code == 2) == (option not in LISTED)  # of --activities, it finds that a file is missing


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("run", "team.aseme", "-q", "-v"), "`--verbose` has no effect with `--quiet`"),
        (("node", "bob", "team.aseme", "-q", "-v"), "`--verbose` has no effect with `--quiet`"),
        (("node", "bob", "team.aseme", "--from", "out"), "`TARGET team.aseme` has no effect with `--from`"),
        (("node", "bob", "out", "-o", "other"), "`-o` has no effect on an output directory"),
        (("node", "bob", "--from", "out", "-o", "other"), "`-o` has no effect on an output directory"),
        (
            ("node", "bob", "team.aseme", "--system", "Team"),
            "`--system` has no effect on a target with one system",
        ),
        (("run", "out", "--process-per-agent", "--allow", "waiting"), "`--allow` has no effect where each"),
        (("sniff", "out", "--json", "--format", "svg"), "`--format` has no effect with `--json`"),
    ],
)
def test_options_without_effect_are_refused(built: Here, arguments: tuple[str, ...], said: str) -> None:
    done = built(*arguments)
    assert (done.code, "E028" in done.out + done.err, said in done.out + done.err) == (2, True, True), done
