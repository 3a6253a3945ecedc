// A timer and nothing else: wake at each multiple of 10 ms.

onmessage = ({ data: count }) => {
  const begun = performance.now();
  const times = [];
  const tick = () => {
    times.push(performance.now());
    if (times.length === count) postMessage(times);
    else setTimeout(tick, begun + times.length * 10 - performance.now());
  };
  tick();
};
