// @ts-check
// What every robot kind is for the widget that shows it.

/**
 * What a robot kind is made with `create(ros, options, changed)`: it calls `changed` when there is
 * something new to draw or to read.
 * @typedef {{
 *   title: string,
 *   inputs: Input[],
 *   drawing: Element,
 *   controls: HTMLElement[],
 *   advance(seconds: number): boolean,
 *   readings(): Reading[],
 *   note(): Note,
 *   reset(): void,
 *   close(): void,
 * }} Robot where `advance` draws what that time brought, and returns whether it is still moving
 * @typedef {{topic: string, type: string}} Input
 * @typedef {{name: string, text: string, level?: number, color?: string}} Reading
 *   a level from -1 to 1 is shown as a bar, a colour as a dot
 * @typedef {{text: string, wrong: boolean}} Note
 */

export {};
