"""A small role that is a plain statechart, too: events, a message, a variable, time."""

LAMP = """
system Lamp
enum Colour { WHITE RED }
message Room { bool dark  Colour colour }
topic room { state Room }
srm lamp {
  var touched : int = 0
  liveness { lamp = (Dark . Shine)~ }
  control lamp {
    enter Shine : touch [room.state.Room.dark && room.state.Room.colour == Colour.RED] / touched = touched + 1
    leave Shine : touch or after(100ms)
  }
}
"""
