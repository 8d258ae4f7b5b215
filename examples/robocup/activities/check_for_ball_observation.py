"""CheckForBallObservation: waits for the next picture; what is in it is told by Vision."""


class CheckForBallObservation:
    """Without an `execute`, an activity just lasts as long as the .aseme file says."""
