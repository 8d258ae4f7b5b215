"""Program: a statechart lowered to what the generators print, worked out once for all of them."""
