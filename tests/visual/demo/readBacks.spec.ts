/** Some browsers falsify pixels that pages read, against fingerprinting. */
import { readdirSync, readFileSync } from 'node:fs';
import { expect, longIf, test } from '../../support/fixtures.ts';

type Cases = typeof import('./readBacks.cases.ts');
const CASES = '/tests/visual/demo/readBacks.cases.ts';
const SRC = new URL('../../../src/', import.meta.url);

const DECISIONS = [
  'renderer/gpu/selfTest',
  'demo/capture/svg',
  'demo/capture/layers',
  'demo/capture/flipbook',
  'demo/film/depth',
];
const READS = /readPixels\(|getImageData\(|readRenderTargetPixels|new PixelReader/;
/** Files that read the pixels of a file or a picture, but choose nothing else by them. */
const OTHERS = [
  // Waits for the GPU.
  'demo/costs/costScene',
  'demo/draw/import',
  'demo/film/film',
  // Examines the files of a film, whose browser the command starts.
  'demo/film/stinger',
  'demo/gallery/ownShape',
  'demo/palette/picture',
  'page/clip/pixelReader',
  'page/clip/record',
  'page/outline/trace',
  'stage/model/colors',
];

test('no other file decides by pixels that it reads', () => {
  const files = readdirSync(SRC, { recursive: true, encoding: 'utf8' }).filter((path) => path.endsWith('.ts'));
  const reading = files.filter((path) => READS.test(readFileSync(new URL(path, SRC), 'utf8')));
  const names = reading.map((path) => path.replace(/\.ts$/, ''));
  expect(names).toEqual(expect.arrayContaining(DECISIONS));
  expect(names.filter((name) => ![...DECISIONS, ...OTHERS].includes(name))).toEqual([]);
});

for (const file of DECISIONS) {
  const tag = longIf(/flipbook|svg|layers/.test(file));
  test(`${file} decides the same by falsified pixels, and notices another truth${tag}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const decide = (noise: Parameters<Cases['decide']>[1], isOther: boolean) =>
      cases.evaluate((module, [name, kind, other]) => module.decide(name, kind, other), [
        `${file}.ts`,
        noise,
        isOther,
      ] as const);
    const [truth, other] = [await decide('none', false), await decide('none', true)];
    expect(truth).not.toEqual(other);
    for (const noise of ['the lowest bit of every byte', 'the highest bit of one byte'] as const) {
      for (const isOther of [false, true]) {
        const decided = await decide(noise, isOther);
        for (const [key, value] of Object.entries(isOther ? other : truth)) {
          // One byte is of one pixel, which is all that it may change.
          const tolerance = key === 'writesDepth' ? 0 : 4 + 0.01 * value;
          expect(Math.abs(decided[key] - value), `${key} with ${noise}`).toBeLessThanOrEqual(tolerance);
        }
      }
    }
  });
}
