// @vitest-environment jsdom
import { describe, expect, it, vi } from 'vitest';
import { readSvg } from '../../../src/page/outline/svg.ts';

const svg = (content: string, attributes = '') =>
  `<svg xmlns="http://www.w3.org/2000/svg" ${attributes}>${content}</svg>`;
const only = (content: string) => readSvg(svg(content)).shapes[0];

describe('the shapes of an SVG file', () => {
  it.each([
    ['<path d="M0 0h4v4z"/>', 'M0 0h4v4z'],
    ['<rect x="1" y="2" width="3" height="4"/>', 'M1 2h3v4h-3z'],
    ['<circle cx="5" cy="6" r="2"/>', 'M3 6a2 2 0 1 0 4 0a2 2 0 1 0 -4 0z'],
    ['<polygon points="0,0 4,0 4,4"/>', 'M0 0 4 0 4 4z'],
    ['<line x1="1" y1="2" x2="3" y2="4"/>', 'M1 2L3 4'],
  ])('%s is a path', (element, path) => expect(only(element).path).toBe(path));

  it.each([
    ['<path d="M0 0" fill="#ff0000"/>', '#ff0000'],
    ['<g fill="red"><path d="M0 0"/></g>', 'red'],
    ['<path d="M0 0" style="fill: blue"/>', 'blue'],
    ['<style>.a, .b { fill: #abc; }</style><path class="b" d="M0 0"/>', '#abc'],
    ['<path d="M0 0" fill="url(#gradient)"/>', '#ffffff'],
    ['<path d="M0 0" fill="none" stroke="red"/>', undefined],
  ])('%s has its colour', (content, fill) => expect(only(content).fill).toBe(fill));

  it('have the transforms of their groups', () => {
    const { matrix } = only('<g transform="translate(10, 20) scale(2)"><path transform="rotate(90)" d="M0 0"/></g>');
    expect(matrix.map((each) => Math.round(each))).toEqual([0, 2, -2, 0, 10, 20]);
  });

  it('are in the box of the file', () => {
    expect(readSvg(svg('<path d="M0 0"/>', 'viewBox="-1 -2 30 40"')).box).toEqual([-1, -2, 30, 40]);
    expect(readSvg(svg('<path d="M0 0"/>', 'width="30" height="40px"')).box).toEqual([0, 0, 30, 40]);
    expect(readSvg(svg('<path d="M0 0"/>', 'viewBox="0 0 NaN -1"')).box).toEqual([0, 0, 100, 100]);
  });
});

describe('a hostile SVG file', () => {
  const GOOD = '<path d="M0 0h4v4z"/>';

  it.each([
    ['scripts', `<script>globalThis.hit = true</script>${GOOD}`],
    ['handlers', `<g onload="globalThis.hit = true">${GOOD}</g>`],
    ['pictures of others', `<image href="https://example.org/a.png"/>${GOOD}`],
    ['documents of others', `<use href="https://example.org/a.svg#a"/>${GOOD}`],
    [
      'foreign elements',
      `<foreignObject><img xmlns="http://www.w3.org/1999/xhtml" src="https://example.org/a.png" onerror="globalThis.hit = true"/></foreignObject>${GOOD}`,
    ],
    ['imported styles', `<style>@import url(https://example.org/a.css);</style>${GOOD}`],
    ['animation', `<animate href="#a" attributeName="href" to="https://example.org"/>${GOOD}`],
    ['links', `<a href="javascript:globalThis.hit = true">${GOOD}</a>`],
    ['hidden definitions', `<defs>${GOOD}</defs><clipPath>${GOOD}</clipPath><symbol>${GOOD}</symbol>${GOOD}`],
  ])('has no effect by %s', (_, content) => {
    const request = vi.spyOn(globalThis, 'fetch');
    expect(readSvg(svg(content)).shapes.map(({ path }) => path)).toEqual(['M0 0h4v4z']);
    expect(request).not.toHaveBeenCalled();
    expect(globalThis).not.toHaveProperty('hit');
  });

  it.each([
    ['empty', ''],
    ['no XML', 'PNG'],
    ['HTML', '<html><body/></html>'],
    ['without shapes', svg('<text>POW</text>')],
    ['an entity bomb', `<!DOCTYPE svg [<!ENTITY a "lol"><!ENTITY b "&a;&a;">]>${svg('<text>&b;</text>')}`],
    ['an external entity', `<!DOCTYPE svg [<!ENTITY a SYSTEM "file:///etc/passwd">]>${svg('<text>&a;</text>')}`],
  ])('that is %s is rejected', (_, text) => expect(() => readSvg(text)).toThrow(/valid SVG|no shapes/));

  it('has a limited depth of nested groups', () => {
    const deep = '<g>'.repeat(300) + GOOD + '</g>'.repeat(300);
    expect(readSvg(svg(deep + GOOD)).shapes).toHaveLength(1);
  });

  it('keeps numbers that are none to itself', () => {
    const { matrix, path } = only('<circle r="NaN" cx="1e999" transform="scale(NaN) rotate()"/>');
    expect(path).not.toContain('NaN');
    expect(matrix).toHaveLength(6);
  });
});
