"""Pack Python programs, and what they import, into archives."""
