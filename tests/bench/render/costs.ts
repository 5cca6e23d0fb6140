/** costs.*: frames of a three.js scene with smoke over the same frame with 2,000 puffs at pixel ratio 1, in turns. */
import { HalfFloatType, MeshStandardMaterial } from 'three';
import { EffectComposer } from 'three/examples/jsm/postprocessing/EffectComposer.js';
import { OutputPass } from 'three/examples/jsm/postprocessing/OutputPass.js';
import { RenderPass } from 'three/examples/jsm/postprocessing/RenderPass.js';
import {
  BrightnessContrastEffect,
  EffectComposer as PmndrsComposer,
  EffectPass,
  RenderPass as PmndrsRenderPass,
} from 'postprocessing';
import { BASE, CASES, type CostCase } from '../../../src/demo/costs/cases.ts';
import { CostScene, type CostSmoke } from '../../../src/demo/costs/costScene.ts';
import { rendererName } from '../../../src/demo/costs/gpuClock.ts';
import { demand, figure, say, time, type Figure } from '../support/figures.ts';
import { HEIGHT, WIDTH } from './bench.ts';

const ROUNDS = 5;
/** Frames of a round. A software renderer takes a good part of a second for each. */
const FRAMES = 1;

interface Measured extends CostCase {
  readonly isWithoutSmoke?: boolean;
  readonly composer?: (host: CostScene) => Composer;
}
interface Composer {
  render(): void;
  dispose(): void;
}

const { puffs } = BASE;
/** Besides those that everybody can measure. */
const MORE: readonly Measured[] = [
  { name: 'the scene without smoke', puffs, isWithoutSmoke: true },
  { name: '`EffectComposer` of three.js', puffs, composer: byThree },
  { name: '`EffectComposer` of three.js, without smoke', puffs, composer: byThree, isWithoutSmoke: true },
  { name: '`EffectComposer` of pmndrs', puffs, composer: byPmndrs },
  { name: '`EffectComposer` of pmndrs, without smoke', puffs, composer: byPmndrs, isWithoutSmoke: true },
  { name: '`style.simplify=4`', puffs, values: { 'style.simplify': 4 } },
  { name: '`style.form=1`', puffs, values: { 'style.form': 1 } },
  { name: '`style.pattern=dots`', puffs, values: { 'style.pattern': 'dots' } },
  { name: '`style.tones=3`', puffs, values: { 'style.tones': 3 } },
  { name: '`style.shadows=0`', puffs, values: { 'style.shadows': 0 } },
  { name: '`style.outlines=0`', puffs, values: { 'style.outlines': 0 } },
];

export async function measure(isQuick: boolean): Promise<Figure[]> {
  const paint = (color: string) => new MeshStandardMaterial({ color });
  const host = new CostScene(new OffscreenCanvas(WIDTH, HEIGHT), WIDTH, HEIGHT, paint);
  const base = await host.create(BASE);
  const figures: Figure[] = [];
  const all: number[] = [];
  for (const each of [...CASES, ...MORE] as readonly Measured[]) {
    const { figure: ratio, milliseconds } = await compare(host, base, each, isQuick ? 3 : ROUNDS);
    figures.push(ratio);
    all.push(...milliseconds);
  }
  const renderer = rendererName(host.renderer.getContext() as WebGL2RenderingContext);
  host.dispose();
  return [figure(`costs.${BASE.name}`, 'ms', all, `a step and a frame, ${WIDTH} x ${HEIGHT}; ${renderer}`), ...figures];
}

/** Frames of a case over those of the base, and the milliseconds of these. */
async function compare(host: CostScene, base: CostSmoke, given: Measured, rounds: number) {
  const own = given.isWithoutSmoke ? undefined : await host.create(given);
  const composer = given.composer?.(host);
  const measureFrames = (smoke: CostSmoke | undefined, draw?: () => void) => {
    if (host.show(smoke)) host.frame(draw);
    host.finish();
    const milliseconds = time(() => {
      for (let frame = 0; frame < FRAMES; frame++) host.frame(draw);
      host.finish();
    });
    return milliseconds / FRAMES;
  };
  const draw = composer && (() => composer.render());
  // A composer has more to load.
  measureFrames(own, draw);
  await own?.smoke.complete();
  const [theirs, ours]: number[][] = [[], []];
  for (let round = 0; round < rounds; round++) {
    await say(`${given.name}, round ${round + 1} of ${rounds}`);
    const runs = [() => ours.push(measureFrames(base)), () => theirs.push(measureFrames(own, draw))];
    for (const run of round % 2 === 0 ? runs : runs.toReversed()) run();
  }
  host.check(base);
  if (own) host.check(own);
  if (own && given.puffs === puffs) {
    const [bodies, ofBase] = [own, base].map(({ smoke }) => smoke.stats.alive);
    demand(Math.abs(bodies / ofBase - 1) < 0.01, `${given.name}: ${bodies} and ${ofBase} puffs`);
  }
  const note = own ? `${own.smoke.stats.bodiesDrawn} bodies, ${own.smoke.stats.castersDrawn} casters` : 'no smoke';
  composer?.dispose();
  if (own) host.remove(own.smoke);
  const ratios = theirs.map((milliseconds, round) => milliseconds / ours[round]);
  return { figure: figure(`costs.${given.name}`, 'x', ratios, note), milliseconds: ours };
}

function byThree({ renderer, scene, camera }: CostScene): Composer {
  const composer = new EffectComposer(renderer);
  for (const pass of [new RenderPass(scene, camera), new OutputPass()]) composer.addPass(pass);
  return composer;
}

function byPmndrs({ renderer, scene, camera }: CostScene): Composer {
  const composer = new PmndrsComposer(renderer, { frameBufferType: HalfFloatType });
  composer.setSize(WIDTH, HEIGHT, false);
  composer.addPass(new PmndrsRenderPass(scene, camera));
  composer.addPass(new EffectPass(camera, new BrightnessContrastEffect({ brightness: 0, contrast: 0 })));
  return {
    render() {
      const { autoClear } = renderer;
      // Its passes clear.
      renderer.autoClear = false;
      composer.render(0);
      renderer.autoClear = autoClear;
    },
    dispose: () => composer.dispose(),
  };
}
