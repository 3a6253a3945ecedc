// Light or dark, as the visitor chose before. Loaded before anything is drawn, so that nothing flashes.
try {
  const chosen = localStorage.getItem("colours");
  if (chosen === "light" || chosen === "dark") document.documentElement.dataset.colours = chosen;
} catch {
  // Storage may be forbidden; the device decides then.
}

// What stands in a frame of another page has that page around it: embed.css leaves the content only.
if (new URLSearchParams(location.search).has("embed")) document.documentElement.dataset.embed = "";
