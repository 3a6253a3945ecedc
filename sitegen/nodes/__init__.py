"""Turn the executables of packages into programs that a page can run."""
