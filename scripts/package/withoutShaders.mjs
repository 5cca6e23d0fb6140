/**
 * A bundler plugin that removes the shaders of three.js's built-in materials and environments, about 110 kB. The renderer uses only its
 * own raw shaders for smoke, surfaces and ink. Do not use it on pages that render anything else with the same three.js.
 */

/** A shader in the build of three.js: a string literal with escaped line breaks, on one line. */
const SHADER = /^((?:var|const) [\w$]+ = )"(?:[^"\\]|\\.)*\\n(?:[^"\\]|\\.)*";$/gm;
/** A shader in the code of environments and of headsets: a template literal that begins with a line of GLSL. */
const TEMPLATE = /`\s+(?:#define|precision|uniform|varying|void) [^`]*`/g;
/** Lower counts mean that the build format of three.js has changed and that SHADER or TEMPLATE must be updated. */
const MIN_SHADERS = 100;
const MIN_TEMPLATES = 10;

/**
 * Applies to builds only.
 * @returns {import('rolldown').Plugin & { apply: 'build' }}
 */
export function withoutShaders() {
  return {
    name: 'without-shaders',
    apply: 'build',
    transform: {
      filter: { id: /three\/build\/three\.module\.js$/ },
      handler(code) {
        const count = code.match(SHADER)?.length ?? 0;
        const templates = code.match(TEMPLATE)?.length ?? 0;
        if (count < MIN_SHADERS || templates < MIN_TEMPLATES)
          throw new Error(`Only ${count} and ${templates} shaders of three.js were found to remove.`);
        return { code: code.replace(SHADER, '$1"";').replace(TEMPLATE, '""'), map: null };
      },
    },
  };
}
