"""Queues whose items expire."""

from __future__ import annotations

import random
import time

import pytest

from sitegen.rowe.expiring import ExpiringQueue, QueueFull


class Clock:
    """A clock that is set."""

    def __init__(self) -> None:
        self.now = 1000.0

    def __call__(self) -> float:
        return self.now


def test_items_leave_in_order_and_with_the_time_that_is_left() -> None:
    clock = Clock()
    queue: ExpiringQueue[str] = ExpiringQueue(clock=clock)
    queue.put("a", 2)
    queue.put("b")
    clock.now += 0.5
    assert queue.take() == (1.5, "a")
    assert queue.take() == (float("inf"), "b")
    assert queue.take() is None


def test_expired_items_are_dropped_wherever_they_are() -> None:
    clock = Clock()
    dropped: list[str] = []
    queue = ExpiringQueue(dropped=dropped.append, clock=clock)
    for name, seconds in [("a", 10.0), ("b", 1.0), ("c", 10.0), ("d", 0.0)]:
        queue.put(name, seconds)
    clock.now += 1.2
    assert len(queue) == 2
    assert sorted(dropped) == ["b", "d"]
    assert [taken and taken[1] for taken in (queue.take(), queue.take(), queue.take())] == [
        "a",
        "c",
        None,
    ]


def test_an_item_that_expires_within_the_tick_is_not_taken() -> None:
    clock = Clock()
    dropped: list[str] = []
    queue = ExpiringQueue(dropped=dropped.append, clock=clock)
    queue.put("a", 0.001)
    clock.now += 0.002
    assert queue.take() is None
    assert dropped == ["a"]


def test_expired_items_make_room() -> None:
    clock = Clock()
    queue: ExpiringQueue[int] = ExpiringQueue(capacity=2, clock=clock)
    queue.put(1)
    queue.put(2, 1)
    with pytest.raises(QueueFull):
        queue.put(3)
    clock.now += 1.1
    queue.put(3)
    assert len(queue) == 2


def test_an_item_can_be_discarded_once() -> None:
    queue: ExpiringQueue[int] = ExpiringQueue()
    ticket = queue.put(1, 5)
    assert queue.discard(ticket)
    assert not queue.discard(ticket)
    assert queue.take() is None


def test_any_order_of_operations_agrees_with_a_list() -> None:
    chance = random.Random(7)
    clock = Clock()
    queue: ExpiringQueue[int] = ExpiringQueue(capacity=1000, clock=clock)
    expected: list[tuple[int, int, float]] = []
    for number in range(5000):
        clock.now += chance.choice([0, 0.01, 0.03, 1.7]) * chance.random()
        expected = [entry for entry in expected if entry[2] > clock.now]
        match chance.randrange(4):
            case 0 | 1:
                seconds = chance.choice([0.02, 0.5, 3, float("inf")])
                expected.append((queue.put(number, seconds), number, clock.now + seconds))
            case 2:
                taken = queue.take()
                assert (taken and taken[1]) == (expected.pop(0)[1] if expected else None)
            case 3 if expected:
                ticket, *_ = expected.pop(chance.randrange(len(expected)))
                assert queue.discard(ticket)
    # What nobody asks for any more is forgotten.
    clock.now += 10
    while queue.take():
        pass
    assert queue._buckets == {}


def test_the_bytes_of_all_items_are_bounded() -> None:
    queue: ExpiringQueue[int] = ExpiringQueue(heaviest=100)
    queue.put(1, weight=500)  # alone, it would never have room
    with pytest.raises(QueueFull):
        queue.put(2, weight=1)
    queue.take()
    queue.put(2, weight=60)
    ticket = queue.put(3, weight=40)
    with pytest.raises(QueueFull):
        queue.put(4, weight=1)
    queue.discard(ticket)
    queue.put(4, weight=40)


def seconds_per_operation(count: int) -> float:
    """Return what an operation takes at best in a queue of `count` items, all with a time."""
    clock = Clock()
    queue: ExpiringQueue[int] = ExpiringQueue(capacity=count + 1, clock=clock)
    chance = random.Random(7)
    times = [100 + 1000 * chance.random() for _ in range(1000)]
    for number in range(count):
        queue.put(number, times[number % 1000])
    best = float("inf")
    for turn in range(50):
        begun = time.perf_counter()
        for seconds in times[:200]:
            queue.put(turn, seconds)
            queue.take()
        best = min(best, (time.perf_counter() - begun) / 400)
    # Nothing has expired until now; then almost all of it at once.
    assert len(queue) == count
    clock.now += 1090
    begun = time.perf_counter()
    assert len(queue) < count / 50
    return max(best, (time.perf_counter() - begun) / count)


def test_an_operation_takes_as_long_with_a_million_items() -> None:
    few, many = seconds_per_operation(10_000), seconds_per_operation(1_000_000)
    # Caches are smaller than a million items, so it is not quite the same.
    assert many < 6 * few, f"{few * 1e6:.2f} µs and {many * 1e6:.2f} µs"
