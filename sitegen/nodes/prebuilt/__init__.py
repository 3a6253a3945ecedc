"""Use programs that were compiled elsewhere."""
