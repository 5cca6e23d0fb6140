/** What the tests ask of a browser, whatever protocol it is driven by. */
export interface Driver {
  /** Loads an address in the one page, and waits for its `load` event. */
  open(address: string): Promise<void>;
  /** Evaluates an expression in the page. Promises are awaited; the value goes through JSON. */
  evaluate(expression: string): Promise<unknown>;
  close(): Promise<void>;
}
