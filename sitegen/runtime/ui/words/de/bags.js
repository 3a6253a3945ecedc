// @ts-check
// What players and recorders of bags say, in German: by the English text that stands in the code.

/** @type {Record<string, string>} */
export const bags = {
  "Bag": "Bag",
  "Player": "Player",
  "Open file…": "Datei öffnen …",
  "Open a bag, or drop one here: a .mcap file, as 'ros2 bag record' writes it. It stays on this device.":
    "Ein Bag öffnen oder hier ablegen: eine .mcap-Datei, wie „ros2 bag record“ sie schreibt. Sie bleibt auf diesem Gerät.",
  "Opening…": "Wird geöffnet …",
  "Play": "Abspielen",
  "Step": "Schritt",
  "Loop": "Schleife",
  "Time": "Zeit",
  "loading": "lädt",
  "Play or save a part": "Einen Teil abspielen oder speichern",
  "Part: {} to {}": "Teil: {} bis {}",
  "From (s)": "Von (s)",
  "To (s)": "Bis (s)",
  "Start here": "Hier beginnen",
  "The bag ends before the part that this page names.": "Das Bag endet vor dem Teil, den diese Seite nennt.",
  "End here": "Hier enden",
  "Whole bag": "Ganzes Bag",
  "Save part": "Teil speichern",
  "This must be later than the start.": "Das muss später als der Anfang sein.",
  "Saving {}…": "{} wird gespeichert …",
  "Saved {}, {}": "{} gespeichert, {}",
  "1 message": "1 Nachricht",
  "{} messages": "{} Nachrichten",
  "{} more topics": "{} weitere Topics",
  "not played: {}": "nicht abgespielt: {}",
  "its messages are not CDR but {}": "seine Nachrichten sind nicht CDR, sondern {}",
  "its name is not valid in ROS 2": "sein Name ist in ROS 2 nicht gültig",
  "its type is not valid in ROS 2": "sein Typ ist in ROS 2 nicht gültig",
  "its type differs from the {} of this page": "sein Typ unterscheidet sich vom {} dieser Seite",

  "Compare the definitions": "Definitionen vergleichen",
  "In the bag": "Im Bag",
  "On this page": "Auf dieser Seite",

  // Recorders.
  "Recorder": "Rekorder",
  "Record": "Aufnehmen",
  "Agree and record": "Zustimmen und aufnehmen",
  "If you agree, these topics and what you press and enter on this page are recorded. Nothing is sent: the recording stays in this browser until you save or delete it.":
    "Mit Zustimmung werden diese Topics und alles aufgenommen, was auf dieser Seite gedrückt und eingegeben wird. Nichts wird gesendet: Die Aufnahme bleibt in diesem Browser, bis sie gespeichert oder gelöscht wird.",
  "Size of the recording": "Größe der Aufnahme",
  "All topics": "Alle Topics",
  "All topics but {}": "Alle Topics außer {}",
  "Hidden topics, too, such as events of services": "Auch verborgene Topics, etwa Ereignisse von Services",
  "Recording {} of at most {}: {} on {} topics, {}": "Aufnahme: {} von höchstens {}, {} auf {} Topics, {}",
  "This browser keeps it in memory only: save it before you close the page.":
    "Dieser Browser hält sie nur im Arbeitsspeicher: bitte speichern, bevor die Seite geschlossen wird.",
  "Recorded: {}, {}": "Aufgenommen: {}, {}",
  "Recordings": "Aufnahmen",
  "A recording that was interrupted is complete again: {}": "Eine unterbrochene Aufnahme ist wieder vollständig: {}",
  "recovered": "wiederhergestellt",
  "Open": "Öffnen",
  "Save as folder": "Als Ordner speichern",
  "A tar file with the folder of 'ros2 bag'": "Eine tar-Datei mit dem Ordner von „ros2 bag“",
  "Rename": "Umbenennen",
  "Name of the recording": "Name der Aufnahme",
  "A name begins with a letter or digit and has letters, digits, spaces and . _ - + ( ).":
    "Ein Name beginnt mit einem Buchstaben oder einer Ziffer und hat Buchstaben, Ziffern, Leerzeichen und . _ - + ( ).",
  "Another recording has this name.": "So heißt schon eine andere Aufnahme.",
  "Delete": "Löschen",
  "Really delete?": "Wirklich löschen?",
  "The recording has reached its limit of {} MB.": "Die Aufnahme hat ihre Grenze von {} MB erreicht.",
  "The browser has no more space for this recording.": "Der Browser hat keinen Platz mehr für diese Aufnahme.",
  "The recording has ended: {}": "Die Aufnahme hat geendet: {}",

  // Bags that cannot be read.
  "A part of this page could not be loaded; check the connection to the site.":
    "Ein Teil dieser Seite konnte nicht geladen werden; bitte die Verbindung zur Site prüfen.",
  "The bag could not be loaded ({}).": "Das Bag konnte nicht geladen werden ({}).",
  "The bag could not be loaded; check the connection to the site.":
    "Das Bag konnte nicht geladen werden; bitte die Verbindung zur Site prüfen.",
  "The server no longer sends parts of this bag; reload the page.":
    "Der Server sendet keine Teile dieses Bags mehr; bitte die Seite neu laden.",
  "This server sends no parts of files, and the bag has more than {} MB.":
    "Dieser Server sendet keine Teile von Dateien, und das Bag hat mehr als {} MB.",
  "There is not enough memory for this bag.": "Für dieses Bag reicht der Arbeitsspeicher nicht.",
  "This bag cannot be read: {}": "Dieses Bag ist nicht lesbar: {}",
  "This is not an MCAP file. Bags of other formats are converted by sitegen when a site is built.":
    "Das ist keine MCAP-Datei. Bags anderer Formate wandelt sitegen um, wenn eine Site gebaut wird.",
  "This bag has chunks of more than {} MB, which the page does not read.":
    "Dieses Bag hat Blöcke von mehr als {} MB, die die Seite nicht liest.",
  "This bag has more than {} topics or {} chunks.": "Dieses Bag hat mehr als {} Topics oder {} Blöcke.",
  "This bag has no index and more than {} MB; convert it with 'ros2 bag convert'.":
    "Dieses Bag hat kein Verzeichnis und mehr als {} MB; „ros2 bag convert“ wandelt es um.",
  "This bag is compressed with '{}', which the page cannot read.":
    "Dieses Bag ist mit „{}“ komprimiert, was die Seite nicht lesen kann.",
  "This bag is cut off or damaged; only its first part is played.":
    "Dieses Bag ist abgeschnitten oder beschädigt; nur sein erster Teil wird abgespielt.",
  "This bag is damaged: its index names bytes that it does not have.":
    "Dieses Bag ist beschädigt: Sein Verzeichnis nennt Bytes, die es nicht hat.",
  "This bag is empty.": "Dieses Bag ist leer.",
  "A damaged part of this bag is left out.": "Ein beschädigter Teil dieses Bags wird ausgelassen.",
  "The schema of {} has an invalid line: {}": "Das Schema von {} hat eine ungültige Zeile: {}",
  "The schema of {} has no definition of {}.": "Das Schema von {} hat keine Definition von {}.",
  "The schema of {} has too many types.": "Das Schema von {} hat zu viele Typen.",
  "The schema of {} is nested too deep.": "Das Schema von {} ist zu tief verschachtelt.",
  "The schema of {} is too large.": "Das Schema von {} ist zu groß.",
  "The schema of {} is too long.": "Das Schema von {} ist zu lang.",
  "The schemas have an invalid type: {}": "Die Schemas haben einen ungültigen Typ: {}",
};
