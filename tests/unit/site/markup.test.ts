/** What a person may type beside a live example of the documentation. */
import { describe, expect, it } from 'vitest';
import { readElement, readValues } from '../../../site/.vitepress/theme/markup.ts';

describe('readElement', () => {
  it.each([
    ['<cartoon-smoke></cartoon-smoke>', {}],
    ['<cartoon-smoke preset="wisp">', { preset: 'wisp' }],
    [
      `\n<cartoon-smoke\n  preset='wisp'\n  paused emission-rate=24\n>A cup.</cartoon-smoke>\n`,
      { preset: 'wisp', paused: '', 'emission-rate': '24' },
    ],
    ['<CARTOON-SMOKE Preset="wisp"></cartoon-smoke>', { preset: 'wisp' }],
    ['<cartoon-smoke alt="&quot;A&quot; &amp;amp; B"></cartoon-smoke>', { alt: '"A" &amp; B' }],
    ['<cartoon-smoke preset="wisp" preset="lamp"></cartoon-smoke>', { preset: 'wisp' }],
    ['<cartoon-smoke style="height: 9px" onload="alert(1)"></cartoon-smoke>', { onload: 'alert(1)' }],
  ])('reads %s', (text, attributes) => {
    expect(Object.fromEntries(readElement(text))).toEqual(attributes);
  });

  it.each([
    ['nothing', ''],
    ['another element', '<img src="x">'],
    ['two elements', '<cartoon-smoke></cartoon-smoke><cartoon-smoke></cartoon-smoke>'],
    ['an element inside', '<cartoon-smoke><img src="x"></cartoon-smoke>'],
    ['an open quote', '<cartoon-smoke preset="wisp></cartoon-smoke>'],
    ['a tag in a value', '<cartoon-smoke alt="<b>"></cartoon-smoke>'],
  ])('refuses %s', (_, text) => {
    expect(() => readElement(text)).toThrow(SyntaxError);
  });

  it('takes no longer for a long text without an end', () => {
    expect(() => readElement(`<cartoon-smoke ${'a=b '.repeat(20_000)}`)).toThrow(SyntaxError);
  });
});

describe('readValues', () => {
  it('reads numbers and texts', () => {
    expect(readValues('{ "emission.rate": 24, "style.smokeColor": "#ffffff" }')).toEqual({
      'emission.rate': 24,
      'style.smokeColor': '#ffffff',
    });
  });

  it.each([
    ['no JSON', '{ a: 1 }'],
    ['a list', '[1]'],
    ['null', 'null'],
    ['an object', '{ "a": {} }'],
    ['a call', 'alert(1)'],
  ])('refuses %s', (_, text) => {
    expect(() => readValues(text)).toThrow(SyntaxError);
  });
});
