"""Turn interface definitions into C++ and Python types."""
