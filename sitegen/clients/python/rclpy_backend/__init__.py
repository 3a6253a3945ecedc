"""The layer below rclpy: what its C++ extension does on a robot, on the graph of a page."""
