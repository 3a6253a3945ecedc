"""The commands of `sitegen` other than `build`."""
