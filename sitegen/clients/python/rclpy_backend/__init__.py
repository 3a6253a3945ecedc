"""The layer below rclpy: what its C++ extension does natively, on the graph of the page."""
