# For ros2 launch; a page has its own way to start nodes.
