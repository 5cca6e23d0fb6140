/** Whole scenes, picture by picture: nothing may pop as time goes by, nor jump while the camera goes round. */
import { readParticles } from '../../bench/support/snapshot.ts';
import { suddenChange } from '../motion.ts';
import { SceneLab } from '../sceneLab.ts';

const SIZE = { width: 200, height: 200 };
/** Nearer to the eye than this nothing of a scene comes, as a share of the camera's distance. */
const NEAREST = 0.6;
/** Pixels on top of the motion: a pixel's own width, and what rounding adds. */
const SLACK = 2;

export interface Steadiness {
  /** Pixels of the largest area that appears or goes from one picture to the next, and the picture in which. */
  largest: number;
  at: number;
  /** Most pixels of all such areas of one picture. */
  all: number;
  /** Greatest motion that was allowed for, pixels. */
  motion: number;
  pictures: number;
  /** Fewest bodies in a picture. */
  bodies: number;
}

/** Pictures of successive steps. */
export async function timePassing(scene: string, fromStep: number, steps: number): Promise<Steadiness> {
  const lab = await SceneLab.create(scene, SIZE);
  lab.step(fromStep);
  const report = await watch(lab, steps, () => {
    lab.step(1);
    return { camera: lab.camera(), motion: fastest(lab) * lab.pixelsPerMetre(NEAREST * lab.scene.camera.distance) };
  });
  lab.dispose();
  return report;
}

/** Pictures a degree apart, with time stopped. */
export async function orbiting(scene: string, atStep: number, degrees: number): Promise<Steadiness> {
  const lab = await SceneLab.create(scene, SIZE);
  lab.step(atStep);
  const { azimuth, distance } = lab.scene.camera;
  const step = Math.PI / 180;
  const report = await watch(lab, degrees, (degree) => ({
    camera: lab.camera({ azimuth: azimuth + degree * step }),
    motion: (1 - NEAREST) * distance * step * lab.pixelsPerMetre(NEAREST * distance),
  }));
  lab.dispose();
  return report;
}

type Next = (picture: number) => { camera: ReturnType<SceneLab['camera']>; motion: number };

async function watch(lab: SceneLab, pictures: number, next: Next): Promise<Steadiness> {
  const report: Steadiness = { largest: 0, at: 0, all: 0, motion: 0, pictures, bodies: Infinity };
  let before = lab.draw();
  for (let picture = 1; picture <= pictures; picture++) {
    const { camera, motion } = next(picture);
    const now = lab.draw({ camera });
    const { all, largest } = suddenChange(before, now, Math.ceil(motion) + SLACK);
    if (largest > report.largest) Object.assign(report, { largest, at: picture });
    report.all = Math.max(report.all, all);
    report.motion = Math.max(report.motion, motion);
    report.bodies = Math.min(report.bodies, lab.report!.bodiesDrawn);
    before = now;
  }
  return report;
}

/** Metres that the fastest particle moves in a step. */
function fastest({ simulator }: SceneLab): number {
  const { x, y, z, px, py, pz } = readParticles(simulator);
  return x.reduce((most, _, i) => Math.max(most, Math.hypot(x[i] - px[i], y[i] - py[i], z[i] - pz[i])), 0);
}
