/** A plugin for the bundler: the bindings of the simulator without what they hold for older browsers and for careless callers. */

/** Every browser with SIMD encodes in place; the only calls are ours, and nobody disposes of what they made by `using`. */
const FALLBACKS = [
  /^if \(!\('encodeInto' in \w+\)\) \{\n(?: .*\n)+\}\n/m,
  / else \{\n +console\.warn\('using deprecated.*\n +\}/g,
  /^if \(Symbol\.dispose\).*\n/m,
];

/** @returns {import('rolldown').Plugin} */
export function withoutFallbacks() {
  return {
    name: 'without-fallbacks',
    transform: {
      filter: { id: /wasm\/\w+\/bindings\.js$/ },
      handler(code) {
        const stray = FALLBACKS.find((fallback) => code.search(fallback) < 0);
        if (stray) throw new Error(`The simulator bindings have no ${stray} to leave out.`);
        return { code: FALLBACKS.reduce((left, fallback) => left.replace(fallback, ''), code), map: null };
      },
    },
  };
}
