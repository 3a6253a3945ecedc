// @ts-check
// What signals end.

/** @typedef {AbortSignal | undefined} Signal */

/**
 * Call `end` once: when one of `signals` aborts, or when the function that this returns is called. Nothing is left at the
 * signals, which may last much longer.
 * @param {Signal[]} signals @param {() => void} end @returns {() => void}
 */
export function endingWith(signals, end) {
  let ended = false;
  const once = () => {
    if (ended) return;
    ended = true;
    for (const one of signals) one?.removeEventListener("abort", once);
    end();
  };
  for (const one of signals) one?.addEventListener("abort", once);
  if (signals.some((one) => one?.aborted)) once();
  return once;
}

/**
 * Settle as `work` does, or reject with the reason of the first of `signals` that aborts.
 * @template Value @param {Signal[]} signals @param {Promise<Value>} work @returns {Promise<Value>}
 */
export function unlessAborted(signals, work) {
  return new Promise((resolve, reject) => {
    const done = endingWith(signals, () => reject(signals.find((one) => one?.aborted)?.reason));
    work.then(resolve, reject).finally(done);
  });
}
