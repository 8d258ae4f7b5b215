"""From goals to use cases to what is expected of protocols and roles."""

from __future__ import annotations

from aseme_dsl.amola.suc import RoleType, Suc
from tests.support.compiling import analysis, system


def suc(text: str) -> Suc:
    return system(f"system S\n{text}").suc


def test_actors_become_roles_and_goals_use_cases_of_all_who_take_part() -> None:
    found = suc(
        """sag {
  actor player { goal score depends on goalie, player "Win." }
  actor goalie { goal rest }
  actor idle { }
}"""
    )
    assert [(role.name, role.type) for role in found.roles] == [
        ("player", RoleType.SYSTEM),
        ("goalie", RoleType.SYSTEM),
        ("idle", RoleType.SYSTEM),
    ]
    assert [(case.name, case.participants, case.requirements) for case in found.usecases] == [
        ("score", ("player", "goalie"), "Win."),
        ("rest", ("goalie",), ""),
    ]


def test_role_types_are_kept_also_those_of_actors() -> None:
    found = suc(
        """sag { actor coach { goal plan }  actor player { } }
suc {
  role coach : human  role camera : legacy
  role center, center_for : abstract  role league : external
}"""
    )
    assert {role.name: role.type.value for role in found.roles} == {
        "coach": "human",
        "player": "system",
        "camera": "legacy",
        "center": "abstract",
        "center_for": "abstract",
        "league": "external",
    }


def test_a_use_case_specifies_the_goal_of_its_name() -> None:
    found = suc(
        """sag { actor player { goal score_goal "Win." }  actor goalie { } }
suc { usecase ScoreGoal by goalie includes kick_ball realises Shoot "By kicking." }"""
    )
    (score, kick) = found.usecases
    assert (score.name, score.participants, score.includes) == (
        "score_goal",
        ("player", "goalie"),
        ("kick_ball",),
    )
    assert (score.requirements, score.realises) == ("Win.\nBy kicking.", ("Shoot",))
    assert kick.name == "kick_ball"


def test_included_use_cases_are_declared_thereby_and_spelled_as_first_written() -> None:
    found = suc("suc { usecase a includes b, walk_far  usecase b includes c, WalkFar  usecase c }")
    assert [(case.name, case.includes) for case in found.usecases] == [
        ("a", ("b", "walk_far")),
        ("b", ("c", "walk_far")),
        ("c", ()),
        ("walk_far", ()),
    ]


def test_a_capability_follows_from_a_use_case_with_inclusions() -> None:
    text = """system S
sag { actor player { goal score "Win." } }
suc { usecase score includes kick_ball, attack  usecase attack includes pass_ball, kick_ball }
srm player {
  capability dance "On wins." = KickBall
  liveness { player = score  score = KickBall . PassBall }
}
"""
    found = analysis(text)
    assert found.system is not None
    assert [(c.name, c.activities, c.description) for c in found.system.srms[0].capabilities] == [
        ("dance", ("KickBall",), "On wins."),
        ("score", ("KickBall", "PassBall"), "Win."),
    ]


def test_what_is_missing_is_never_an_error() -> None:
    text = """system S
sag { actor player { goal score depends on goalie  goal rest }  actor goalie { } }
suc { usecase score includes kick, block  usecase block by goalie }
"""
    found = analysis(text)
    assert {item.severity for item in found.diagnostics} == {"note"}
    assert found.system is not None


def decided(text: str) -> str:
    """The text with every operator that is still to be chosen: one after the other."""
    assert " ? " in text
    return text.replace(" ? ", " . ")


def test_skeletons_compile_and_leave_nothing_out() -> None:
    text = """system S
sag {
  actor player { goal score depends on goalie  goal rest  goal train }
  actor goalie { goal guard }
  actor idle { }
}
suc {
  role center : abstract
  usecase score includes kick, block, attack
  usecase block by goalie
  usecase attack by center, goalie includes run, kick
  usecase train includes run, lift
  usecase lift includes pull, push
}
"""
    notes = analysis(text).diagnostics
    skeletons = [item.hint.split("\n", 1)[1] for item in notes if item.hint and item.code in ("N701", "N703")]
    assert len(skeletons) == 5
    complete = analysis(decided(text + "\n".join(skeletons)))
    assert complete.system is not None
    assert {item.code for item in complete.diagnostics} <= {"N704", "N706"}  # nobody plays `center`
    used = {node.name for chart in complete.system.statecharts for node in chart.states}
    assert {"Kick", "Block", "Run", "Pull", "Push", "Rest", "Guard", "train", "lift"} <= used


def test_a_use_case_that_is_called_like_its_role_is_not_lost() -> None:
    text = """system S
sag { actor guard { goal guard } }
suc { usecase guard includes watch, walk_round }
"""
    (note,) = analysis(text).diagnostics
    assert note.code == "N703" and note.hint is not None
    found = analysis(decided(text + note.hint.split("\n", 1)[1]))
    assert found.diagnostics == () and found.system is not None
    assert found.system.srms[0].activities == ("Watch", "WalkRound")
