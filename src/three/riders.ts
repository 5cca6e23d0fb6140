import { Quaternion, Vector3, type Object3D } from 'three';
import { FIRST_PART, POSE_FLOATS } from '../sim/layout.ts';
import type { Simulator } from '../sim/simulator.ts';
import { poseOf, type Pose } from './shapes.ts';

/** Numbers of a part: its carrier, -1 for none, and its pose. */
const PART_FLOATS = 1 + POSE_FLOATS;
const STILL = [-1, 0, 0, 0, 0, 0, 0, 1];
/** A rider that moves farther in a step, in metres, is there at once and leaves no trail: 120 m/s. */
const TELEPORT = 2;

/** An object that emitters and forces of the simulator ride on, as a part. */
export interface Rider {
  /** Number of the part, where the simulator expects that of a rigid. */
  readonly number: number;
  readonly now: Pose;
  readonly before: Pose;
}

/** The parts of the simulator that follow objects of the host's scene. Numbers of removed riders are reused. */
export class Riders {
  private readonly simulator: Simulator;
  private readonly riders: (Rider | undefined)[] = [];
  private readonly numbers: number[] = [];

  constructor(simulator: Simulator) {
    this.simulator = simulator;
  }

  /** Adds a rider that rests at a pose. */
  add({ position, rotation }: Pose): Rider {
    const free = this.riders.indexOf(undefined);
    const slot = free < 0 ? this.riders.length : free;
    const rider = {
      number: FIRST_PART + slot,
      now: { position: position.clone(), rotation: rotation.clone() },
      before: { position: position.clone(), rotation: rotation.clone() },
    };
    this.riders[slot] = rider;
    return rider;
  }

  remove({ number }: Rider): void {
    this.riders[number - FIRST_PART] = undefined;
    while (this.riders.length > 0 && !this.riders.at(-1)) this.riders.pop();
  }

  /** Sets the poses of the next step. @param from, to fractions of the way between the last two poses */
  place(from: number, to: number): void {
    const { riders, numbers } = this;
    if (riders.length === 0) return;
    numbers.length = 2 * PART_FLOATS * riders.length;
    const farthest = TELEPORT / (to - from);
    riders.forEach((rider, slot) => {
      const isSudden = rider && rider.before.position.distanceTo(rider.now.position) > farthest;
      this.write(rider, slot, isSudden ? 1 : from);
      this.write(rider, riders.length + slot, isSudden ? 1 : to);
    });
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

const between: Pose = { position: new Vector3(), rotation: new Quaternion() };

/** The current world pose of an object. */
export function worldPose(object: Object3D, into: Pose): Pose {
  object.updateWorldMatrix(true, false);
  return poseOf(object.matrixWorld, into);
}

/** Makes the current pose the previous one and reads the object again. */
export function followObject(rider: Rider, object: Object3D): Pose {
  rider.before.position.copy(rider.now.position);
  rider.before.rotation.copy(rider.now.rotation);
  return worldPose(object, rider.now);
}
