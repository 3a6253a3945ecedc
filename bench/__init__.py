"""Measure the speed of sitegen, each figure beside the raw limit of the same run."""
