import "./height.css";

/** @type {import("./ros").Mount<{highest: number}>} */
export const mount = (element, ros, options) => {
  const meter = document.createElement("meter");
  meter.max = options.highest;
  const ahead = document.createElement("button");
  ahead.textContent = "Ahead";
  element.append(meter, ahead);

  ros.subscribe("/turtle1/pose", "turtlesim/msg/Pose", ({ y }) => {
    meter.value = y;
  });
  const commands = ros.advertise("/turtle1/cmd_vel", "geometry_msgs/msg/Twist");
  ahead.addEventListener("click", () => {
    commands.publish({ linear: { x: 1 }, angular: { z: 0.5 } });
  });
};
