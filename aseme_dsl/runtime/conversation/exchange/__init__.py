"""Exchange: who takes part, what is sent, delivered and heard, and how parts begin and end."""
