/** The documentation site, built by scripts/site/docs.mjs from pages that scripts/site/documents.mjs writes. */

import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { createCssVariablesTheme, type ShikiTransformer } from 'shiki';
import { defineConfig, type DefaultTheme, type HeadConfig } from 'vitepress';

const CACHE = fileURLToPath(new URL('../../.cache/docs', import.meta.url));
const PAGES = fileURLToPath(new URL('../pages', import.meta.url));
const ICON = readFileSync(fileURLToPath(new URL('../../public/favicon.svg', import.meta.url)), 'utf8');
const OUT = process.env.DOCS_OUT ?? join(CACHE, 'out');
/** Where the documentation will be published, with a trailing slash; empty if that is not known. */
const PUBLISHED = process.env.DOCS_ADDRESS ?? '';

const { repository, groups }: { repository: string; groups: DefaultTheme.SidebarItem[] } = JSON.parse(
  readFileSync(join(PAGES, 'navigation.json'), 'utf8'),
);

/** Classes in place of style attributes, which a Content Security Policy with `style-src 'self'` forbids. */
const classesForColors: ShikiTransformer = {
  name: 'classes-for-colors',
  preprocess(_, options) {
    // Otherwise a slow machine would leave the ends of lines without colours.
    options.tokenizeTimeLimit = 0;
  },
  pre(node) {
    delete node.properties.style;
  },
  span(node) {
    const name = /--shiki-token-([\w-]+)/.exec(String(node.properties.style))?.[1];
    delete node.properties.style;
    if (name) node.properties.class = `token-${name}`;
  },
};

/** Moves inline scripts to files, and removes style attributes: a strict Content Security Policy forbids both. */
function withoutInlineCode(html: string, page: string): string {
  // These are of the theme; site.css has what they do.
  const plain = html.replace(/ style="(position:relative|--vp-vh:0px);"/g, '');
  if (/ style="/.test(plain)) throw new Error(`${page} has a style attribute, which a strict policy forbids.`);
  return plain.replace(/<script(?![^>]*\bsrc=)([^>]*)>([^]*?)<\/script>/g, (_, attributes: string, code: string) => {
    const name = `assets/${createHash('sha256').update(code).digest('hex').slice(0, 10)}.js`;
    mkdirSync(join(OUT, 'assets'), { recursive: true });
    writeFileSync(join(OUT, name), code);
    // Only the one that chooses light or dark has to run before the page is visible.
    const isEarly = /check-dark-mode|type="module"/.test(attributes);
    return `<script${attributes}${isEarly ? '' : ' defer'} src="${relative(dirname(page), join(OUT, name)).replaceAll('\\', '/')}"></script>`;
  });
}

/** The address of a page for search engines. */
function canonicalLinks(page: string): HeadConfig[] {
  if (!PUBLISHED || page === '404.md') return [];
  const path = page.replace(/\.md$/, '.html').replace(/(^|\/)index\.html$/, '$1');
  return [['link', { rel: 'canonical', href: new URL(path, PUBLISHED).href }]];
}

/** A block of code with smoke beside it, see theme/liveSmoke.ts. */
function liveExample(block: string, code: string, kind: string, preset: string, page: string): string {
  const picture = `${'../'.repeat(page.split('/').length - 1) || './'}posters/${preset}.webp`;
  return `<LiveSmoke code="${encodeURIComponent(code).replaceAll("'", '%27')}" kind="${kind}" preset="${preset}">
<template #poster><img src="${picture}" width="800" height="400" alt="" /></template>
<template #code>${block}</template>
</LiveSmoke>
`;
}

export interface ThemeConfig extends DefaultTheme.Config {
  /** Address of the script of the element, from the root of the documentation. */
  readonly elementScript: string;
}

export default defineConfig<ThemeConfig>({
  title: 'Cartoon Smoke',
  description: 'Real-time cartoon smoke for the browser: guides, parameters and the API.',
  lang: 'en',
  // The site works in any folder of any host.
  base: './',
  // The sidebar has links to all pages: the service worker fetches these when the first page is complete.
  router: { prefetchLinks: false },
  srcDir: PAGES,
  outDir: OUT,
  cacheDir: join(CACHE, 'vite'),
  // Source maps list the packages in the scripts, for their licences.
  vite: { build: { sourcemap: 'hidden', assetsInlineLimit: 0 } },
  transformHtml: withoutInlineCode,
  transformHead: ({ page }) => canonicalLinks(page),
  // It would insert a style element.
  appearance: { disableTransition: false },
  // A relative address would be wrong after a link to a page in another folder, which changes only the content.
  head: [['link', { rel: 'icon', href: `data:image/svg+xml,${encodeURIComponent(ICON)}`, type: 'image/svg+xml' }]],
  markdown: {
    theme: createCssVariablesTheme(),
    codeTransformers: [classesForColors],
    // Guides begin with text, for which pictures further down would leave less of a slow connection.
    image: { lazyLoad: true },
    // As GitHub makes them, so that links with a heading work in both places.
    anchor: { slugify: anchorOf },
    config(md) {
      const { code_inline: inlineCode } = md.renderer.rules;
      // Otherwise Vue would evaluate `{{ }}` in it.
      md.renderer.rules.code_inline = (tokens, at, ...others) => {
        tokens[at].attrSet('v-pre', '');
        return inlineCode!(tokens, at, ...others);
      };
      for (const rule of ['th_open', 'td_open']) {
        md.renderer.rules[rule] = (tokens, at, options, _env, self) => {
          const token = tokens[at];
          const [, side] = /^text-align:(\w+)$/.exec(token.attrGet('style') ?? '') ?? [];
          if (side) token.attrs = [...token.attrs!.filter(([name]) => name !== 'style'), ['class', `aligned-${side}`]];
          return self.renderToken(tokens, at, options);
        };
      }
      const { fence } = md.renderer.rules;
      md.renderer.rules.fence = (tokens, at, options, env: { relativePath: string }, self) => {
        const block = fence!(tokens, at, options, env, self);
        const [, language, named] = /^(html|json) live ?([\w-]*)/.exec(tokens[at].info) ?? [];
        if (!language) return block;
        const code = tokens[at].content.trim();
        const preset = named || (/\spreset="([\w-]+)"/.exec(code)?.[1] ?? 'lamp');
        return liveExample(block, code, language === 'html' ? 'element' : 'values', preset, env.relativePath);
      };
    },
  },
  themeConfig: {
    nav: [
      { text: 'Demo', link: '/../index.html', target: '_self' },
      { text: 'Examples', link: '/../examples.html', target: '_self' },
    ],
    elementScript: process.env.DOCS_ELEMENT ?? '',
    sidebar: { '/design/': groups, '/': groups.map(withoutPages) },
    outline: { level: [2, 3] },
    search: { provider: 'local' },
    socialLinks: [{ icon: 'github', link: repository }],
    docFooter: { prev: false, next: false },
  },
});

/** A link to the first page in place of a collapsed group. Pages with fewer links hydrate faster. */
function withoutPages(group: DefaultTheme.SidebarItem): DefaultTheme.SidebarItem {
  return group.collapsed ? { text: group.text, link: group.items![0].link } : group;
}

function anchorOf(heading: string): string {
  return heading
    .toLowerCase()
    .replace(/[^\p{L}\p{N} _-]/gu, '')
    .trim()
    .replaceAll(' ', '-');
}
