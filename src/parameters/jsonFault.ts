import { visit } from 'jsonc-parser';

/** Line and column, starting at 1. */
export interface TextPosition {
  readonly line: number;
  readonly column: number;
}

/** Maximum nesting: deeper than any valid file, and low enough not to overflow the stack. */
const MAX_DEPTH = 200;

/**
 * Position of the first JSON syntax error; undefined if the text is valid JSON. Browsers report it differently or not at
 * all.
 */
export function jsonFault(text: string): TextPosition | undefined {
  let fault: TextPosition | undefined;
  let depth = 0;
  const report = (line: number, character: number) => (fault ??= { line: line + 1, column: character + 1 });
  const enter = (_offset: number, _length: number, line: number, character: number) => {
    if (++depth <= MAX_DEPTH) return;
    report(line, character);
    throw new RangeError('nested too deeply');
  };
  const leave = () => void depth--;
  const onError = (_code: number, _offset: number, _length: number, line: number, character: number) =>
    void report(line, character);
  const visitor = { onArrayBegin: enter, onObjectBegin: enter, onArrayEnd: leave, onObjectEnd: leave, onError };
  try {
    visit(text, visitor, { disallowComments: true });
  } catch (error) {
    if (!(error instanceof RangeError)) throw error;
  }
  return fault;
}
