// @ts-check
// What terminals say, and how nodes are started with other arguments. The output of commands is that of ROS, in English.

/** @type {Record<string, string>} */
export const terminal = {
  "Terminal": "Terminal",
  "Terminals": "Terminals",
  "Terminal {}": "Terminal {}",
  "New terminal": "Neues Terminal",
  "Close terminal": "Terminal schließen",
  "Complete": "Vervollständigen",
  "Earlier line": "Frühere Zeile",
  "Later line": "Spätere Zeile",
  "Cursor left": "Zeichen nach links",
  "Cursor right": "Zeichen nach rechts",
  "Type the next letter with Ctrl": "Den nächsten Buchstaben mit Strg tippen",
  "Screen reader": "Vorlesen",
  "Screen readers read the output. Press Esc, then Tab to leave the terminal.":
    "Screenreader lesen die Ausgabe vor. Esc, dann Tab verlässt das Terminal.",
  "Try {}, or {} for more. Tab completes.": "Zum Beispiel {}, oder {} für mehr. Tab vervollständigt.",
  "Run {}": "{} ausführen",
  "Run in the terminal": "Im Terminal ausführen",

  // Options of the next start.
  "Parameters, remaps and arguments": "Parameter, Umbenennungen und Argumente",
  "These apply when {} starts next.": "Sie gelten, wenn {} das nächste Mal startet.",
  "Remaps": "Umbenennungen",
  "parameter": "Parameter",
  "value": "Wert",
  "from": "von",
  "to": "zu",
  "Arguments": "Argumente",
  "As a command:": "Als Befehl:",
  "Start with these": "Damit starten",
  "close every quote": "alle Anführungszeichen schließen",
};
