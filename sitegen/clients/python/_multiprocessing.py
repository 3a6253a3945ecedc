"""The native part of `multiprocessing`, which is not available in the browser."""

raise ImportError("processes are not available in the browser; use threads")
