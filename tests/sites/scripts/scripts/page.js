// Makes what tests use known to them.
import { GoalError, ros } from "sitegen";
import * as rosbridge from "sitegen/rosbridge";

Object.assign(globalThis, { ros, GoalError, rosbridge });
document.body.dataset.scripted = "yes";
