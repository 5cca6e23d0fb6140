/**
 * A bundler plugin that removes code of wasm-bindgen for browsers without WASM SIMD, which smoke needs anyway, and for calls of
 * `initSync` that `src/sim/load.ts` does not make.
 */

/** @type {readonly [RegExp, string][]} */
const FALLBACKS = [
  [/if \(!\('encodeInto' in cachedTextEncoder\)\) \{.*?\n\}\n/s, ''],
  [/\(typeof FinalizationRegistry === 'undefined'\)\s*\? \{[^?]*?\}\s*: new /, 'new '],
  [/if \(module !== undefined\) \{\s*if \(Object.*?\n {4}\}\n/s, '({module} = module);\n'],
  [/if \(!\(module instanceof WebAssembly\.Module\)\) \{.*?\n {4}\}\n/s, ''],
];

/** @returns {import('rolldown').Plugin} */
export function withoutFallbacks() {
  return {
    name: 'without-fallbacks',
    transform: {
      filter: { id: /sim\/wasm\/\w+\/bindings\.js$/ },
      handler: (code) => ({ code: FALLBACKS.reduce(without, code), map: null }),
    },
  };
}

/**
 * @param {string} code
 * @param {[RegExp, string]} fallback and what replaces it
 */
function without(code, [fallback, replacement]) {
  if (!fallback.test(code)) throw new Error(`The code of wasm-bindgen has changed: ${fallback} is not in it.`);
  return code.replace(fallback, replacement);
}
