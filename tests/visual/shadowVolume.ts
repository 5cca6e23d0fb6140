/**
 * The shadow volume of a puff, by its definition and in double precision: of all that its lobes hide from the light, what
 * lies behind the start; along each view ray without gaps, from the first entry to the last exit.
 */
import { type Camera, Matrix4, PerspectiveCamera, type Ray, Vector3 } from 'three';
import { bakedPuffs } from '../../src/smoke/bakedPuffs.ts';
import type { PuffForm } from '../../src/device/puffTextures.ts';
import type { StartCaps } from '../../src/puffs/startCaps.ts';
import { spherePoint } from '../../src/puffs/vector.ts';
import type { LabPuff } from './lab.ts';

/** The margin of the definition: see volumes.vert. */
const CAP_SLACK = 0.02;

export interface View {
  camera: Camera;
  /** Unit vector; absent where a lamp stands in the scene. */
  towardsLight?: Vector3;
  lamp?: Vector3;
  reversedDepth?: boolean;
}

/** Unit vector from a place towards the light of a view. */
export function towardsLightOf({ towardsLight, lamp }: View, place: Vector3): Vector3 {
  return (lamp ? lamp.clone().sub(place) : towardsLight!.clone()).normalize();
}

/** Discs on the plane through the centre across the light, each with the rays that pass through it. */
export interface Volume {
  centre: Vector3;
  /** Unit vector. */
  axis: Vector3;
  /** Metres from the centre to the start. */
  cap: number;
  /** One over the distance of a lamp; 0 under a sun. */
  growth: number;
  discs: { centre: Vector3; radius: number }[];
}

export function volumeOf(form: PuffForm, caster: LabPuff, view: View): Volume {
  const centre = new Vector3(...caster.place);
  const axis = towardsLightOf(view, centre).negate();
  const puff = form === 'lobes' ? standing(caster, view) : facing(caster, view);
  const growth = view.lamp ? 1 / view.lamp.distanceTo(centre) : 0;
  const volume = { centre, axis, cap: (puff.cap + CAP_SLACK) * caster.radius, growth };
  return { ...volume, discs: discsOf(puff, caster, volume) };
}

/** A puff in the world: its lobes about its centre, in radii, and where its volume starts before the slack. */
interface StandingPuff {
  lobes: { center: Vector3; radius: number }[];
  cap: number;
}

function discsOf(puff: StandingPuff, { radius }: LabPuff, { axis, growth }: Omit<Volume, 'discs'>): Volume['discs'] {
  const discs = puff.lobes.map((lobe) => {
    const along = lobe.center.dot(axis);
    const nearness = radius / (1 + growth * radius * along);
    const seen = lobe.center.clone().addScaledVector(axis, -along).multiplyScalar(nearness);
    // The cone that touches the lobe.
    const half = Math.asin(Math.min(1, lobe.radius * nearness * growth));
    return { centre: seen, radius: growth > 0 ? Math.tan(half) / growth : lobe.radius * nearness };
  });
  // A lamp within the puff throws no shadow of it.
  const widest = Math.max(...discs.map((disc) => disc.centre.length() + disc.radius));
  return growth * widest < 1 ? discs : [];
}

function facing({ place, roll = 0, variation = 0 }: LabPuff, view: View): StandingPuff {
  const { startCaps, casters } = bakedPuffs().billboards;
  const { camera } = view;
  const towards = towardsLightOf(view, new Vector3(...place)).transformDirection(camera.matrixWorldInverse);
  const turn = new Matrix4().makeRotationZ(roll).premultiply(camera.matrixWorld.clone().setPosition(0, 0, 0));
  const slant = slantOf(place, camera, towards);
  const rolled = towards.clone().applyMatrix4(new Matrix4().makeRotationZ(-roll));
  return {
    lobes: turned(casters.table, casters.lobeCount, variation, turn),
    cap: tabled(startCaps, variation, rolled) + Math.max(0, slant),
  };
}

function standing({ place, radius, roll = 0, seed = 0, variation = 0 }: LabPuff, view: View): StandingPuff {
  const { startCaps, table, lobeCount, count, depth } = bakedPuffs().lobes;
  const { camera } = view;
  const towards = towardsLightOf(view, new Vector3(...place));
  const inView = towards.clone().transformDirection(camera.matrixWorldInverse);
  const turn = new Matrix4().makeRotationAxis(new Vector3(...spherePoint(seed, 256)), roll);
  const slant = slantOf(place, camera, inView);
  const distance = -new Vector3(...place).applyMatrix4(camera.matrixWorldInverse).z;
  const aside = camera instanceof PerspectiveCamera ? (0.5 * Math.hypot(inView.x, inView.y) * radius) / distance : 0;
  const shear = Math.max(slant, -depth * slant) + aside;
  const inPuff = towards.clone().applyMatrix4(turn.clone().invert());
  return {
    lobes: turned(table, table.length / count / 4, variation, turn).slice(0, lobeCount),
    cap: tabled(startCaps, variation, inPuff) + shear,
  };
}

function turned(table: Float32Array, columns: number, variation: number, turn: Matrix4): StandingPuff['lobes'] {
  return Array.from({ length: columns }, (_, lobe) => {
    const first = 4 * (variation * columns + lobe);
    return { center: new Vector3().fromArray(table, first).applyMatrix4(turn), radius: table[first + 3] };
  });
}

/** How far each radius of relief moves a fragment away from the light along the view ray; 0 without perspective. */
function slantOf(place: LabPuff['place'], camera: Camera, light: Vector3): number {
  if (!(camera instanceof PerspectiveCamera)) return 0;
  const inView = new Vector3(...place).applyMatrix4(camera.matrixWorldInverse);
  return -(light.x * inView.x + light.y * inView.y) / inView.z;
}

function tabled({ width, height, values }: StartCaps, layer: number, towards: Vector3): number {
  const column = Math.min(width - 1, Math.floor((Math.atan2(towards.y, towards.x) / (2 * Math.PI) + 0.5) * width));
  const row = Math.min(height - 1, Math.floor((Math.acos(towards.z) / Math.PI) * height));
  return Math.max(0, values[(layer * height + row) * width + column]);
}

/** Whether a volume holds a point of a view ray. */
export function holds({ centre, axis, cap, growth, discs }: Volume, ray: Ray, point: Vector3): boolean {
  if (point.clone().sub(centre).dot(axis) < cap) return false;
  const origin = ray.origin.clone().sub(centre);
  const at = point.distanceTo(ray.origin);
  const [height, climb] = [origin.dot(axis), ray.direction.dot(axis)];
  const across = origin.clone().addScaledVector(axis, -height);
  const drift = ray.direction.clone().addScaledVector(axis, -climb);
  const [scale, gain] = [1 + growth * height, growth * climb];
  let [enter, leave] = [Infinity, -Infinity];
  for (const disc of discs) {
    const offset = across.clone().addScaledVector(disc.centre, -scale);
    const step = drift.clone().addScaledVector(disc.centre, -gain);
    const stretch = within(offset, step, disc.radius, scale, gain);
    if (stretch) [enter, leave] = [Math.min(enter, stretch[0]), Math.max(leave, stretch[1])];
  }
  return enter <= at && at <= leave;
}

/** Where |offset + t step| <= radius (scale + t gain), on the side of the lamp that its rays reach. */
function within(
  offset: Vector3,
  step: Vector3,
  radius: number,
  scale: number,
  gain: number,
): [number, number] | undefined {
  const a = step.lengthSq() - (radius * gain) ** 2;
  const b = offset.dot(step) - radius * radius * scale * gain;
  const root = Math.sqrt(b * b - a * (offset.lengthSq() - (radius * scale) ** 2));
  if (!(root > 0)) return undefined;
  const [low, high] = [(-b - root) / a, (-b + root) / a].sort((x, y) => x - y);
  if (a > 0) return scale + low * gain > 0 ? [low, high] : undefined;
  return gain > 0 ? [high, Infinity] : [-Infinity, low];
}
