"""The player, by hand: a number for each region that has several states, the others need none."""

from __future__ import annotations

from typing import Any

STAND, CALIBRATE_CAMERA, CHECK_FOR_BALL, SCAN_FOR_BALL, ACTION = range(5)
"""Where `main` is, with where `decision` is once the player is active."""

(
    CHOOSE,
    WALK_TOWARDS_BALL,
    KICK_BALL,
    CENTER_WALK,
    CENTER_PASS,
    CENTER_END,
    FOR_WALK_GOAL,
    FOR_WALK_BALL,
    FOR_KICK,
    SHOT_END,
    CENTER_FOR_END,
    DO_END,
) = range(12)
"""Where `do` is while the player acts."""

FOREVER = ("Sensors", "RobotController", "LedHandler", "MotionController")
ACTIVE = ("Vision", "Localization", "ObstacleAvoidance", "HeadHandler")
MAIN = ("Stand", "CalibrateCamera", "CheckForBall", "ScanForBall")
DO = (
    "Choose",
    "WalkTowardsBall",
    "KickBall",
    "CenterWalk",
    "CenterPass",
    "center_end",
    "ForWalkGoal",
    "ForWalkBall",
    "ForKick",
    "shot_end",
    "center_for_end",
    "do_end",
)


class Machine:
    """A player that looks for the ball and acts, while the parts of its body work beside it."""

    __slots__ = ("bb", "do", "has_tracked", "main")

    def __init__(self, bb: dict[str, Any]) -> None:
        self.bb = bb
        self.main = STAND
        self.do = CHOOSE
        self.has_tracked = False

    def start(self) -> None:
        """Stand up, with what works all the time."""
        bb = self.bb
        bb["entered_Sensors"] = bb["entered_Sensors"] + 1
        bb["entered_RobotController"] = bb["entered_RobotController"] + 1
        bb["entered_LedHandler"] = bb["entered_LedHandler"] + 1
        bb["entered_MotionController"] = bb["entered_MotionController"] + 1
        bb["entered_initialize"] = bb["entered_initialize"] + 1
        bb["entered_Stand"] = bb["entered_Stand"] + 1
        self.main = STAND

    def send(self, event: str) -> bool:
        """Take one event; say whether anything was done."""
        bb = self.bb
        main = self.main
        if event == "tick":
            moved = False
            if bb["sensors_done"]:
                bb["entered_Sensors"] = bb["entered_Sensors"] + 1
                moved = True
            if bb["controller_done"]:
                bb["entered_RobotController"] = bb["entered_RobotController"] + 1
                moved = True
            if bb["leds_done"]:
                bb["entered_LedHandler"] = bb["entered_LedHandler"] + 1
                moved = True
            if bb["motion_done"]:
                bb["entered_MotionController"] = bb["entered_MotionController"] + 1
                moved = True
            if main < CHECK_FOR_BALL:
                if main == STAND and bb["stand_done"]:
                    bb["entered_CalibrateCamera"] = bb["entered_CalibrateCamera"] + 1
                    self.main = CALIBRATE_CAMERA
                    moved = True
                return moved
            if bb["vision_done"]:
                bb["entered_Vision"] = bb["entered_Vision"] + 1
                moved = True
            if bb["localization_done"]:
                bb["entered_Localization"] = bb["entered_Localization"] + 1
                moved = True
            if bb["obstacles_done"]:
                bb["entered_ObstacleAvoidance"] = bb["entered_ObstacleAvoidance"] + 1
                moved = True
            if bb["head_done"]:
                bb["entered_HeadHandler"] = bb["entered_HeadHandler"] + 1
                moved = True
            if main == CHECK_FOR_BALL:
                if not bb["ball_seen"]:
                    bb["entered_ScanForBall"] = bb["entered_ScanForBall"] + 1
                    self.main = SCAN_FOR_BALL
                    moved = True
            elif main == SCAN_FOR_BALL:
                if bb["scan_done"]:
                    bb["entered_CheckForBall"] = bb["entered_CheckForBall"] + 1
                    self.main = CHECK_FOR_BALL
                    moved = True
            else:
                if not self.has_tracked and bb["track_done"]:
                    self.has_tracked = True
                    bb["entered_track_end"] = bb["entered_track_end"] + 1
                    bb["track_ended"] = True
                    moved = True
                do = self.do
                if do == CHOOSE:
                    if bb["can_kick"]:
                        bb["entered_KickBall"] = bb["entered_KickBall"] + 1
                        self.do = KICK_BALL
                    elif bb["engaged"]:
                        if bb["is_center"]:
                            bb["entered_CenterWalk"] = bb["entered_CenterWalk"] + 1
                            self.do = CENTER_WALK
                        else:
                            bb["entered_ForWalkGoal"] = bb["entered_ForWalkGoal"] + 1
                            self.do = FOR_WALK_GOAL
                    else:
                        bb["entered_WalkTowardsBall"] = bb["entered_WalkTowardsBall"] + 1
                        self.do = WALK_TOWARDS_BALL
                    moved = True
                elif do == DO_END:
                    pass
                elif do == WALK_TOWARDS_BALL:
                    if bb["walk_done"]:
                        moved = self.end_do(bb)
                elif do == KICK_BALL:
                    if bb["kick_done"]:
                        moved = self.end_do(bb)
                elif do == CENTER_WALK:
                    if bb["walk_done"]:
                        if bb["can_pass"]:
                            bb["entered_CenterPass"] = bb["entered_CenterPass"] + 1
                            self.do = CENTER_PASS
                        else:
                            bb["entered_center_end"] = bb["entered_center_end"] + 1
                            bb["role_ended"] = True
                            self.do = CENTER_END
                        moved = True
                    elif bb["role_ended"]:
                        moved = self.end_do(bb)
                elif do == CENTER_PASS:
                    if bb["kick_done"]:
                        bb["entered_center_end"] = bb["entered_center_end"] + 1
                        bb["role_ended"] = True
                        self.do = CENTER_END
                        moved = True
                    elif bb["role_ended"]:
                        moved = self.end_do(bb)
                elif do == FOR_WALK_GOAL:
                    if bb["at_goal"]:
                        if bb["ball_near"]:
                            bb["entered_ForWalkBall"] = bb["entered_ForWalkBall"] + 1
                            self.do = FOR_WALK_BALL
                        else:
                            self.end_center_for(bb)
                        moved = True
                    elif bb["role_ended"]:
                        moved = self.end_do(bb)
                elif do in (CENTER_END, CENTER_FOR_END):
                    if bb["role_ended"]:
                        moved = self.end_do(bb)
                elif do == FOR_WALK_BALL and bb["walk_done"]:
                    if bb["can_kick"]:
                        bb["entered_ForKick"] = bb["entered_ForKick"] + 1
                        self.do = FOR_KICK
                    else:
                        self.end_shot(bb)
                    moved = True
                elif do == FOR_KICK and bb["kick_done"]:
                    self.end_shot(bb)
                    moved = True
                elif bb["shot_ended"]:  # in the shot, and nothing in it was to be done
                    self.end_center_for(bb)
                    moved = True
                elif bb["role_ended"]:
                    moved = self.end_do(bb)
            return moved
        if event == "tock":
            if main == ACTION:
                if bb["do_ended"] and bb["track_ended"]:
                    bb["entered_CheckForBall"] = bb["entered_CheckForBall"] + 1
                    self.main = CHECK_FOR_BALL
                    return True
                if bb["abort"] and not bb["ball_seen"]:
                    bb["entered_ScanForBall"] = bb["entered_ScanForBall"] + 1
                    self.main = SCAN_FOR_BALL
                    return True
            elif main == CHECK_FOR_BALL and bb["ball_seen"]:
                bb["entered_action"] = bb["entered_action"] + 1
                bb["do_ended"] = False
                bb["track_ended"] = False
                bb["role_ended"] = False
                bb["shot_ended"] = False
                bb["entered_TrackBall"] = bb["entered_TrackBall"] + 1
                bb["entered_Choose"] = bb["entered_Choose"] + 1
                self.has_tracked = False
                self.do = CHOOSE
                self.main = ACTION
                return True
        elif event == "calibrated" and main == CALIBRATE_CAMERA:
            bb["entered_activate"] = bb["entered_activate"] + 1
            bb["entered_Vision"] = bb["entered_Vision"] + 1
            bb["entered_Localization"] = bb["entered_Localization"] + 1
            bb["entered_ObstacleAvoidance"] = bb["entered_ObstacleAvoidance"] + 1
            bb["entered_HeadHandler"] = bb["entered_HeadHandler"] + 1
            bb["entered_CheckForBall"] = bb["entered_CheckForBall"] + 1
            self.main = CHECK_FOR_BALL
            return True
        return False

    def end_shot(self, bb: dict[str, Any]) -> None:
        """Come to the end of the shot."""
        bb["entered_shot_end"] = bb["entered_shot_end"] + 1
        bb["shot_ended"] = True
        self.do = SHOT_END

    def end_center_for(self, bb: dict[str, Any]) -> None:
        """Come to the end of the role of the center forward."""
        bb["entered_center_for_end"] = bb["entered_center_for_end"] + 1
        bb["role_ended"] = True
        self.do = CENTER_FOR_END

    def end_do(self, bb: dict[str, Any]) -> bool:
        """Come to the end of what was chosen."""
        bb["entered_do_end"] = bb["entered_do_end"] + 1
        bb["do_ended"] = True
        self.do = DO_END
        return True

    def leaves(self) -> tuple[str, ...]:
        """The active basic states, in document order."""
        found: tuple[str, ...] = FOREVER
        if self.main < CHECK_FOR_BALL:
            return (*found, MAIN[self.main])
        found += ACTIVE
        if self.main != ACTION:
            return (*found, MAIN[self.main])
        return (*found, "track_end" if self.has_tracked else "TrackBall", DO[self.do])
