import type { Object3D } from 'three';
import { FIRST_PART, POSE_FLOATS } from '../simulator/layout.ts';
import type { Simulator } from '../simulator/simulator.ts';
import { TELEPORT, type SmokeFrame } from './smokeSpace.ts';
import { copyOf, newPose, poseOf, type Pose } from './shapes.ts';

/** Numbers of a part: its carrier, -1 for none, and its pose. */
const PART_FLOATS = 1 + POSE_FLOATS;
const STILL = [-1, 0, 0, 0, 0, 0, 0, 1];

/** An object that emitters and forces of the simulator ride on, as a part. */
export interface ObjectPart {
  /** Number of the part, where the simulator expects that of a rigid. */
  readonly number: number;
  readonly now: Pose;
  readonly before: Pose;
}

/** The parts of the simulator that follow objects of the host's scene. Numbers of removed parts are reused. */
export class ObjectParts {
  readonly frame: SmokeFrame;
  private readonly simulator: Simulator;
  private readonly parts: (ObjectPart | undefined)[] = [];
  private readonly numbers: number[] = [];

  constructor(simulator: Simulator, frame: SmokeFrame) {
    this.simulator = simulator;
    this.frame = frame;
  }

  /** Adds a part that rests at a pose. */
  add(pose: Pose): ObjectPart {
    const free = this.parts.indexOf(undefined);
    const slot = free < 0 ? this.parts.length : free;
    const part = { number: FIRST_PART + slot, now: copyOf(pose), before: copyOf(pose) };
    this.parts[slot] = part;
    return part;
  }

  remove({ number }: ObjectPart): void {
    this.parts[number - FIRST_PART] = undefined;
    while (this.parts.length > 0 && !this.parts.at(-1)) this.parts.pop();
  }

  /** Makes the current pose of a part the previous one. */
  move(part: ObjectPart, { position, rotation }: Pose): void {
    const { now, before } = part;
    before.position.copy(this.frame.hasJumped ? position : now.position);
    before.rotation.copy(this.frame.hasJumped ? rotation : now.rotation);
    now.position.copy(position);
    now.rotation.copy(rotation);
  }

  /** Sets the poses of the next step, and the direction of up. @param from, to fractions of the way between the last two poses */
  place(from: number, to: number): void {
    const { parts, numbers, frame } = this;
    const up = frame.up((from + to) / 2);
    if (parts.length === 0 && !up) return;
    numbers.length = 2 * PART_FLOATS * parts.length;
    const farthest = TELEPORT / frame.now.scale / (to - from);
    parts.forEach((part, slot) => {
      const isSudden = part && part.before.position.distanceTo(part.now.position) > farthest;
      this.write(part, slot, isSudden ? 1 : from);
      this.write(part, parts.length + slot, isSudden ? 1 : to);
    });
    if (up) numbers.push(up.x, up.y, up.z);
    this.simulator.placeParts(numbers);
  }

  private write(part: ObjectPart | undefined, index: number, share: number): void {
    const { numbers } = this;
    const first = PART_FLOATS * index;
    for (let at = 0; at < PART_FLOATS; at++) numbers[first + at] = STILL[at];
    if (!part) return;
    const { before, now } = part;
    between.position.lerpVectors(before.position, now.position, share).toArray(numbers, first + 1);
    between.rotation.slerpQuaternions(before.rotation, now.rotation, share).toArray(numbers, first + 4);
  }
}

const between = newPose();

/** The current world pose of an object. */
export function worldPose(object: Object3D, into: Pose): Pose {
  object.updateWorldMatrix(true, false);
  return poseOf(object.matrixWorld, into);
}
