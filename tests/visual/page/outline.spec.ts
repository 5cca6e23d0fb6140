/** Shapes traced from texts, paths, SVG files and images. */
import { expect, test } from '../../support/fixtures.ts';

type Cases = typeof import('./outline.cases.ts');
const CASES = '/tests/visual/page/outline.cases.ts';

const svg = (content: string, head = '') =>
  `${head}<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">${content}</svg>`;
const SQUARE = '<path d="M10 10h50v50h-50z"/>';

// Source, number of lines, ratio of width and height, covered part of the rectangle.
const SOURCES = [
  [{ path: 'M0 0h10v10h-10z' }, 1, 1, 1],
  [{ path: 'M1000 1000h4000v1000h-4000z' }, 1, 4, 1],
  [{ svg: svg(SQUARE) }, 1, 1, 1],
  [{ svg: svg('<circle cx="50" cy="50" r="30"/>') }, 1, 1, Math.PI / 4],
  ['canvas', 2, 1, (Math.PI / 4) * (1 - 0.6 ** 2)],
  [{ text: '\u25a0' }, 1, 1, 1],
] as const;

test('a shape is traced to whole numbers along its longer side', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  for (const [source, lines, ratio, covered] of SOURCES) {
    const traced = await cases.evaluate((module, each) => module.traced(each), source);
    expect(traced, JSON.stringify(source)).toMatchObject({ isValid: true, lines });
    const [width, height] = traced.size!;
    expect(Math.max(width, height)).toBeGreaterThan(244);
    expect(width / height / ratio, JSON.stringify(source)).toBeCloseTo(1, 1);
    expect(traced.covered, JSON.stringify(source)).toBeCloseTo(covered, 1);
  }
});

test('a word has the outlines of its letters and of their holes', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const linesOf = async (text: string) =>
    (await cases.evaluate((module, word) => module.traced({ text: word }), text)).lines;
  expect(await linesOf('TEA')).toBe(4);
  expect(await linesOf('BOO')).toBe(7);
  expect(await linesOf('T\nT')).toBe(2);
});

const EVIL = 'https://evil.example/';
// What the file or the text holds besides, and whether there is something to fill.
const HOSTILE = [
  [{ svg: svg(`<script>window.hacked = true</script>${SQUARE}`) }, true],
  [{ svg: svg(`<image href="${EVIL}a.png"/><use href="${EVIL}b.svg#c"/>${SQUARE}`) }, true],
  [{ svg: svg(`<style>@import "${EVIL}a.css"; path { fill: url(${EVIL}c.svg#d) }</style>${SQUARE}`) }, true],
  [{ svg: svg(`<path fill="url(${EVIL}a.svg#b)" d="M10 10h50v50h-50z"/>`) }, true],
  [
    {
      svg: svg(`<g onload="window.hacked = true">${SQUARE}</g><foreignObject><iframe src="${EVIL}"/></foreignObject>`),
    },
    true,
  ],
  [{ svg: svg(SQUARE, `<!DOCTYPE svg [<!ENTITY e SYSTEM "${EVIL}e">]>`) }, true],
  [{ svg: svg('<path d="M1e999 NaNh1"/>') }, false],
  [{ svg: svg('<g>'.repeat(5000)) }, false],
  [{ svg: 'not an SVG' }, false],
  [{ path: `url(${EVIL})` }, false],
  [{ path: 'M0 0h1e30v1e30z' }, true],
  [{ path: 'M'.repeat(200_000) }, false],
  [{ text: `<img src="${EVIL}" onerror="hacked=1">`.slice(0, 40) }, true],
  [{ text: 'A', font: `900 a, url(${EVIL}f.woff)` }, true],
  [{ text: '\u200b' }, false],
  [{ text: ' ' }, false],
] as const;

test('hostile files and texts run nothing and request nothing', async ({ load, page }) => {
  const cases = await load<Cases>(CASES);
  const requested: string[] = [];
  page.on('request', (request) => requested.push(request.url()));
  for (const [source, isShape] of HOSTILE) {
    const name = JSON.stringify(source).slice(0, 80);
    const traced = await cases.evaluate((module, each) => module.traced(each), source);
    if (isShape) expect(traced, name).toMatchObject({ isValid: true });
    else expect(traced.error, name).toBeTruthy();
  }
  expect(await cases.evaluate((module) => module.isUntouched())).toBe(true);
  expect(requested.filter((url) => url.includes('evil'))).toEqual([]);
});
