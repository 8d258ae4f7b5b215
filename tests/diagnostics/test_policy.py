"""How bad a project finds each kind of problem."""

from __future__ import annotations

from pathlib import Path

from aseme_dsl.diagnostics import Diagnostic, Policy, Setting, Severity
from aseme_dsl.source import Source, Span
from tests.support.worded import worded

OFF, NOTE, WARNING, ERROR = None, Severity.NOTE, Severity.WARNING, Severity.ERROR


def at(code: str, path: str = "team.aseme") -> Diagnostic:
    return worded(code, "…", Span(Source(path, "text"), 0, 4))


def severities(policy: Policy, *items: Diagnostic) -> list[str]:
    return [f"{item.code} {item.severity}" for item in policy.apply(items)]


def test_a_code_is_as_bad_as_the_policy_says() -> None:
    policy = Policy((Setting("W300", ERROR), Setting("N700", WARNING), Setting("W301", OFF)))
    found = severities(policy, at("W300"), at("N700"), at("W301"), at("W400"))
    assert found == ["W300 error", "N700 warning", "W400 warning"]


def test_the_longest_code_counts() -> None:
    policy = Policy((Setting("W300", NOTE), Setting("W3", ERROR), Setting("W", OFF)))
    assert severities(policy, at("W300"), at("W301"), at("W400")) == ["W300 note", "W301 error"]


def test_of_one_code_the_setting_for_particular_files_counts(tmp_path: Path) -> None:
    policy = Policy((Setting("W3", NOTE, "drafts/*"), Setting("W3", ERROR), Setting("W3", OFF)), tmp_path)
    draft = at("W300", str(tmp_path / "drafts" / "old" / "team.aseme"))
    assert severities(policy, draft, at("W300", str(tmp_path / "team.aseme"))) == ["W300 note"]
    unread = worded("W001", "…", None, path=str(tmp_path / "drafts" / "x.aseme"))
    assert severities(Policy((Setting("W", OFF, "drafts/x*"),), tmp_path), unread, at("W300", "/else")) == [
        "W300 warning"
    ]


def test_an_error_stays_an_error() -> None:
    assert severities(Policy((Setting("E", OFF), Setting("E200", NOTE))), at("E200")) == ["E200 error"]
