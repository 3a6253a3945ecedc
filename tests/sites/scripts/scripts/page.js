// Makes what tests use known to them.
import { GoalError, ros } from "sitegen";
import * as rosbridge from "sitegen/rosbridge";
import * as ROSLIB from "sitegen/roslib";

Object.assign(globalThis, { ros, GoalError, rosbridge, ROSLIB });
document.body.dataset.scripted = "yes";
