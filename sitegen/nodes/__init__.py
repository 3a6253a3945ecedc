"""Turn the executables of packages into what a page can run."""
