"""Turn pages and programs into the files of a web site."""
