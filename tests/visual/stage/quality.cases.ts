/** Stages that draw fewer pixels than the page has. */
import { createDevice, type Device } from '../../../src/renderer/gpu/device.ts';
import { findPreset, presetValues } from '../../../src/parameters/presets.ts';
import { createStage } from '../../../src/stage/stage.ts';
import { gpuKeepsUp } from '../../support/gpuKeepsUp.ts';
import { PLAIN_LOOK } from '../../support/plainLook.ts';
import { differing, HEIGHT, pixelsOf, shown, SMALL, visibleCanvas, WIDTH } from './stage.cases.ts';

/**
 * A stage with half the pixels in each direction, compared with a stage of half the size: differing pixels whose
 * neighbourhood is uniform in the second picture, and all such pixels, without ink. Also reports whether `picture()`
 * has all pixels, and the size of the canvas.
 */
export async function halfQuality(device?: Device): Promise<{
  flat: number;
  ink: number;
  differing: number;
  pictureChanged: number;
  canvas: number[];
}> {
  const canvas = visibleCanvas();
  const values = { ...SMALL, 'style.outlineWidth': 6, 'style.inkColor': '#123456' };
  const size = { values, width: WIDTH / 2, height: HEIGHT / 2 };
  const half = await createStage(canvas, { ...size, pixelRatio: 2, quality: 0.5, device });
  const small = await createStage(visibleCanvas(), { ...size, pixelRatio: 1 });
  const whole = await createStage(visibleCanvas(), { ...size, pixelRatio: 2 });
  for (const stage of [half, small, whole]) stage.step(150);
  const [large, reference] = [shown(canvas), shown(small.canvas as HTMLCanvasElement, WIDTH / 2, HEIGHT / 2)];
  const report = { flat: 0, ink: 0, differing: 0 };
  for (let y = 1; y < HEIGHT / 2 - 1; ++y) {
    for (let x = 1; x < WIDTH / 2 - 1; ++x) {
      const color = reference[(y * WIDTH) / 2 + x];
      const around = [-1, 0, 1].flatMap((dy) => [-1, 0, 1].map((dx) => reference[((y + dy) * WIDTH) / 2 + x + dx]));
      if (around.some((other) => other !== color)) continue;
      const block = [0, 1, WIDTH, WIDTH + 1].map((offset) => large[2 * y * WIDTH + 2 * x + offset]);
      report.flat += 1;
      report.ink += color === 0xff563412 ? 1 : 0;
      report.differing += block.some((other) => other !== color) ? 1 : 0;
    }
  }
  const [a, b] = await Promise.all([half, whole].map(async (stage) => pixelsOf(await stage.picture())));
  for (const stage of [half, small, whole]) stage.dispose();
  return { ...report, pictureChanged: differing(a, b), canvas: [canvas.width, canvas.height] };
}

/** The same on a device that stages share. */
export async function halfQualityShared(): ReturnType<typeof halfQuality> {
  const device = createDevice(new OffscreenCanvas(1, 1));
  const report = await halfQuality(device);
  device.dispose();
  return report;
}

/** Scales of a playing stage whose frames are too slow, and after a pause. */
export async function governedScales(quality: 'auto' | undefined): Promise<{ played: number[]; paused: number }> {
  gpuKeepsUp();
  let frame: FrameRequestCallback = () => {};
  const { requestAnimationFrame } = globalThis;
  globalThis.requestAnimationFrame = (callback) => {
    frame = callback;
    return 1;
  };
  const canvas = new OffscreenCanvas(64, 48);
  const values = { ...presetValues(findPreset('air')!), ...PLAIN_LOOK, 'simulation.maxParticles': 50 };
  const stage = await createStage(canvas, { values, width: 64, height: 48, pixelRatio: 1, quality });
  const played: number[] = [];
  stage.play();
  for (let now = 0, count = 0; count < 60; ++count) {
    frame((now += 50 * stage.stats.scale ** 2));
    if (played.at(-1) !== stage.stats.scale) played.push(stage.stats.scale);
  }
  stage.pause();
  const paused = stage.stats.scale;
  stage.dispose();
  globalThis.requestAnimationFrame = requestAnimationFrame;
  return { played, paused };
}
