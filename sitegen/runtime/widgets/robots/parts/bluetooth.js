// @ts-check
// Whether robots can be reached over Bluetooth.

import { say } from "../../../ui/words.js";

/** Return why this page cannot connect to a hub, or "". */
export function obstacle() {
  if (!window.isSecureContext) {
    return say("Browsers allow Bluetooth only on https:// pages and on this computer. " +
      "Open this page at such an address to connect a robot.");
  }
  if (!navigator.bluetooth) {
    return say("This browser does not support Web Bluetooth. " +
      "Chrome and Edge do, on computers and on Android. The simulated robot works without it.");
  }
  return "";
}
