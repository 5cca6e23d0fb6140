/**
 * collide.vsCompat: one query per particle through Rapier's JavaScript bindings, divided by the time of our collisions.
 */
import { loadSimulators } from '../../../../src/simulator/load.ts';
import type { Simulator } from '../../../../src/simulator/simulator.ts';
import { EVERYTHING } from '../../../support/sim/everything.ts';
import { demand, figure, say, time, type Figure } from '../../support/figures.ts';
import { readParticles, withParticles } from '../../support/snapshot.ts';
import { SIX_FORCES } from '../cloud.ts';
import { CompatWorld } from './compat.ts';
import { poseAt, RIGIDS, seededSmoke, seededSwings } from './obstacles.ts';

const COUNT = 10_000;
const STEP = 1 / 60;
const WARMING_STEPS = 30;
/** Consecutive steps, as the bindings run query after query: each side finds its caches warm. */
const CHUNK = 5;
/** Largest relative motion of a particle and a rigid within a step, metres. Only our collisions handle it. */
const WAY = 0.06;
/** Largest difference between the two positions of a rigid, metres. */
const POSE_TOLERANCE = 1e-4;

/** Moving smoke flows around the rigids: the same forces as in sim.vsQuarks, with a smaller vortex. */
const FORCES = { ...SIX_FORCES, 'vortices.0.circulation': 2, 'vortices.0.reach': 4 };

interface Round {
  /** Milliseconds of the fastest step: all steps do the same work, and other processes only make them slower. */
  withRigids: number;
  without: number;
  compat: number;
}

/** The same smoke with and without rigids, and the rigids in the bindings' own world. */
class Contest {
  readonly swings = seededSwings(11);
  readonly compat: CompatWorld;
  readonly withRigids: Simulator;
  readonly without: Simulator;
  private readonly start: Uint8Array;
  private readonly startWithout: Uint8Array;
  private seconds = 0;

  private constructor(compat: CompatWorld, withRigids: Simulator, without: Simulator) {
    this.compat = compat;
    this.withRigids = withRigids;
    this.without = without;
    const smoke = seededSmoke(COUNT, 5);
    for (const simulator of [withRigids, without]) simulator.set(FORCES);
    for (const swing of this.swings) {
      withRigids.addRigid({ kind: 'kinematic', shape: swing.shape, ...poseAt(swing, 0), friction: 0.2 });
    }
    this.start = withParticles(withRigids, smoke);
    this.startWithout = withParticles(without, smoke);
  }

  static async create(): Promise<Contest> {
    const factory = await loadSimulators({ physics: true });
    const make = () => factory.create({ capacity: COUNT, seed: 7 });
    return new Contest(await CompatWorld.create(seededSwings(11), 0), make(), make());
  }

  restart(): void {
    this.withRigids.restore(this.start);
    this.without.restore(this.startWithout);
    this.compat.moveTo(0);
    this.seconds = 0;
  }

  /** Advances the rigids of both worlds, outside all timings. */
  send(): void {
    this.sendOurs();
    this.compat.moveTo(this.seconds);
  }

  private sendOurs(): void {
    this.seconds += STEP;
    this.swings.forEach((swing, index) => {
      const { position, rotation } = poseAt(swing, this.seconds);
      this.withRigids.moveRigid(index, position, rotation);
    });
  }

  round(steps: number): Round {
    const min = { withRigids: Infinity, without: Infinity };
    const minOfTenths = Array.from({ length: 10 }, () => Infinity);
    const take = (name: keyof typeof min) => {
      min[name] = Math.min(
        min[name],
        time(() => this[name].step()),
      );
    };
    for (let chunk = 0; chunk < steps / CHUNK; chunk++) {
      for (let step = 0; step < CHUNK; step++) {
        this.sendOurs();
        take('withRigids');
      }
      for (let step = 0; step < CHUNK; step++) take('without');
      this.compat.moveTo(this.seconds);
      const { place, count } = this.withRigids.arrange(EVERYTHING).rows;
      demand(count === COUNT, `${count} particles live`);
      // A run with all queries is so long that other processes always interrupt it.
      minOfTenths.forEach((cost, tenth) => {
        const rows = place.subarray((4 * tenth * count) / 10, (4 * (tenth + 1) * count) / 10);
        minOfTenths[tenth] = Math.min(
          cost,
          time(() => this.compat.projectAll(rows, count / 10)),
        );
      });
    }
    return { ...min, compat: minOfTenths.reduce((sum, cost) => sum + cost, 0) };
  }

  dispose(): void {
    for (const part of [this.withRigids, this.without, this.compat]) part.dispose();
  }
}

export async function measureAgainstCompat(quick: boolean): Promise<Figure[]> {
  const contest = await Contest.create();
  contest.restart();
  const touched = compare(contest);
  contest.round(WARMING_STEPS);
  const rounds: Round[] = [];
  const wanted = quick ? 5 : 9;
  while (rounds.length < wanted) {
    await say(`collide.vsCompat, round ${rounds.length + 1} of ${wanted}`);
    contest.restart();
    rounds.push(contest.round(quick ? 10 : 40));
  }
  contest.dispose();
  const ours = rounds.map(({ withRigids, without }) => withRigids - without);
  const compat = rounds.map((round) => round.compat);
  return [
    figure(
      'collide.vsCompat',
      'x',
      compat.map((theirs, round) => theirs / ours[round]),
      `${COUNT} particles among ${RIGIDS} moving rigids, ${touched} of them pushed in the step compared; ` +
        'each side goes on for several steps in a row; goal >= 20',
    ),
    figure('collide.ours', 'ms', ours, 'a step with rigids less one without: world step, grid, search, swept contacts'),
    figure('collide.compat', 'ms', compat, 'the queries alone, without world step and answer'),
  ];
}

/**
 * Checks one step: every particle that we push must be near a rigid in the bindings' world, and every particle that
 * overlaps one there must be pushed. The motion within the step explains the rest. Returns the number of pushed
 * particles.
 */
function compare(contest: Contest): number {
  for (let step = 0; step < 5; step++) {
    contest.send();
    contest.withRigids.step();
    // Keeps the age of its air equal, although its particles are replaced.
    contest.without.step();
  }
  const before = readParticles(contest.withRigids);
  contest.without.restore(withParticles(contest.without, before));
  contest.send();
  contest.withRigids.step();
  contest.without.step();
  comparePoses(contest);
  const after = readParticles(contest.withRigids);
  const free = readParticles(contest.without);
  let [pushed, overlapping] = [0, 0];
  for (let i = 0; i < COUNT; i++) {
    const gap = contest.compat.distance(free.x[i], free.y[i], free.z[i]) - free.size[i];
    const isPushed = after.x[i] !== free.x[i] || after.y[i] !== free.y[i] || after.z[i] !== free.z[i];
    if (isPushed) pushed++;
    if (gap < 0) overlapping++;
    demand(!isPushed || gap < WAY, `particle ${i} was pushed ${gap} m away from all rigids of the bindings`);
    demand(isPushed || gap > -0.02 * free.size[i], `particle ${i} overlaps a rigid of the bindings by ${-gap} m`);
  }
  const share = pushed / COUNT;
  demand(share > 0.01 && share < 0.5, `${pushed} particles were pushed`);
  demand(overlapping > 0.5 * pushed, `${overlapping} overlap in the bindings' world, ${pushed} were pushed`);
  return pushed;
}

function comparePoses({ withRigids, compat }: Contest): void {
  const poses = withRigids.rigidPoses(1);
  for (let index = 0; index < RIGIDS; index++) {
    const error = Math.max(...compat.placeOf(index).map((theirs, axis) => Math.abs(theirs - poses[7 * index + axis])));
    demand(error < POSE_TOLERANCE, `rigid ${index} is ${error} m off in the bindings' world`);
  }
}
