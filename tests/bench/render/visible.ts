/**
 * Cost relative to visible content: bodies and casters that remain from seeded plumes of 1,000 to 100,000 and the time
 * of `arrange` for them, and frames of plumes and of a dense column.
 */
import { demand, figure, say, type Figure } from '../support/figures.ts';
import { HEIGHT, RenderBench, WIDTH } from './bench.ts';
import { saturatedColumn, seededPlume } from './plume.ts';

/** Numbers of particles for `arrange` alone, without drawing. */
const ARRANGED = [1_000, 3_000, 10_000, 30_000, 100_000];
/** Numbers of particles for the comparison of time per drawn body and caster. */
const COMPARED = [5_000, 10_000, 20_000, 50_000];
const COLUMN = [5_000, 20_000];

/** Times and drawn rows of one smoke's frames. */
interface Frames {
  frame: number[];
  arrange: number[];
  bodies: number;
  casters: number;
}

export async function measureVisible(quick: boolean): Promise<Figure[]> {
  const rounds = quick ? 3 : 5;
  const compared = quick ? COMPARED.filter((count) => count <= 10_000) : COMPARED;
  const kept = await drawnShareOfPlumes(rounds);
  const plumes = await framesOf('plume', compared, rounds, seededPlume);
  const column = await framesOf('column', COLUMN, rounds, saturatedColumn);
  return [
    ...kept,
    ...[...plumes].flatMap(([count, frames]) => frameFigures(`plume.${count}`, frames)),
    ...[...column].flatMap(([count, frames]) => frameFigures(`column.${count}`, frames)),
    arrangeFigure(plumes.get(10_000)!),
    perDrawnFigure([...plumes.values()]),
    growthFigure(column.get(COLUMN[0])!, column.get(COLUMN[1])!),
  ];
}

async function drawnShareOfPlumes(rounds: number): Promise<Figure[]> {
  await say(`render, what stays of plumes of ${ARRANGED.join(', ')}`);
  const figures: Figure[] = [];
  for (const count of ARRANGED) {
    const bench = await RenderBench.create(1, count);
    // The first call warms up code and memory.
    const reports = Array.from({ length: 1 + rounds }, () => bench.arrange(true)).slice(1);
    const [{ bodiesDrawn, castersDrawn }] = reports;
    const times = reports.map(({ arrangeMs }) => arrangeMs);
    figures.push(
      figure(`render.bodies.of.${count}`, '', [bodiesDrawn], `stay of a plume, ${WIDTH} x ${HEIGHT}`),
      figure(`render.casters.of.${count}`, '', [castersDrawn], 'stay of the same plume'),
      figure(`render.arrange.of.${count}`, 'ms', times, 'for eye and light; information'),
    );
    bench.dispose();
  }
  return figures;
}

/** Draws the smokes of all counts in turns, so that load on the machine affects all alike. */
async function framesOf(
  name: string,
  counts: readonly number[],
  rounds: number,
  smoke: typeof seededPlume,
): Promise<Map<number, Frames>> {
  const sides = new Map<number, { bench: RenderBench; frames: Frames }>();
  for (const count of counts) {
    const bench = await RenderBench.create(1, count, smoke);
    const { bodiesDrawn, castersDrawn } = bench.draw(true);
    demand(
      bodiesDrawn > 100 && castersDrawn > 100,
      `${bodiesDrawn} bodies and ${castersDrawn} casters of ${count} stay`,
    );
    sides.set(count, { bench, frames: { frame: [], arrange: [], bodies: bodiesDrawn, casters: castersDrawn } });
  }
  for (let round = 0; round < rounds; round++) {
    await say(`render, ${name}s of ${counts.join(', ')}, round ${round + 1} of ${rounds}`);
    for (const { bench, frames } of sides.values()) {
      frames.frame.push(bench.timeDrawing(() => frames.arrange.push(bench.draw(true).arrangeMs)));
    }
  }
  for (const { bench } of sides.values()) bench.dispose();
  return new Map([...sides].map(([count, { frames }]) => [count, frames]));
}

function frameFigures(name: string, { bodies, casters, frame }: Frames): Figure[] {
  const note = `${bodies} bodies and ${casters} casters stay; SwiftShader, information`;
  return [figure(`render.frame.${name}`, 'ms', frame, note)];
}

function arrangeFigure({ arrange, frame }: Frames): Figure {
  const shares = arrange.map((milliseconds, round) => milliseconds / frame[round]);
  return figure('render.arrange', 'x', shares, 'arrange for eye and light / frame, plume of 10,000; goal <= 0.15');
}

/** The ratio of the highest to the lowest time per drawn body and caster, minus 1, by round. */
function perDrawnFigure(plumes: readonly Frames[]): Figure {
  const spread = plumes[0].frame.map((_, round) => {
    const each = plumes.map(({ frame, bodies, casters }) => frame[round] / (bodies + casters));
    return Math.max(...each) / Math.min(...each) - 1;
  });
  const note = 'frame time for each body and caster drawn, plumes of 5,000 to 50,000: most / least - 1; goal <= 0.2';
  return figure('render.perDrawn', 'x', spread, note);
}

function growthFigure(few: Frames, many: Frames): Figure {
  return figure(
    'render.growth',
    'x',
    many.frame.map((milliseconds, round) => milliseconds / few.frame[round]),
    'frame of a saturated column of 20,000 / of 5,000; goal <= 1.5',
  );
}
