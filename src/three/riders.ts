import type { Object3D } from 'three';
import { FIRST_PART, POSE_FLOATS } from '../simulator/layout.ts';
import type { Simulator } from '../simulator/simulator.ts';
import { TELEPORT, type SmokeFrame } from './smokeSpace.ts';
import { copyOf, newPose, poseOf, type Pose } from './shapes.ts';

/** Numbers of a part: its carrier, -1 for none, and its pose. */
const PART_FLOATS = 1 + POSE_FLOATS;
const STILL = [-1, 0, 0, 0, 0, 0, 0, 1];

/** An object that emitters and forces of the simulator ride on, as a part. */
export interface Rider {
  /** Number of the part, where the simulator expects that of a rigid. */
  readonly number: number;
  readonly now: Pose;
  readonly before: Pose;
}

/** The parts of the simulator that follow objects of the host's scene. Numbers of removed riders are reused. */
export class Riders {
  readonly frame: SmokeFrame;
  private readonly simulator: Simulator;
  private readonly riders: (Rider | undefined)[] = [];
  private readonly numbers: number[] = [];

  constructor(simulator: Simulator, frame: SmokeFrame) {
    this.simulator = simulator;
    this.frame = frame;
  }

  /** Adds a rider that rests at a pose. */
  add(pose: Pose): Rider {
    const free = this.riders.indexOf(undefined);
    const slot = free < 0 ? this.riders.length : free;
    const rider = { number: FIRST_PART + slot, now: copyOf(pose), before: copyOf(pose) };
    this.riders[slot] = rider;
    return rider;
  }

  remove({ number }: Rider): void {
    this.riders[number - FIRST_PART] = undefined;
    while (this.riders.length > 0 && !this.riders.at(-1)) this.riders.pop();
  }

  /** Makes the current pose of a rider the previous one. */
  move(rider: Rider, { position, rotation }: Pose): void {
    const { now, before } = rider;
    before.position.copy(this.frame.hasJumped ? position : now.position);
    before.rotation.copy(this.frame.hasJumped ? rotation : now.rotation);
    now.position.copy(position);
    now.rotation.copy(rotation);
  }

  /** Sets the poses of the next step, and the direction of up. @param from, to fractions of the way between the last two poses */
  place(from: number, to: number): void {
    const { riders, numbers, frame } = this;
    const up = frame.up((from + to) / 2);
    if (riders.length === 0 && !up) return;
    numbers.length = 2 * PART_FLOATS * riders.length;
    const farthest = TELEPORT / frame.now.scale / (to - from);
    riders.forEach((rider, slot) => {
      const isSudden = rider && rider.before.position.distanceTo(rider.now.position) > farthest;
      this.write(rider, slot, isSudden ? 1 : from);
      this.write(rider, riders.length + slot, isSudden ? 1 : to);
    });
    if (up) numbers.push(up.x, up.y, up.z);
    this.simulator.placeParts(numbers);
  }

  private write(rider: Rider | undefined, part: number, share: number): void {
    const { numbers } = this;
    const first = PART_FLOATS * part;
    for (let at = 0; at < PART_FLOATS; at++) numbers[first + at] = STILL[at];
    if (!rider) return;
    const { before, now } = rider;
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
