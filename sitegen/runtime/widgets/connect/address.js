// @ts-check
// Addresses of gateways, and what browsers forbid about them.

import { say } from "../../ui/words.js";

/** The address that is meant: `self` is the server of the page. @param {string} given */
export function addressOf(given) {
  if (given !== "self") return given;
  return `${location.protocol === "https:" ? "wss:" : "ws:"}//${location.host}`;
}

/** @param {string} address */
export function isAddress(address) {
  try {
    return ["ws:", "wss:"].includes(new URL(address).protocol);
  } catch {
    return false;
  }
}

/** Say why the browser will not even try, or "". @param {string} address */
export function blocked(address) {
  const { protocol, hostname } = new URL(address);
  if (location.protocol !== "https:" || protocol !== "ws:" || isLoopback(hostname)) return "";
  return say("This page came over https://, so browsers do not let it use {}. Start the gateway with --tls and use wss://, or open the page from the gateway itself: sitegen gateway serves it with --site.", address);
}

/** Say what may be the reason that nobody answers, or "". @param {string} address */
export function hint(address) {
  const { protocol, hostname } = new URL(address);
  if (protocol === "wss:") {
    return say("If its certificate is its own, open {} once and accept it.", address.replace(/^wss/, "https"));
  }
  if (isLocal(hostname) && !isLocal(location.hostname)) {
    return say("If the browser asks, allow this page to reach devices in your network.");
  }
  return "";
}

/** @param {string} host */
function isLoopback(host) {
  return host === "localhost" || host.endsWith(".localhost") || /^127\./.test(host) || host === "[::1]";
}

/** Whether a host is of this computer or of a private network. @param {string} host */
function isLocal(host) {
  return isLoopback(host) || host.endsWith(".local") || !host.includes(".") || /^(10|192\.168|172\.(1[6-9]|2\d|3[01]))\./.test(host);
}
