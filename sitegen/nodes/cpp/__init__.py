"""Compile C++ executables to WebAssembly."""
