// Prints and complains without end.
importScripts("middleware.js");

register("/rosout", "publisher");
let count = 0;
setInterval(() => {
  for (let line = 0; line < 100; line++) {
    log("INFO", "flood", `line ${count}`);
    register(`/topic${count++}`, "publisher");
  }
}, 20);
