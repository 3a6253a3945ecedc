"""Loops of asyncio from their beginning to their end, without any thread."""

import asyncio
import signal

import rclpy


async def soon(value):
    """Return it in a moment."""
    await asyncio.sleep(0.01)
    return value


async def fail():
    """End by an exception."""
    await asyncio.sleep(0)
    raise ValueError("in a coroutine")


async def numbers():
    """Yield some, and tell when that is over."""
    try:
        for number in range(9):
            yield number
    finally:
        print("closed")


async def first():
    """Take one number and leave the others."""
    async for number in numbers():
        return number


def main(args=None):
    """Make loops, run and close them."""
    loop = asyncio.new_event_loop()
    print(loop.run_until_complete(soon("a")), loop.is_running(), loop.is_closed())
    loop.call_later(0.02, loop.stop)
    print(loop.run_forever())
    loop.close()
    wanted = soon("b")
    try:
        loop.run_until_complete(wanted)
    except RuntimeError as error:
        print(error, loop.is_closed())
    wanted.close()
    try:
        asyncio.run(fail())
    except ValueError as error:
        print("caught", error)
    print(asyncio.run(first()))
    with asyncio.Runner() as runner:
        loop = runner.get_loop()
        loop.add_signal_handler(signal.SIGINT, print)
        print(runner.run(soon("c")), loop.remove_signal_handler(signal.SIGINT))
    try:
        asyncio.get_event_loop()
    except RuntimeError as error:
        print(error)

    rclpy.init(args=args)
    node = rclpy.create_node("node")
    future = rclpy.task.Future()
    node.create_timer(0.01, lambda: future.set_result("in time"))

    async def spin():
        while not future.done():
            rclpy.spin_once(node, timeout_sec=0)
            await asyncio.sleep(0)
        return future.result()

    print(asyncio.run(spin()))
    rclpy.shutdown()
