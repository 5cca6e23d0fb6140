import type { Object3D } from 'three';
import { ParameterError, SimulatorError } from '../base/errors.ts';
import { runOnSelf } from '../base/onSelf.ts';
import type { Pose } from './shapes.ts';

/**
 * What `collide`, `cast`, `emitFrom` and `attach` return. While its object is outside the scene that it was in, or has a
 * transform that is not finite, a handle has no effect.
 */
export interface SmokeHandle {
  /** Whether it has an effect. Takes effect in the next step. Setting it throws a SimulatorError after `remove`. */
  enabled: boolean;
  /** Ends the effect and frees what it uses. Repeated calls have no effect. */
  remove(): void;
}

/** The smoke that a handle belongs to. */
export interface HandleOwner {
  /** The smoke object, whose scene is the scene of the handles. */
  readonly object: Object3D;
  /** Reports an error that no caller can catch. */
  report(error: unknown): void;
  /** Whether the simulator and the renderer of the smoke still exist. */
  isAlive(): boolean;
}

/** Largest coordinate of objects, bursts and positions of the parameter table, in metres. */
export const MAX_COORDINATE = 5000;

/** Starts and stops an effect as its object appears and disappears. */
export abstract class Handle implements SmokeHandle {
  /** Name of the call that made it, for errors. */
  protected readonly call: string;
  protected readonly object: Object3D;
  /** Whether the effect is on. */
  protected isActive = false;
  private handles: Handles | undefined;
  private isEnabled = true;
  private wasInScene = false;
  private hasFailed = false;

  /** @throws ParameterError when `object` is no object of three.js */
  constructor(call: string, object: Object3D) {
    this.call = call;
    this.object = object;
    if (!(object as Object3D | undefined)?.isObject3D)
      throw new ParameterError(`${call}.object`, object, 'an Object3D of three.js');
    runOnSelf(this);
  }

  get enabled(): boolean {
    return this.isEnabled;
  }

  set enabled(value: boolean) {
    this.requireUsable('enabled');
    if (typeof value !== 'boolean') throw new ParameterError(`${this.call}.enabled`, value, 'true or false');
    this.isEnabled = value;
  }

  remove(): void {
    const { handles } = this;
    if (!handles) return;
    this.handles = undefined;
    handles.delete(this);
    if (!handles.owner.isAlive()) return;
    this.deactivate();
    this.release();
  }

  /** Adds it to a smoke. @throws what `start` throws; nothing is added then */
  join(handles: Handles): void {
    this.start();
    this.isActive = true;
    this.handles = handles;
    this.noteScene(rootOf(handles.owner.object));
  }

  /** Reads the object for the next steps. Reports errors once, until the object is sound again. */
  look(): void {
    const { owner } = this.handles!;
    const isWanted = this.isEnabled && this.isPresent(owner.object);
    try {
      if (!isWanted) this.deactivate();
      else if (this.isActive) this.follow();
      else {
        this.start();
        this.isActive = true;
      }
      this.hasFailed &&= !isWanted;
    } catch (error) {
      this.deactivate();
      if (!this.hasFailed) owner.report(error);
      this.hasFailed = true;
    }
  }

  /** Prepares a step. @param from, to fractions of the way between the poses of the last two looks */
  move(_from: number, _to: number): void {}

  /** Shows where the simulator has moved the object. @param blend between the previous step (0) and the latest (1) */
  show(_blend: number): void {}

  /** Turns the effect on at the current pose. @throws ParameterError when it cannot; it is off then */
  protected abstract start(): void;
  /** Turns the effect off. */
  protected abstract stop(): void;
  /** Reads the current pose. @throws ParameterError for a transform that is not finite */
  protected follow(): void {}
  /** Frees what outlasts `stop`. */
  protected release(): void {}

  /** @throws SimulatorError after `remove` or after the smoke was disposed */
  protected requireUsable(what: string): void {
    const { call, handles } = this;
    if (!handles) throw new SimulatorError(`${call}.${what}: this handle was removed; call ${call}() again.`);
    if (!handles.owner.isAlive())
      throw new SimulatorError(`${call}.${what}: the smoke of this handle was disposed; create a new one.`);
  }

  /** @throws ParameterError for a pose that is not finite or beyond {@link MAX_COORDINATE} */
  protected requireSound({ position, rotation }: Pose): void {
    const { x, y, z } = position;
    const most = Math.max(Math.abs(x), Math.abs(y), Math.abs(z));
    // NaN fails every comparison.
    if (most <= MAX_COORDINATE && rotation.lengthSq() > 0) return;
    const { call, object } = this;
    const where = `${object.name || object.type} at ${x}, ${y}, ${z}`;
    throw new ParameterError(`${call}.object`, where, `an object with a finite transform within ${MAX_COORDINATE} m`);
  }

  /** Turns the effect off until the next look. */
  deactivate(): void {
    if (this.isActive) this.stop();
    this.isActive = false;
  }

  /** Objects that were never in the scene count as present: they are mere anchors. */
  private isPresent(smoke: Object3D): boolean {
    const root = rootOf(smoke);
    return this.noteScene(root) || !this.wasInScene || root.uuid === smoke.uuid;
  }

  private noteScene(root: Object3D): boolean {
    // Not by identity: the object, or what holds the smoke, may be a Proxy.
    const isInScene = rootOf(this.object).uuid === root.uuid;
    this.wasInScene ||= isInScene;
    return isInScene;
  }
}

/** The handles of one smoke, in the order of their calls. */
export class Handles {
  readonly owner: HandleOwner;
  private readonly all = new Set<Handle>();

  constructor(owner: HandleOwner) {
    this.owner = owner;
  }

  add<Kind extends Handle>(handle: Kind): Kind {
    handle.join(this);
    this.all.add(handle);
    return handle;
  }

  delete(handle: Handle): void {
    this.all.delete(handle);
  }

  look(): void {
    for (const handle of this.all) handle.look();
  }

  move(from: number, to: number): void {
    for (const handle of this.all) handle.move(from, to);
  }

  show(blend: number): void {
    for (const handle of this.all) handle.show(blend);
  }

  /** Ends all effects until the next look. */
  pause(): void {
    for (const handle of this.all) handle.deactivate();
  }
}

function rootOf(object: Object3D): Object3D {
  let at = object;
  while (at.parent) at = at.parent;
  return at;
}
