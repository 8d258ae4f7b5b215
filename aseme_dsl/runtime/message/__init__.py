"""Message: messages as bytes, as JSON and as text of FIPA."""
