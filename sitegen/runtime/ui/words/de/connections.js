// @ts-check
// What scripts and connections to gateways say, in German.

/** @type {Record<string, string>} */
export const connections = {
  // Scripts of authors.
  "this page has no ROS graph; import 'sitegen' in a script or a panel of a page":
    "diese Seite hat keinen ROS-Graphen; importieren Sie 'sitegen' in einem Skript oder einem Feld einer Seite",
  "this page has no definition of {}": "diese Seite hat keine Definition von {}",
  "'{}' is not a valid name in ROS": "'{}' ist kein gültiger Name in ROS",
  "'{}' is not a valid type; write it like '{}'": "'{}' ist kein gültiger Typ; schreiben Sie ihn wie '{}'",
  "give {} a type: the graph has no such topic": "geben Sie {} einen Typ: der Graph hat kein solches Topic",
  "give {} a type: the graph has no such service": "geben Sie {} einen Typ: der Graph hat keinen solchen Service",
  "give {} a type: the graph has no such action": "geben Sie {} einen Typ: der Graph hat keine solche Action",
  "no server for {} within {} s": "kein Server für {} innerhalb von {} s",
  "the goal was {}": "das Ziel endete so: {}",
  "the goal was canceled": "das Ziel wurde abgebrochen",
  "{} has no parameters, or is not running": "{} hat keine Parameter oder läuft nicht",
  "{} refused: {}": "{} lehnte ab: {}",
  "a parameter is a boolean, a number, a text, or a list of one of these":
    "ein Parameter ist ein Wahrheitswert, eine Zahl, ein Text oder eine Liste davon",
  "{} does not fit into 64 bits": "{} passt nicht in 64 Bit",
  "parameter '{}' has already been declared": "der Parameter „{}“ ist schon deklariert",
  "a parameter needs a name, which is a text": "ein Parameter braucht einen Namen, der ein Text ist",
  "{}: a parameter needs a value or a type": "{}: ein Parameter braucht einen Wert oder einen Typ",
  "{}: only integers and doubles can have a range": "{}: nur ganze Zahlen und Gleitkommazahlen können einen Bereich haben",
  "{}: unknown option '{}'; known are {}": "{}: unbekannte Option „{}“; bekannt sind {}",
  "{}: unknown type '{}'; known are {}": "{}: unbekannter Typ „{}“; bekannt sind {}",
  "{}: unknown option '{}'; known are qos and signal": "{}: unbekannte Option „{}“; bekannt sind qos und signal",
  "the page itself has no parameters; make a node with ros.node()":
    "die Seite selbst hat keine Parameter; machen Sie eine Node mit ros.node()",
  "a period must be a positive number of ms": "eine Periode muss eine positive Anzahl von ms sein",
  "unknown log level '{}'; known are {}": "unbekannte Stufe des Protokolls „{}“; bekannt sind {}",
  "qos must be the name of a profile, such as 'sensor_data', or an object of policies":
    "qos muss der Name eines Profils sein, zum Beispiel 'sensor_data', oder ein Objekt mit Policies",
  "qos: unknown {} '{}'; known are {}": "qos: {} „{}“ ist unbekannt; bekannt sind {}",
  "qos: unknown policy '{}'; known are {}": "qos: unbekannte Policy „{}“; bekannt sind {}",
  "qos: '{}' must be true or false": "qos: „{}“ muss true oder false sein",
  "qos: '{}' must be a time in ms": "qos: „{}“ muss eine Zeit in ms sein",
  "qos: '{}' must be a whole number": "qos: „{}“ muss eine ganze Zahl sein",
  // The connection to a gateway.
  "Connection": "Verbindung",
  "Gateway": "Gateway",
  "Key": "Schlüssel",
  "Remote nodes": "Nodes anderswo",
  "Here now: {}": "Gerade hier: {}",
  "1 page": "1 Seite",
  "{} pages": "{} Seiten",
  "1 other client": "1 anderer Client",
  "{} other clients": "{} andere Clients",
  "Who": "Wer",
  "Namespace": "Namespace",
  "Since": "Seit",
  "visitor {}": "Gast {}",
  "(you)": "(Sie)",
  "domain {}": "Domain {}",
  "'{}' is not an address": "„{}“ ist keine Adresse",
  "Connecting to {}…": "Verbindet mit {} …",
  "Connected to {} ({}).": "Verbunden mit {} ({}).",
  "This server speaks rosbridge: the robot can use the topics, services and actions of this page, but does not see its nodes.":
    "Dieser Server spricht rosbridge: Der Roboter kann Topics, Services und Actions dieser Seite benutzen, sieht aber ihre Nodes nicht.",
  "The gateway at {} does not answer. Messages wait until it does.":
    "Das Gateway bei {} antwortet nicht. Nachrichten warten, bis es antwortet.",
  "No gateway answers at {}. Next try in {} s.": "Bei {} antwortet kein Gateway. Nächster Versuch in {} s.",
  "The gateway has ended the connection: {}": "Das Gateway hat die Verbindung beendet: {}",
  "Not connected. The nodes of this page are by themselves.": "Nicht verbunden. Die Nodes dieser Seite sind unter sich.",
  "This gateway asks for a key.": "Dieses Gateway verlangt einen Schlüssel.",
  "Your key is good for {} more.": "Ihr Schlüssel gilt noch {}.",
  "It is your turn for {} more.": "Sie sind noch {} an der Reihe.",
  "It is the turn of {} for {} more.": "{} ist noch {} an der Reihe.",
  "It is nobody's turn.": "Niemand ist an der Reihe.",
  "You have no appointment; you can watch.": "Sie haben keinen Termin; Sie können zusehen.",
  "Yours begins in {}.": "Ihr Termin beginnt in {}.",
  "{} stays in this page: {}": "{} bleibt auf dieser Seite: {}",
  "{} is left out: its type {} differs from the one that this page was built with.":
    "{} fehlt hier: Der Typ {} ist ein anderer als der, mit dem diese Seite gebaut wurde.",
  "The clock of the gateway is {} s ahead of this computer's; times of messages differ.":
    "Die Uhr des Gateways geht gegenüber diesem Computer {} s vor; die Zeiten von Nachrichten weichen ab.",
  "The clock of the gateway is {} s behind this computer's; times of messages differ.":
    "Die Uhr des Gateways geht gegenüber diesem Computer {} s nach; die Zeiten von Nachrichten weichen ab.",
  "This page came over https://, so browsers do not let it use {}. Start the gateway with --tls and use wss://, or open the page from the gateway itself: sitegen gateway serves it with --site.":
    "Diese Seite kam über https://, deshalb lassen Browser sie {} nicht benutzen. Starten Sie das Gateway mit --tls und verwenden Sie wss://, oder öffnen Sie die Seite vom Gateway selbst: sitegen gateway liefert sie mit --site aus.",
  "If its certificate is its own, open {} once and accept it.":
    "Hat es sich sein Zertifikat selbst ausgestellt, öffnen Sie einmal {} und nehmen Sie es an.",
  "If the browser asks, allow this page to reach devices in your network.":
    "Fragt der Browser, erlauben Sie dieser Seite, Geräte in Ihrem Netzwerk zu erreichen.",
};
