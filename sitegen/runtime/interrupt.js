// @ts-check
// Interrupts: how the page reaches a Python program that computes and never waits, where they share memory.

// As rclpy_backend/system/interrupts.py has it: SIGUSR2.
const HEAR = 12;

/** Whether page and workers can share memory here: in isolated pages of browsers that have it. */
export const sharesMemory = globalThis.crossOriginIsolated && "SharedArrayBuffer" in globalThis;

/** A byte that page and worker share, where they can; Python looks at it between instructions. */
export function sharedByte() {
  return sharesMemory ? new Uint8Array(new SharedArrayBuffer(1)) : undefined;
}

/** Let who has the byte listen to what was posted to it just before. @param {Uint8Array} [byte] */
export function interrupt(byte) {
  if (byte) Atomics.store(byte, 0, HEAR);
}

/** What was posted has arrived. @param {Uint8Array} [byte] */
export function heard(byte) {
  if (byte) Atomics.store(byte, 0, 0);
}
