/**
 * render.look: a frame of a preset as the page draws it, compared with blended quads of three.quarks and with the same frame
 * in the plain look, in turns. render.lights and render.patterns: a frame with lights besides the key light, and with the marks
 * of a print, over that without.
 */
import { Matrix4, Vector3, type PerspectiveCamera } from 'three';
import { fetchExtras } from '../../../src/renderer/extraPasses.ts';
import type { AdditionalLight } from '../../../src/renderer/light.ts';
import { PLAIN_LOOK } from '../../support/plainLook.ts';
import { SceneLab, type SceneChoice } from '../../visual/sceneLab.ts';
import { demand, figure, say, timeDrawing, type Figure } from '../support/figures.ts';
import { QuarksScene } from './quarks.ts';

export const PRESETS = ['lamp', 'train', 'cloudscape', 'airplane', 'wisp'];
const SIZES = [
  { width: 1280, height: 720, suffix: '' },
  { width: 1920, height: 1080, suffix: '.hd' },
];
const STEPS = 360;
const LIT_PRESETS = ['lamp', 'cloudscape', 'campfire'];
const PRINTED_PRESETS = ['rocket-newsprint', 'lamp-engraving', 'airplane-manga', 'cloudscape-riso', 'wisp-charcoal'];
/** A lantern, a moon and a lamp behind the smoke. */
const LIGHTS: readonly AdditionalLight[] = [
  { light: { kind: 'lamp', place: new Vector3(1.5, 0.5, 1.5), falloff: { decay: 2 } }, color: [2, 0.8, 0.2] },
  { light: { kind: 'sun', towards: new Vector3(-0.8, 0.6, 0) }, color: [0.1, 0.2, 0.6] },
  { light: { kind: 'lamp', place: new Vector3(-0.5, 2.5, -1.5), falloff: { decay: 2 } }, color: [0.3, 1, 0.5] },
];

/** Returns the milliseconds of the draw calls of `draw`. */
export type DrawClock = (gl: WebGL2RenderingContext, draw: () => void) => number | Promise<number>;

interface Picture {
  /** Of the figures. */
  name: string;
  preset: string;
  width: number;
  height: number;
  /** In the note of the time of a frame. */
  renderer: string;
}

export async function measureLooks(quick: boolean): Promise<Figure[]> {
  const figures: Figure[] = [];
  for (const { width, height, suffix } of SIZES) {
    for (const preset of PRESETS) {
      const picture = { name: `render.look.${preset}${suffix}`, preset, width, height };
      figures.push(
        ...(await measureLook({ ...picture, renderer: 'SwiftShader, information' }, quick ? 3 : 7, timeDrawing)),
      );
    }
  }
  return figures;
}

/** The frame of a preset over the same in the plain look and over blended quads, in turns. */
export async function measureLook(
  { name, preset, width, height, renderer: graphics }: Picture,
  rounds: number,
  clock: DrawClock,
): Promise<Figure[]> {
  const choice = { width, height, smoothEdges: true, ownLook: true };
  const [own, plain] = [await prepared(preset, choice), await prepared(preset, { ...choice, values: PLAIN_LOOK })];
  own.redraw({ cull: false });
  const quarks = new QuarksScene(own.passes.bodies.places.slice(), own.scene.surfaces, transformsOf(own));
  const camera: PerspectiveCamera = own.camera();
  const { renderer } = own.passes;
  const sides = [() => own.redraw(), () => plain.redraw(), () => quarks.draw(renderer, camera)];
  for (const draw of sides) draw();
  const [bodies, plainBodies] = [own, plain].map(({ report }) => report!.bodiesDrawn);
  demand(bodies > 20 && quarks.alive >= bodies, `${bodies} bodies, ${quarks.alive} quads`);
  demand(
    own.simulator.alive === plain.simulator.alive,
    `${own.simulator.alive} and ${plain.simulator.alive} particles`,
  );
  const times: number[][] = [[], [], []];
  for (let round = 0; round < rounds; round++) {
    await say(`${name}, round ${round + 1} of ${rounds}`);
    const order = round % 2 === 0 ? [0, 1, 2] : [2, 1, 0];
    for (const side of order) times[side].push(await clock(own.context, sides[side]));
  }
  quarks.dispose();
  for (const lab of [own, plain]) lab.dispose();
  const [look, without, quads] = times;
  const over = (others: readonly number[]) => look.map((milliseconds, round) => milliseconds / others[round]);
  const size = `${width} x ${height}`;
  return [
    figure(name, 'x', over(quads), `the frame / ${quarks.alive} blended quads of the same places and sizes, ${size}`),
    figure(
      `${name}.plain`,
      'x',
      over(without),
      `the frame / the plain look, ${bodies} and ${plainBodies} bodies, ${size}`,
    ),
    figure(`${name}.ms`, 'ms', look, `the frame, ${size}; ${graphics}`),
  ];
}

/** The frame of presets with one and with three lights besides the key light over that without. */
export async function measureLights(quick: boolean): Promise<Figure[]> {
  const figures: Figure[] = [];
  for (const preset of LIT_PRESETS) {
    const name = `render.lights.${preset}`;
    const choices = [0, 1, LIGHTS.length].map((count) => ({ lights: LIGHTS.slice(0, count) }));
    const { ratios, size } = await measureRatios(name, preset, choices, quick);
    const note = `the frame / that without further lights, ${size}`;
    figures.push(figure(`${name}.1`, 'x', ratios[1], note), figure(`${name}.3`, 'x', ratios[2], note));
  }
  return figures;
}

/** The frame of presets with the marks of a print over that without. */
export async function measurePatterns(quick: boolean): Promise<Figure[]> {
  const figures: Figure[] = [];
  for (const preset of PRINTED_PRESETS) {
    const name = `render.patterns.${preset}`;
    const choices: Partial<SceneChoice>[] = [{ values: { 'style.pattern': 'none' } }, {}];
    const { ratios, size } = await measureRatios(name, preset, choices, quick);
    figures.push(figure(name, 'x', ratios[1], `the frame / that without marks, ${size}; at most 1.1`));
  }
  return figures;
}

/** Frames of a preset over that of the first choice, in turns. */
async function measureRatios(
  name: string,
  preset: string,
  choices: readonly Partial<SceneChoice>[],
  quick: boolean,
): Promise<{ ratios: number[][]; size: string }> {
  const [{ width, height }] = SIZES;
  const labs: SceneLab[] = [];
  for (const choice of choices) {
    labs.push(await prepared(preset, { width, height, smoothEdges: true, ownLook: true, ...choice }));
  }
  for (const lab of labs) lab.redraw();
  const bodies = labs.map(({ report }) => report!.bodiesDrawn);
  demand(bodies[0] > 20 && new Set(bodies).size === 1, `${bodies.join()} bodies`);
  const times: number[][] = labs.map(() => []);
  const rounds = quick ? 3 : 9;
  for (let round = 0; round < rounds; round++) {
    await say(`${name}, round ${round + 1} of ${rounds}`);
    const order = round % 2 === 0 ? labs : labs.toReversed();
    for (const lab of order) times[labs.indexOf(lab)].push(timeDrawing(lab.context, () => lab.redraw()));
  }
  for (const lab of labs) lab.dispose();
  const ratios = times.map((own) => own.map((milliseconds, round) => milliseconds / times[0][round]));
  return { ratios, size: `${bodies[0]} bodies, ${width} x ${height}` };
}

async function prepared(preset: string, choice: SceneChoice): Promise<SceneLab> {
  const lab = await SceneLab.create(preset, choice);
  await fetchExtras({ ...lab.style, isTiled: true });
  lab.step(STEPS);
  return lab;
}

/** Where the surfaces of the scene are. */
function transformsOf(lab: SceneLab): Matrix4[] {
  const { rigids, parts } = lab.frame();
  return lab.scene.surfaces.map(({ rigid, part }) => {
    if (part !== undefined) return parts![part];
    return rigid === undefined ? new Matrix4() : rigids[rigid];
  });
}
