/** Captures are files. Without an encoder for a video, capture fails with a VideoError. */
import { describe, expect } from 'vitest';
import { decodeApng } from '../support/files/apng.ts';
import { engine, test } from './fixtures.ts';
import { colorsIn, pictureIn } from './pictures.ts';

type Page = typeof import('./page/stages.ts');

const STAGES = '/tests/engines/page/stages.ts';

test('a PNG', async ({ load }) => {
  const file = fileIn(await (await load<Page>(STAGES)).captured('png'));
  const picture = pictureIn(file.bytes);
  expect([file.type, picture.width, picture.height]).toEqual(['image/png', 80, 60]);
  expect(colorsIn(picture)).toBeGreaterThan(20);
});

test('a GIF', async ({ load }) => {
  const file = fileIn(await (await load<Page>(STAGES)).captured('gif'));
  const bytes = Buffer.from(file.bytes, 'base64');
  expect([file.type, bytes.toString('latin1', 0, 6)]).toEqual(['image/gif', 'GIF89a']);
  expect([bytes.readUInt16LE(6), bytes.readUInt16LE(8)]).toEqual([80, 60]);
  expect(bytes.length).toBeGreaterThan(2_000);
});

test('an APNG', async ({ load }) => {
  const file = fileIn(await (await load<Page>(STAGES)).captured('apng'));
  expect(file.type).toBe('image/apng');
  const { width, height, plays, frames } = decodeApng(Buffer.from(file.bytes, 'base64'));
  expect([width, height, plays]).toEqual([80, 60, 0]);
  expect(frames.length).toBeGreaterThan(1);
  for (const frame of frames) expect(colorsIn({ data: frame })).toBeGreaterThan(20);
});

test('a WebP, or the reason why there is none', async ({ load, task }) => {
  const outcome = await (await load<Page>(STAGES)).captured('webp');
  let note = 'is encoded';
  if ('error' in outcome) {
    expect(outcome.error).toBe('VideoError');
    expect(outcome.message).toMatch(/^This browser cannot encode WebP\. Choose APNG/);
    note = outcome.message;
  } else {
    const bytes = Buffer.from(outcome.bytes, 'base64');
    expect([outcome.type, bytes.toString('latin1', 8, 16)]).toEqual(['image/webp', 'WEBPVP8X']);
    expect([bytes.readUIntLE(24, 3), bytes.readUIntLE(27, 3)]).toEqual([79, 59]);
    expect(bytes.length).toBeGreaterThan(2_000);
  }
  task.meta.note = `webp  ${engine.title}  ${note}`;
});

// Debian's WebKitGTK has VideoEncoder, but its web process crashes in isConfigSupported().
describe.skipIf(engine.title === 'WebKit' && !engine.isPlaywrights)('video', () => {
  test.for(['webm', 'mp4'] as const)('a %s, or the reason why there is none', async (format, { load, task }) => {
    const outcome = await (await load<Page>(STAGES)).captured(format);
    if ('error' in outcome) {
      expect(outcome.error).toBe('VideoError');
      expect(outcome.message).toMatch(/^This browser cannot encode (WebM|MP4) at 80 × 60 pixels\./);
    } else {
      expect(outcome.type).toBe(`video/${format}`);
      expect(outcome.bytes.length).toBeGreaterThan(1_000);
    }
    task.meta.note = `${format}  ${engine.title}  ${'error' in outcome ? outcome.message : 'is encoded'}`;
  });
});

function fileIn(outcome: Awaited<ReturnType<Page['captured']>>): { type: string; bytes: string } {
  if ('error' in outcome) throw new Error(`${outcome.error}: ${outcome.message}`);
  return outcome;
}
