"""Computes and never waits."""


def main():
    """Compute."""
    print("computing", flush=True)
    while True:
        pass
