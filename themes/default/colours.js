// Light or dark, as the visitor chose before. Loaded before anything is drawn, so that nothing flashes.
try {
  const chosen = localStorage.getItem("colours");
  if (chosen === "light" || chosen === "dark") document.documentElement.dataset.colours = chosen;
} catch {
  // Storage may be forbidden; the device decides then.
}
