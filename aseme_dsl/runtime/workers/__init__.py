"""Workers: the threads and processes in which activities run."""
