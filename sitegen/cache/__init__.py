"""Keep what need not be made, downloaded or checked again."""
