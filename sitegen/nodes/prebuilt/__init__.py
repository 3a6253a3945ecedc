"""Take in programs that were compiled elsewhere."""
