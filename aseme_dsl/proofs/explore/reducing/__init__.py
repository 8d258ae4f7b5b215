"""Reducing: fewer states, with the same answers.

- `spent`: what conversations remember that makes no difference any more
- `never`: transitions that cannot be taken again
- `faint`: variables that decide nothing
- `alike`: values of variables that no line can tell apart
- `faded`: what messages say that are too old for anything to ask for it
- `steady`: ends of activities that do nothing but what another move does
- `symmetry`: agents that may change places

All but the last two forget something between two moves that no later move reads. Two states that differ in
nothing else have the same moves, and these lead to states that again differ in nothing else. So the reduced
states are those of the team, up to what is forgotten, and each run of one is a run of the other. The answers
ask for nothing that is forgotten: where they do, the reduction is switched off
(`Explored.hears`, `Explored.judges`).
"""
