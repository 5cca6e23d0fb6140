/**
 * A patch of three.js: bundler plugins that remove code that no pass uses. The renderer has only its own raw shaders for
 * smoke, surfaces and ink. Do not use them on pages that render anything else with the same three.js. All apply to builds
 * only. A build fails if three.js no longer has the code.
 */

/** @typedef {import('rolldown').Plugin & { apply: 'build' }} BuildPlugin */
/**
 * @typedef Removal
 * @property {RegExp} pattern with the flag `g`
 * @property {string} [replacement]
 * @property {number} atLeast matches; fewer mean that the build of three.js has changed and that the pattern must be updated
 */

const RENDERER = /three\/build\/three\.module\.js$/;
const CORE = /three\/build\/three\.core\.js$/;

/**
 * Shaders of the built-in materials: string literals with escaped line breaks, on one line. Shaders of environments and of
 * headsets: template literals that begin with a line of GLSL.
 * @type {Removal[]}
 */
const SHADERS = [
  { pattern: /^((?:var|const) [\w$]+ = )"(?:[^"\\]|\\.)*\\n(?:[^"\\]|\\.)*";$/gm, replacement: '$1"";', atLeast: 140 },
  { pattern: /`\s+(?:#define|precision|uniform|varying|void) [^`]*`/g, replacement: '""', atLeast: 11 },
];

/** What the renderer calls although no session ever starts. */
const NO_HEADSET = `class WebXRManager extends EventDispatcher {
  enabled = false;
  isPresenting = false;
  getEnvironmentBlendMode() {}
  setAnimationLoop() {}
  dispose() {}
}
`;

/** @type {Removal[]} */
const HEADSETS = [
  { pattern: /^class WebXRManager extends EventDispatcher \{\n.*?\n\}\n/gms, replacement: NO_HEADSET, atLeast: 1 },
];

/**
 * Extensions that no pass uses. Each waits for the GPU twice.
 * @type {Removal[]}
 */
const EXTENSIONS = [
  { pattern: /^\t\t\tgetExtension\( '(?!EXT_color_buffer_float)\w+' \);$/gm, atLeast: 5 },
  { pattern: /extensions\.has\( 'EXT_texture_filter_anisotropic' \) === true/g, replacement: 'false', atLeast: 2 },
  { pattern: /extensions\.has\( 'OES_texture_float_linear' \) === false/g, replacement: 'false', atLeast: 2 },
];

/**
 * Assignments to classes of animation and of loaders, because of which a bundler keeps the classes.
 * @type {Removal[]}
 */
const ANIMATION = [
  { pattern: /^\w*KeyframeTrack\.prototype\.\w+ = .*;$/gm, atLeast: 19 },
  { pattern: /^PropertyBinding\.(?:prototype\.)?\w+ = (?:\w+|\{.*?\n\}|\[.*?\n\]);$/gms, atLeast: 5 },
  { pattern: /^Loader\.DEFAULT_MATERIAL_NAME = .*;$/gm, atLeast: 1 },
];

/** @type {Removal[]} */
const JSON_METHODS = [{ pattern: /^\t(?:static )?(?:toJSON|fromJSON)\(.*?^\t\}$/gms, atLeast: 90 }];

/**
 * Shaders are about 110 kB.
 * @param {{ hasLoaders?: boolean }} [options] whether the page loads models, which needs animation
 * @returns {BuildPlugin[]}
 */
export function smallThree({ hasLoaders = false } = {}) {
  return [
    without('shaders', RENDERER, SHADERS),
    without('headsets', RENDERER, HEADSETS),
    without('extensions', RENDERER, EXTENSIONS),
    ...(hasLoaders ? [] : [without('animation', CORE, ANIMATION)]),
    without('json', CORE, JSON_METHODS),
  ];
}

/**
 * @param {string} part
 * @param {RegExp} id
 * @param {Removal[]} removals
 * @returns {BuildPlugin}
 */
function without(part, id, removals) {
  return {
    name: `without-${part}`,
    apply: 'build',
    transform: { filter: { id }, handler: (code) => ({ code: removals.reduce(removed(part), code), map: null }) },
  };
}

/** @param {string} part */
function removed(part) {
  return (/** @type {string} */ code, /** @type {Removal} */ { pattern, replacement = '', atLeast }) => {
    const count = code.match(pattern)?.length ?? 0;
    if (count < atLeast)
      throw new Error(
        `Only ${count} pieces of the ${part} of three.js were found to remove, not ${atLeast}: update scripts/patches/three.mjs for ${pattern}.`,
      );
    return code.replace(pattern, replacement);
  };
}
