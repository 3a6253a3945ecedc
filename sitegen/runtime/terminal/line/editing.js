// @ts-check
// The text of the input line, and what each key does to it, as in readline with Emacs keys.

/** What the keys of a terminal ask for, by their sequence. @type {Record<string, string>} */
const KEYS = {
  "\r": "enter", "\n": "enter", "\t": "complete", "\x03": "interrupt", "\x04": "end", "\x0c": "clear",
  "\x7f": "rubOut", "\b": "rubOut", "\x1b[3~": "delete",
  "\x1b[A": "older", "\x1bOA": "older", "\x10": "older", "\x1b[B": "newer", "\x1bOB": "newer", "\x0e": "newer",
  "\x1b[C": "right", "\x1bOC": "right", "\x06": "right", "\x1b[D": "left", "\x1bOD": "left", "\x02": "left",
  "\x1b[H": "home", "\x1bOH": "home", "\x1b[1~": "home", "\x01": "home",
  "\x1b[F": "toEnd", "\x1bOF": "toEnd", "\x1b[4~": "toEnd", "\x05": "toEnd",
  "\x0b": "killToEnd", "\x15": "killToStart", "\x17": "killWord", "\x1b\x7f": "killWord", "\x19": "yank",
  "\x1bb": "wordLeft", "\x1b[1;5D": "wordLeft", "\x1b[1;3D": "wordLeft",
  "\x1bf": "wordRight", "\x1b[1;5C": "wordRight", "\x1b[1;3C": "wordRight", "\x1bd": "deleteWord", "\x12": "search",
};
const SEQUENCE = /\x1b(?:\[[\d;]*[A-Za-z~]|O[A-Z]|[\x20-\x7f]?)|[\0-\x1f\x7f]|[^\0-\x1f\x7f]+/g;

/**
 * Split what a terminal sends into actions and texts.
 * @param {string} data @returns {{action: string, text: string}[]} `action` is "insert" for texts, "" for unknown keys
 */
export function keysOf(data) {
  return (data.match(SEQUENCE) ?? []).map((text) => {
    const known = Object.hasOwn(KEYS, text) ? KEYS[text] : undefined;
    return { action: known ?? (text < " " || text === "\x7f" ? "" : "insert"), text };
  });
}

export class Editing {
  text = "";
  /** The index of the cursor, in the text. */
  at = 0;
  #killed = "";

  /** @param {string} text @param {number} [at] */
  set(text, at = text.length) {
    this.text = text;
    this.at = at;
  }

  /** @param {string} more */
  insert(more) {
    this.set(this.text.slice(0, this.at) + more + this.text.slice(this.at), this.at + more.length);
  }

  /** Do what a key asks for; return whether it is known here. @param {string} action */
  apply(action) {
    const { at, text } = this;
    switch (action) {
      case "left": this.at = this.#before(at); break;
      case "right": this.at = this.#after(at); break;
      case "home": this.at = 0; break;
      case "toEnd": this.at = text.length; break;
      case "wordLeft": this.at = this.#wordLeft(); break;
      case "wordRight": this.at = this.#wordRight(); break;
      case "rubOut": this.#remove(this.#before(at), at); break;
      case "delete": this.#remove(at, this.#after(at)); break;
      case "killToEnd": this.#kill(at, text.length); break;
      case "killToStart": this.#kill(0, at); break;
      case "killWord": this.#kill(text.slice(0, at).search(/\S+\s*$/), at); break;
      case "deleteWord": this.#kill(at, this.#wordRight()); break;
      case "yank": this.insert(this.#killed); break;
      default: return false;
    }
    return true;
  }

  /** @param {number} from @param {number} to */
  #kill(from, to) {
    if (from < 0 || from === to) return;
    this.#killed = this.text.slice(from, to);
    this.#remove(from, to);
  }

  /** @param {number} from @param {number} to */
  #remove(from, to) {
    this.set(this.text.slice(0, from) + this.text.slice(to), from);
  }

  // Characters outside of the first plane are two units.
  /** @param {number} at */
  #before(at) {
    return Math.max(0, at - (/[\udc00-\udfff]/.test(this.text[at - 1] ?? "") ? 2 : 1));
  }

  /** @param {number} at */
  #after(at) {
    return Math.min(this.text.length, at + (/[\ud800-\udbff]/.test(this.text[at] ?? "") ? 2 : 1));
  }

  #wordLeft() {
    return Math.max(0, this.text.slice(0, this.at).search(/\w+\W*$/));
  }

  #wordRight() {
    return this.at + (/^\W*\w*/.exec(this.text.slice(this.at))?.[0].length ?? 0);
  }
}
