// @ts-check
// Interrupts for Python programs that compute without waiting, through a byte in shared memory.

// As rclpy_backend/system/interrupts.py has it: SIGUSR2.
const HEAR = 12;

/** Whether page and workers can share memory, which needs an isolated page. */
export const sharesMemory = globalThis.crossOriginIsolated && "SharedArrayBuffer" in globalThis;

/** Return a byte that Python checks between instructions, if memory can be shared. */
export function sharedByte() {
  return sharesMemory ? new Uint8Array(new SharedArrayBuffer(1)) : undefined;
}

/** Make the program that has the byte handle the message that is posted next. @param {Uint8Array} [byte] */
export function interrupt(byte) {
  if (byte) Atomics.store(byte, 0, HEAR);
}

/** Confirm that this message has arrived. @param {Uint8Array} [byte] */
export function heard(byte) {
  if (byte) Atomics.store(byte, 0, 0);
}

/**
 * Return the byte in the form that Pyodide reads and clears it. Pyodide reads a number and then writes 0, so with the
 * byte itself, what the page writes between the two would be lost. Here, only what was read is cleared.
 * @param {Uint8Array} byte
 */
export function interruptBuffer(byte) {
  let read = 0;
  return {
    get 0() {
      read = Atomics.load(byte, 0);
      return read;
    },
    set 0(value) {
      if (read) Atomics.compareExchange(byte, 0, read, value);
    },
  };
}
