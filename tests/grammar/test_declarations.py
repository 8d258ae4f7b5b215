"""Every kind of declaration, and every entry and clause in it."""

from __future__ import annotations

from aseme_dsl.grammar.text import tree
from tests.grammar.reading import declared, places, read, short


def test_system_and_imports() -> None:
    assert short(
        read('system Kouretes import soccer\nimport "field.aseme" import "body.proto"').declarations
    ) == (
        ("System", "Kouretes"),
        ("Import", "soccer"),
        ("Import", '"field.aseme"'),
        ("Import", '"body.proto"'),
    )


def test_enum() -> None:
    assert short(declared("enum E { A B = 3, C; D = -1 E=0 }")) == (
        "Enum",
        "E",
        (
            ("EnumConstant", "A", None),
            ("EnumConstant", "B", 3),
            ("EnumConstant", "C", None),
            ("EnumConstant", "D", -1),
            ("EnumConstant", "E", 0),
        ),
    )


def test_message() -> None:
    text = "message M { bool a  double b; optional int c, repeated Pose d = 7; string optional }"
    assert short(declared(text)) == (
        "Message",
        "M",
        (
            ("Field", "", "bool", "a", None),
            ("Field", "", "double", "b", None),
            ("Field", "optional", "int", "c", None),
            ("Field", "repeated", "Pose", "d", 7),
            ("Field", "", "string", "optional", None),
        ),
    )


def test_topic() -> None:
    text = """topic team under world radio 10 delay 200ms {
      state Ball, Pose from camera, robot1 every 33ms queued persist
      signal Whistle queued expires 2s  data Track persist every 1s
      state Plain
    }"""
    assert short(declared(text)) == (
        "Topic",
        "team",
        "world",
        10,
        "200000000ns",
        (
            ("TopicEntry", "state", ("Ball", "Pose"), ("camera", "robot1"), "33000000ns", True, True, None),
            ("TopicEntry", "signal", ("Whistle",), (), None, True, False, "2000000000ns"),
            ("TopicEntry", "data", ("Track",), (), "1000000000ns", False, True, None),
            ("TopicEntry", "state", ("Plain",), (), None, False, False, None),
        ),
    )
    assert short(declared("topic a { }")) == ("Topic", "a", None, None, None, ())


def test_function_and_let() -> None:
    assert short(declared('function near(Ball b, int n) : bool = "soccer.ball:near"')) == (
        "Function",
        "near",
        (("Parameter", "Ball", "b"), ("Parameter", "int", "n")),
        "bool",
        '"soccer.ball:near"',
    )
    assert short(declared('function now() : duration = "m:f"'))[2] == ()
    assert short(declared("let near = vision.state.Ball.distance < 6\nsystem A let far = !near")) == (
        "Let",
        "far",
        "(!near)",
    )


def test_sag() -> None:
    text = """sag {
      actor player {
        goal score depends on player, coach "The ball is in."
        goal win "Won." depends on player
        goal play
      }
      actor coach { }
    }"""
    assert short(declared(text)) == (
        "Sag",
        (
            (
                "Actor",
                "player",
                (
                    ("Goal", "score", ("player", "coach"), '"The ball is in."'),
                    ("Goal", "win", ("player",), '"Won."'),
                    ("Goal", "play", (), None),
                ),
            ),
            ("Actor", "coach", ()),
        ),
    )


def test_suc() -> None:
    text = """suc {
      role center, center_for : abstract
      role referee : human  role field
      usecase attack by center, center_for includes pass, kick realises attack_goal "Together."
      usecase pass
    }"""
    assert short(declared(text)) == (
        "Suc",
        (
            ("Roles", ("center", "center_for"), "abstract"),
            ("Roles", ("referee",), "human"),
            ("Roles", ("field",), None),
        ),
        (
            (
                "UseCase",
                "attack",
                ("center", "center_for"),
                ("pass", "kick"),
                ("attack_goal",),
                '"Together."',
            ),
            ("UseCase", "pass", (), (), (), None),
        ),
    )


def test_aip_participants() -> None:
    text = """aip net {
      participant manager {
        engage "One." engage "Two."
        var bids : int = 0   var best : Offer
        let enough = bids > 3
        sends cfp Task, accept_proposal Award
        receives propose Bid
        sends inform Done
        process = Announce . settle
        settle = Award | GiveUp
      }
      participant contractor [1..*] { process = Bid~ }
      participant pair [2..3] { } participant three [3] { }
      outcome "Done."
    }"""
    net = declared(text)
    assert short(net.participants[0]) == (
        "Participant",
        "manager",
        None,
        ('"One."', '"Two."'),
        (("Var", "bids", "int", 0), ("Var", "best", "Offer", None)),
        (("Let", "enough", "(bids > 3)"),),
        (
            ("AgentMessage", "cfp", "Task"),
            ("AgentMessage", "accept_proposal", "Award"),
            ("AgentMessage", "inform", "Done"),
        ),
        (("AgentMessage", "propose", "Bid"),),
        (("NamedFormula", "process", "Announce . settle"), ("NamedFormula", "settle", "Award | GiveUp")),
    )
    assert [short(participant.multiplicity) for participant in net.participants[1:]] == [
        ("Multiplicity", 1, None),
        ("Multiplicity", 2, 3),
        ("Multiplicity", 3, 3),
    ]
    assert short(net.outcomes) == (("Outcome", '"Done."', ()),)


def test_aip_clauses() -> None:
    text = """aip a {
      clause at most one center
      clause at most 3 (Kick@center or Pass@center)
      clause PassBall@center before KickBall @ center_for
      clause every Announce@manager leads to (Await@manager or GiveUp@manager) within 10s
      clause every A leads to B
      let near = x < 3
      clause A before (B or C)
    }"""
    center = ("Place", "center", None)
    assert short(declared(text).clauses) == (
        ("Clause", "at most", (center,), (), 1, None),
        ("Clause", "at most", (("Place", "Kick", "center"), ("Place", "Pass", "center")), (), 3, None),
        (
            "Clause",
            "before",
            (("Place", "PassBall", "center"),),
            (("Place", "KickBall", "center_for"),),
            0,
            None,
        ),
        (
            "Clause",
            "leads to",
            (("Place", "Announce", "manager"),),
            (("Place", "Await", "manager"), ("Place", "GiveUp", "manager")),
            0,
            "10000000000ns",
        ),
        ("Clause", "leads to", (("Place", "A", None),), (("Place", "B", None),), 0, None),
        ("Clause", "before", (("Place", "A", None),), (("Place", "B", None), ("Place", "C", None)), 0, None),
    )
    assert short(declared(text).lets) == (("Let", "near", "(x < 3)"),)


def test_srm_plays() -> None:
    text = """srm a {
      plays attack.center
      plays attack.center_for as striker with Walk = WalkFar, Kick = KickHard
      plays relief.tired, relief.fresh with A = B, other.one
    }"""
    assert short(declared(text).plays) == (
        ("Plays", "attack", "center", None, ()),
        (
            "Plays",
            "attack",
            "center_for",
            "striker",
            (("Binding", "Walk", "WalkFar", None), ("Binding", "Kick", "KickHard", None)),
        ),
        ("Plays", "relief", "tired", None, ()),
        ("Plays", "relief", "fresh", None, (("Binding", "A", "B", None),)),
        ("Plays", "other", "one", None, ()),
    )


def test_srm_variables_capabilities_and_functionalities() -> None:
    text = """srm a {
      var n : int = -1   var p : Place = Place.HOME  var t : duration = 200ms  var s : string = "x"
      var q : bool
      let far = n > 3 let near = !far
      capability score "Scores." = KickBall, Attack  capability defend
      functionality camera { technology "CMOS" permissions "read" environment "light" algorithm "YOLO" }
      functionality arm { }
    }"""
    srm = declared(text)
    assert short(srm.variables) == (
        ("Var", "n", "int", "(-1)"),
        ("Var", "p", "Place", "Place.HOME"),
        ("Var", "t", "duration", "200000000ns"),
        ("Var", "s", "string", '"x"'),
        ("Var", "q", "bool", None),
    )
    assert short(srm.lets) == (("Let", "far", "(n > 3)"), ("Let", "near", "(!far)"))
    assert short(srm.capabilities) == (
        ("Capability", "score", '"Scores."', ("KickBall", "Attack")),
        ("Capability", "defend", None, ()),
    )
    assert short(srm.functionalities) == (
        ("Functionality", "camera", '"CMOS"', '"read"', '"light"', '"YOLO"'),
        ("Functionality", "arm", None, None, None, None),
    )


def test_srm_activities() -> None:
    text = """srm a {
      activities {
        Vision every 33ms takes 5ms as process uses camera, cpu
               reads world.state.Pose for 2s, below vision, above.state.M writes vision.state.Ball, budget
        Bare
        Backwards writes x reads around team uses b as step takes 1s every 2s
        Battery every 1s
      }
      activities { More uses c  Grasp ends held, slipped within 5s uses hand }
    }"""
    assert short(declared(text).activities) == (
        (
            "Activity",
            "Vision",
            ("camera", "cpu"),
            "33000000ns",
            "5000000ns",
            "process",
            (
                ("ActivityRead", "on", "world.state.Pose", "2000000000ns"),
                ("ActivityRead", "below", "vision", None),
                ("ActivityRead", "on", "above.state.M", None),
            ),
            ("vision.state.Ball", "budget"),
        ),
        ("Activity", "Bare", (), None, None, None, (), ()),
        (
            "Activity",
            "Backwards",
            ("b",),
            "2000000000ns",
            "1000000000ns",
            "step",
            (("ActivityRead", "around", "team", None),),
            ("x",),
        ),
        ("Activity", "Battery", (), "1000000000ns", None, None, (), ()),
        ("Activity", "More", ("c",), None, None, None, (), ()),
        ("Activity", "Grasp", ("hand",), None, None, None, (), (), "5000000000ns", ("held", "slipped")),
    )


def test_srm_formulas_follow_each_other_without_separators() -> None:
    text = "srm a { liveness { a = A . b b = B | c c = C~ } liveness { d = D\n=E } }"
    assert places(text) == ["E100 1:64"]
    text = "srm a { liveness { a = A . b b = B | c\nc\n= C~ } liveness { d = D } }"
    assert short(declared(text).formulas) == (
        ("NamedFormula", "a", "A . b"),
        ("NamedFormula", "b", "B | c"),
        ("NamedFormula", "c", "C~"),
        ("NamedFormula", "d", "D"),
    )


def test_statechart() -> None:
    text = """statechart Blink {
      var n : int = 0
      let late = n > 3
      state 0 OR  state 0.1 START
      state 0.2 BASIC On activity LedOn
      state 0.3 BASIC "Led off" activity LedOff
      state 0.4 CONDITION state 0.5 AND state state_5 END
    }"""
    assert places(text) == ["E100 7:47"]
    text = text.replace(
        "state state_5 END", "state 0.6 END\n0.1 -> 0.2 :\n0.2 -> 0.3 : after(1s) / n = n + 1"
    )
    chart = declared(text + "\n")
    assert short(chart.nodes) == (
        ("ChartNode", "0", "OR", None, None),
        ("ChartNode", "0.1", "START", None, None),
        ("ChartNode", "0.2", "BASIC", "On", "LedOn"),
        ("ChartNode", "0.3", "BASIC", '"Led off"', "LedOff"),
        ("ChartNode", "0.4", "CONDITION", None, None),
        ("ChartNode", "0.5", "AND", None, None),
        ("ChartNode", "0.6", "END", None, None),
    )
    assert short(chart.variables) == (("Var", "n", "int", 0),)
    assert short(chart.lets) == (("Let", "late", "(n > 3)"),)
    assert [(way.source.text, way.targets[0].text) for way in chart.transitions] == [
        ("0.1", "0.2"),
        ("0.2", "0.3"),
    ]
    assert short(declared("statechart A { activities { LedOn every 1s } }").activities)[0][1] == "LedOn"


def test_team() -> None:
    text = "team T { desk : dispatcher  a, b , c[1..8] : robot\n d[2..2]:robot }"
    assert short(declared(text)) == (
        "Team",
        "T",
        (
            ("TeamAgents", (("desk", None),), "dispatcher"),
            ("TeamAgents", (("a", None), ("b", None), ("c", (1, 8))), "robot"),
            ("TeamAgents", (("d", (2, 2)),), "robot"),
        ),
    )


def test_scenario_and_property() -> None:
    text = """scenario "a lost ball" {
      robot1 : player
      activity Check takes 20ms  // not now
      at 0ms robot1 receives vision.state.Ball { visible = true  pose = { x = -1.5 } }
      by 3s  robot1 in (ScanForBall
                        or Other)
    }"""
    scenario = declared(text)
    assert isinstance(scenario, tree.Scenario)
    assert [" ".join(map(str, statement)) for statement in scenario.statements] == [
        "robot1 : player",
        "activity Check takes 20ms",
        "at 0ms robot1 receives vision.state.Ball { visible = true pose = { x = - 1.5 } }",
        "by 3s robot1 in ( ScanForBall or Other )",
    ]
    assert all(name.span.text == name.text for statement in scenario.statements for name in statement)
    guarded = declared('property "guarded" { always some g in (shift or TakeOver) }')
    assert " ".join(map(str, guarded.tokens)) == "always some g in ( shift or TakeOver )"
    assert declared('scenario "empty" { }').statements == ()


def test_words_are_names_where_nothing_begins() -> None:
    text = """
    topic team { state system }
    message system { int message  bool topic  double every }
    enum role { actor goal }
    srm srm {
      var state : int = 0
      let system = team.state.system.message + state
      liveness { srm = sag . enter | team . usecase process = suc }
      activities { sag uses uses, reads  reads team.state.system writes state }
      control srm { enter sag : [system > state && role.actor == role.goal && let(import) < 3] }
    }
    team team { team, agent : srm }
    """
    read(text)


def test_words_of_the_block_are_no_names() -> None:
    assert places("srm a { var plays : int }") == ["E106 1:13"]
    assert places("aip a { let outcome = 3 }") == ["E106 1:13"]
    assert places("aip a { participant p { sends = A } }") == ["E106 1:25"]
    assert places("srm else { }") == ["E106 1:5"]
    assert places("srm a { liveness { a = A . not . B } }") == ["E106 1:28"]
    assert places("srm a { liveness { a = int } }") == ["E106 1:24"]
    assert places("message state { }") == ["E106 1:9"]


def test_what_is_said_twice() -> None:
    assert places("srm a { activities { A every 1s every 2s } }") == ["E114 1:33"]
    assert places("topic t under a under b { state M queued queued }") == ["E114 1:23", "E114 1:42"]
    assert places('sag { actor a { goal g "x" "y" } }') == ["E114 1:28"]
    assert places('srm a { functionality f { technology "x" technology "y" } }') == ["E114 1:42"]


def test_ranges() -> None:
    assert places("team T { a[3..1] : b }") == ["E115 1:12"]
    assert places("aip a { participant p [3..1] { } participant q [0] { } }") == ["E115 1:24", "E115 1:49"]
