"""The layer of the operating system, shared by all programs: threads, waits, signals, keyboard."""
