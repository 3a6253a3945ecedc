// @ts-check
// Measures the times between frames.

/** Return the times between the frames of some seconds (ms). @param {number} seconds @returns {Promise<number[]>} */
export function frames(seconds) {
  return new Promise((resolve) => {
    /** @type {number[]} */
    const times = [];
    const end = performance.now() + 1000 * seconds;
    let before = 0;
    const next = () => {
      const now = performance.now();
      if (before) times.push(now - before);
      before = now;
      if (now < end || times.length < 2) requestAnimationFrame(next);
      else resolve(times);
    };
    requestAnimationFrame(next);
  });
}
