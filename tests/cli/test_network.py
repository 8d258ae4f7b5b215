"""`--network` and the project's `network`: what they do to a run, and what is refused."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.support import Here
from tests.support.traces import records_of

TEAM = """system Team
message Note { int n }
topic line { state Note }
srm speaker {
  liveness { speaker = Speak . Rest }
  activities { Speak takes 100ms simulated  Rest takes 1s simulated }
  control speaker { enter Rest : / line.state.Note.n = 1; write_messages.line.state.Note }
}
srm hearer {
  liveness { hearer = Wait . Hear }
  activities { Wait takes 1min simulated  Hear takes 100ms simulated }
  control hearer { enter Hear : when [line.state.Note.n == 1] }
}
team T { ann : speaker  bob : hearer }
"""
PROJECT = """[tool.asemec]
files = ["team.aseme"]
[tool.asemec.run]
network = "{words}"
"""


@pytest.fixture
def team(here: Here, folder: Path) -> Here:
    (folder / "team.aseme").write_text(TEAM)
    return here


def hears(folder: Path) -> float:
    lines = records_of(folder / "out" / "trace.jsonl.gz")
    return next(
        line["time"] / 1e9
        for line in lines
        if line["kind"] == "activity" and (line["what"], line["activity"]) == ("start", "Hear")
    )


def test_messages_are_late(team: Here, folder: Path) -> None:
    assert team("run", "team.aseme", "--quiet").code == 0
    assert hears(folder) == 0.1
    done = team("run", "team.aseme", "--network", "delay=50ms", "--quiet")
    assert (done.code, hears(folder)) == (0, 0.15)
    assert "(virtual, seed 1, network delay 50ms)" in done.out
    assert team("run", "out", "--network", "delay 1s", "--json").json["result"]["network"] == "delay 1s"
    assert hears(folder) == 1.1
    assert team("run", "out", "--json").json["result"]["network"] is None


def test_the_project_says_it_and_the_option_overrides_it(team: Here, folder: Path) -> None:
    (folder / "pyproject.toml").write_text(PROJECT.format(words="delay=200ms"))
    assert team("run", "--quiet").code == 0
    assert hears(folder) == 0.3
    assert team("run", "--quiet", "--network", "delay=0ms").code == 0
    assert hears(folder) == 0.1


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("", "a network is described by `delay`, `loss` and `reorder`"),
        ("delay=50ms,", "a network is described by"),
        (",,", "a network is described by"),
        ("=", "a network is described by"),
        ("latency=50ms", "`latency` does not describe a network"),
        ("delay", "`delay` has no value"),
        ("delay=50", "`50` is not a delay"),
        ("delay=50us", "`50us` is not a delay"),
        ("delay=-50ms", "`-50ms` is not a delay"),
        ("delay=1..2..3s", "`1..2..3s` is not a delay"),
        ("delay=99999min", "`99999min` is not a delay"),
        ("delay=300ms..0ms", "the range of delays `300ms..0ms` is empty"),
        ("loss", "`loss` has no value"),
        ("loss=10", "`10` is not a loss"),
        ("loss=100%", "`100%` is not a loss"),
        ("loss=1e3%", "`1e3%` is not a loss"),
        ("delay=0..1s,reorder=yes", "`reorder` takes no value, but has `yes`"),
        ("delay=0..1s,delay=1s", "`delay` is given twice"),
        ("delay=1s,reorder", "`reorder` has no effect without a range of delays"),
        ("reorder", "`reorder` has no effect without a range of delays"),
        ("\x1b[31m", "a network is described by"),
        ("délai=1s", "`délai` does not describe a network"),
        ("delay=\x1b1s", "`delay` has no value"),
        ("delay=" + "9" * 5000 + "ms", "a network is described by"),
        ("delay=٣ms", "`٣ms` is not a delay"),
    ],
)
def test_words_that_mean_nothing_are_refused(team: Here, folder: Path, words: str, said: str) -> None:
    done = team("run", "team.aseme", "--network", words)
    assert (done.code, done.out) == (2, "")
    assert "error[E036]: " in done.err and said in done.err and "hint: " in done.err, done.err
    assert "\x1b" not in done.err
    data = team("run", "team.aseme", "--network", words, "--json").json
    assert [item["code"] for item in data["diagnostics"]] == ["E036"]
    assert team("optimise", "team.aseme", "--measure", "time", "--network", words).code == 2
    if words.isprintable() and len(words) < 100:
        (folder / "pyproject.toml").write_text(PROJECT.format(words=words))
        checked = team("check")
        assert checked.code == 1 and "pyproject.toml:4:1: error[E036]: " in checked.err + checked.out


def test_a_number_is_not_words(team: Here, folder: Path) -> None:
    (folder / "pyproject.toml").write_text(PROJECT.format(words="").replace('""', "3"))
    done = team("check")
    assert "error[E010]: `network` must be words for a network in quotes" in done.err + done.out


@pytest.mark.parametrize(
    "options", [("--real",), ("--process-per-agent",), ("--platform", "zenoh"), ("--platform", "spade")]
)
def test_real_time_has_no_simulated_network(team: Here, options: tuple[str, ...]) -> None:
    done = team("run", "team.aseme", "--network", "delay=50ms", *options)
    assert done.code == 2
    text = f"error[E037]: `--network` simulates a network in virtual time, not with `{' '.join(options)}`"
    assert text in done.err
    data = team("run", "team.aseme", "--network", "delay=50ms", *options, "--json").json
    assert [item["code"] for item in data["diagnostics"]] == ["E037"]


def test_in_real_time_the_projects_network_is_noted(team: Here, folder: Path) -> None:
    (folder / "team.aseme").write_text(TEAM.replace("takes 1s", "takes 1ms"))
    (folder / "pyproject.toml").write_text(PROJECT.format(words="delay=200ms"))
    done = team("run", "--real", "--quiet", "--for", "2s")
    assert done.code == 0
    said = "the network `delay 200ms` of the project is not simulated in real time"
    assert f"pyproject.toml:4:1: note[N770]: {said}" in done.err


def test_one_agent_has_no_network(team: Here, folder: Path) -> None:
    done = team("run", "team.aseme", "--role", "speaker", "--network", "delay=50ms")
    assert done.code == 2
    assert "error[E028]: `--network` has no effect with `--role`" in done.err
    (folder / "pyproject.toml").write_text(PROJECT.format(words="delay=200ms"))
    assert team("run", "--role", "speaker", "--quiet").code == 0


def test_a_study_has_one_too(team: Here, folder: Path) -> None:
    times = []
    for words in ("delay=0ms", "delay=1s"):
        done = team(
            "optimise", "team.aseme", "--measure", "time", "--runs", "1", "-j", "1", "--quicker", "1",
            "--network", words, "--json",
        )  # fmt: skip
        assert done.code == 0, done.err
        times.append(done.json["result"]["runs"][0]["time"])
        assert done.json["result"]["network"] == words.replace("=", " ")
        report = (folder / "out" / "optimise" / "report.md").read_text()
        assert f"over a network with {words.replace('=', ' ')}" in report
    assert times == [1_100_000_000, 1_200_000_000]
