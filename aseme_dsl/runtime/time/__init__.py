"""Time: clocks and timers."""
