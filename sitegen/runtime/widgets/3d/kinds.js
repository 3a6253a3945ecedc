// @ts-check
// The kinds of displays, by the names that they have in site.yaml.

import { kind as axes } from "./displays/axes.js";
import { kind as camera } from "./displays/camera.js";
import { kind as grid } from "./displays/grid.js";
import { kind as imu } from "./displays/imu.js";
import { kind as interactiveMarkers } from "./displays/interactive_markers.js";
import { kind as laserScan } from "./displays/laser_scan.js";
import { kind as map } from "./displays/map.js";
import { kind as markers } from "./displays/markers.js";
import { kind as odometry } from "./displays/odometry.js";
import { kind as path } from "./displays/path.js";
import { kind as point } from "./displays/point.js";
import { kind as pointCloud } from "./displays/point_cloud.js";
import { kind as polygon } from "./displays/polygon.js";
import { kind as pose } from "./displays/pose.js";
import { kind as poseArray } from "./displays/pose_array.js";
import { kind as range } from "./displays/range.js";
import { kind as robot } from "./displays/robot.js";
import { kind as tf } from "./displays/tf.js";
import { kind as wrench } from "./displays/wrench.js";

/** @import { Kind } from "./shown.js" */

/** @type {Record<string, Kind>} */
export const KINDS = {
  grid, axes, tf, robot, markers, interactive_markers: interactiveMarkers, laser_scan: laserScan, point_cloud: pointCloud, map,
  path, odometry, pose, pose_array: poseArray, point, polygon, range, wrench, imu, camera,
};
