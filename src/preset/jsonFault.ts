/** Finds the position of a JSON syntax error. Browsers report it differently or not at all. */

/** Line and column, starting at 1. */
export interface TextPosition {
  readonly line: number;
  readonly column: number;
}

const SPACE = /[ \t\n\r]*/y;
const SCALAR =
  /"(?:[^"\\\p{Cc}]|[\u007f-\u009f]|\\(?:["\\/bfnrt]|u[0-9a-fA-F]{4}))*"|-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?|true|false|null/uy;
/** Maximum nesting: deeper than any valid file, and low enough not to overflow the stack. */
const DEEPEST = 200;

/** Position of the first syntax error; undefined if the text is valid JSON. */
export function jsonFault(text: string): TextPosition | undefined {
  const scan = new Scan(text);
  if (scan.takeValue(0) && scan.isAtEnd) return undefined;
  const before = text.slice(0, scan.at).split('\n');
  return { line: before.length, column: before.at(-1)!.length + 1 };
}

/** A recursive descent scanner that stops at the first syntax error. */
class Scan {
  at = 0;
  private readonly text: string;

  constructor(text: string) {
    this.text = text;
  }

  get isAtEnd(): boolean {
    this.take(SPACE);
    return this.at === this.text.length;
  }

  takeValue(depth: number): boolean {
    if (depth > DEEPEST) return false;
    if (this.takeSign('{')) return this.takeRest('}', () => this.takePair(depth));
    if (this.takeSign('[')) return this.takeRest(']', () => this.takeValue(depth + 1));
    return this.take(SCALAR);
  }

  private takePair(depth: number): boolean {
    this.take(SPACE);
    return this.text[this.at] === '"' && this.take(SCALAR) && this.takeSign(':') && this.takeValue(depth + 1);
  }

  /** Scans the items after an opening bracket, up to the closing one. */
  private takeRest(end: string, takePart: () => boolean): boolean {
    if (this.takeSign(end)) return true;
    while (takePart()) {
      if (this.takeSign(end)) return true;
      if (!this.takeSign(',')) return false;
    }
    return false;
  }

  private takeSign(sign: string): boolean {
    this.take(SPACE);
    if (this.text[this.at] !== sign) return false;
    this.at += 1;
    return true;
  }

  private take(pattern: RegExp): boolean {
    pattern.lastIndex = this.at;
    if (!pattern.test(this.text)) return false;
    this.at = pattern.lastIndex;
    return true;
  }
}
