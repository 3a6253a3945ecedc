"""Join the graphs of pages, and programs without ROS, to a native ROS 2 graph."""
