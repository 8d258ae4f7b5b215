"""`simulated`: an activity that has no code, on purpose."""

from aseme_dsl.runtime import Context
from tests.runtime.playing import play


class Walk:
    def execute(self, context: Context) -> None:
        context.log("I walk.")


def test_no_code_is_loaded_for_it() -> None:
    text = "system S srm R { liveness { R = Walk } activities { Walk simulated takes 2s } }"
    run = play(text, {"Walk": Walk})
    assert run.activities() == ["0 start Walk", "2000 end Walk"]
    assert run.of("log") == run.of("fault") == []


def test_what_one_role_says_holds_for_all() -> None:
    text = """
      system S
      srm A { liveness { A = Walk } activities { Walk takes 2s } }
      srm B { liveness { B = Walk } activities { Walk simulated } }
      team T { a : A  b : B }"""
    run = play(text, {"Walk": Walk}, agents=[("a", "A"), ("b", "B")])
    assert run.activities("end") == ["2000 end Walk", "2000 end Walk"]
    assert run.of("log") == []


def test_its_outcome_is_the_first() -> None:
    text = """
      system S
      srm R {
        liveness { R = Grasp . (A | B | C) }
        activities { Grasp takes 1s simulated ends held, slipped  A takes 1s  B takes 1s  C takes 1s }
        control R {
          enter A : [outcome(Grasp) == held]
          enter B : [outcome(Grasp) == slipped]
          enter C : else
        }
      }"""
    assert play(text).order("start") == ["start Grasp", "start A"]
