"""Files are written all or none, and never over what is not ours."""

from __future__ import annotations

import errno
import json
import os
import signal
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

import pytest

from aseme_dsl.project.files.manifest import NAME
from aseme_dsl.project.files.write import DISK, STAGED, Disk, Planned, Written, write


def planned(files: Mapping[str, str], part: str = "models") -> list[Planned]:
    return [Planned(path, text.encode(), part) for path, text in files.items()]


def put(
    folder: Path,
    files: Mapping[str, str],
    *,
    parts: tuple[str, ...] = ("models",),
    system: str = "Team",
    source: str = "team.aseme",
    force: bool = False,
    disk: Disk = DISK,
) -> Written:
    return write(
        folder,
        planned(files, parts[0]),
        parts=frozenset(parts),
        system=system,
        source=source,
        force=force,
        disk=disk,
    )


def tree(folder: Path) -> dict[str, bytes]:
    return {
        path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()
    }


def without_manifest(folder: Path) -> dict[str, bytes]:
    return {path: content for path, content in tree(folder).items() if path != NAME}


def codes(written: Written) -> list[str]:
    return [item.code for item in written.diagnostics]


def test_files_and_folders_are_made(tmp_path: Path) -> None:
    out = tmp_path / "deep" / "out"
    written = put(out, {"models/sag.json": "{}\n", "models/suc.json": "[]\n"})
    assert written.diagnostics == ()
    assert written.created == (out / "models/sag.json", out / "models/suc.json")
    assert without_manifest(out) == {"models/sag.json": b"{}\n", "models/suc.json": b"[]\n"}


def test_a_second_build_touches_nothing(tmp_path: Path) -> None:
    files = {"models/sag.json": "{}\n"}
    put(tmp_path, files)
    before = {path: path.stat().st_mtime_ns for path in tmp_path.rglob("*")}
    inodes = {path: path.stat().st_ino for path in tmp_path.rglob("*")}
    written = put(tmp_path, files)
    assert written.unchanged == (tmp_path / "models/sag.json",)
    assert (written.created, written.changed, written.removed) == ((), (), ())
    assert {path: path.stat().st_mtime_ns for path in tmp_path.rglob("*")} == before
    assert {path: path.stat().st_ino for path in tmp_path.rglob("*")} == inodes


def test_the_same_files_give_the_same_bytes_anywhere(tmp_path: Path) -> None:
    files = {"models/b.json": "b", "models/a.json": "a"}
    put(tmp_path / "one", files)
    put(tmp_path / "some" / "where" / "two", dict(reversed(files.items())))
    assert tree(tmp_path / "one") == tree(tmp_path / "some/where/two")


def test_what_is_no_longer_generated_is_removed_with_its_empty_folders(tmp_path: Path) -> None:
    put(tmp_path, {"models/a.json": "a", "models/old/deep/b.json": "b"})
    written = put(tmp_path, {"models/a.json": "a"})
    assert written.removed == (tmp_path / "models/old/deep/b.json",)
    assert sorted(path.name for path in tmp_path.rglob("*")) == [NAME, "a.json", "models"]


def test_folders_with_files_of_the_user_stay(tmp_path: Path) -> None:
    put(tmp_path, {"models/a.json": "a", "models/old/b.json": "b"})
    (tmp_path / "models/old/mine.txt").write_text("mine")
    put(tmp_path, {"models/a.json": "a"})
    assert set(without_manifest(tmp_path)) == {"models/a.json", "models/old/mine.txt"}


def test_other_parts_are_left_alone(tmp_path: Path) -> None:
    put(tmp_path, {"models/a.json": "a"}, parts=("models",))
    put(tmp_path, {"proto/team.proto": "p"}, parts=("proto",))
    put(tmp_path, {}, parts=("proto",))
    assert set(without_manifest(tmp_path)) == {"models/a.json"}


def test_a_file_of_somebody_else_is_refused_and_nothing_is_written(tmp_path: Path) -> None:
    (tmp_path / "models").mkdir()
    (tmp_path / "models/b.json").write_text("mine")
    written = put(tmp_path, {"models/a.json": "a", "models/b.json": "b"})
    assert codes(written) == ["E009"]
    assert "did not write it" in written.diagnostics[0].message
    assert "--force" in (written.diagnostics[0].hint or "")
    assert tree(tmp_path) == {"models/b.json": b"mine"}


def test_a_file_of_somebody_else_with_the_right_content_is_fine(tmp_path: Path) -> None:
    (tmp_path / "models").mkdir()
    (tmp_path / "models/b.json").write_text("b")
    assert put(tmp_path, {"models/b.json": "b"}).diagnostics == ()


def test_an_edited_file_is_refused_until_forced(tmp_path: Path) -> None:
    put(tmp_path, {"models/a.json": "a"})
    (tmp_path / "models/a.json").write_text("edited")
    written = put(tmp_path, {"models/a.json": "new"})
    assert codes(written) == ["E009"]
    assert "was edited" in written.diagnostics[0].message
    assert (tmp_path / "models/a.json").read_text() == "edited"
    assert put(tmp_path, {"models/a.json": "new"}, force=True).changed == (tmp_path / "models/a.json",)
    assert (tmp_path / "models/a.json").read_text() == "new"
    assert put(tmp_path, {"models/a.json": "newer"}).diagnostics == ()


def test_an_edited_file_that_would_be_removed_stays(tmp_path: Path) -> None:
    put(tmp_path, {"models/a.json": "a", "models/b.json": "b"})
    (tmp_path / "models/b.json").write_text("edited")
    written = put(tmp_path, {"models/a.json": "a"}, force=True)
    assert codes(written) == ["W002"]
    assert (tmp_path / "models/b.json").read_text() == "edited"
    assert put(tmp_path, {"models/a.json": "a"}).diagnostics == ()


def test_all_refusals_are_said_at_once(tmp_path: Path) -> None:
    put(tmp_path, {"models/a.json": "a", "models/b.json": "b"})
    for name in "ab":
        (tmp_path / f"models/{name}.json").write_text("edited")
    assert codes(put(tmp_path, {"models/a.json": "1", "models/b.json": "2"})) == ["E009", "E009"]


def test_the_folder_of_another_system_is_refused(tmp_path: Path) -> None:
    put(tmp_path, {"models/a.json": "a"})
    written = put(tmp_path, {"models/a.json": "b"}, system="Other", source="other.aseme")
    assert codes(written) == ["E009"]
    assert f"holds the build of Team (from {tmp_path}/team.aseme)" in written.diagnostics[0].message
    forced = put(tmp_path, {"models/c.json": "c"}, system="Other", source="other.aseme", force=True)
    assert forced.removed == (tmp_path / "models/a.json",)


def test_a_renamed_system_takes_its_folder_with_it(tmp_path: Path) -> None:
    put(tmp_path, {"monas/Team/a.py": "a"}, parts=("monas",))
    written = put(tmp_path, {"monas/Squad/a.py": "a"}, parts=("monas",), system="Squad")
    assert written.diagnostics == ()
    assert set(without_manifest(tmp_path)) == {"monas/Squad/a.py"}


class TestFilesOfTheUser:
    def put(self, out: Path, home: Path, text: str = "template") -> Written:
        file = Planned("monas/activities/kick.py", text.encode(), "monas", home=home)
        return write(out, [file], parts=frozenset({"monas"}), system="Team", source="team.aseme")

    def test_they_are_written_once_and_never_again(self, tmp_path: Path) -> None:
        home = tmp_path / "activities" / "kick.py"
        assert self.put(tmp_path / "out", home).created == (home,)
        home.write_text("filled in")
        written = self.put(tmp_path / "out", home, "newer template")
        assert written.kept == (home,)
        assert home.read_text() == "filled in"

    def test_not_even_in_place_of_a_broken_link(self, tmp_path: Path) -> None:
        home = tmp_path / "kick.py"
        home.symlink_to(tmp_path / "nowhere")
        assert self.put(tmp_path / "out", home).kept == (home,)

    def test_they_are_not_removed_with_what_is_generated(self, tmp_path: Path) -> None:
        home = tmp_path / "out" / "monas" / "activities" / "kick.py"
        self.put(tmp_path / "out", home)
        put(tmp_path / "out", {}, parts=("monas",))
        assert home.exists()


@pytest.mark.parametrize("path", ["../outside", "/etc/outside", "a/../../b", NAME, "a\\b", "a\0b"])
def test_no_generated_file_leaves_the_folder(tmp_path: Path, path: str) -> None:
    assert codes(put(tmp_path, {path: "x"})) == ["E009"]


def test_a_manifest_that_was_tampered_with_removes_nothing_outside(tmp_path: Path) -> None:
    out = tmp_path / "out"
    put(out, {"models/a.json": "a"})
    (tmp_path / "precious").write_text("a")
    document = json.loads((out / NAME).read_text())
    document["files"]["../precious"] = document["files"]["models/a.json"]
    (out / NAME).write_text(json.dumps(document))
    put(out, {})
    assert (tmp_path / "precious").read_text() == "a"


@pytest.mark.parametrize("text", ["", "{", "[]", '{"format": 99}', "[" * 100_000, "null", "\udcff"])
def test_a_damaged_manifest_is_said(tmp_path: Path, text: str) -> None:
    put(tmp_path, {"models/a.json": "a"})
    (tmp_path / NAME).write_text(text, "utf-8", "surrogateescape")
    written = put(tmp_path, {"models/a.json": "b"})
    assert codes(written) == ["E009"]
    assert (tmp_path / "models/a.json").read_text() == "a"
    assert put(tmp_path, {"models/a.json": "b"}, force=True).diagnostics == ()


def test_a_file_where_the_folder_should_be(tmp_path: Path) -> None:
    (tmp_path / "out").write_text("a file")
    assert "is not a folder" in put(tmp_path / "out", {"a": "a"}).diagnostics[0].message
    written = put(tmp_path / "out" / "deeper", {"a": "a", "b": "b"})
    assert [item.message for item in written.diagnostics] == [f"{tmp_path / 'out'} is not a folder"]
    (tmp_path / "models").write_text("a file")
    assert codes(put(tmp_path, {"models/a.json": "a"})) == ["E009"]


def test_a_folder_where_a_file_should_be(tmp_path: Path) -> None:
    (tmp_path / "models/a.json").mkdir(parents=True)
    written = put(tmp_path, {"models/a.json": "a"}, force=True)
    assert "is a folder" in written.diagnostics[0].message


def test_two_contents_for_one_place(tmp_path: Path) -> None:
    files = [Planned("a.py", b"1", "monas"), Planned("a.py", b"2", "monas")]
    written = write(tmp_path, files, parts=frozenset({"monas"}), system="Team", source="team.aseme")
    assert "written twice" in written.diagnostics[0].message


def test_permissions_are_kept(tmp_path: Path) -> None:
    put(tmp_path, {"models/a.json": "a"})
    (tmp_path / "models/a.json").chmod(0o640)
    put(tmp_path, {"models/a.json": "b"})
    assert (tmp_path / "models/a.json").stat().st_mode & 0o777 == 0o640


class Failing(Disk):
    """A disk whose n-th operation of a kind fails."""

    def __init__(self, kind: str, number: int, error: int) -> None:
        self.kind, self.left, self.error = kind, number, error

    def _count(self, kind: str, path: Path) -> None:
        if kind == self.kind:
            self.left -= 1
            if self.left == 0:
                raise OSError(self.error, os.strerror(self.error), str(path))

    def create(self, path: Path, content: bytes, mode: int | None) -> None:
        try:
            self._count("create", path)
        except OSError:
            path.write_bytes(content[: len(content) // 2])  # a full disk takes what still fits
            raise
        super().create(path, content, mode)

    def rename(self, source: Path, target: Path) -> None:
        self._count("rename", target)
        super().rename(source, target)

    def link(self, target: Path, name: Path) -> None:
        self._count("link", name)
        super().link(target, name)

    def make_folder(self, path: Path) -> None:
        self._count("make_folder", path)
        super().make_folder(path)


OLD = {"models/a.json": "old a", "models/b.json": "old b", "models/c.json": "old c", "models/d.json": "old d"}
NEW = {"models/a.json": "new a", "models/b.json": "new b", "models/d.json": "old d", "new/deep/e.json": "new"}


@pytest.mark.parametrize(
    ("kind", "number", "error", "word"),
    [("create", n, errno.ENOSPC, "No space left") for n in range(1, 5)]
    + [("rename", n, errno.EROFS, "Read-only") for n in range(1, 6)]
    + [("make_folder", n, errno.EACCES, "Permission denied") for n in (1, 2)],
)
def test_a_failure_anywhere_leaves_everything_as_it_was(
    tmp_path: Path, kind: str, number: int, error: int, word: str
) -> None:
    put(tmp_path, OLD)
    before = {path: (path.stat().st_ino, path.stat().st_mtime_ns) for path in tmp_path.rglob("*.json")}
    contents = tree(tmp_path)
    written = put(tmp_path, NEW, disk=Failing(kind, number, error))
    assert codes(written) == ["E009"]
    assert word in written.diagnostics[0].message
    assert written.diagnostics[0].hint == "nothing was changed"
    assert tree(tmp_path) == contents
    assert {
        path: (path.stat().st_ino, path.stat().st_mtime_ns) for path in tmp_path.rglob("*.json")
    } == before
    assert not (tmp_path / "new").exists()
    assert put(tmp_path, NEW).diagnostics == ()
    assert without_manifest(tmp_path) == {path: text.encode() for path, text in NEW.items()}


@pytest.mark.parametrize("number", [1, 2])
def test_a_file_system_without_links_will_do(tmp_path: Path, number: int) -> None:
    put(tmp_path, OLD)
    assert put(tmp_path, NEW, disk=Failing("link", number, errno.EPERM)).diagnostics == ()
    assert without_manifest(tmp_path) == {path: text.encode() for path, text in NEW.items()}


class Interrupting(Disk):
    """Ctrl-C during the n-th operation."""

    def __init__(self, number: int) -> None:
        self.left = number

    def _count(self) -> None:
        self.left -= 1
        if self.left == 0:
            signal.raise_signal(signal.SIGINT)

    def create(self, path: Path, content: bytes, mode: int | None) -> None:
        super().create(path, content, mode)
        self._count()

    def rename(self, source: Path, target: Path) -> None:
        self._count()
        super().rename(source, target)


@pytest.mark.parametrize("number", range(1, 10))
def test_an_interrupted_build_is_whole_or_nothing(tmp_path: Path, number: int) -> None:
    put(tmp_path, OLD)
    contents = tree(tmp_path)
    with pytest.raises(KeyboardInterrupt):
        put(tmp_path, NEW, disk=Interrupting(number))
    assert not list(tmp_path.rglob(f"{STAGED}*.new")) + list(tmp_path.rglob(f"{STAGED}*.old"))
    if number <= 4:  # while files are staged
        assert tree(tmp_path) == contents
    else:  # while they are renamed: it waits
        assert without_manifest(tmp_path) == {path: text.encode() for path, text in NEW.items()}
    assert put(tmp_path, NEW).diagnostics == ()


def test_a_really_full_disk(tmp_path: Path) -> None:
    """A limit on the size of files is the one full disk that every machine has."""
    pytest.importorskip("resource")
    out = tmp_path / "out"
    put(out, OLD)
    contents = tree(out)
    program = (
        "import resource, sys\nfrom pathlib import Path\n"
        "from aseme_dsl.project.files.write import Planned, write\n"
        "resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))\n"
        "files = [Planned('models/a.json', b'new', 'models'), Planned('big', b'x' * 10000, 'models')]\n"
        "parts = frozenset({'models'})\n"
        "done = write(Path(sys.argv[1]), files, parts=parts, system='Team', source='team.aseme')\n"
        "print(done.diagnostics[0].message)"
    )
    done = subprocess.run([sys.executable, "-B", "-c", program, str(out)], capture_output=True, text=True)
    assert "cannot be written: File too large" in done.stdout, done.stderr
    assert tree(out) == contents


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="nothing is read-only for root")
def test_a_read_only_target(tmp_path: Path) -> None:
    put(tmp_path, OLD)
    (tmp_path / "models/a.json").chmod(0o444)
    assert "read-only" in put(tmp_path, NEW).diagnostics[0].message
    (tmp_path / "models/a.json").chmod(0o644)
    (tmp_path / "models").chmod(0o555)
    try:
        contents = tree(tmp_path)
        assert codes(put(tmp_path, NEW)) == ["E009"]
        assert tree(tmp_path) == contents
    finally:
        (tmp_path / "models").chmod(0o755)
