// @ts-check
// What panels of authors and of diagnostics say, in German: by the English text that stands in the code.

/** @type {Record<string, string>} */
export const panels = {
  "it exports no function 'mount'": "es exportiert keine Funktion 'mount'",
  "Diagnostics": "Diagnose",
  "show only": "nur zeigen",
  "No status of this level": "Kein Status dieser Stufe",
  "Only the first {} statuses are shown": "Nur die ersten {} Status werden gezeigt",
  "Show what {} contains": "Zeigen, was {} enthält",
  "Choose a status to see its values": "Einen Status wählen, um seine Werte zu sehen",
  "hardware: {}": "Hardware: {}",
  "Levels": "Stufen",
  "Which messages nodes log": "Welche Meldungen Nodes ausgeben",
  "default": "Standard",
  "refused": "abgelehnt",
  "No nodes now. They appear when they start.": "Gerade keine Nodes. Sie erscheinen, wenn sie starten.",
  "No logger services: {}. A node offers them if its program sets the option enable_logger_service.":
    "Ohne Logger-Services: {}. Ein Node bietet sie an, wenn sein Programm die Option enable_logger_service setzt.",
  "Copy": "Kopieren",
  "Copied": "Kopiert",
  "Find in the lines of {}": "In den Zeilen von {} suchen",
  "Tools for the lines of {}": "Werkzeuge für die Zeilen von {}",
  "Find, copy, save, fold": "Suchen, kopieren, speichern, einklappen",
  "Copy these lines": "Diese Zeilen kopieren",
  "Save these lines as a file": "Diese Zeilen als Datei speichern",
  "Show lines": "Zeilen zeigen",
  "Hide lines": "Zeilen verbergen",
  "{} of {}": "{} von {}",
  "{} lines": "{} Zeilen",
  "Not copied": "Nicht kopiert",
  "Interactive markers": "Interaktive Marker",
  "Menu of {}": "Menü von {}",
  "Camera": "Kamera",
  "no CameraInfo on {}": "keine CameraInfo auf {}",
  "the CameraInfo on {} has no focal length": "die CameraInfo auf {} hat keine Brennweite",
};
