"""`// asemec: allow(CODE) reason`: what is right as it is, and why."""

from __future__ import annotations

import pytest

from aseme_dsl.compiler import Options, analyse
from aseme_dsl.diagnostics import Policy, Setting, Severity
from aseme_dsl.source import Source
from tests.support.compiling import analysis, codes, printed


def guard(before: str = "", behind: str = "", top: str = "", formula: str = "Watch . Report || Sleep") -> str:
    """A system with W300 on the line that `before` stands above."""
    return (
        f"{top}\nsystem Guard\n\nsrm robot {{\n  liveness {{\n    {before}\n"
        f"    robot = {formula} {behind}\n  }}\n}}\n"
    )


class TestWhatItIsAbout:
    def test_the_next_line(self) -> None:
        found = analysis(guard("// asemec: allow(W300) it is read well"))
        assert found.diagnostics == ()
        (item,) = found.suppressed
        assert (item.diagnostic.code, item.reason, item.allow.text) == ("W300", "it is read well", "W300")

    def test_its_own_line(self) -> None:
        assert codes(guard(behind="// asemec: allow(W300) it is read well")) == []

    def test_the_file(self) -> None:
        text = guard(top="// the guard\n// asemec: allow-file(W300) it is read well")
        assert codes(text) == []

    def test_a_block(self) -> None:
        text = guard().replace("  liveness", "  // asemec: allow(W300) it is read well\n  liveness")
        assert codes(text) == []

    def test_a_declaration(self) -> None:
        text = guard().replace("srm", "// asemec: allow(W300) it is read well\nsrm")
        assert codes(text) == []

    def test_all_of_several_lines(self) -> None:
        text = guard("// asemec: allow(W300) it is", formula="\n  (Rest .\n  (Watch . Report || Sleep) )")
        assert codes(text) == []

    def test_blank_lines_and_comments_between_do_not_count(self) -> None:
        text = guard("// asemec: allow(W300) it is read well\n\n  /* on\n two lines */ // and\n")
        assert codes(text) == []

    def test_nothing_else(self) -> None:
        comment = "// asemec: allow(W300) it is read well"
        other = "srm other { liveness { other = Watch . Report || Sleep } }"
        assert codes(guard(comment) + other) == ["W300"]
        assert codes(guard().replace("  liveness", f"  var a : int = 0 {comment}\n  liveness")) == [
            "W011",
            "W300",
        ]
        assert sorted(codes(guard() + comment)) == ["W011", "W300"]

    def test_several_codes(self) -> None:
        text = guard("// asemec: allow(W301,W300 , N702) why not")
        assert [item.diagnostic.code for item in analysis(text).suppressed] == ["W300"]
        assert codes(text) == ["W011", "W011"]

    @pytest.mark.parametrize("end", ["\n", "\r\n"])
    def test_the_innermost_is_the_one_that_is_used(self, end: str) -> None:
        text = guard("// asemec: allow(W300) here", top="// asemec: allow-file(W300) everywhere")
        found = analysis(text.replace("\n", end))
        assert [item.reason for item in found.suppressed] == ["here"]
        assert [item.code for item in found.diagnostics] == ["W011"]


class TestWhatIsWrongWithIt:
    def test_no_reason(self) -> None:
        assert printed(guard("// asemec: allow(W300)")) == (
            "test.aseme:6:5: warning[W010]: this does not say why\n"
            " 6 |     // asemec: allow(W300)\n"
            "   |     ^^^^^^^^^^^^^^^^^^^^^^\n"
            "   hint: write after the bracket why it is right here\n"
        )

    def test_it_allows_nothing(self) -> None:
        text = guard("// asemec: allow(W300) it is read well", formula="Watch")
        (item,) = analysis(text).diagnostics
        assert item.code == "W011"
        assert [(edit.span.text, edit.text) for edit in item.changes] == [
            ("    // asemec: allow(W300) it is read well\n", "")
        ]

    def test_while_there_are_errors_nobody_knows_what_it_allows(self) -> None:
        text = guard("// asemec: allow(W300) it is read well", formula="Watch")
        assert codes(text.replace("system Guard", "system Guard team A { a : b }")) == ["E207"]

    def test_no_such_code(self) -> None:
        found = analysis(guard("// asemec: allow(w300) it is read well")).diagnostics
        assert [(item.code, item.fix) for item in found] == [("W012", "W300"), ("W300", None)]
        (item, _) = analysis(guard("// asemec: allow(W40) it is read well")).diagnostics
        assert item.fix is None

    @pytest.mark.parametrize("code", ["E200", "W011"])
    def test_what_cannot_be_allowed(self, code: str) -> None:
        assert codes(guard(f"// asemec: allow({code}) please", formula="Watch")) == ["W013"]

    def test_an_error_is_not_allowed(self) -> None:
        text = guard("// asemec: allow(E303) please", formula="[Watch]~")
        assert codes(text) == ["W013", "E303"]

    @pytest.mark.parametrize(
        "comment",
        [
            "// asemec: allow W300 it is",
            "// asemec: allow()",
            "// asemec: alow(W300) it is",
            "// asemec:",
            "/* asemec: allow(W300) it is */",
            "// asemec: allow-file(W300) too late",
        ],
    )
    def test_what_is_not_understood(self, comment: str) -> None:
        assert codes(guard(comment)) == ["W014", "W300"] or codes(guard(comment)) == ["W010", "W014", "W300"]

    @pytest.mark.parametrize("comment", ["// as emec: allow", "// see asemec: allow(W300)", "// asemecs: x"])
    def test_other_comments_are_nobodys_business(self, comment: str) -> None:
        assert codes(guard(comment)) == ["W300"]


def test_what_is_allowed_to_be_missing_is_not_missing() -> None:
    text = "system A\nsag {\n  actor a {\n    goal be_there %s\n  }\n}\nsrm a { liveness { a = Walk } }\n"
    assert [item.note.code for item in analysis(text % "").missing] == ["N700"]
    found = analysis(text % "// asemec: allow(N700) it needs no robot")
    assert (found.missing, found.diagnostics) == ((), ())


def test_what_is_allowed_is_allowed_whatever_the_policy_says() -> None:
    policy = Policy((Setting("W300", Severity.ERROR), Setting("W011", None)))
    source = Source("guard.aseme", guard("// asemec: allow(W300, W301) it is read well"))
    found = analyse(source, options=Options(policy=policy))
    assert found.diagnostics == ()
    assert found.system is not None
    strict = analyse(Source("guard.aseme", guard()), options=Options(policy=policy))
    assert strict.system is None
    assert [item.severity for item in strict.diagnostics] == [Severity.ERROR]
