"""Play a scenario: what native rclpy does, line by line, as the C++ program beside does."""

import sys

import actions
import parameters
import policies
import services
import times

SCENARIOS = {
    "actions": actions.play,
    "parameters": parameters.play,
    "policies": policies.play,
    "services": services.play,
    "times": times.play,
}

SCENARIOS[sys.argv[1]]()
