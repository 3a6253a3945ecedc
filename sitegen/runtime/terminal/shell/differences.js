// @ts-check
// What is different from a terminal on a computer; `help` and docs/terminal.md list it.

export const DIFFERENCES = [
  "ros2 knows the nodes and programs of this page, and no others",
  "files live in this tab: there are no folders, and cat, ls, rm, save, > and < are all there is for them",
  "ros2 bag record keeps bags in this browser, each as one file; save downloads them",
  "no variables except $?, no loops, functions, $(…), * or scripts",
  "Ctrl-Z holds back what a command prints; a program that ros2 run has started goes on meanwhile",
  "ros2 doctor, daemon and pkg tell about the page; ros2 multicast and security do not exist",
];
