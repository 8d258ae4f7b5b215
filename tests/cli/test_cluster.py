"""`--cluster`: many runs on the workers of a Dask cluster give what they give in one process."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.cli.support import GOOD, Here
from tests.cli.test_optimise import FEED

SEEDED = """
scenario "it takes its time" {
  one : robot
  activity Stand takes 500ms..1500ms
  by 700ms one in Walk
}
"""
LOOKS = """\
from where import PLACE

class Walk:
    def execute(self, context):
        context.wait(PLACE)
"""


@pytest.fixture(scope="module")
def cluster() -> Iterator[str]:
    """The address of a cluster of two workers, each a process."""
    import distributed

    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=2, dashboard_address="127.0.0.1:0", host="127.0.0.1"
    ) as there:
        yield there.scheduler_address


def test_scenarios_have_the_same_verdicts(cluster: str, here: Here, folder: Path) -> None:
    (folder / "good.aseme").write_text(GOOD + SEEDED)
    arguments = ("test", "good.aseme", "--seeds", "20", "--json")
    there, alone = here(*arguments, "--cluster", cluster), here(*arguments, "-j", "1")
    assert (there.code, there.out) == (alone.code, alone.out) == (1, there.out)
    assert "failed" in there.out


@pytest.mark.long
def test_a_study_has_the_same_numbers(cluster: str, here: Here, folder: Path) -> None:
    """Several variants, so several packages with modules of the same names, on workers that stay."""
    (folder / "feed.aseme").write_text(FEED)
    arguments: tuple[Any, ...] = (
        *("optimise", "feed.aseme", "--vary", "carrier=1..3", "--measure", "Carry"),
        *("--runs", "3", "--for", "20s", "--json"),
    )
    there, alone = here(*arguments, "--cluster", cluster), here(*arguments, "-j", "1")
    assert there.code == alone.code == 0
    assert json.loads(there.out) == json.loads(alone.out)


def test_the_workers_have_the_project_s_modules(cluster: str, here: Here, folder: Path) -> None:
    """A second play sees what was edited in between."""
    (folder / "good.aseme").write_text(
        GOOD + 'scenario "it walks" { one : robot  activity Walk real  by 3s one ends Walk }\n'
    )
    (folder / "activities").mkdir()
    (folder / "activities" / "walk.py").write_text(LOOKS)
    arguments = ("test", "good.aseme", "--activities", "activities", "--json")
    for place in (1, 2):
        (folder / "where.py").write_text(f"PLACE = {place}\n")
        there, alone = here(*arguments, "--cluster", cluster), here(*arguments, "-j", "1")
        assert there.out == alone.out


def test_what_is_wrong_is_said(cluster: str, here: Here, folder: Path, monkeypatch: Any) -> None:
    from aseme_dsl.project.spreading import cluster as clusters

    (folder / "good.aseme").write_text(GOOD + SEEDED)
    done = here("test", "good.aseme", "--cluster", cluster, "-j", "2")
    assert (done.code, "give one of them" in done.err) == (2, True)
    monkeypatch.setattr(clusters, "LARGEST", 10)
    assert "MB of files" in here("test", "good.aseme", "--cluster", cluster).err
    monkeypatch.setattr(clusters, "LARGEST", 10**6)
    monkeypatch.setattr("platform.python_version_tuple", lambda: ("3", "99", "0"))
    assert "and 3.99." in here("test", "good.aseme", "--cluster", cluster).err
    monkeypatch.setattr(clusters, "PATIENCE", 1)
    done = here("test", "good.aseme", "--cluster", "tcp://127.0.0.1:9")
    assert (done.code, "no scheduler of a Dask cluster answers" in done.err) == (1, True)
