"""Keep the results of earlier builds and downloads."""
