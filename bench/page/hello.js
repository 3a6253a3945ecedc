// @ts-check
// The worker of hello.html: it has the program, and says so.

onmessage = () => postMessage("Hello, world!");
