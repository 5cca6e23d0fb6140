// Writes a static site. A server can render the same pages.
export default { output: 'export' };
