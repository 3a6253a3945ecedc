// @ts-check
// The interface between the widget and each kind of robot.

/**
 * Each kind exports `create(ros, options, changed)`, which returns a Robot. The robot calls `changed` when its drawing
 * or its readings must be updated.
 * @typedef {{
 *   title: string,
 *   inputs: Input[],
 *   drawing: Element,
 *   waits: string,
 *   controls: HTMLElement[],
 *   advance(seconds: number): boolean,
 *   readings(): Reading[],
 *   note(): Note,
 *   reset(): void,
 *   close(): void,
 * }} Robot `waits` is the topic without which it does not move; `advance` moves and draws the robot, and returns whether it is still moving
 * @typedef {{topic: string, type: string}} Input
 * @typedef {{name: string, text: string, level?: number, color?: string}} Reading
 *   a level from -1 to 1 is shown as a bar, a colour as a dot
 * @typedef {{text: string, wrong: boolean}} Note
 */

export {};
