/** Values of the element's `src` attribute. */
import { expect, test } from 'vitest';
import { readLink } from '../../../../src/page/element/attributes/link.ts';
import { FIRST_PRESET } from '../../../../src/parameters/byScene/fetchPreset.ts';
import type { Notice } from '../../../../src/parameters/notice.ts';

const PAGE = 'https://example.org/page.html';

async function read(src: string) {
  const notices: Notice[] = [];
  const { values, start } = await readLink(src, PAGE, notices);
  return { scene: values.scene, start, notices };
}

test.each(['', '?t=3', 'v=1&preset=wisp', 'https://example.org/', '#'])(
  'a src without a hash, %j, is reported and the first preset is shown',
  async (src) => {
    const { scene, notices } = await read(src);
    expect(scene).toBe(FIRST_PRESET);
    expect(notices).toEqual([{ code: 'malformed', key: 'src', given: src, message: expect.any(String) }]);
    expect(notices[0].message).toBe(
      `src cannot be \u201c${src}\u201d: it takes a share link, such as #v=1&preset=wisp. \u201c${FIRST_PRESET}\u201d is shown.`,
    );
  },
);

test('a src with a hash is read without a notice, with the time of its query', async () => {
  expect(await read('?t=3#v=1&preset=wisp')).toEqual({ scene: 'wisp', start: 3, notices: [] });
});

test.each(['#?secret=abc123', '#secret', ':~:text=smoke', '?utm_source=mail'])(
  'what a host appends to a src, or to the address of a frame, ends the link: %s',
  async (suffix) => {
    for (const address of ['?t=3', 'https://example.org/embed.html?interactive=0&t=3']) {
      const link = `${address}#v=1&preset=wisp`;
      expect(await read(link + suffix), link).toEqual({ scene: 'wisp', start: 3, notices: [] });
    }
  },
);

test('an invalid src is reported once', async () => {
  const { notices } = await read('https://[');
  expect(notices.map(({ code, key }) => [code, key])).toEqual([['damaged', 'src']]);
});
