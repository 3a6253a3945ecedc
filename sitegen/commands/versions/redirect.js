// Leads to the page that this one stands for, with all that follows the path of the address.
const { href } = /** @type {HTMLLinkElement} */ (document.querySelector("link[rel=canonical]"));
location.replace(href + location.search + location.hash);
