/**
 * A plugin for the bundler: three.js without the shaders of its own materials, some 100 kB of text. Smoke, its surfaces and its
 * ink are drawn by raw shaders of this project alone. Not for pages that draw anything else with the same three.js.
 */

/** A shader as the build of three.js holds it: text with line breaks in it, on one line. */
const SHADER = /^((?:var|const) [\w$]+ = )"(?:[^"\\]|\\.)*\\n(?:[^"\\]|\\.)*";$/gm;
/** Fewer mean that three.js is built another way now, and that this should look there. */
const MIN_SHADERS = 100;

/** Does nothing where nothing is bundled. @returns {import('rolldown').Plugin & { apply: 'build' }} */
export function withoutShaders() {
  return {
    name: 'without-shaders',
    apply: 'build',
    transform: {
      filter: { id: /three\/build\/three\.module\.js$/ },
      handler(code) {
        const count = code.match(SHADER)?.length ?? 0;
        if (count < MIN_SHADERS) throw new Error(`Only ${count} shaders of three.js were found to leave out.`);
        return { code: code.replace(SHADER, '$1"";'), map: null };
      },
    },
  };
}
