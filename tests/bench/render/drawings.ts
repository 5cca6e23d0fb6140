/**
 * render.drawings.*: bodies and frames of drawn puffs, relative to lobes with silhouettes of the same area, and the baking
 * of four drawings.
 */
import { bakedPuffs } from '../../../src/renderer/bakedPuffs.ts';
import type { Arranger } from '../../../src/renderer/frameInput.ts';
import type { BakedPuffs } from '../../../src/renderer/gpu/puffTextures.ts';
import { bakingBillboards, makingShapes } from '../../../src/renderer/billboards.ts';
import { finished, PIECE_MS } from '../../../src/base/work.ts';
import { presetValues } from '../../../src/parameters/presets.ts';
import { fetchExtras } from '../../../src/renderer/extraPasses.ts';
import type { Style } from '../../../src/renderer/style.ts';
import { PLAIN_STYLE } from '../../visual/lab.ts';
import { demand, figure, say, type Figure } from '../support/figures.ts';
import { RenderBench } from './bench.ts';

/** Their first drawings: a heart, a leaf, popcorn and a cloud. */
const PRESETS = ['wisp-hearts', 'air-leaves', 'campfire-popcorn', 'cloudscape-woodcut'] as const;

interface Side {
  style: Style;
  puffs: BakedPuffs;
  arranger: Arranger;
  /** Milliseconds per million covered fragments of the bodies. */
  bodies: number[];
  frames: number[];
  bodiesDrawn: number;
}

export async function measureDrawings(quick: boolean): Promise<Figure[]> {
  const text = PRESETS.map((name) => presetValues(name)['puff.drawing']!.split(';')[0]).join(';');
  await fetchExtras({ ...PLAIN_STYLE, form: 'billboards' });
  const bench = await RenderBench.create();
  const baking = await bakingFigures(text, quick);
  const lobes = bakedPuffs();
  const drawn = bakedPuffs(finished(makingShapes(text)));
  const scale = meanRadius(lobes) / meanRadius(drawn);
  const sides = [
    side(PLAIN_STYLE, lobes, bench.simulator),
    side({ ...PLAIN_STYLE, form: 'billboards' }, drawn, scaled(bench.simulator, scale)),
  ];
  const rounds = quick ? 5 : 11;
  const covered: number[] = [];
  for (let round = 0; round <= rounds; round++) {
    await say(`render.drawings, round ${round} of ${rounds}`);
    const order = round % 2 === 0 ? sides : sides.toReversed();
    for (const each of order) {
      Object.assign(bench, { style: each.style, arranger: each.arranger });
      bench.smoke.setPuffs(each.puffs);
      // Uploads the textures, and in the first round compiles the programs.
      each.bodiesDrawn = bench.draw(false).bodiesDrawn;
      if (round === 0) covered[sides.indexOf(each)] = bench.countFragments().bodies.kept / 1e6;
      const { bodies, frame } = bench.timeFrame(false);
      if (round === 0) continue;
      each.bodies.push(bodies / covered[sides.indexOf(each)]);
      each.frames.push(frame / covered[sides.indexOf(each)]);
    }
  }
  bench.dispose();
  const [ofLobes, ofDrawings] = sides;
  demand(ofLobes.bodiesDrawn === ofDrawings.bodiesDrawn, 'bodies of lobes and of drawings');
  const ratio = (what: 'bodies' | 'frames') => ofDrawings[what].map((value, round) => value / ofLobes[what][round]);
  const note = `drawings / lobes of the same area, per covered fragment (${covered.map((count) => count.toFixed(2)).join(' / ')} million); at most 1.2`;
  return [
    figure('render.drawings.bodies', 'x', ratio('bodies'), note),
    figure('render.drawings.frame', 'x', ratio('frames'), `whole frame with volumes, ${note}`),
    ...baking,
  ];
}

function side(style: Style, puffs: BakedPuffs, arranger: Arranger): Side {
  return { style, puffs, arranger, bodies: [], frames: [], bodiesDrawn: 0 };
}

/** Bakes different drawings in each round: the same ones would come from the cache. */
async function bakingFigures(text: string, quick: boolean): Promise<Figure[]> {
  const [totals, longest]: number[][] = [[], []];
  let slices = 0;
  for (let round = 0; round < (quick ? 3 : 5); round++) {
    await say(`render.drawings.baking, round ${round + 1}`);
    const costs = slicesOf(text.replace(/^.{6}/, `ffffe${round}`));
    slices = costs.length;
    totals.push(costs.reduce((sum, cost) => sum + cost, 0));
    longest.push(Math.max(...costs));
  }
  return [
    figure('render.drawings.baking', 'ms', totals, `four drawings, from text to billboards, in ${slices} slices`),
    figure('render.drawings.slice', 'ms', longest, `the longest slice; the first round is cold; at most ${PIECE_MS}`),
  ];
}

/** Milliseconds of each slice from text to baked billboards. */
function slicesOf(text: string): number[] {
  const costs: number[] = [];
  const work = (function* () {
    return yield* bakingBillboards(yield* makingShapes(text));
  })();
  for (;;) {
    const start = performance.now();
    const { done } = work.next();
    costs.push(performance.now() - start);
    if (done) return costs;
  }
}

/** Radius of the disc with the mean area of the silhouettes. */
function meanRadius({ billboards }: BakedPuffs): number {
  const { figures } = billboards.layers;
  return Math.sqrt(figures.reduce((sum, { silhouetteRadius }) => sum + silhouetteRadius ** 2, 0) / figures.length);
}

/** The same rows with other radii. */
function scaled(simulator: Arranger, scale: number): Arranger {
  return {
    moves: () => simulator.moves(),
    arrange(view) {
      const { rows, ...rest } = simulator.arrange(view);
      for (let row = 0; row < rows.count; row++) rows.place[4 * row + 3] *= scale;
      return { rows, ...rest };
    },
  };
}
