import type { HtmlTagDescriptor, Plugin } from 'vite';

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
