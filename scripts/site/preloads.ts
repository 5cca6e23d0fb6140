import type { Plugin, Rollup } from 'vite';

/**
 * Adds preload hints to the page for modules that its entry imports dynamically, so that they load in parallel.
 * @param entry suffix of the path of a module that the page's entry imports dynamically
 */
export function preloads(entry: string): Plugin {
  return {
    name: 'preloads',
    apply: 'build',
    transformIndexHtml: {
      order: 'post',
      handler(_, { bundle = {}, chunk }) {
        const later = chunk?.dynamicImports.find((name) => {
          const found = bundle[name];
          return found?.type === 'chunk' && found.facadeModuleId?.endsWith(entry);
        });
        if (!chunk || !later) return [];
        const hinted = closure(bundle, chunk.fileName);
        return [...closure(bundle, later)]
          .filter((name) => !hinted.has(name))
          .map((name) => ({
            tag: 'link',
            attrs: { rel: 'modulepreload', crossorigin: true, href: `./${name}` },
            injectTo: 'head' as const,
          }));
      },
    },
  };
}

/** A chunk and all its static imports. */
function closure(bundle: Rollup.OutputBundle, name: string): Set<string> {
  const names = new Set([name]);
  for (const each of names) {
    const chunk = bundle[each];
    if (chunk?.type === 'chunk') for (const imported of chunk.imports) names.add(imported);
  }
  return names;
}
