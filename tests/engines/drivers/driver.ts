/** What the tests ask of a browser, whatever protocol it is driven by. */
export interface Driver {
  /** Loads an address in the one page, and waits for its `load` event. */
  open(address: string): Promise<void>;
  /** Evaluates an expression in the page. Promises are awaited; the value goes through JSON. */
  evaluate(expression: string): Promise<unknown>;
  /** What WebGL draws with. Leaves the page. */
  renderer(): Promise<string>;
  close(): Promise<void>;
}

/** Milliseconds that a command may take. */
export const LIMIT = 600_000;

/** An expression for the unmasked renderer string of WebGL 2. */
export const RENDERER = `(() => {
  const gl = document.createElement('canvas').getContext('webgl2');
  const extension = gl?.getExtension('WEBGL_debug_renderer_info');
  return extension ? gl.getParameter(extension.UNMASKED_RENDERER_WEBGL) : 'no WebGL 2';
})()`;
