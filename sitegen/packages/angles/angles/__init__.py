"""Functions on angles in radians."""

from math import fmod, pi

__all__ = [
    "normalize_angle",
    "normalize_angle_positive",
    "shortest_angular_distance",
    "shortest_angular_distance_with_large_limits",
    "shortest_angular_distance_with_limits",
    "two_pi_complement",
]


def normalize_angle_positive(angle: float) -> float:
    """Return the equal angle in [0, 2π)."""
    return angle % (2.0 * pi)


def normalize_angle(angle: float) -> float:
    """Return the equal angle in (-π, π]."""
    rest = normalize_angle_positive(angle)
    return rest - 2.0 * pi if rest > pi else rest


def shortest_angular_distance(from_angle: float, to_angle: float) -> float:
    """Return the shortest turn from one angle to another, in (-π, π]."""
    return normalize_angle(to_angle - from_angle)


def two_pi_complement(angle: float) -> float:
    """Return the turn in [-2π, 2π] that ends where `angle` does, in the other direction."""
    if abs(angle) > 2.0 * pi:
        angle = fmod(angle, 2.0 * pi)
    return angle - 2.0 * pi if angle > 0 else angle + 2.0 * pi


def shortest_angular_distance_with_limits(
    from_angle: float, to_angle: float, left_limit: float, right_limit: float
) -> tuple[bool, float]:
    """Return the shortest turn between two angles that stays within an interval.

    The interval goes from `left_limit` to `right_limit` in the positive direction; both are in
    [-π, π]. The first value is False if an angle is not in the interval.
    """
    inside, least, greatest = _find_min_max_delta(from_angle, left_limit, right_limit)
    near = shortest_angular_distance(from_angle, to_angle)
    far = two_pi_complement(near)
    for turn in (near, far):
        if inside and least <= turn <= greatest:
            return True, turn
    # Cross the limit that is next to the angle outside.
    if inside:
        _, least, greatest = _find_min_max_delta(to_angle, left_limit, right_limit)
    before, after = abs(least), abs(greatest)
    if before == after:
        return False, near if abs(near) < abs(far) else far
    return False, max(near, far) if (before < after) == inside else min(near, far)


def shortest_angular_distance_with_large_limits(
    from_angle: float, to_angle: float, left_limit: float, right_limit: float
) -> tuple[bool, float]:
    """Return the shortest turn to an angle that is equal to `to_angle`, within limits of any size.

    The first value is False if there is none, if `from_angle` is not within the limits, or if
    `left_limit` is greater than `right_limit`.
    """

    def is_allowed(angle: float) -> bool:
        return left_limit <= angle <= right_limit

    distance = shortest_angular_distance(from_angle, to_angle)
    near, far = sorted((distance, two_pi_complement(distance)), key=abs)
    turn = far if not is_allowed(from_angle + near) and is_allowed(from_angle + far) else near
    return is_allowed(from_angle) and is_allowed(from_angle + turn), turn


def _find_min_max_delta(
    from_angle: float, left_limit: float, right_limit: float
) -> tuple[bool, float, float]:
    """Return the least (negative) and the greatest turn that stay within the interval.

    The first value is False if `from_angle` is not in the interval: then the turns are those that
    reach it.
    """
    left = shortest_angular_distance(from_angle, left_limit)
    right = shortest_angular_distance(from_angle, right_limit)
    # Both limits can be reached in both directions.
    left_back, left_on = sorted((left, two_pi_complement(left)))
    right_back, right_on = sorted((right, two_pi_complement(right)))
    if left == 0:
        return True, 0.0, right_on
    if right == 0:
        return True, left_back, 0.0
    if left_back > right_back and right_on < left_on:
        return True, left_back, right_on
    return left_limit == -pi and right_limit == pi, right_back, left_on
