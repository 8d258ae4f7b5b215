"""Editor: the compiler answering an editor: functions over one view of a file, and a server around them."""
