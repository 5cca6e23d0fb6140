/** The bundler plugins of the site. */

import { fileURLToPath } from 'node:url';
import type { HtmlTagDescriptor, Plugin, Rolldown } from 'vite';

const PICTURE = 'icons/512.png';

/**
 * Adds a page's absolute URLs for search engines and link previews, if the site's URL is known.
 * @param base URL of the site's folder, with a trailing slash
 */
export function addresses(base: string | undefined): Plugin {
  return {
    name: 'addresses',
    apply: 'build',
    transformIndexHtml(html, { path }) {
      if (!base) return [];
      const address = new URL(path.replace(/^\//, '').replace(/index\.html$/, ''), base).href;
      const texts = { title: /<title>([^<]*)</, description: /name="description"\s+content="([^"]*)"/ };
      return [
        head('link', { rel: 'canonical', href: address }),
        head('meta', { property: 'og:url', content: address }),
        head('meta', { property: 'og:image', content: new URL(PICTURE, base).href }),
        ...Object.entries(texts).flatMap(([name, pattern]) => {
          const content = pattern.exec(html)?.[1];
          return content === undefined ? [] : [head('meta', { property: `og:${name}`, content })];
        }),
      ];
    },
  };
}

function head(tag: string, attrs: Record<string, string>): HtmlTagDescriptor {
  return { tag, attrs, injectTo: 'head' };
}

/**
 * Adds Content-Security-Policies to built pages. The development server needs inline styles and a web socket.
 * @param byPath policies by the paths of pages, such as `/overlay.html`
 */
export function policies(byPath: Readonly<Record<string, string>>): Plugin {
  return {
    name: 'policies',
    apply: 'build',
    transformIndexHtml: {
      order: 'post',
      handler(_, { path }) {
        const content = byPath[path];
        if (content === undefined) return [];
        // A policy applies to what follows it.
        const attrs = { 'http-equiv': 'Content-Security-Policy', content };
        return [{ tag: 'meta', attrs, injectTo: 'head-prepend' as const }];
      },
    },
  };
}

/** Links the theme before the other style sheets, which override it. Vite's order follows the chunks of the scripts. */
export function themeFirst(): Plugin {
  return {
    name: 'theme-first',
    apply: 'build',
    transformIndexHtml: {
      order: 'post',
      handler(html) {
        const theme = /\s*<link rel="stylesheet"[^>]*\/theme-[^>]*>/.exec(html)?.[0];
        if (!theme) return html;
        return html.replace(theme, '').replace(/\s*<link rel="stylesheet"/, (first) => theme + first);
      },
    },
  };
}

/**
 * Names one chunk for modules and all their static imports.
 * @param modules absolute paths
 * @param exporting paths of modules that only export others, whose imports are not all needed
 */
export function together(
  name: string,
  modules: readonly string[],
  exporting: RegExp,
): Rolldown.CodeSplittingNameFunction {
  let all: Set<string> | undefined;
  return (id, context) => {
    if (!all) {
      all = new Set(modules);
      for (const each of all) {
        const imported = exporting.test(each) ? [] : (context.getModuleInfo(each)?.importedIds ?? []);
        for (const one of imported) all.add(one);
      }
    }
    return all.has(id) ? name : null;
  };
}

const SOURCE = fileURLToPath(new URL('../../src/demo/offline/worker.ts', import.meta.url));
const NAME = 'sw.js';

/** Builds the service worker with the site, so that it contains the file names of its version. */
export function serviceWorker(): Plugin {
  return {
    name: 'service-worker',
    apply: 'build',
    buildStart() {
      // Without a hash in the name, because browsers check this URL for updates.
      this.emitFile({ type: 'chunk', id: SOURCE, fileName: NAME });
    },
    generateBundle: {
      order: 'post',
      handler(_, bundle) {
        const chunk = bundle[NAME];
        if (chunk?.type !== 'chunk' || chunk.imports.length > 0) this.error(`${NAME} has to be one plain script.`);
        const files = Object.keys(bundle).filter((name) => name.startsWith('assets/') && !name.endsWith('.map'));
        chunk.code = chunk.code.replace('HASHED_FILES', JSON.stringify(files.sort()));
      },
    },
  };
}
