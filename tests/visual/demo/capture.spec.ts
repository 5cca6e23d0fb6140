import { PNG } from 'pngjs';
import { decodeApng } from '../../support/files/apng.ts';
import { expect, longIf, test } from '../../support/fixtures.ts';

type Cases = typeof import('./capture.cases.ts');
const CASES = '/tests/visual/demo/capture.cases.ts';

test('a PNG is the picture, also larger with the same flat colours, and transparent without background', async ({
  load,
}) => {
  const report = await (await load<Cases>(CASES)).evaluate((cases) => cases.still());
  expect(report).toEqual({ differing: 0, size: [320, 240], foreignFlats: [], alphaOfCorner: 0, isUntouched: true });
});

for (const format of ['gif', 'apng', 'webp'] as const) {
  test(`a loop as ${format} has all frames at their times, and has no seam${longIf(format !== 'apng')}`, async ({
    load,
  }) => {
    const { moves, jump, ...report } = await (
      await load<Cases>(CASES)
    ).evaluate((cases, name) => cases.loop(name), format);
    expect(report).toMatchObject({ frameCount: 6, loops: true, type: `image/${format}`, isUntouched: true });
    // Delays of a GIF are hundredths of a second.
    report.times.forEach((time, frame) => expect(Math.abs(time - frame / 12)).toBeLessThan(0.0051));
    // Of the picture with its backdrop. The others are compared byte by byte below.
    if (format === 'gif') expect(report.kept).toBe(20);
    for (const moved of moves) expect(moved).toBeGreaterThan(50);
    const seam = moves.pop()!;
    expect(seam).toBeLessThanOrEqual(Math.max(...moves));
    expect(Math.max(...moves)).toBeLessThan(jump);
  });
}

test('an APNG has every byte of the PNG files, alpha included @long', async ({ load }) => {
  const { file, straight } = await (await load<Cases>(CASES)).evaluate((cases) => cases.loop('apng'));
  const { frames, plays, delays } = decodeApng(Buffer.from(file, 'base64'));
  expect([plays, delays]).toEqual([0, Array(6).fill(1 / 12)]);
  // The loop starts with the fourth picture of the sequence; its second half is the transition.
  for (const [at, png] of straight.slice(3).entries()) {
    expect(Buffer.compare(frames[at], PNG.sync.read(Buffer.from(png, 'base64')).data), `frame ${at}`).toBe(0);
  }
  const partial = frames.map((frame) => frame.filter((value, at) => at % 4 === 3 && value > 0 && value < 255).length);
  for (const count of partial) expect(count).toBeGreaterThan(50);
});

test('a WebP has the alpha of the PNG files, and nearly their colours @long', async ({ load }) => {
  const { straight, pixels } = await (await load<Cases>(CASES)).evaluate((cases) => cases.loop('webp'));
  for (const [at, png] of straight.slice(3).entries()) {
    const expected = PNG.sync.read(Buffer.from(png, 'base64')).data;
    const found = Buffer.from(pixels[at], 'base64');
    expect(found.filter((value, byte) => byte % 4 === 3 && value !== expected[byte]).length).toBe(0);
    const off = Array.from(found, (value, byte) => Math.abs(value - expected[byte]) * (expected[byte | 3] / 255));
    expect(off.reduce((sum, value) => sum + value) / off.length).toBeLessThan(1);
  }
});

test('clip() gives the bytes of the loop of the page', async ({ load }) => {
  const report = await (await load<Cases>(CASES)).evaluate((cases) => cases.clipped());
  expect(report).toEqual({ own: true, asked: true, isUntouched: true });
});

test('without an encoder of WebP the page reports it and suggests APNG', async ({ load }) => {
  const report = await (await load<Cases>(CASES)).evaluate((cases) => cases.withoutWebp());
  expect(report).toEqual({
    message: 'VideoError: This browser cannot encode WebP. Choose APNG, which every browser shows.',
    isUntouched: true,
  });
});

for (const format of ['webm', 'mp4'] as const) {
  const tag = longIf(format === 'mp4');
  test(`a ${format} has every frame at its time, and neighbours differ${tag}`, async ({ load }) => {
    const report = await (await load<Cases>(CASES)).evaluate((cases, name) => cases.video(name), format);
    expect(report.times).toHaveLength(6);
    report.times.forEach((time, frame) => expect(time).toBeCloseTo(frame / 24, 2));
    // Compression hides some of the pixels in which the drawn frames differ.
    report.moves.forEach((moved, at) => expect(moved).toBeGreaterThan(0.4 * report.drawnMoves[at]));
    for (const moved of report.drawnMoves) expect(moved).toBeGreaterThan(20);
    expect(report.size).toEqual([160, 120]);
    expect(report.isUntouched).toBe(true);
  });
}

test('a sequence has a PNG with alpha for each frame', async ({ load }) => {
  const report = await (await load<Cases>(CASES)).evaluate((cases) => cases.sequence(false));
  expect(report.names).toEqual(['frame-0001.png', 'frame-0002.png', 'frame-0003.png']);
  expect(report.corners).toEqual([0, 0, 0]);
  expect(report.composed).toBeGreaterThan(50);
  expect(report.isUntouched).toBe(true);
});

test('composited layers equal the picture @long', async ({ load }) => {
  const report = await (await load<Cases>(CASES)).evaluate((cases) => cases.sequence(true));
  expect(report.names).toEqual([
    'depth/0001.png',
    'flats/0001.png',
    'ink/0001.png',
    'shadow/0001.png',
    'surfaces/0001.png',
  ]);
  expect(report.composed).toBeLessThan(1);
  expect(report.isUntouched).toBe(true);
});

test('layers follow a timeline of what they change, and composited equal each frame @long', async ({ load }) => {
  const { errors, parts, ...report } = await (await load<Cases>(CASES)).evaluate((cases) => cases.animatedLayers());
  for (const error of errors) expect(error).toBeLessThan(1);
  // At the steps 180, 182.5, 185 and 187.5.
  expect(parts).toEqual([
    [true, true],
    [false, true],
    [false, false],
    [true, false],
  ]);
  expect(report).toEqual({ isSame: true, isUntouched: true });
});

test('composited layers of smoke with marks equal the picture @long', async ({ load }) => {
  const report = await (await load<Cases>(CASES)).evaluate((cases) => cases.printedLayers());
  const layers = ['depth', 'flats', 'ink', 'marks', 'shadow', 'surfaces'];
  expect(report.names).toEqual(layers.map((layer) => `${layer}/0001.png`));
  expect(report.error).toBeLessThan(1);
  expect(report.marked).toBeGreaterThan(300);
});

test('the layer of surfaces has everything but the smoke', async ({ load }) => {
  const report = await (await load<Cases>(CASES)).evaluate((cases) => cases.withoutSmoke());
  expect(report.flats).toBeGreaterThan(100);
  expect(report.surfaces).toBe(0);
  expect(report.drawn).toBe(50);
  expect(report.isUntouched).toBe(true);
});

test('a flipbook has its frames in rows, loops, and covers the same pixels in all atlases', async ({ load }) => {
  const report = await (await load<Cases>(CASES)).evaluate((cases) => cases.flipbook());
  expect(report.names).toEqual(['channels.png', 'color.png', 'flipbook.json', 'motion.png', 'normals.png']);
  expect(report.layout).toMatchObject({ columns: 3, rows: 2, frames: 6, rate: 12, frame: [80, 60], atlas: [240, 120] });
  expect(report.size).toEqual([240, 120]);
  expect([report.isFirst, report.isStart]).toEqual([true, false]);
  for (const moved of report.moves) expect(moved).toBeGreaterThan(10);
  expect(report.moves[5]).toBeLessThanOrEqual(Math.max(...report.moves.slice(0, 5)));
  expect(report.motion).toBeGreaterThan(10);
  expect(report.alpha).toBe(0);
  for (const levels of report.channels) expect(levels).toBeGreaterThan(10);
  expect(report.isUntouched).toBe(true);
});

const LAYOUTS = {
  unity: ['right', 'top', 'back', 'coverage', 'left', 'bottom', 'front', 'emission'],
  unreal: ['right', 'left', 'top', 'coverage', 'bottom', 'back', 'front', 'emission'],
} as const;

for (const [layout, glow] of [
  ['unity', 1],
  ['unreal', 0],
] as const) {
  test(`light maps for ${layout} have light from six sides, and emission ${glow}${longIf(layout === 'unreal')}`, async ({
    load,
  }) => {
    const report = await (
      await load<Cases>(CASES)
    ).evaluate((cases, given) => cases.lightMaps(...given), [layout, glow] as const);
    expect(report.order).toEqual(LAYOUTS[layout]);
    const { coverage, right, left, top, bottom, front, back, emission } = report.sides;
    expect(coverage.sum).toBeGreaterThan(50_000);
    expect(right.x - coverage.x).toBeGreaterThan(1);
    expect(coverage.x - left.x).toBeGreaterThan(1);
    expect(bottom.y - top.y).toBeGreaterThan(2);
    expect(front.sum).toBeGreaterThan(3 * back.sum);
    for (const { most } of [right, left, top, bottom, front]) expect(most).toBe(255);
    // The violet of the darkest tone has 0.55 of the light of white in its brightest channel.
    if (glow) expect(emission.sum).toBeGreaterThan(0.5 * coverage.sum);
    else expect(emission.sum).toBe(0);
  });
}

test('a drawing has the flat colours in named groups, and looks like the picture', async ({ load }) => {
  const report = await (await load<Cases>(CASES)).evaluate((cases) => cases.drawing());
  expect(report.groups).toEqual(['flats', 'ink']);
  expect(report.missing).toEqual([]);
  expect(report.bytes).toBeLessThan(100_000);
  expect(report.error).toBeLessThan(0.02 * 255);
  expect(report.isUntouched).toBe(true);
});

test('a drawing of smoke with marks has patterns instead of marks, and is as dark as the picture', async ({ load }) => {
  const report = await (await load<Cases>(CASES)).evaluate((cases) => cases.printedDrawing());
  console.log(JSON.stringify(report));
  expect(report.groups).toEqual(['flats', 'marks', 'ink']);
  expect(report.patterns.length).toBeGreaterThan(2);
  expect(report.fills).toEqual(report.patterns.map((id) => `url(#${id})`));
  expect(report.bytes).toBeLessThan(140_000);
  expect(report.error).toBeLessThan(0.03 * 255);
  const [picture, drawing, without] = report.means;
  expect(picture - without).toBeGreaterThan(0.5);
  expect(Math.abs(picture - drawing)).toBeLessThan(0.25 * (picture - without));
});

for (const format of ['zip', 'apng'] as const) {
  test(`a cancelled ${format} ends at once and does not change the smoke${longIf(format === 'zip')}`, async ({
    load,
  }) => {
    const report = await (await load<Cases>(CASES)).evaluate((cases, name) => cases.cancelled(name), format);
    expect(report).toEqual({ outcome: 'AbortError', shares: 2, isUntouched: true });
  });
}

const CLIPS = [
  ['apng', 'image/apng', undefined],
  ['webp', 'image/webp', undefined],
  ['gif', 'image/gif', undefined],
  ['webm', 'video/webm', undefined],
  ['mp4', 'video/mp4', undefined],
] as const;
const [APNG, WEBP, GIF, WEBM] = CLIPS;

for (const [what, settings, isWithoutEncoder, rows] of [
  ['all formats', { rate: 12 }, false, CLIPS],
  [
    'those without background',
    { rate: 12, hasBackground: false },
    false,
    [APNG, WEBP, GIF, WEBM, ['mp4', 'video/mp4', 'with background']],
  ],
  [
    'a clip that is too fast for GIF, in a browser without video',
    { rate: 60, seconds: 0.1 },
    true,
    [
      APNG,
      WEBP,
      ['gif', undefined, 'At most 30 per second'],
      ['webm', undefined, 'Not in this browser'],
      ['mp4', undefined, 'Not in this browser'],
    ],
  ],
] as const) {
  test(`a comparison of ${what} has a file or a reason for each${longIf(what !== 'all formats')}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const report = await cases.evaluate((module, given) => module.compared(...given), [
      settings,
      isWithoutEncoder,
    ] as const);
    expect(report.rows).toEqual(rows);
    for (const size of report.sizes) expect(size).toBeGreaterThan(500);
    expect(report.shares).toEqual(report.shares.toSorted((a, b) => a - b));
    expect(report.shares.at(-1)).toBe(isWithoutEncoder ? 1 / 3 : 1);
    expect(report.isUntouched).toBe(true);
  });
}

// No browser encodes it in 2026, so the encoder is replaced. The browser of the tests is the one without.
test('an MP4 has alpha if, and only if, the browser encodes HEVC with it', async ({ load }) => {
  const report = await (await load<Cases>(CASES)).evaluate((cases) => cases.hevc());
  expect(report.hasField, 'whether there is a field, and a background').toEqual([false, true, true, false]);
  const config = { codec: 'hvc1.1.6.L153.B0', width: 160, height: 120, framerate: 24, alpha: 'keep' };
  expect(report.configs).toEqual([expect.objectContaining(config)]);
  expect(report.corners).toEqual(Array(6).fill(0));
  expect(report.times.map((time) => Math.round(24 * time))).toEqual([0, 1, 2, 3, 4, 5]);
  expect([report.codec, report.type, report.isUntouched]).toEqual(['hevc', 'video/mp4', true]);
});

test('without an encoder the page reports it and suggests an alternative', async ({ load }) => {
  const report = await (await load<Cases>(CASES)).evaluate((cases) => cases.withoutEncoder());
  expect(report.message).toContain('cannot encode Video (MP4) at 160 \u00d7 120 pixels. Use');
  expect(report.isUntouched).toBe(true);
});
