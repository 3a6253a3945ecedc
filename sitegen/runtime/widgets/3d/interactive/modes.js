// @ts-check
// What a control does: the values of `interaction_mode`.

export const MODES = {
  none: 0, menu: 1, button: 2, moveAxis: 3, movePlane: 4, rotateAxis: 5, moveRotate: 6, move3d: 7, rotate3d: 8,
  moveRotate3d: 9,
};

/**
 * What a control does now: as in RViz, Shift turns what can be moved and turned.
 * @param {{mode: number}} control @param {boolean} shift
 */
export function modeOf({ mode }, shift) {
  if (mode === MODES.moveRotate) return shift ? MODES.rotateAxis : MODES.movePlane;
  if (mode === MODES.moveRotate3d) return shift ? MODES.rotate3d : MODES.move3d;
  return mode;
}
