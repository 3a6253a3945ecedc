// @ts-check
// What visitors do with a marker: the values of `event_type` of its feedback.

export const EVENTS = { keepAlive: 0, pose: 1, menu: 2, click: 3, down: 4, up: 5 };
