#!/usr/bin/env python3
"""Asks for what a page does not have."""

import cProfile
import faulthandler
import multiprocessing
import socket
import subprocess
import sys
import threading
import urllib.request


def attempt(function):
    """Print what comes of it."""
    try:
        print(function())
    except Exception as error:
        print(type(error).__name__, error)


attempt(lambda: subprocess.run(["ls", "-l"], check=True))
attempt(lambda: subprocess.check_output("ls", shell=True))
attempt(lambda: socket.create_connection(("127.0.0.1", 9)))
attempt(lambda: socket.socket().bind(("127.0.0.1", 0)))
attempt(lambda: socket.socket(type=socket.SOCK_DGRAM).sendto(b"x", ("127.0.0.1", 9)))
attempt(lambda: urllib.request.urlopen("http://127.0.0.1:9/"))
attempt(multiprocessing.Process(target=print).start)
attempt(lambda: multiprocessing.Pool(2))

# With one thread, each of these works; with a second one that waits, none does.
end = threading.Event()
other = threading.Thread(target=end.wait)
for begin in (lambda: None, other.start):
    begin()
    attempt(lambda: sys.settrace(None))
    attempt(lambda: sys.setprofile(lambda *_: None))
    attempt(lambda: sys.setprofile(None))
    attempt(lambda: cProfile.Profile().runcall(sum, [1, 2]))
    attempt(lambda: len(sys._current_frames()))
    attempt(lambda: faulthandler.dump_traceback())
end.set()
other.join()
attempt(lambda: cProfile.Profile().runcall(sum, [3, 4]))
