from __future__ import annotations

import json
import os
import sys
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from aseme_dsl import outside

VALUES = st.recursive(
    st.none() | st.booleans() | st.integers() | st.text(),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(), inner, max_size=3),
    max_leaves=40,
)


@given(VALUES)
def test_json_is_read_as_the_standard_library_reads_it(value: object) -> None:
    text = json.dumps(value)
    assert outside.loads(text) == value
    assert outside.loads(json.dumps(value, ensure_ascii=False).encode("utf-8", "surrogatepass")) == value


def deep(value: object) -> int:
    inner = value.values() if isinstance(value, dict) else value if isinstance(value, list) else None
    return 0 if inner is None else 1 + max(map(deep, inner), default=0)


@given(VALUES)
def test_brackets_in_texts_are_no_depth(value: object) -> None:
    assert outside.depth(json.dumps(value)) == deep(value)


@pytest.mark.parametrize("opening", ["[", '{"a":', '[{"a":'])
def test_deep_json_is_refused_before_it_is_parsed(opening: str) -> None:
    for text in (opening * 100_000, '["\\"' + opening * 100_000):
        with pytest.raises(ValueError):
            outside.loads(text)
    with pytest.raises(ValueError, match="more than 100 lists and objects"):
        outside.loads(opening * 100_000)


def test_as_deep_as_is_allowed_is_read() -> None:
    assert outside.loads("[" * 100 + "]" * 100)
    with pytest.raises(ValueError, match="in each other"):
        outside.loads("[" * 101 + "]" * 101)
    assert outside.loads("[" + "[]," * 1000 + '"[[[["]')


def test_large_json_is_refused() -> None:
    with pytest.raises(ValueError, match="larger than 10 bytes"):
        outside.loads(b"[1,2,3,4,5,6]", largest=10)


def test_a_regular_file_is_read_and_links_are_followed(tmp_path: Path) -> None:
    (tmp_path / "a").write_bytes(b"one\r\ntwo")
    (tmp_path / "b").symlink_to("a")
    assert outside.read_bytes(tmp_path / "b") == b"one\r\ntwo"
    assert outside.read_text(tmp_path / "b") == "one\ntwo"
    with pytest.raises(OSError, match="larger than 4 bytes"):
        outside.read_bytes(tmp_path / "a", largest=4)
    with pytest.raises(FileNotFoundError):
        outside.read_bytes(tmp_path / "c")
    with pytest.raises(IsADirectoryError):
        outside.read_bytes(tmp_path)
    with pytest.raises(OSError, match="not the name of a file"):
        outside.read_bytes(tmp_path / "a\0b")


@pytest.mark.skipif(sys.platform == "win32", reason="there are no such files")
@pytest.mark.parametrize("name", ["pipe", "device", "link"])
def test_what_is_no_regular_file_is_refused_at_once(tmp_path: Path, name: str) -> None:
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "link").symlink_to("pipe")
    path = Path("/dev/zero") if name == "device" else tmp_path / name
    with pytest.raises(OSError, match="not a regular file"):
        outside.read_bytes(path)


@pytest.mark.skipif(sys.platform == "win32", reason="there are no such files")
@pytest.mark.parametrize("name", ["pipe", "folder", "a\0b"])
def test_what_cannot_take_all_is_not_written(tmp_path: Path, name: str) -> None:
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "folder").mkdir()
    with pytest.raises(OSError):
        outside.new_file(tmp_path / name)


def test_a_file_is_emptied_and_a_device_takes_all(tmp_path: Path) -> None:
    (tmp_path / "a").write_bytes(b"much")
    (tmp_path / "b").symlink_to("a")
    with outside.new_file(tmp_path / "b") as file:
        file.write(b"x")
    assert (tmp_path / "a").read_bytes() == b"x"
    outside.new_file(os.devnull).close()


def test_lines_and_contents_are_bounded(tmp_path: Path) -> None:
    path = tmp_path / "a"
    path.write_bytes(b"one\ntwo")
    with outside.open_file(path) as file:
        assert list(outside.lines(file, 4)) == [b"one\n", b"two"]
    with outside.open_file(path) as file, pytest.raises(OSError, match="longer than 3 bytes"):
        list(outside.lines(file, 3))
    assert outside.holds(path, b"one\ntwo")
    assert not outside.holds(path, b"one\ntw") and not outside.holds(path, b"one\ntwoo")
    assert not outside.holds(tmp_path, b"") and not outside.holds(tmp_path / "c", b"")
