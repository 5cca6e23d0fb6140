/** The browser interface of the tests, independent of the protocol. */
export interface Driver {
  /** Loads a URL in the single page, and waits for its `load` event. */
  open(address: string): Promise<void>;
  /** Evaluates an expression in the page. Awaits promises; serializes the value as JSON. */
  evaluate(expression: string): Promise<unknown>;
  /** The WebGL renderer. Navigates the page. */
  renderer(): Promise<string>;
  close(): Promise<void>;
}

/** Timeout of a command, milliseconds. */
export const LIMIT = 600_000;

/** An expression for the unmasked renderer string of WebGL 2. */
export const RENDERER = `(() => {
  const gl = document.createElement('canvas').getContext('webgl2');
  const extension = gl?.getExtension('WEBGL_debug_renderer_info');
  return extension ? gl.getParameter(extension.UNMASKED_RENDERER_WEBGL) : 'no WebGL 2';
})()`;
