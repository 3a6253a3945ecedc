// A joystick, drawn on a canvas, that drives the turtle.
import { ros } from "sitegen";

const command = ros.topic("/turtle1/cmd_vel", "geometry_msgs/msg/Twist");
const publish = () => command.publish({ linear: { x: -2 * y }, angular: { z: -2 * x } });

const canvas = document.getElementById("joystick");
const [brush, half] = [canvas.getContext("2d"), canvas.width / 2];
let [x, y, timer, keys] = [0, 0, 0, {}]; // x to the right, y down, both from -1 to 1

function draw() {
  canvas.width = canvas.height = 2 * half * devicePixelRatio; // also clears it
  brush.scale(half * devicePixelRatio, half * devicePixelRatio);
  brush.fillStyle = getComputedStyle(canvas).color;
  brush.arc(1 + 0.6 * x, 1 + 0.6 * y, 0.35, 0, 2 * Math.PI);
  brush.fill();
}
function move(toX, toY) {
  const length = Math.max(1, Math.hypot(toX, toY));
  [x, y] = [toX / length, toY / length];
  draw();
  publish();
  clearInterval(timer);
  if (x || y) timer = setInterval(publish, 100); // one command lasts for a second only
}
canvas.style.cssText = `display: block; width: ${2 * half}px; margin: auto; border-radius: 50%;
  touch-action: none; color: var(--accent); background: var(--accent-soft)`;
matchMedia("(prefers-color-scheme: dark)").onchange = draw;
new MutationObserver(draw).observe(document.documentElement, { attributes: true }); // light, dark
canvas.onpointerdown = ({ pointerId }) => canvas.setPointerCapture(pointerId);
canvas.onpointermove = ({ pointerId: id, offsetX, offsetY }) =>
  canvas.hasPointerCapture(id) && move(offsetX / half - 1, offsetY / half - 1);
canvas.onlostpointercapture = canvas.onblur = () => { keys = {}; move(0, 0); };
canvas.onkeydown = canvas.onkeyup = (event) => {
  if (event.key.startsWith("Arrow")) event.preventDefault(); // the page does not scroll
  keys[event.key] = event.type === "keydown" ? 1 : 0;
  const { ArrowUp: up = 0, ArrowDown: down = 0, ArrowLeft: left = 0, ArrowRight: right = 0 } = keys;
  move(right - left, down - up);
};
draw();
