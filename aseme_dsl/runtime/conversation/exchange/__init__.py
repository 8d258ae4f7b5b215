"""Exchange of messages: members, sending, delivery, external agents, and how parts begin and end."""
