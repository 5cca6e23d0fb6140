/** The campfire by day and at night, with and without glowing flames. */
import type { Values } from '../../../src/parameters/parameter.ts';
import { SceneLab } from '../sceneLab.ts';

const NIGHT: Values = { 'light.intensity': 0, 'light.ambient': 0.1 };
/** Flames are hotter; below is smoke. */
const GLOW: Values = { 'emission.glow': '.15:0,.19:1' };

/** How the flames and the grey smoke of a picture change with the light. */
export interface Changes {
  flames: number;
  smoke: number;
  /** Pixels of flames that glow with a change from day to night, and the greatest change of a channel without glow. */
  glowing: number;
  dull: number;
  /** Brightest channel of grey smoke by day, at night, and at night beside flames that glow. */
  byDay: number;
  atNight: number;
  byFire: number;
}

/** The campfire after 3 s under the lights, drawn with further values. */
export async function changes(values: Values): Promise<Changes> {
  const [day, bare, glowing, dull] = await Promise.all([
    // Without decay all smoke has the colours of the style.
    picture({ ...values, 'light.decay': 0 }),
    picture({ ...values, 'light.decay': 0 }, true),
    picture({ ...values, ...NIGHT, ...GLOW }),
    picture({ ...values, ...NIGHT }),
  ]);
  const result: Changes = { flames: 0, smoke: 0, glowing: 0, dull: 0, byDay: 0, atNight: 0, byFire: 0 };
  for (let at = 0; at < day.length; at += 4) {
    const colors = [day, bare, glowing, dull].map((pixels) => [...pixels.subarray(at, at + 3)]);
    const [own, behind, hot, cold] = colors;
    // Puffs, and neither ink nor what is in front of them.
    if (own.every((channel, index) => channel === behind[index]) || Math.max(...own) < 60) continue;
    const [red, , blue] = own;
    const apart = (other: number[]) => Math.max(...own.map((channel, index) => Math.abs(channel - other[index])));
    if (blue < 0.42 * red) {
      result.flames++;
      result.glowing += Number(apart(hot) > 2);
      result.dull = Math.max(result.dull, apart(cold));
    } else if (blue > 0.95 * red) {
      result.smoke++;
      result.byDay = Math.max(result.byDay, ...own);
      result.atNight = Math.max(result.atNight, ...cold);
      result.byFire = Math.max(result.byFire, ...hot);
    }
  }
  return result;
}

async function picture(values: Values, isBare = false): Promise<Uint8Array> {
  // Lines have no light. The rim of flames has the colour of smoke.
  const plain: Values = { 'style.outlines': 0, 'style.rim': 0, ...values };
  const lab = await SceneLab.create('campfire', {
    width: 300,
    height: 260,
    values: plain,
    surfaces: () => [],
    ownLook: true,
  });
  lab.step(180);
  // The bounds are those of the previous frame.
  lab.draw();
  const { pixels } = lab.draw({ isBare });
  lab.dispose();
  return pixels;
}

/** Mean brightest channel of what smoke neither covers nor shadows, in some successive steps and without the light of the fire. */
export async function ground(preset: string, step: number, count: number): Promise<{ byFire: number[]; dark: number }> {
  const lab = await SceneLab.create(preset, { width: 300, height: 225, ownLook: true });
  lab.step(step);
  const byFire: number[] = [];
  // The bounds are those of the previous frame.
  lab.draw();
  const unlit = lab.draw({ hasLamps: false }).pixels;
  const bare = lab.draw({ isBare: true }).pixels;
  const seen = seenGround(unlit, bare);
  lab.draw();
  for (let index = 0; index < count; ++index) {
    byFire.push(brightness(lab.draw().pixels, seen));
    lab.step(1);
  }
  lab.dispose();
  return { byFire, dark: brightness(unlit, seen) };
}

/** Pixels of the lower half that have the same colour with and without smoke, and are less blue than the backdrop there. */
function seenGround(drawn: Uint8Array, bare: Uint8Array): number[] {
  const pixels = Array.from({ length: drawn.length / 8 }, (_, index) => 4 * index);
  return pixels.filter(
    (at) => [0, 1, 2].every((channel) => drawn[at + channel] === bare[at + channel]) && bare[at + 2] < 100,
  );
}

function brightness(pixels: Uint8Array, at: readonly number[]): number {
  return at.reduce((sum, first) => sum + Math.max(...pixels.subarray(first, first + 3)), 0) / at.length;
}
