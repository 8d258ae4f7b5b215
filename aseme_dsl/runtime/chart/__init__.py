"""Chart: the step of a statechart: its boards, its inputs and its plan."""
