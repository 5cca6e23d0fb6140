/** The handles of a smoke of src/three without a renderer. */
import { Group, Scene, type Object3D } from 'three';
import type { Values } from '../../src/parameters/parameter.ts';
import { ALL_PARTICLES } from '../../src/simulator/view.ts';
import type { SimulatorFactory } from '../../src/simulator/load.ts';
import { PLACE_FLOATS } from '../../src/simulator/layout.ts';
import { simulatorValues } from '../../src/simulator/simulatorValues.ts';
import { Attachment } from '../../src/three/attachment.ts';
import { ItemMotion } from '../../src/three/itemMotion.ts';
import { Collider, requireCollideOptions, type CollideOptions, type Obstacles } from '../../src/three/colliders.ts';
import type { EmitterOptions } from '../../src/simulator/emitterOptions.ts';
import { EmitterPool, PooledEmitter, TableEmitter } from '../../src/three/emitters.ts';
import { SmokeFrame, type SmokeSpace } from '../../src/three/smokeSpace.ts';
import { Handles, type Handle } from '../../src/three/handle.ts';
import { Overrides } from '../../src/three/overrides.ts';
import { PushedObject } from '../../src/three/pushed.ts';
import { ObjectParts } from '../../src/three/objectParts.ts';

/** Still air in which nothing dies, and no emitter of the table emits. */
export const STILL: Values = {
  'emission.rate': 0,
  'emission.lifetime': 60,
  'emission.growthTime': 0,
  'buoyancy.acceleration': 0,
  'turbulence.speed': 0,
  'drag.rate': 0,
};

export class HandledSmoke {
  readonly simulator;
  readonly scene = new Scene();
  readonly object = new Group();
  readonly errors: unknown[] = [];
  readonly pool;
  isAlive = true;
  /** The simulators that colliders have asked for. */
  readonly needs: string[] = [];
  private readonly obstacles: Obstacles;
  private readonly handles;
  private readonly parts;
  private readonly overrides;
  private readonly frameOfSmoke;
  private readonly itemMotion: ItemMotion;
  private readonly attached = new Set<string>();
  private values: Values;

  constructor(factory: SimulatorFactory, values: Values = STILL, capacity = 4000, space: SmokeSpace = 'world') {
    this.values = values;
    this.simulator = factory.create({ capacity, seed: 7 });
    this.simulator.set(simulatorValues(values));
    this.scene.add(this.object);
    this.frameOfSmoke = new SmokeFrame(space);
    this.parts = new ObjectParts(this.simulator, this.frameOfSmoke);
    this.pool = new EmitterPool(this.simulator, this.parts);
    this.overrides = new Overrides(this.simulator, (key) => this.itemMotion.numberOf(key));
    const { simulator, parts, overrides, frameOfSmoke: frame } = this;
    this.itemMotion = new ItemMotion({ simulator, parts, overrides, frame, values: () => this.values });
    this.obstacles = { simulator, frame, taken: new Set(), need: (what) => void this.needs.push(what) };
    const report = (error: unknown) => this.errors.push(error);
    this.handles = new Handles({ object: this.object, report, isAlive: () => this.isAlive });
  }

  set(values: Values): void {
    const after = { ...this.values, ...values };
    this.simulator.set(this.overrides.over(simulatorValues(values, after)));
    this.values = after;
  }

  /** Adds an object to the scene. */
  put<Kind extends Object3D>(object: Kind, x = 0): Kind {
    object.position.x = x;
    this.scene.add(object);
    return object;
  }

  emitFrom(object: Object3D, options: EmitterOptions | number = {}) {
    this.place();
    if (typeof options === 'object') return this.handles.add(new PooledEmitter(this.pool, object, options));
    const { simulator, overrides, frameOfSmoke: frame, pool: emitters } = this;
    const release = (item: string) => this.itemMotion.release(item);
    const context = { simulator, overrides, frame, emitters, release, set: (values: Values) => this.set(values) };
    return this.handles.add(new TableEmitter(context, object, options));
  }

  collide(object: Object3D, options: CollideOptions = {}) {
    this.place();
    requireCollideOptions(options);
    const Kind = options.feelsSmoke ? PushedObject : Collider;
    return this.handles.add<Handle>(new Kind(this.obstacles, object, options));
  }

  attach(item: string, object: Object3D) {
    this.place();
    const { parts, overrides, attached } = this;
    return this.handles.add(new Attachment({ parts, overrides, attached }, item, object));
  }

  /** Reads the transform before the first step. */
  place(): void {
    if (this.simulator.steps === 0) this.itemMotion.look(this.object, 1, true);
  }

  /** One frame of `count` steps. An invalid transform is an error of {@link errors}. */
  frame(count = 1): void {
    try {
      this.itemMotion.look(this.object, count, this.simulator.steps === 0);
    } catch (error) {
      this.errors.push(error);
    }
    this.handles.look();
    for (let step = 0; step < count; step++) {
      this.handles.move(step / count, (step + 1) / count);
      this.itemMotion.place((step + 0.5) / count);
      this.parts.place(step / count, (step + 1) / count);
      this.simulator.step();
      this.pool.settle();
    }
    this.handles.show(1);
  }

  frames(count: number): void {
    for (let frame = 0; frame < count; frame++) this.frame();
  }

  /** Centres of the living particles. */
  places(): number[][] {
    const { count, place } = this.simulator.arrange({ ...ALL_PARTICLES, blend: 1 }).rows;
    return Array.from({ length: count }, (_, row) =>
      Array.from(place.subarray(PLACE_FLOATS * row, PLACE_FLOATS * row + 3)),
    );
  }
}
