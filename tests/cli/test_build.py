"""`asemec build`."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import time
from pathlib import Path

import pytest

from aseme_dsl.compiler.chart import chart as charts_of_compiler
from tests.cli.support import GOOD, Here, asemec, command

PROTOCOL = """\
system Pair
message Pass { int to }
topic team { signal Pass }
sag { actor first { goal hand_over depends on second "The ball changes hands." } actor second { } }
aip hand_over {
  participant giver { process = Give }
  participant taker { process = Take }
}
srm first { plays hand_over.giver  liveness { first = Wait . giver } }
srm second { plays hand_over.taker  liveness { second = Rest . taker } }
"""


def tree(folder: Path) -> dict[str, bytes]:
    return {
        path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()
    }


def state(folder: Path) -> dict[str, tuple[int, int, int]]:
    """What would change if a file was touched; a folder's time does where a file has come and gone."""
    return {
        str(path): (path.stat().st_ino, path.stat().st_mtime_ns if path.is_file() else 0, path.stat().st_size)
        for path in folder.rglob("*")
    }


def test_everything_has_its_place(here: Here, folder: Path) -> None:
    done = here("build", "good.aseme", "-o", "out")
    assert done.code == 0, done.err
    assert set(tree(folder / "out")) == {
        ".asemec.json",
        "models/sag.json",
        "models/suc.json",
        "models/srm.robot.json",
        "models/iac.robot.json",
        "diagrams/srm.robot.svg",
        "diagrams/iac.robot.svg",
        "diagrams/iac.robot.nested.svg",
        "diagrams/iac.robot.tree.svg",
        "proto/Walker.proto",
        "monas/Walker/__init__.py",
        "monas/Walker/messages.py",
        "monas/Walker/robot/__init__.py",
        "monas/Walker/robot/plan.py",
        "monas/Walker/robot/step.py",
        "monas/activities/walk.py",
        "monas/activities/stand.py",
    }
    assert done.out.splitlines()[0] == "Walker -> out: files: 16 created; 1 statechart certified"


def test_every_model_has_a_file_and_a_diagram(here: Here, folder: Path) -> None:
    (folder / "pair.aseme").write_text(PROTOCOL)
    done = here("build", "pair.aseme", "-o", "out")
    assert done.code == 0, done.err
    models = {
        "sag",
        "suc",
        "aip.hand_over",
        "srm.first",
        "srm.second",
        "eac.hand_over",
        "iac.first",
        "iac.second",
    }
    assert {path.stem for path in (folder / "out/models").iterdir()} == models
    drawn = {path.stem for path in (folder / "out/diagrams").iterdir()}
    charts = {name for name in models if name.startswith(("eac.", "iac."))}
    assert drawn == models | {f"{name}.{layout}" for name in charts for layout in ("nested", "tree")}


def test_the_same_bytes_whatever_the_process_and_the_folder(folder: Path) -> None:
    (folder / "else").mkdir()
    (folder / "else" / "good.aseme").write_text(GOOD)
    one = asemec("build", "good.aseme", "-o", "one", PYTHONHASHSEED="1")
    two = asemec("build", "good.aseme", "-o", "deep/two", cwd=folder / "else", PYTHONHASHSEED="2")
    assert (one.code, two.code) == (0, 0)
    first, second = tree(folder / "one"), tree(folder / "else/deep/two")
    manifests = [json.loads(item.pop(".asemec.json")) for item in (first, second)]
    assert [item.pop("source") for item in manifests] == ["../good.aseme", "../../good.aseme"]
    assert (first, manifests[0]) == (second, manifests[1])


def test_a_second_build_touches_nothing(here: Here, folder: Path) -> None:
    here("build", "good.aseme", "-o", "out")
    before = state(folder / "out")
    done = here("build", "good.aseme", "-o", "out")
    assert done.out.splitlines()[0] == (
        "Walker -> out: files: 14 unchanged, 2 of yours kept; 1 statechart certified"
    )
    assert state(folder / "out") == before


def test_an_error_changes_nothing(here: Here, folder: Path) -> None:
    here("build", "good.aseme", "-o", "out")
    before = state(folder / "out")
    (folder / "good.aseme").write_text((folder / "bad.aseme").read_text())
    done = here("build", "good.aseme", "-o", "out")
    assert done.code == 1
    assert "error[" in done.err
    assert done.out == ""
    assert state(folder / "out") == before


@pytest.mark.parametrize(
    ("only", "folders"),
    [
        (["models"], {"models"}),
        (["diagrams"], {"diagrams"}),
        (["proto"], {"proto"}),
        (["monas"], {"monas"}),
        (["proto", "models"], {"proto", "models"}),
    ],
)
def test_only_some_parts(here: Here, folder: Path, only: list[str], folders: set[str]) -> None:
    arguments = [word for part in only for word in ("--only", part)]
    assert here("build", "good.aseme", "-o", "out", *arguments).code == 0
    assert {path.name for path in (folder / "out").iterdir() if path.is_dir()} == folders


def test_what_is_no_longer_there_goes_and_other_parts_stay(here: Here, folder: Path) -> None:
    here("build", "good.aseme", "-o", "out")
    (folder / "good.aseme").write_text(GOOD.replace("srm robot", "srm droid").replace(" robot", " droid"))
    here("build", "good.aseme", "-o", "out", "--only", "models")
    assert not (folder / "out/models/iac.robot.json").exists()
    assert (folder / "out/diagrams/iac.robot.svg").exists()
    done = here("build", "good.aseme", "-o", "out")
    assert done.code == 0
    assert not (folder / "out/diagrams/iac.robot.svg").exists()
    assert not (folder / "out/monas/Walker/robot").exists()


class TestActivities:
    def test_each_is_started_once_and_never_touched(self, here: Here, folder: Path) -> None:
        here("build", "good.aseme", "-o", "out")
        mine = "class Walk:\n    def execute(self, context):\n        pass\n"
        (folder / "out/monas/activities/walk.py").write_text(mine)
        (folder / "good.aseme").write_text(GOOD.replace("takes 1s", "takes 2s"))
        assert here("build", "good.aseme", "-o", "out", "--force").code == 0
        assert (folder / "out/monas/activities/walk.py").read_text() == mine

    def test_they_may_be_elsewhere(self, here: Here, folder: Path) -> None:
        (folder / "skills").mkdir()
        mine = "class Walk:\n    def execute(self, context):\n        context.wait(1.0)\n"
        (folder / "skills/walk.py").write_text(mine)
        assert here("scaffold", "good.aseme", "--activities", "skills").code == 0
        done = here("build", "good.aseme", "-o", "out", "--activities", "skills")
        assert done.code == 0
        assert {path.name for path in (folder / "skills").iterdir()} == {"walk.py", "stand.py"}
        assert (folder / "skills/walk.py").read_text() == mine
        assert not (folder / "out/monas/activities").exists()

    def test_only_for_the_activities_that_have_none(self, here: Here, folder: Path) -> None:
        here("build", "good.aseme", "-o", "out")
        skills = folder / "out/monas/activities"
        (skills / "walk.py").unlink()
        (folder / "good.aseme").write_text(GOOD.replace("Stand", "Sit"))
        here("build", "good.aseme", "-o", "out")
        assert {path.name for path in skills.iterdir()} == {"walk.py", "stand.py", "sit.py"}


def test_generated_and_written_lines_are_counted(here: Here, folder: Path) -> None:
    def lines(*paths: Path) -> int:
        return sum(1 for path in paths for line in path.read_text().splitlines() if line.strip())

    here("build", "good.aseme", "-o", "out")
    first = here("build", "good.aseme", "-o", "out", "--json").json["systems"][0]["count"]
    code = [path for path in (folder / "out/monas").rglob("*.py")]
    assert first["generated"]["lines"] == lines(*code)
    assert first["by_hand"] == {"files": 0, "lines": 0, "bytes": 0}
    assert first["source"] == {"files": 1, "lines": 14, "bytes": len(GOOD)}
    walk = folder / "out/monas/activities/walk.py"
    walk.write_text("# mine\n\nclass Walk: ...\n")
    second = here("build", "good.aseme", "-o", "out", "--json").json["systems"][0]["count"]
    assert second["by_hand"] == {"files": 1, "lines": 2, "bytes": len(walk.read_bytes())}
    assert second["generated"]["lines"] == lines(*code) - 2
    assert "generated:" not in here("build", "good.aseme", "-o", "out").out
    said = here("build", "good.aseme", "-o", "out", "--stats").out
    total = second["generated"]["lines"] + 2
    assert f"generated: {total - 2} of {total} lines (" in said
    assert (
        f"hand-written: 2 lines of activities in 1 file, 14 lines of .aseme ({len(GOOD) / 1000:.1f} KB)"
        in said
    )


def test_helpers_beside_activities_count_as_written(here: Here, folder: Path) -> None:
    (folder / "skills").mkdir()
    (folder / "skills/geometry.py").write_text("def angle(): ...\n")
    (folder / "skills/jump.py").write_text("class Jump: ...  # of another system\n")
    here("scaffold", "good.aseme", "--activities", "skills")
    arguments = ["build", "good.aseme", "-o", "out", "--activities", "skills", "--json"]
    count = here(*arguments).json["systems"][0]["count"]
    assert count["by_hand"] == {"files": 1, "lines": 1, "bytes": 17}


@pytest.mark.parametrize("name", [b"caf\xe9", b"a \"b\" 'c'", b'"""\\N{x}', b"two\nlines", "ω – x".encode()])
def test_a_file_may_be_called_anything(here: Here, folder: Path, name: bytes) -> None:
    path = os.fsdecode(name) + ".aseme"
    (folder / path).write_text(GOOD)
    for arguments in (["check"], ["run", "--for", "1s", "-o", "out"], ["diagram", "-o", "drawn"]):
        done = here(arguments[0], path, *arguments[1:])
        assert done.code == 0, done.err


class TestOverwriting:
    def test_an_edited_file_is_not_overwritten(self, here: Here, folder: Path) -> None:
        here("build", "good.aseme", "-o", "out")
        plan = folder / "out/monas/Walker/robot/plan.py"
        plan.write_text("# mine")
        before = state(folder / "out")
        (folder / "good.aseme").write_text(GOOD.replace("takes 1s", "takes 2s"))
        done = here("build", "good.aseme", "-o", "out")
        assert done.code == 1
        assert "plan.py was edited since it was generated" in done.err
        assert "--force" in done.err
        assert state(folder / "out") == before
        assert here("build", "good.aseme", "-o", "out", "--force").code == 0
        assert plan.read_text() != "# mine"

    def test_a_folder_that_belongs_to_something_else(self, here: Here, folder: Path) -> None:
        (folder / "out/models").mkdir(parents=True)
        (folder / "out/models/sag.json").write_text("mine")
        assert here("build", "good.aseme", "-o", "out").code == 1
        assert tree(folder / "out") == {"models/sag.json": b"mine"}

    def test_another_systems_folder(self, here: Here, folder: Path) -> None:
        here("build", "good.aseme", "-o", "out")
        (folder / "pair.aseme").write_text(GOOD.replace("Walker", "Runner"))
        before = state(folder / "out")
        done = here("build", "pair.aseme", "-o", "out")
        assert done.code == 1
        assert "out holds the build of Walker (from good.aseme)" in done.err
        assert state(folder / "out") == before

    def test_small_files_of_one_folder_are_built_one_after_the_other(self, here: Here, folder: Path) -> None:
        """In `out`, which nobody chose, as long as nothing of the user's is there."""
        (folder / "pair.aseme").write_text(GOOD.replace("Walker", "Runner"))
        for name in ("good", "pair", "good"):
            done = here("run", f"{name}.aseme")
            assert done.code == 0, done.err
        assert not (folder / "out/monas/Runner/__init__.py").exists()
        assert here("build", "pair.aseme").code == 0  # with stubs
        done = here("run", "good.aseme")
        assert done.code == 1 and "out holds the build of Runner (from pair.aseme)" in done.err

    def test_the_source_is_never_overwritten(self, here: Here, folder: Path) -> None:
        done = here("build", "good.aseme", "-o", "good.aseme")
        assert done.code == 1
        assert "good.aseme is not a folder" in done.err
        assert (folder / "good.aseme").read_text() == GOOD


def test_several_systems_get_a_folder_each(here: Here, folder: Path) -> None:
    (folder / "other.aseme").write_text(GOOD.replace("Walker", "Runner"))
    done = here("build", "good.aseme", "other.aseme", "-o", "out")
    assert done.code == 0
    assert {path.name for path in (folder / "out").iterdir()} == {"Walker", "Runner"}
    assert (folder / "out/Runner/monas/Runner/robot/step.py").exists()


def test_what_an_earlier_build_left_elsewhere_is_told(here: Here, folder: Path) -> None:
    (folder / "pair.aseme").write_text(PROTOCOL)
    assert here("build", "good.aseme", "-o", "out", "--only", "monas").err.count("earlier build") == 0
    both = here("build", "good.aseme", "pair.aseme", "-o", "out", "--only", "monas")
    assert (
        "note: out has an older build of Walker, which is unchanged; the new one is in out/Walker" in both.err
    )
    alone = here("build", "pair.aseme", "-o", "out", "--only", "monas", "--force")
    assert "note: out/Pair has an older build of Pair" in alone.err


def test_of_several_systems_one_with_an_error_stops_all(here: Here, folder: Path) -> None:
    assert here("build", "good.aseme", "bad.aseme", "-o", "out").code == 1
    assert not (folder / "out").exists()


def test_json(here: Here, folder: Path) -> None:
    result = here("build", "good.aseme", "-o", "out", "--only", "proto", "--json").json
    assert result["format"] == 1
    (system,) = result["systems"]
    assert system["system"] == "Walker"
    assert system["folder"] == "out"
    assert system["created"] == [str(Path("out/proto/Walker.proto"))]
    assert system["count"] is None
    failed = here("build", "bad.aseme", "-o", "out", "--json")
    assert failed.code == 1
    assert failed.json["systems"] == []
    assert failed.json["errors"] == 2


def test_standard_input(here: Here, folder: Path) -> None:
    done = here("build", "-", "-o", "out", "--only", "models", input=GOOD.encode())
    assert done.code == 0, done.err
    assert (folder / "out/models/iac.robot.json").exists()


class TestConfiguration:
    def test_it_says_where_things_are(
        self, here: Here, folder: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        (folder / "pyproject.toml").write_text(
            '[tool.asemec]\noutput = "made"\nactivities = "skills"\nexpressions = "none"\n'
        )
        (folder / "deep").mkdir()
        monkeypatch.chdir(folder / "deep")
        assert here("scaffold", "../good.aseme").code == 0
        assert here("build", "../good.aseme").code == 0
        assert (folder / "made/monas/Walker/robot/step.py").exists()
        assert (folder / "skills/walk.py").exists()
        assert not list((folder / "deep").iterdir())
        assert b">1<" not in (folder / "made/diagrams/iac.robot.svg").read_bytes()

    def test_a_project_that_does_not_say_where_is_built_beside_its_file(
        self, here: Here, folder: Path
    ) -> None:
        (folder / "walker").mkdir()
        (folder / "good.aseme").rename(folder / "walker/good.aseme")
        (folder / "walker/pyproject.toml").write_text("[tool.asemec]\n")
        for words in (("build", "walker"), ("run", "walker", "--for", "1s"), ("run", "walker/good.aseme")):
            assert here(*words).code == 0
            assert not (folder / "out").exists()
        assert (folder / "walker/out/trace.jsonl.gz").exists()

    def test_a_file_of_no_project_is_built_where_one_works(self, here: Here, folder: Path) -> None:
        (folder / "deep").mkdir()
        (folder / "good.aseme").rename(folder / "deep/good.aseme")
        (folder / "deep/pyproject.toml").write_text('[project]\nname = "another"\n')
        assert here("build", "deep/good.aseme").code == 0
        assert (folder / "out/models/iac.robot.json").exists()
        assert not (folder / "deep/out").exists()

    def test_the_command_line_goes_first(self, here: Here, folder: Path) -> None:
        (folder / "pyproject.toml").write_text('[tool.asemec]\noutput = "made"\nactivities = "skills"\n')
        assert here("scaffold", "good.aseme", "--activities", "acts").code == 0
        assert here("build", "good.aseme", "-o", "out", "--activities", "acts").code == 0
        assert {path.name for path in folder.iterdir()} >= {"out", "acts"}
        assert not (folder / "made").exists()
        assert not (folder / "skills").exists()

    def test_a_backend_that_is_not_there(self, here: Here, folder: Path) -> None:
        (folder / "pyproject.toml").write_text('[tool.asemec]\nbackends = ["jade"]\n')
        done = here("build", "good.aseme")
        assert done.code == 2
        assert "Unknown backend 'jade'" in done.err


def test_states_may_be_named_as_the_originals_do(here: Here, folder: Path) -> None:
    def names(*arguments: str) -> set[str]:
        assert here("build", "good.aseme", "-o", "out", *arguments).code == 0
        model = json.loads((folder / "out/models/iac.robot.json").read_text())
        return {node["name"] for node in model["states"]}

    assert "(Walk | Stand)" in names()
    assert not any(" | " in name for name in names("--labels", "original"))
    (folder / "pyproject.toml").write_text('[tool.asemec]\nlabels = "original"\n')
    assert not any(" | " in name for name in names())
    assert here("run", "good.aseme", "-o", "out", "--for", "1s").code == 0
    assert "iac.robot" in here("diagram", "good.aseme", "iac", "--labels", "plain", "--json").out


def test_templates_of_the_user(here: Here, folder: Path) -> None:
    (folder / "mine").mkdir()
    (folder / "mine/activity.py.j2").write_text("# {{ name }} of mine\n")
    assert here("build", "good.aseme", "-o", "out", "--templates", "mine").code == 0
    assert (folder / "out/monas/activities/walk.py").read_text() == "# Walk of mine\n"


def test_without_graphviz_there_are_texts_and_a_warning(
    here: Here, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from aseme_dsl.diagrams import GraphvizMissing

    def missing() -> str:
        raise GraphvizMissing

    monkeypatch.setattr("aseme_dsl.diagrams.rendering.layout.program", missing)
    done = here("build", "good.aseme", "-o", "out")
    assert done.code == 0
    assert done.err.count("warning[W003]") == 1
    assert {path.suffix for path in (folder / "out/diagrams").iterdir()} == {".dot"}
    assert (folder / "out/monas/Walker/robot/step.py").exists()
    (folder / "pyproject.toml").write_text('[tool.asemec.diagnostics]\nW003 = "error"\n')
    done = here("build", "good.aseme", "-o", "other")
    assert done.code == 1
    assert done.err.count("error[W003]") == 1
    assert not (folder / "other").exists()


BACKEND = '''\
"""A backend that is installed beside asemec."""

import os
import pathlib
import time

from aseme_dsl.backends.backend import Artefact


class Listing:
    name = "listing"

    def generate(self, system, options):
        if "ASEMEC_TEST_READY" in os.environ:
            pathlib.Path(os.environ["ASEMEC_TEST_READY"]).touch()
            time.sleep(300)
        return (Artefact(f"{system.name}.txt", "\\n".join(chart.name for chart in system.iacs)),)


BACKEND = Listing()
'''


@pytest.fixture
def site(tmp_path: Path) -> Path:
    """A folder with an installed package that offers the backend `listing`."""
    folder = tmp_path / "site"
    package = folder / "listing-1.0.dist-info"
    package.mkdir(parents=True)
    (folder / "listing_backend.py").write_text(BACKEND)
    (package / "METADATA").write_text("Metadata-Version: 2.1\nName: listing\nVersion: 1.0\n")
    (package / "entry_points.txt").write_text("[aseme_dsl.backends]\nlisting = listing_backend:BACKEND\n")
    return folder


def test_a_backend_of_somebody_else(folder: Path, site: Path) -> None:
    arguments = ["--backend", "listing", "--backend", "monas"]
    done = asemec("build", "good.aseme", "-o", "out", *arguments, cwd=folder, PYTHONPATH=str(site))
    assert done.code == 0, done.err
    assert (folder / "out/listing/Walker.txt").read_text() == "robot"
    assert (folder / "out/monas/Walker/robot/step.py").exists()
    only = asemec("build", "good.aseme", "-o", "two", "--only", "listing", cwd=folder, PYTHONPATH=str(site))
    assert only.code == 0, only.err
    assert set(tree(folder / "two")) == {".asemec.json", "listing/Walker.txt"}


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_an_interrupted_build_loses_nothing(
    here: Here, folder: Path, site: Path, number: signal.Signals
) -> None:
    assert here("build", "good.aseme", "-o", "out").code == 0
    before = state(folder / "out")
    (folder / "good.aseme").write_text(GOOD.replace("takes 1s", "takes 2s"))
    ready = folder / "ready"
    process = subprocess.Popen(
        command("build", "good.aseme", "-o", "out", "--backend", "monas", "--backend", "listing"),
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(site), "ASEMEC_TEST_READY": str(ready)},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    while not ready.exists():
        assert process.poll() is None
        time.sleep(0.05)
    process.send_signal(number)
    out, err = process.communicate(timeout=60)
    assert process.returncode == {signal.SIGINT: 130, signal.SIGTERM: 143}[number]
    assert (out, "Traceback" in err) == ("", False)
    assert state(folder / "out") == before


@pytest.mark.parametrize("size", [200, 3000])
def test_a_full_disk_loses_nothing(here: Here, folder: Path, size: int) -> None:
    """A limit on the size of files stands for the disk."""
    resource = pytest.importorskip("resource")
    here("build", "good.aseme", "-o", "out")
    before = state(folder / "out")
    (folder / "good.aseme").write_text(GOOD.replace("Walk", "Stroll"))
    done = subprocess.run(
        command("build", "good.aseme", "-o", "out"),
        cwd=folder,
        capture_output=True,
        text=True,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)),
        env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"},
    )
    assert done.returncode == 1
    assert "error[E009]" in done.stderr
    assert "File too large" in done.stderr
    assert "nothing was changed" in done.stderr
    assert "Traceback" not in done.stderr
    assert state(folder / "out") == before


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="nothing is read-only for root")
def test_a_read_only_folder(here: Here, folder: Path) -> None:
    (folder / "out").mkdir()
    (folder / "out").chmod(0o555)
    try:
        done = here("build", "good.aseme", "-o", "out")
        assert done.code == 1
        assert "error[E009]" in done.err
        assert "Permission denied" in done.err
        assert not list((folder / "out").iterdir())
    finally:
        (folder / "out").chmod(0o755)


def test_a_place_that_cannot_be_written(here: Here, folder: Path) -> None:
    """/proc takes no folders from anybody."""
    if not Path("/proc/self").exists():
        pytest.skip("this system has no /proc")
    done = here("build", "good.aseme", "-o", "/proc/out")
    assert done.code == 1
    assert "error[E009]: /proc/out cannot be written" in done.err


def test_the_manifest_is_documented_and_stable(here: Here, folder: Path) -> None:
    here("build", "good.aseme", "-o", "out", "--only", "proto")
    document = json.loads((folder / "out/.asemec.json").read_text())
    assert document["format"] == 1
    assert (document["system"], document["source"]) == ("Walker", "../good.aseme")
    assert list(document["files"]) == ["proto/Walker.proto"]
    assert set(document["files"]["proto/Walker.proto"]) == {"part", "hash"}


class TestReports:
    """What `asemec check` has in its formats, of a build."""

    @pytest.mark.parametrize("form", ["sarif", "github", "junit", "codequality"])
    def test_it_says_what_check_says(self, here: Here, folder: Path, form: str) -> None:
        built = here("build", "bad.aseme", "--format", form)
        checked = here("check", "bad.aseme", "--format", form)
        assert (built.code, built.err) == (1, "")
        assert built.out == checked.out.replace("asemec check", "asemec build")
        assert not (folder / "out").exists()

    def test_a_file_gets_the_report_and_the_terminal_what_was_written(self, here: Here, folder: Path) -> None:
        done = here("build", "good.aseme", "--format", "sarif", "--report", "report.sarif")
        assert (done.code, done.err) == (0, "")
        assert done.out.startswith("Walker -> out: files: ")
        assert json.loads((folder / "report.sarif").read_text())["runs"][0]["results"] == []

    def test_text_into_a_file(self, here: Here, folder: Path) -> None:
        done = here("build", "bad.aseme", "--report", "report.txt")
        assert (done.code, done.out, done.err) == (1, "", "")
        assert (folder / "report.txt").read_text() == here("build", "bad.aseme").err
        done = here("build", "good.aseme", "--report", "report.txt")
        assert (done.code, done.err) == (0, "")
        assert (folder / "report.txt").read_text() == done.out

    def test_what_the_build_itself_finds_is_in_it(self, here: Here, folder: Path) -> None:
        here("build", "good.aseme")
        (folder / "out" / "models" / "suc.json").write_text("edited")
        done = here("build", "good.aseme", "--format", "codequality")
        (issue,) = json.loads(done.out)
        assert done.code == 1
        assert (issue["check_name"], issue["location"]["path"]) == ("E009", "out/models/suc.json")

    def test_several_systems_that_share_a_file_say_it_once(self, here: Here, folder: Path) -> None:
        (folder / "bad.aseme").unlink()
        (folder / "good.aseme").unlink()
        own = [line for line in GOOD.splitlines(keepends=True) if not line.startswith("message Seen")]
        for name in ("One", "Two"):
            text = 'import "shared.aseme"\n' + "".join(own).replace("Walker", name)
            (folder / f"{name}.aseme").write_text(text)
        (folder / "shared.aseme").write_text("message Seen { bol ball  bool home }\n")
        assert len(json.loads(here("build", ".", "--format", "codequality").out)) == 1

    @pytest.mark.parametrize(
        "arguments", [("--json", "--format", "sarif"), ("--format", "xml"), ("--report", "good.aseme")]
    )
    def test_wrong_use(self, here: Here, folder: Path, arguments: tuple[str, ...]) -> None:
        assert here("build", "good.aseme", *arguments).code == 2
        assert (folder / "good.aseme").read_text() == GOOD


@pytest.mark.parametrize(
    ("backends", "control"),
    [
        (("monas", "jade_like", "plain"), "control player { enter Go : [ground.state.Ball.x > 1] }"),
        (("monas", "batch"), ""),
    ],
)
def test_a_build_is_the_same_from_every_folder(
    folder: Path, here: Here, monkeypatch: pytest.MonkeyPatch, backends: tuple[str, ...], control: str
) -> None:
    """With each backend; also of a file that imports another, and the standard library."""
    text = """system Team
import resources
import "shared/words.aseme"
srm player { liveness { player = Look . Go } activities { Look takes 1s  Go takes 1s }
  CONTROL }
team Players { bob : player }
"""
    (folder / "project/shared").mkdir(parents=True)
    (folder / "project/team.aseme").write_text(text.replace("CONTROL", control))
    (folder / "project/shared/words.aseme").write_text(
        "message Ball { int x }\ntopic ground { state Ball }\n"
    )
    options = [part for name in backends for part in ("--backend", name)]
    outputs = []
    for number, (current, target) in enumerate(
        [
            ("project", "team.aseme"),
            (".", "project/team.aseme"),
            ("project/shared", "../team.aseme"),
            ("project", str(folder / "project/team.aseme")),
        ]
    ):
        monkeypatch.chdir(folder / current)
        output = folder / f"out{number}"
        assert here("build", target, "-o", str(output), *options).code == 0
        here("run", str(output), "--for", "3s", "--quiet")
        files = (path for path in output.rglob("*") if path.is_file() and path.suffix != ".pyc")
        outputs.append({str(path.relative_to(output)): path.read_bytes() for path in files})
    assert outputs[0] == outputs[1] == outputs[2] == outputs[3]
    assert {".asemec.json", "trace.jsonl.gz"} <= set(outputs[0])
    assert b'"file": "<stdlib>/resources.aseme"' in outputs[0]["models/aip.resource.json"]
    assert b'"file": "team.aseme"' in outputs[0]["models/iac.player.json"]
    assert {name.split("/")[0] for name in outputs[0]} >= {"models", "diagrams", *backends}


def test_a_folder_of_the_user_may_be_called_as_the_library_is(folder: Path, here: Here) -> None:
    (folder / "stdlib").mkdir()
    (folder / "stdlib/own.aseme").write_text("message Ball { int x }\ntopic ground { state Ball }\n")
    (folder / "team.aseme").write_text(
        'system Team\nimport "stdlib/own.aseme"\n'
        "srm player { liveness { player = Look }\n  activities { Look takes 1s reads ground.state.Ball } }\n"
    )
    done = here("build", "team.aseme", "--stats")
    assert "6 lines of .aseme" in done.out


# ---- certificates --------------------------------------------------------------------------------

CERTIFIED = "system T\nsrm R { liveness { R = A . [B] . C } }\n"


def test_a_build_says_what_is_certified(here: Here, folder: Path) -> None:
    (folder / "t.aseme").write_text(CERTIFIED)
    done = here("build", "t.aseme", "-o", "out", "--only", "models")
    assert done.out.rstrip().endswith("; 1 statechart certified")
    assert json.loads((folder / "out/.asemec.json").read_text())["certified"] == {"iac.R": "proved"}
    document = json.loads(here("build", "t.aseme", "-o", "out", "--json").out)
    assert document["systems"][0]["certified"] == [
        {"chart": "iac.R", "states": 10, "transitions": 8, "subcharts": [], "left_out": []}
    ]


def test_a_mistake_of_the_compiler_stops_the_build(
    here: Here, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (folder / "t.aseme").write_text(CERTIFIED)
    made = charts_of_compiler.transitions
    monkeypatch.setattr(charts_of_compiler, "transitions", lambda *given: made(*given)[:-2])
    for arguments in (("build", "t.aseme", "-o", "out"), ("check", "t.aseme")):
        done = here(*arguments)
        assert done.code == 70
        assert (
            "internal error: NotCertified: the statechart of R (IAC) is not what its source says" in done.err
        )
        assert "it lacks the transition of `skip B` (no line)" in done.err
        assert ": at `choice in [B]` (0.3.2), t.aseme:2:28 reached by A . [B]: it lacks" in done.err
        assert "This is a bug in asemec; please report it" in done.err
    assert not (folder / "out").exists()
