/** Pictures of static smoke while the camera orbits it: nothing jumps. */
import { PerspectiveCamera } from 'three';
import { Lab, type LabPuff, type LabScene } from '../../lab.ts';
import { suddenChange } from '../../motion.ts';
import { random } from '../../random.ts';

const SIZE = 160;
const DISTANCE = 4;
const RADIUS = 0.8;

/** Changes between two pictures, one degree apart, that motion alone does not explain. */
export interface OrbitReport {
  /** Largest number of such pixels in one step, and the degree of that step. */
  largest: number;
  at: number;
  /** Smallest number of pixels that smoke covers in a picture. */
  painted: number;
  /** Largest motion of a point of the smoke in a step, pixels. */
  motion: number;
}

export function orbit(what: 'puff' | 'cluster', steps: number): OrbitReport {
  const puffs = what === 'puff' ? [PUFF] : cluster();
  const scene: LabScene = { width: SIZE, height: SIZE, puffs, towardsLight: [0.5, 0.8, 0.6] };
  const lab = new Lab(scene);
  const report = { largest: 0, at: 0, painted: Infinity, motion: motionOf(puffs) };
  let before = lab.draw({ ...scene, camera: cameraAt(0) });
  for (let degree = 1; degree <= steps; degree++) {
    const now = lab.draw({ ...scene, camera: cameraAt(degree) });
    const reach = Math.ceil(report.motion) + 1;
    const sudden = suddenChange(before, now, { reach }).all;
    if (sudden > report.largest) Object.assign(report, { largest: sudden, at: degree });
    report.painted = Math.min(report.painted, now.pixels.filter((value, i) => i % 4 === 3 && value > 0).length);
    before = now;
  }
  lab.dispose();
  return report;
}

const PUFF: LabPuff = { place: [0, 0, 0], radius: RADIUS, variation: 1, seed: 90, roll: 2 };

function cluster(): LabPuff[] {
  const next = random(31);
  return Array.from({ length: 9 }, (_, index) => ({
    place: [next() - 0.5, 0.9 * (next() - 0.5), next() - 0.5],
    radius: 0.25 + 0.25 * next(),
    variation: index % 4,
    seed: Math.floor(256 * next()),
    roll: 6.28 * next(),
  }));
}

function cameraAt(degree: number): PerspectiveCamera {
  const camera = new PerspectiveCamera(32, 1, 0.1, 50);
  const azimuth = (degree * Math.PI) / 180;
  camera.position.set(DISTANCE * Math.sin(azimuth), 1, DISTANCE * Math.cos(azimuth));
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  return camera;
}

/** Motion of a point at the far side of the smoke when the camera orbits by one degree, pixels. */
function motionOf(puffs: readonly LabPuff[]): number {
  const reach = Math.max(...puffs.map(({ place, radius }) => Math.hypot(...place) + radius));
  const pixelsPerMetre = SIZE / 2 / Math.tan((16 * Math.PI) / 180) / (DISTANCE - reach);
  return ((reach * Math.PI) / 180) * pixelsPerMetre;
}
