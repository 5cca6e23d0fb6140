/** The component of docs/film.md in Remotion, which renders frames in any order. */
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { PNG } from 'pngjs';
import { expect, test } from '../../support/freshProject.ts';

const [FIRST, LAST] = [60, 65];
const SINGLE = [64, 60];

const ROOT = `
import { Composition, registerRoot } from 'remotion';
import { Smoke } from './Smoke';
const size = { width: 160, height: 90 };
registerRoot(() => <Composition id="smoke" component={Smoke} durationInFrames={90} fps={30} {...size} />);
`;

const RENDER = `
import { bundle } from '@remotion/bundler';
import { renderFrames, renderStill, selectComposition } from '@remotion/renderer';
const serveUrl = await bundle({ entryPoint: 'src/root.tsx' });
const browser = {
  browserExecutable: process.argv[2],
  chromiumOptions: { gl: 'swangle' },
  timeoutInMilliseconds: 300_000,
};
const composition = await selectComposition({ serveUrl, id: 'smoke', ...browser });
const clip = { outputDir: 'frames', imageFormat: 'png', concurrency: 2, frameRange: [${FIRST}, ${LAST}], inputProps: {} };
await renderFrames({ serveUrl, composition, ...clip, onStart() {}, onFrameUpdate() {}, ...browser });
for (const frame of [${SINGLE.join()}]) {
  await renderStill({ serveUrl, composition, frame, output: \`single-\${frame}.png\`, ...browser });
}
`;

function component(): string {
  const guide = readFileSync(new URL('../../../docs/film.md', import.meta.url), 'utf8');
  return /```tsx\n([^]+?)```/.exec(guide)![1];
}

test('frames of two tabs are the frames rendered alone', async ({ project, launchOptions }) => {
  const remotion = ['remotion', '@remotion/bundler', '@remotion/renderer'].map((name) => `${name}@4`);
  const files = { 'src/Smoke.tsx': component(), 'src/root.tsx': ROOT, 'render.mjs': RENDER };
  const place = project([...remotion, 'react@19', 'react-dom@19'], files);
  execFileSync(process.execPath, ['render.mjs', launchOptions.executablePath!], {
    cwd: place,
    stdio: 'pipe',
  });
  const picture = (file: string) => PNG.sync.read(readFileSync(join(place, file)));
  const pictures = Array.from({ length: LAST - FIRST + 1 }, (_, at) => picture(`frames/element-${FIRST + at}.png`));
  for (const frame of SINGLE) {
    expect(picture(`single-${frame}.png`).data.equals(pictures[frame - FIRST].data)).toBe(true);
  }
  expect(new Set(pictures.map(({ data }) => data.toString('base64'))).size).toBe(pictures.length);
});
