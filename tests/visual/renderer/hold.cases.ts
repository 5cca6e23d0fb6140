/** Smoke on ones to fours beside a ball that moves in every step: the steps in which each of them changes. */
import { SceneLab } from '../sceneLab.ts';
import type { Values } from '../../../src/parameters/parameter.ts';

const SIZE = 160;
const BALL = 0;
/** Share of the picture's width: the ball is to the right of it, the smoke to the left. */
const BORDER = 0.72;
/** At this step the puffs have left the spout and are far from the end of their lifetime. */
const FIRST_STEP = 60;

export interface HoldReport {
  /** Steps, from 0, in which the smoke or its ink differs from the previous step. */
  smoke: number[];
  ball: number[];
}

/** @param hold how long puffs keep a drawing, in 24ths of a second */
export async function changes(hold: number, puffs: number, steps: number): Promise<HoldReport> {
  const values: Values = { 'style.hold': hold, 'style.shadows': 0, 'simulation.maxParticles': puffs };
  const lab = await SceneLab.create('lamp', { width: SIZE, height: SIZE, values });
  lab.step(FIRST_STEP);
  const report: HoldReport = { smoke: [], ball: [] };
  let before = sides(lab, 0);
  for (let step = 0; step < steps; step++) {
    lab.step(1);
    const now = sides(lab, step + 1);
    if (now.smoke !== before.smoke) report.smoke.push(step);
    if (now.ball !== before.ball) report.ball.push(step);
    before = now;
  }
  lab.dispose();
  return report;
}

/** The two parts of the picture as strings, for comparison. */
function sides(lab: SceneLab, step: number): { smoke: string; ball: string } {
  lab.simulator.moveRigid(BALL, [1.6, 1 + 0.03 * step, 0]);
  const pixels = new Uint32Array(lab.draw().pixels.buffer);
  const isLeft = (at: number): boolean => at % SIZE < BORDER * SIZE;
  return { smoke: pixels.filter((_, at) => isLeft(at)).join(), ball: pixels.filter((_, at) => !isLeft(at)).join() };
}
