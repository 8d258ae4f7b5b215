"""The canonical layout: what is aligned, what is broken, what stays."""

from __future__ import annotations

import random
import re
from textwrap import dedent

import pytest

from aseme_dsl.grammar.layout import format_source
from aseme_dsl.grammar.layout.fill import WIDTH
from aseme_dsl.source import Source


def laid(text: str) -> str:
    """The layout of a text, indented as the test likes, which is stable."""
    result = format_source(Source("test.aseme", dedent(text)))
    assert not result.diagnostics
    assert format_source(Source("test.aseme", result.text)).text == result.text
    return result.text


def becomes(before: str, after: str) -> None:
    assert laid(before) == dedent(after).lstrip("\n")


def stays(text: str) -> None:
    becomes(text, text)


# ---- tables ------------------------------------------------------------------------------------


def test_control_is_aligned_at_the_colon() -> None:
    becomes(
        """
        srm r { control r {
        enter Walk:[a.state.M.x]/start_timer( t,1s )
        repeat (Walk|Stand) : else
        skip Stand#2:
        } }
        """,
        """
        srm r {
          control r {
            enter  Walk           : [a.state.M.x] / start_timer(t, 1s)
            repeat (Walk | Stand) : else
            skip   Stand#2        :
          }
        }
        """,
    )  # fmt: skip


def test_a_blank_line_ends_a_table_and_a_comment_does_not() -> None:
    stays(
        """
        srm r {
          control r {
            enter Walk  : [a]
            // A comment.
            enter Stand : else

            leave  (Walk | Stand) : [b]
            repeat (Walk | Stand) : else
          }
        }
        """
    )


def test_what_is_very_wide_sticks_out() -> None:
    stays(
        f"""
        srm r {{
          liveness {{
            a = B
            c = D
            {"long" * 15} = E
          }}
        }}
        """
    )


def test_fields_variables_agents_and_formulas_are_aligned() -> None:
    becomes(
        """
        message M {
          int x = 1
          Colour colour
          repeated double many
        }
        srm r {
          var n : int = 0
          var name : string = "x"
          liveness {
            r = A
            longer = B
          }
        }
        team T {
          one, two : r
          c[1..8] : r
        }
        """,
        """
        message M {
          int    x = 1
          Colour colour
          repeated double many
        }

        srm r {
          var n    : int    = 0
          var name : string = "x"
          liveness {
            r      = A
            longer = B
          }
        }

        team T {
          one, two : r
          c[1..8]  : r
        }
        """,
    )


def test_clauses_stand_in_columns_and_stay_on_lines_of_their_own() -> None:
    becomes(
        """
        srm r {
          activities {
            Walk every 10ms uses legs reads a.state.M
            LookAround uses camera
               reads a.state.M
               writes b.state.M, c.state.M
            Rest every 1s
          }
        }
        """,
        """
        srm r {
          activities {
            Walk       every 10ms uses legs reads  a.state.M
            LookAround            uses camera
                                            reads  a.state.M
                                            writes b.state.M, c.state.M
            Rest       every 1s
          }
        }
        """,
    )


def test_blocks_on_one_line_are_aligned_at_their_braces() -> None:
    becomes(
        """
        message Task { string id; double x, double y, }
        message Bid {string task}
        enum E{A,B;C}
        enum Numbered { A = 1, B = -2 }
        """,
        """
        message Task { string id  double x  double y }
        message Bid  { string task }
        enum E        { A B C }
        enum Numbered { A = 1  B = -2 }
        """,
    )


def test_a_block_is_on_one_line_if_its_author_began_it_there_and_it_fits() -> None:
    becomes(
        """
        message A { int x
          int y }
        message B {
          int x int y }
        """,
        """
        message A { int x  int y }

        message B {
          int x
          int y
        }
        """,
    )
    names = "  ".join(f"int field_number_{n}" for n in range(8))
    assert laid(f"message A {{ {names} }}").count("\n") == 10


# ---- long lines --------------------------------------------------------------------------------


def test_long_formulas_are_broken_at_the_loosest_operators() -> None:
    names = [f"Act{n}" for n in range(10, 26)]
    becomes(
        f"srm r {{ liveness {{ r = {' || '.join(f'{name}~' for name in names)} || (A . B) }} }}",
        """
        srm r {
          liveness {
            r = Act10~ || Act11~ || Act12~ || Act13~ || Act14~ || Act15~ || Act16~ || Act17~ || Act18~ || Act19~
                || Act20~ || Act21~ || Act22~ || Act23~ || Act24~ || Act25~ || (A . B)
          }
        }
        """,  # noqa: E501
    )
    becomes(
        f"srm r {{ liveness {{ r = A || ({' . '.join(names)}) | C }} }}",
        """
        srm r {
          liveness {
            r = A
                || (Act10 . Act11 . Act12 . Act13 . Act14 . Act15 . Act16 . Act17 . Act18 . Act19 . Act20 . Act21
                    . Act22 . Act23 . Act24 . Act25)
                  | C
          }
        }
        """,  # noqa: E501
    )


def test_long_transition_expressions_are_broken_at_actions_then_in_the_condition() -> None:
    stays(
        """
        srm r {
          control r {
            enter A : [expired(pace) && game.state.GameState.player_state != PlayerState.FINISHED && fit]
                      / start_timer(pace, 100ms)
            leave A : when [vision.state.Ball.visible && vision.state.Ball.distance < approach_limit
                            && (is_center || is_center_for) && world.state.Pose.distance_to_post < 250]
            leave C : [vision.state.Ball.visible && vision.state.Ball.distance < approach_limit && is_center
                       || fallen]
                      / start_timer(pace, 100ms)
            leave B : inform Something from contractor or failure Something from contractor or after(2min)
                      / send reject_proposal Contract to contractor; team.state.Assignment.center = number;
                        write_messages.team.state.Assignment
          }
        }
        """
    )


def test_long_lists_are_broken_at_their_commas() -> None:
    channels = ", ".join(f"topic{n}.state.Message" for n in range(6))
    becomes(
        f"srm r {{ activities {{\nWalk reads {channels}\n}} }}",
        """
        srm r {
          activities {
            Walk reads topic0.state.Message, topic1.state.Message, topic2.state.Message, topic3.state.Message,
                       topic4.state.Message, topic5.state.Message
          }
        }
        """,
    )


def test_no_line_is_too_long_that_can_be_broken() -> None:
    term = "(Alpha . [Beta] . Gamma+ . (Delta | Epsilon~ | Zeta*))"
    text = laid(f"srm r {{ liveness {{ r = {' || '.join([term] * 20)} }} }}")
    assert max(map(len, text.splitlines())) <= WIDTH


@pytest.mark.parametrize("depth", [100, 500])
def test_formulas_may_be_nested_deeply(depth: int) -> None:
    text = "A . (" * depth + "B" + ")" * depth
    assert laid(f"srm r {{ liveness {{ r = {text} }} }}")
    assert laid(f"srm r {{ liveness {{ r = {'(' * depth}A . B{')' * depth} }} }}")
    assert laid(f"srm r {{ liveness {{ r = {'[' * depth}A | B{']' * depth} }} }}")


# ---- blanks ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("written", "canonical"),
    [
        ("A.B|C||D", "A . B | C || D"),
        ("( A )* . [ B . C ]+ . D ω", "(A)* . [B . C]+ . D~"),
        ("Vision ^ω || Visionω", "Vision~ || Vision~"),
        ("A [ 3 ] . | B ~ | 3", "A[3] . |B~|3"),
        ("| |A|3|2 | B", "| |A|3|2 | B"),
        ("A || |B|2", "A || |B|2"),
    ],
)
def test_blanks_in_formulas(written: str, canonical: str) -> None:
    assert f"  r = {canonical}\n" in laid(f"srm r {{ liveness {{\nr={written}\n}} }}")


@pytest.mark.parametrize(
    ("written", "canonical"),
    [
        ("1+2*3", "1 + 2 * 3"),
        ("- 1 - - 2", "-1 - -2"),
        ("!a&&! (b||not c)", "!a && !(b || not c)"),
        ("f ( x,- 1 ) and g( )", "f(x, -1) and g()"),
        ("vision . state\n. Ball.x<200ms", "vision.state.Ball.x < 200ms"),
        ('x!="a  b"', 'x != "a  b"'),
    ],
)
def test_blanks_in_expressions(written: str, canonical: str) -> None:
    assert laid(f"let a={written}") == f"let a = {canonical}\n"


@pytest.mark.parametrize(
    ("written", "canonical"),
    [
        ("after( 5s )or when[a]", "after(5s) or when [a]"),
        ("[a/2>1]/x=-1;y=x/2", "[a / 2 > 1] / x = -1; y = x / 2"),
        ("else/send cfp M to b", "else / send cfp M to b"),
        ("/read_messages ;f( )", "/ read_messages; f()"),
    ],
)
def test_blanks_in_transition_expressions(written: str, canonical: str) -> None:
    text = laid(f"srm r {{ control r {{\nenter A:{written}\n}} }}")
    assert f"enter A : {canonical}\n" in text


def test_blank_lines() -> None:
    becomes(
        """


        system A
        import soccer



        let a = 1
        srm r {

          liveness { r = A }


          activities { A takes 1s }

        }
        srm q {
          liveness { q = A }
        }
        team T { one : r }


        """,
        """
        system A
        import soccer

        let a = 1

        srm r {
          liveness { r = A }

          activities { A takes 1s }
        }

        srm q {
          liveness { q = A }
        }

        team T { one : r }
        """,
    )


@pytest.mark.parametrize("text", ["", "\n", "  \n\n", "\ufeff"])
def test_nothing(text: str) -> None:
    assert laid(text) == text[:1].strip()


def test_lines_end_as_they_did_and_a_mark_stays() -> None:
    assert laid("system A\r\nlet   a=1\n") == "system A\r\nlet a = 1\r\n"
    assert laid("system A\nlet   a=1\r\n") == "system A\nlet a = 1\n"
    assert laid("/* a\r\nb */ system A") == "/* a\r\nb */ system A\r\n"
    assert laid("\ufeffsystem   A") == "\ufeffsystem A\n"
    assert laid("\ufeff// c\nsystem   A") == "\ufeff// c\nsystem A\n"


# ---- comments ----------------------------------------------------------------------------------


def test_comments_stay_where_they_belong() -> None:
    becomes(
        """
        // first

          // second
        system A // of the system

        // before the role
        srm r { // of the role
             // before the block
          liveness { r = A } // of the block
          /* several
             lines */

          activities {
            A takes 1s // of A
            // more

            LongName takes 20s // of LongName
            // at the end
          } // behind
          // last
        }
        // of the file
        """,
        """
        // first

        // second
        system A  // of the system

        // before the role
        srm r {  // of the role
          // before the block
          liveness { r = A }  // of the block
          /* several
             lines */

          activities {
            A takes 1s  // of A
            // more

            LongName takes 20s  // of LongName
            // at the end
          }  // behind
          // last
        }

        // of the file
        """,
    )


def test_comments_at_the_ends_of_lines_are_aligned() -> None:
    stays(
        """
        enum E {
          A       // one
          LONGER  // two
                  // and more of it
          B
          C       // three
        }
        """
    )


def test_comments_inside() -> None:
    becomes(
        """
        let a = b // why b
          && // why not
          c /* and c */ && d

        let /* x */ e = /* y */ f
        srm r { /* nothing */ }
        srm /* name */ q { liveness { q = A /* a */ . // b
           // own
           B } }
        message M { int x, /* of y */ int y // of y, too
          , int z }
        """,
        """
        let a = b  // why b
                &&  // why not
                c /* and c */ && d

        let /* x */ e = /* y */ f
        srm r { /* nothing */ }

        srm /* name */ q {
          liveness {
            q = A /* a */ .  // b
                // own
                B
          }
        }

        message M {
          int            x
          /* of y */ int y  // of y, too
          int            z
        }
        """,
    )


def test_what_a_comment_allows_stays_on_its_line() -> None:
    """A line with such a comment is never broken, however long it is; one above is about all of an entry."""
    condition = " && ".join(f"condition_{n}" for n in range(12))
    stays(
        f"""
        srm r {{
          control r {{
            enter A : [{condition}] / start_timer(t, 1s)  // asemec: allow(W400) it is so
            // asemec: allow(W400) it is so
            enter B : else
          }}
        }}
        """
    )


# ---- what is not understood --------------------------------------------------------------------


def test_lines_of_a_scenario_stay_lines() -> None:
    becomes(
        """
        scenario "x" {
        one:robot
          at 0ms one receives a.state.M {  x=1 y=2  }
          at 100ms one is { // c
            A
             }
          by 1s one in A }
        """,
        """
        scenario "x" {
          one : robot
          at 0ms one receives a.state.M { x = 1  y = 2 }
          at 100ms one is {  // c
            A
          }
          by 1s one in A
        }
        """,
    )


def test_a_statement_stands_on_a_line() -> None:
    becomes(
        """
        scenario "x" {
          one:robot world w:make for 2s  // all
          at 0ms one receives a.state.M { x=1 y=2 }   by 1s
            one in A@p and one has [a.state.M.x>0]
          table (n, s) {
            (1, A)  (2, B)
          }
          every one in B||one in A leads to one in (A or B) within 1s in 95% of 20 seeds never one in C
        }
        property "short" { never fault }
        property "p" { never fault always one in A }
        """,
        """
        scenario "x" {
          one : robot
          world w:make
          for 2s  // all
          at 0ms one receives a.state.M { x = 1  y = 2 }
          by 1s  one in A@p and one has [a.state.M.x>0]
          table (n, s) {
            (1, A) (2, B)
          }
          every one in B || one in A leads to one in (A or B) within 1s in 95% of 20 seeds
          never one in C
        }

        property "short" { never fault }

        property "p" {
          never fault
          always one in A
        }
        """,
    )


def test_a_long_statement_is_broken_before_the_words_that_join_its_parts() -> None:
    becomes(
        """
        property "p" {
          every game.state.GameState.player_state == PlayerState.PENALISED and not robot1 in NoGame leads
             to robot1 in NoGame within 1s
        }
        """,
        """
        property "p" {
          every game.state.GameState.player_state == PlayerState.PENALISED and not robot1 in NoGame
              leads to robot1 in NoGame within 1s
        }
        """,
    )  # fmt: skip


def test_statements_however_they_are_written() -> None:
    """The same statements, and a layout that stays, wherever lines end and comments stand."""
    statements = (
        "one, spare[1..3] : robot", "network delay 0..300ms loss 20% reorder", "given n in 0..300",
        "activity Look takes 1s..3s ends found, lost sets n = 1 + 2", "for 20s", "points 3",
        "crash one at 6s",
        "at 2s one receives a.state.M { x = 1  y = n > 2 } from two", "at 3s one raises E", "never fault",
        "after 500ms in A one receives b.data.N { }", "from 3s to 8s partition { one } | { two }",
        "within 200ms of a.state.M.x == 1 two in B@p", "at most 2 of robot in A", "in order A, B@p",
        "no sent inform M m by one [m.x == 2] before 1s", "one in A before sent M", "one fails by 5s",
        'eventually outcome "well" within 60s in 95% of 200 seeds', "always one has [x && (y or z)]",
        "every one in (A or B) and not (two in A || x + 1 < 2) leads to two in B within 1s",
    )  # fmt: skip
    choose = random.Random(7)
    between = [" "] * 12 + ["  ", "\n", "\n\n", " // c\n", " /* d */ ", "\n// e\n"]
    for _ in range(60):
        chosen = choose.choices(statements, k=6)
        words = " ".join(chosen).split(" ")
        text = "".join(word + choose.choice(between) for word in words if word)
        found = laid(f'scenario "x" {{ {text} }}\n')
        bare = re.sub(r"//.*|/\*.*?\*/", "", found)
        assert bare.split()[3:-1] == [word for word in words if word]
        firsts = {statement.split()[0] for statement in statements}
        lines = re.findall(r"^ {2,3}(\S+)", bare, re.M)
        assert [word for word in lines if word in firsts] == [item.split()[0] for item in chosen]
        assert found.count("// c") == text.count("// c") and found.count("/* d */") == text.count("/* d */")


def test_a_file_with_mistakes_is_not_touched() -> None:
    result = format_source(Source("test.aseme", "system  A\nsrm r { liveness { r = A . } }"))
    assert [item.code for item in result.diagnostics] == ["E101"]
    assert result.text == "system  A\nsrm r { liveness { r = A . } }"
    assert not result.changed
