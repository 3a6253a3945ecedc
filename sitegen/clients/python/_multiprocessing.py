"""What Python's `multiprocessing` would start processes with."""

raise ImportError("a page cannot start processes; threads work")
