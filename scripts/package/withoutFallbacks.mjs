/** A bundler plugin that removes the fallbacks for older browsers and unused features from the simulator's bindings. */

/** Every browser with SIMD has encodeInto, only this project calls the bindings, and it does not use `using`. */
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
        if (stray) throw new Error(`The simulator bindings contain no ${stray} to remove.`);
        return { code: FALLBACKS.reduce((left, fallback) => left.replace(fallback, ''), code), map: null };
      },
    },
  };
}
