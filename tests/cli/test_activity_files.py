"""The files of activities: what the commands say where one is missing, empty or not needed."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.support import Done, Here

SYSTEM = """\
system Team
srm player {
  liveness { player = Search . KickBall }
  activities { Search takes 1s  KickBall takes 1s }
}
"""
PROJECT = '[tool.asemec]\nfiles = ["team.aseme"]\noutput = "out"\nactivities = "acts"\n'
CODE = "class {name}:\n    def execute(self, context):\n        context.log('done')\n"


@pytest.fixture
def project(folder: Path) -> Path:
    """A project whose activities have their files."""
    (folder / "team.aseme").write_text(SYSTEM)
    (folder / "pyproject.toml").write_text(PROJECT)
    (folder / "acts").mkdir()
    write(folder, "acts/search.py", "Search")
    write(folder, "acts/kick_ball.py", "KickBall")
    return folder


def write(folder: Path, path: str, name: str, before: str = "") -> None:
    (folder / path).write_text(before + CODE.format(name=name))


def change(folder: Path, old: str, new: str) -> None:
    text = (folder / "team.aseme").read_text()
    assert old in text
    (folder / "team.aseme").write_text(text.replace(old, new))


def codes(done: Done) -> list[str]:
    return [item["code"] for item in done.json["diagnostics"]]


def only(done: Done) -> tuple[str, str, str]:
    """Code, message and hint of the only problem."""
    (item,) = done.json["diagnostics"]
    return item["code"], item["message"], item["hint"]


def files(folder: Path) -> list[str]:
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*"))


def test_a_project_with_all_its_files_is_fine(here: Here, project: Path) -> None:
    assert here("check").out == "no problems found in 1 file\n"


def test_a_missing_file_is_an_error_and_nothing_is_played_or_written(here: Here, project: Path) -> None:
    (project / "acts/kick_ball.py").unlink()
    before = files(project)
    code, message, hint = only(here("check", "--json"))
    assert code == "E543"
    assert message == "the activity `KickBall` has no code: there is no `acts/kick_ball.py`"
    assert hint == (
        "`asemec scaffold team.aseme` starts the file; or let it be simulated: `KickBall takes 1s simulated`"
    )
    for command in (("check",), ("build",), ("run",), ("node", "player", "."), ("optimise", ".")):
        done = here(*command)
        assert done.code == 1 and "team.aseme:4:33: error[E543]" in done.out + done.err, command
    assert files(project) == before


def test_a_simulated_activity_needs_no_file(here: Here, project: Path) -> None:
    (project / "acts/kick_ball.py").unlink()
    change(project, "KickBall takes 1s", "KickBall takes 1s simulated")
    assert here("check").out == "no problems found in 1 file\n"
    done = here("run")
    assert done.code == 0
    assert "  simulated (declared): KickBall\n" in done.out
    assert here("build").code == 0 and not (project / "acts/kick_ball.py").exists()
    assert here("scaffold", "team.aseme").out == "team.aseme: 0 skeletons added\n"


def test_the_file_of_a_simulated_activity_is_reported(here: Here, project: Path) -> None:
    change(project, "KickBall takes 1s", "KickBall takes 1s simulated")
    code, message, _ = only(here("check", "--json"))
    assert (code, message) == ("W542", "`KickBall` is simulated, so `acts/kick_ball.py` is not loaded")
    write(project, "acts/search.py", "Search", "from .kick_ball import KickBall\n")
    assert codes(here("check", "--json")) == []
    change(project, "simulated", "simulated // asemec: allow(W542) for the match on Friday\n")
    write(project, "acts/search.py", "Search")
    assert codes(here("check", "--json")) == []


def test_a_folder_that_is_missing_is_reported_once(here: Here, project: Path) -> None:
    (project / "acts").rename(project / "act")
    code, message, hint = only(here("check", "--json"))
    assert code == "E544" and "`acts`" in message and hint == "did you mean `act`?"
    assert "pyproject.toml:4:1: error[E544]" in here("check").out
    (project / "act").rename(project / "elsewhere")
    assert only(here("check", "--json"))[2] == (
        "`asemec scaffold team.aseme` starts it, with a file for each activity"
        "; or name another one, here or with `--activities`"
    )
    assert here("scaffold", "team.aseme").code == 0
    assert files(project / "acts") == ["kick_ball.py", "search.py"]
    assert codes(here("check", "--json")) == ["N740", "N740"]


def test_a_folder_that_an_option_names(here: Here, project: Path) -> None:
    (project / "pyproject.toml").unlink()
    assert here("check", "team.aseme").out == "no problems found in 1 file\n"
    for command in ("build", "run"):
        done = here(command, "team.aseme", "--activities", "nowhere")
        assert done.code == 1 and "error[E544]" in done.err, command
    (project / "acts/search.py").unlink()
    for command in ("build", "run"):
        done = here(command, "team.aseme", "--activities", "acts")
        assert done.code == 1 and "error[E543]" in done.err, command
    assert here("scaffold", "team.aseme", "--activities", "acts").code == 0
    assert here("run", "team.aseme", "--activities", "acts").code == 0


def test_a_file_that_nobody_has_filled_in_is_noted(here: Here, project: Path) -> None:
    (project / "acts/kick_ball.py").unlink()
    done = here("scaffold", "team.aseme")
    assert done.out == "team.aseme: 0 skeletons added\nacts/kick_ball.py: created\n"
    code, message, hint = only(here("check", "--json"))
    assert (code, message) == (
        "N740",
        "the activity `KickBall` is not written yet: its `execute` does nothing",
    )
    assert hint == "write its `execute`; or delete the file and say `KickBall takes 1s simulated`"
    assert "acts/kick_ball.py:6:7: note[N740]" in here("check").out
    assert "  simulated (empty stub): KickBall\n" in here("run").out


def test_a_preview_of_scaffold_shows_the_files(here: Here, project: Path) -> None:
    (project / "acts/kick_ball.py").unlink()
    done = here("scaffold", "--diff", "team.aseme")
    assert "+++ acts/kick_ball.py" in done.out and "+class KickBall:" in done.out
    assert not (project / "acts/kick_ball.py").exists()


def test_a_file_that_nothing_uses(here: Here, project: Path) -> None:
    write(project, "acts/dance.py", "Dance")
    code, message, hint = only(here("check", "--json"))
    assert (code, message) == ("W541", "no activity uses `acts/dance.py`")
    assert hint == "delete it, or import it where it is needed"
    write(project, "acts/dance.py", "Dance", "# asemec: allow(W541) for later\n")
    (project / "acts/dance.py").write_text("class Dance: ...  # asemec: allow(W541) for later\n")
    assert codes(here("check", "--json")) == []


def test_a_file_with_a_slip_in_its_name(here: Here, project: Path) -> None:
    (project / "acts/kick_ball.py").rename(project / "acts/kickball.py")
    missing, unused = here("check", "--json").json["diagnostics"]
    if missing["code"] == "W541":
        missing, unused = unused, missing
    assert missing["hint"] == "did you mean `acts/kickball.py`? Rename it to `kick_ball.py`"
    assert unused["hint"] == "did you mean `kick_ball.py`? Rename it"


@pytest.mark.parametrize(
    "user",
    [
        ("acts/search.py", "from .dance import Dance\n"),
        ("acts/search.py", "from . import dance\n"),
        ("acts/search.py", "import acts.dance as moves\n"),
        ("acts/search.py", "from acts import dance\n"),
        ("acts/search.py", "def f():\n    from .dance import Dance\n"),
        ("acts/search.py", "from .waltz import Waltz\n"),
        ("acts/search.py", "import importlib\n"),
        ("world.py", "from acts.dance import Dance\n"),
    ],
)
def test_who_uses_a_file(here: Here, project: Path, user: tuple[str, str]) -> None:
    path, imports = user
    write(project, "acts/dance.py", "Dance")
    if "waltz" in imports:
        write(project, "acts/waltz.py", "Waltz", "from .dance import Dance\n")
    write(project, path, "Search", imports)
    assert codes(here("check", "--json")) == []


def test_functions_modules_and_tests_use_files(here: Here, project: Path) -> None:
    change(project, "srm player {", 'function near(int n) : bool = "acts.places:near"\nsrm player {')
    change(
        project,
        "  liveness",
        '  var n : int = 0\n  modules { Eyes every 1s = "acts.sight:Eyes" }\n  liveness',
    )
    change(project, "}\n}\n", "}\n  control player { enter KickBall : [near(n)] }\n}\n")
    (project / "acts/places.py").write_text("def near(n):\n    return n > 1\n")
    write(project, "acts/sight.py", "Eyes")
    write(project, "acts/test_search.py", "Tests")
    (project / "acts/__init__.py").write_text("")
    assert "W541" not in codes(here("check", "--json"))


def test_systems_that_share_a_folder(here: Here, project: Path) -> None:
    other = (
        SYSTEM.replace("Team", "Other").replace("Search . KickBall", "Dance").replace("Search takes 1s  ", "")
    )
    (project / "other.aseme").write_text(other.replace("KickBall takes", "Dance takes"))
    write(project, "acts/dance.py", "Dance")
    assert codes(here("check", "--json", "team.aseme")) == []
    (project / "pyproject.toml").write_text(PROJECT.replace('"team.aseme"', '"team.aseme", "other.aseme"'))
    assert codes(here("check", "--json")) == []


def test_a_module_needs_its_file(here: Here, project: Path) -> None:
    change(project, "  liveness", "  modules { Eyes every 1s }\n  liveness")
    code, message, hint = only(here("check", "--json"))
    assert (code, message) == ("E543", "the module `Eyes` has no code: there is no `acts/eyes.py`")
    assert hint == "`asemec scaffold team.aseme` starts the file"


def test_an_activity_of_the_library_is_reported_at_the_role(here: Here, project: Path) -> None:
    (project / "team.aseme").write_text(
        "system Team\nimport protocols\n"
        "srm boss { plays contract_net.manager  liveness { boss = manager } }\n"
        "srm hand { plays contract_net.contractor  liveness { hand = contractor~ } }\n"
    )
    found = here("check", "--json").json["diagnostics"]
    missing = [item for item in found if item["code"] == "E543"]
    assert missing, found
    assert {item["place"]["file"] for item in missing} == {"team.aseme"}


def test_run_never_starts_files_and_says_what_does(here: Here, project: Path) -> None:
    (project / "pyproject.toml").unlink()
    done = here("run", "team.aseme")
    assert done.code == 0
    said = "simulated (no code): Search, KickBall"
    assert f"  {said}; `asemec build team.aseme` creates stubs\n" in done.out
    assert not (project / "out/monas/activities").exists()
    assert here("build", "team.aseme").code == 0
    assert files(project / "out/monas/activities") == ["kick_ball.py", "search.py"]
    assert "simulated (empty stub): Search, KickBall" in here("run", "team.aseme").out
    assert here("check", "team.aseme").out == "no problems found in 1 file\n"


def test_what_scaffold_writes_says_which_variables_may_be_used(here: Here, folder: Path) -> None:
    (folder / "team.aseme").write_text(
        """system Team
message Ball { bool visible }
topic vision { state Ball }
srm player {
  var tries : int = 0
  var tired : bool = false
  liveness { player = Search . Kick . Rest }
  modules { Eyes every 1s reads tries writes vision.state.Ball, tired }
  activities {
    Search reads vision.state.Ball, tries writes tries, tired
    Kick reads tries
    Rest writes tired
  }
}
"""
    )
    (folder / "pyproject.toml").write_text(PROJECT)
    assert here("scaffold", "team.aseme").code == 0
    search = (folder / "acts/search.py").read_text()
    assert "    Reads vision.state.Ball, tries.\n    Writes tries, tired.\n" in search
    kick = (folder / "acts/kick.py").read_text()
    assert "    Reads tries.\n" in kick and "Writes" not in kick
    assert "\n\n    Writes tired.\n" in (folder / "acts/rest.py").read_text()
    eyes = (folder / "acts/eyes.py").read_text()
    assert "    Reads tries.\n    Writes vision.state.Ball, tired.\n" in eyes


def test_an_activity_that_was_renamed_in_the_file(here: Here, project: Path) -> None:
    change(project, ". KickBall", ". Shoot")
    change(project, "KickBall takes", "Shoot takes")
    found = {item["code"]: item["hint"] for item in here("check", "--json").json["diagnostics"]}
    assert found == {
        "E543": "did you mean `acts/kick_ball.py`? Rename it to `shoot.py`, and its class to `Shoot`",
        "W541": "did you mean `shoot.py`? Rename it, and its class to `Shoot`",
    }
    (project / "acts/kick_ball.py").write_text("SPEED = 1\n")  # no activity: something else
    found = {item["code"]: item["hint"] for item in here("check", "--json").json["diagnostics"]}
    assert "scaffold" in found["E543"] and "delete" in found["W541"]


SHOP = """system Shop
aip deal {
  participant buyer  { engage "It wants." process = Ask . Pay }
  participant seller { engage "It has." process = Wait . give  give = Sell }
  outcome "Sold."
}
srm customer { plays deal.buyer  liveness { customer = buyer }
  activities { Ask takes 1s simulated  Pay takes 1s simulated } }
srm shop { liveness { shop = Open . seller }  activities { Open takes 1s simulated } }
"""


def test_a_participant_that_the_role_forgets_to_play(here: Here, project: Path) -> None:
    (project / "team.aseme").write_text(SHOP)
    for path in (project / "acts").iterdir():
        path.unlink()
    write(project, "acts/sell.py", "Sell")
    write(project, "acts/wait.py", "Wait")
    done = here("check", "--json")
    assert only(done) == (
        "E543",
        "the activity `seller` has no code: there is no `acts/seller.py`",
        "write `plays deal.seller` in srm shop",
    )
    assert done.code == 1
    assert "the participant of deal, which shop does not play" in here("check").out
    write(project, "acts/sale.py", "Sale")  # is of nobody, whatever is played
    assert sorted(codes(here("check", "--json"))) == ["E543", "W541"]
    (project / "acts/sale.py").unlink()
    change(project, "srm shop {", "srm shop { plays deal.seller ")
    assert here("check").out == "no problems found in 1 file\n"
    change(project, "plays deal.seller ", "")
    change(project, "1s simulated } }\nsrm shop", "1s simulated } }\nsrm shop")
    change(project, "activities { Open", "activities { seller takes 1s simulated  Open")
    assert codes(here("check", "--json")).count("W202") == 1  # no error that says it


def test_the_participant_may_be_one_of_several_protocols(here: Here, project: Path) -> None:
    other = "aip swap { participant seller { process = Give }  participant taker { process = Take } }\n"
    (project / "team.aseme").write_text(SHOP.replace("srm customer", f"{other}srm customer"))
    for path in (project / "acts").iterdir():
        path.unlink()
    for name in ("Sell", "Wait", "Give"):  # would be used, whichever is played
        write(project, f"acts/{name.lower()}.py", name)
    found = here("check", "--json").json["diagnostics"]
    assert [item["hint"] for item in found if item["code"] == "E543"] == [
        "write `plays deal.seller` or `plays swap.seller` in srm shop"
    ]
    assert "W541" not in [item["code"] for item in found]


SILENT = """system Kitchen
message Meal { int table }
aip serving {
  participant waiter { process = Ask }
  participant cook {
    sends    inform Meal
    process  = Cook
  }
}
srm robot { plays serving.cook  liveness { robot = cook }  activities { Cook takes 1s simulated } }
"""


def test_what_a_simulated_activity_would_send_is_sent_by_nobody(here: Here, folder: Path) -> None:
    (folder / "kitchen.aseme").write_text(SILENT)
    assert "no line and no activity of `cook` sends `inform Meal`" in here("check", "kitchen.aseme").out


@pytest.mark.parametrize(
    "allowed",
    [
        "    // asemec: allow(W556) later\n    // (the grill is not there yet)\n    sends    inform Meal\n",
        "    sends    inform Meal  // asemec: allow(W556) later\n",
    ],
)
def test_a_comment_above_or_behind_allows_it(here: Here, folder: Path, allowed: str) -> None:
    text = SILENT.replace("    sends    inform Meal\n", allowed)
    (folder / "kitchen.aseme").write_text(text)
    done = here("check", "kitchen.aseme", "--json")
    assert [item["code"] for item in done.json["diagnostics"] if item["code"] in ("W556", "W011")] == []
    (folder / "kitchen.aseme").write_text(text.replace("W556", "W300"))
    done = here("check", "kitchen.aseme", "--json")
    assert [item["code"] for item in done.json["diagnostics"] if item["code"][0] == "W"].count("W556") == 1
