/** The paper's four effects, each on or off: sixteen pictures of one heap of smoke above the ground. */
import type { Gradient } from '../../../src/renderer/passes/bodies.ts';
import { colorAt, type Color } from '../../../src/renderer/gpu/ramps.ts';
import { rampOf, surfaceToning } from '../../../src/renderer/palette.ts';
import type { Style } from '../../../src/renderer/style.ts';
import { base64, Lab, PLAIN_STYLE, upright, type LabPuff, type LabScene } from '../lab.ts';
import { random } from '../random.ts';
import { ground } from '../solids.ts';

const EFFECTS = ['shading', 'shadows', 'outlines', 'gradient'] as const;
const SKY: Color = [96, 128, 176];
const GROUND = ground(-0.8, 6);
const AGES = [0, 1 / 3, 2 / 3];
const SUN = [0.5, 0.8, 0.33] as const;

/** The enabled effects, as bits in the order of `EFFECTS`. */
export const COMBINATIONS = Array.from({ length: 16 }, (_, bits) => bits);

export function labelOf(bits: number): string {
  const on = EFFECTS.filter((_, effect) => isOn(bits, effect));
  return on.length === 0 ? 'none' : on.join(', ');
}

/** Pixels by colour `r,g,b` for each combination, and the expected colours, each within `slack`. */
export function colorsOf(): { label: string; found: Record<string, number>; expected: Color[]; slack: number }[] {
  const scene = sceneOf(200, 150);
  const lab = new Lab(scene);
  const reports = COMBINATIONS.map((bits) => {
    const style = styleOf(bits, 'age');
    const { pixels } = lab.draw({ ...scene, style });
    // The factor and the target each round a colour once.
    return {
      label: labelOf(bits),
      found: countColors(pixels),
      expected: expectedOf(style),
      slack: isOn(bits, 3) ? 1 : 0,
    };
  });
  lab.dispose();
  return reports;
}

/** All combinations as one PNG, four by four with labels, in base64. */
export async function sheet(): Promise<string> {
  const [width, height, bar] = [320, 240, 22];
  const scene = sceneOf(width, height);
  const lab = new Lab(scene);
  const canvas = new OffscreenCanvas(4 * width, 4 * (height + bar));
  const context = canvas.getContext('2d')!;
  context.font = '14px sans-serif';
  for (const bits of COMBINATIONS) {
    const [left, top] = [(bits % 4) * width, Math.floor(bits / 4) * (height + bar)];
    const { pixels } = lab.draw({ ...scene, style: styleOf(bits, 'height'), smoothEdges: true });
    context.putImageData(upright(pixels, width, height), left, top);
    context.fillStyle = '#fffdf6';
    context.fillRect(left, top + height, width, bar);
    context.fillStyle = '#1d1720';
    context.fillText(labelOf(bits), left + 6, top + height + 16);
  }
  lab.dispose();
  return base64(await canvas.convertToBlob({ type: 'image/png' }));
}

function isOn(bits: number, effect: number): boolean {
  return (bits & (1 << effect)) !== 0;
}

function styleOf(bits: number, gradient: Gradient): Style {
  return {
    ...PLAIN_STYLE,
    shading: isOn(bits, 0),
    shadows: isOn(bits, 1),
    outlines: isOn(bits, 2),
    gradient: isOn(bits, 3) ? gradient : 'none',
    gradientColor: [226, 120, 96],
    innerLine: 0.3,
  };
}

function sceneOf(width: number, height: number): LabScene {
  return { width, height, puffs: heap(), surfaces: [GROUND], backdrop: { top: SKY, bottom: SKY }, towardsLight: SUN };
}

/** Puffs of three ages around a vertical axis, larger below. */
function heap(): LabPuff[] {
  const next = random(13);
  return Array.from({ length: 48 }, (_, index) => {
    const [angle, away, up] = [2.4 * index, 0.75 * Math.sqrt(next()), next()];
    return {
      place: [away * (1.2 - up) * Math.cos(angle), 1.7 * up - 0.7, away * (1.2 - up) * Math.sin(angle)],
      radius: 0.34 - 0.16 * up + 0.08 * next(),
      roll: 6.28 * next(),
      variation: index % 4,
      seed: Math.floor(256 * next()),
      age: AGES[index % AGES.length],
    };
  });
}

/** Sky; ground, lit and in shadow; ink; and each tone of the smoke at each age. */
function expectedOf(style: Style): Color[] {
  const facing = SUN[1] / Math.hypot(...SUN);
  const floor = rampOf(GROUND.color, surfaceToning(style));
  const smoke = rampOf(style.smokeColor, style);
  const tones = [...smoke.lit, ...(style.shadows ? smoke.unlit : [])].map(({ color }) => color);
  const filled =
    style.gradient === 'none' ? tones : AGES.flatMap((age) => tones.map((tone) => faded(tone, age, style)));
  const colors = [SKY, colorAt(floor.lit, facing), ...filled];
  if (style.shadows) colors.push(colorAt(floor.unlit, facing));
  if (style.outlines) colors.push(style.inkColor);
  return [...new Map(colors.map((color) => [color.join(), color])).values()];
}

/** Gradient fills multiply tones: from the smoke's own colour at birth to the second colour at the end of life. */
function faded(tone: Color, age: number, { gradientColor, smokeColor }: Style): Color {
  const channel = (index: 0 | 1 | 2) =>
    Math.round(tone[index] * (1 + age * (gradientColor[index] / smokeColor[index] - 1)));
  return [channel(0), channel(1), channel(2)];
}

function countColors(pixels: Uint8Array): Record<string, number> {
  const counts: Record<string, number> = {};
  for (let at = 0; at < pixels.length; at += 4) {
    const key = pixels.subarray(at, at + 3).join();
    counts[key] = (counts[key] ?? 0) + 1;
  }
  return counts;
}
