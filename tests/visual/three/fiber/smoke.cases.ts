/** `<Smoke>` and its handles in real React trees, beside the calls that they stand for. */
import { useFrame } from '@react-three/fiber';
import { Component, createElement as h, createRef, Fragment, type ReactNode } from 'react';
import { DirectionalLight, Group, Mesh, MeshBasicMaterial, SphereGeometry, Vector3 } from 'three';
import { Caster, Collider, Emitter, Smoke, type EmitterProps, type SmokeProps } from '../../../../src/fiber.ts';
import type { Values } from '../../../../src/parameters/parameter.ts';
import { CartoonSmoke } from '../../../../src/three/cartoonSmoke.ts';
import type { EmitterHandle } from '../../../../src/three/emitters.ts';
import { liveObjects } from '../../../support/liveObjects.ts';
import { makeRenderer } from '../scene.ts';
import { census, Mounted, Tree } from './tree.ts';

const VALUES: Values = { 'emission.rate': 0, 'emission.lifetime': 3, 'simulation.maxParticles': 400, seed: 5 };
const BALL = { position: [0.1, 1.1, 0] as const, radius: 0.3 };
const LIGHT = [2, 5, 3] as const;

/** Resolves to the smoke when it is ready. */
async function ready(tree: Tree, of: (events: Partial<SmokeProps>) => ReactNode): Promise<CartoonSmoke> {
  return new Promise((resolve, reject) => void tree.show(of({ onReady: resolve, onError: reject })));
}

const keyLight = new DirectionalLight();
keyLight.position.set(...LIGHT);

interface Changes {
  values?: Values;
  emitter?: Partial<EmitterProps>;
  isSolid?: boolean;
}

const emitterRef = createRef<EmitterHandle>();
const smokeRef = createRef<CartoonSmoke>();

/** A scene with each component. */
function scene(
  events: Partial<SmokeProps>,
  { values = VALUES, emitter = {}, isSolid = true }: Changes = {},
): ReactNode {
  const geometry = h('sphereGeometry', { args: [BALL.radius, 24, 16] });
  return h(
    Smoke,
    { keyLight, values, ref: smokeRef, ...events },
    h(Emitter, { ref: emitterRef, rotation: [0.2, 0, 0], rate: 60, size: 0.15, ...emitter }),
    h(
      Collider,
      { enabled: isSolid, friction: 0.5, position: BALL.position },
      h(Caster, null, h('mesh', null, geometry, h('meshBasicMaterial', { color: '#a04030' }))),
    ),
    h('primitive', { object: keyLight }),
    h(Mounted),
  );
}

/** The place of `<Smoke>` in the world, moved, and the hash beside that of a smoke that calls put there. */
export async function placed() {
  const tree = await Tree.open();
  const values = { ...VALUES, 'emission.rate': 60 };
  const show = (x: number) => (events: Partial<SmokeProps>) =>
    h(
      'group',
      { position: [0, 1, 0] },
      h(Smoke, { keyLight, values, space: 'local', position: [x, 0, 0], rotation: [0.3, 0, 0], ...events }, h(Mounted)),
    );
  const smoke = await ready(tree, show(1));
  const mounts = census.mounts;
  tree.frames(10);
  await tree.show(show(2)({}));
  tree.frames(10);
  const { x, y, z } = smoke.getWorldPosition(new Vector3());
  const seen = [smoke.hash(), [x, y, z].join(), smoke.space, census.mounts - mounts];
  await tree.end();
  const renderer = makeRenderer();
  const called = await CartoonSmoke.create({ renderer, keyLight, values, space: 'local' });
  called.rotation.x = 0.3;
  called.update(0);
  for (let frame = 0; frame < 19; frame++) called.update(1 / 60);
  const expected = [called.hash(), '2,1,0', 'local', 0];
  called.dispose();
  return [seen, expected];
}

/** The same scene and changes by components and by calls: hashes after each part, and whether the pictures are equal. */
export async function besideCalls(isStrict: boolean) {
  const changed = { ...VALUES, 'forces.wind.x': 0.8 };
  const tree = await Tree.open({ isStrict });
  const before = { ...census };
  const smoke = await ready(tree, (events) => scene(events));
  const byTree: string[] = [];
  const part = async (changes: Changes, count = 12) => {
    await tree.show(scene({}, changes));
    tree.frames(count);
    byTree.push(smoke.hash());
  };
  await part({}, 40);
  await part({ values: changed, emitter: { rate: 200 } });
  await part({ values: changed, emitter: { rate: 200, speed: 2 }, isSolid: false });
  // What is no longer given has its default again.
  await part({ emitter: { rate: 200 } });
  void emitterRef.current!.burst(5);
  await part({ emitter: { rate: 200, enabled: false } });
  await part({ emitter: { rate: 200, enabled: false, tint: 2 } });
  const pictures = [tree.picture()];
  const refs = [
    smokeRef.current === smoke,
    tree.smokes.length,
    census.created - before.created,
    census.mounts - before.mounts,
  ];
  const { alive } = smoke.stats;
  await tree.end();
  const gone = [smokeRef.current, emitterRef.current, census.disposed - before.disposed];

  const byCalls = await callsInstead(changed, pictures);
  return {
    byTree,
    byCalls,
    refs,
    gone,
    alive,
    isSamePicture: pictures[0].every((byte, at) => byte === pictures[1][at]),
  };
}

async function callsInstead(changed: Values, pictures: Uint8Array[]): Promise<string[]> {
  const hashes: string[] = [];
  const tree = await Tree.open();
  const { renderer } = tree;
  const smoke = await CartoonSmoke.create({ renderer, keyLight, values: VALUES });
  const [emitting, solid, casting] = [new Group(), new Group(), new Group()];
  emitting.rotation.x = 0.2;
  solid.position.set(...BALL.position);
  casting.add(new Mesh(new SphereGeometry(BALL.radius, 24, 16), new MeshBasicMaterial({ color: '#a04030' })));
  const own = new Group().add(emitting, solid.add(casting), keyLight, smoke);
  await tree.show(h('primitive', { object: own }));
  let emitter = smoke.emitFrom(emitting, { rate: 60, size: 0.15 });
  smoke.cast(casting);
  const collider = smoke.collide(solid, { friction: 0.5 });
  let frame = 0;
  const frames = (count: number) => {
    for (let taken = 0; taken < count; taken++, frame++) smoke.update((frame + 1) / 60 - frame / 60);
    hashes.push(smoke.hash());
  };
  frames(40);
  smoke.set(changed && { 'forces.wind.x': 0.8 });
  emitter.set({ rate: 200 });
  frames(12);
  emitter.remove();
  emitter = smoke.emitFrom(emitting, { rate: 200, size: 0.15, speed: 2 });
  collider.enabled = false;
  frames(12);
  smoke.set({ 'forces.wind.x': 0 });
  emitter.remove();
  emitter = smoke.emitFrom(emitting, { rate: 200, size: 0.15 });
  collider.enabled = true;
  frames(12);
  void emitter.burst(5);
  emitter.enabled = false;
  frames(12);
  emitter.remove();
  emitter = smoke.emitFrom(emitting, { rate: 200, size: 0.15, tint: 2 });
  emitter.enabled = false;
  frames(12);
  pictures.push(tree.picture());
  smoke.dispose();
  await tree.end();
  return hashes;
}

/** Objects of the GPU before a smoke, with it, and after it was unmounted. */
export async function unmounted() {
  const renderer = makeRenderer();
  const count = liveObjects(renderer);
  const tree = await Tree.open({ renderer, isStrict: true });
  const empty = h('mesh', null, h('sphereGeometry'), h('meshBasicMaterial'));
  const seen: Record<string, number>[] = [];
  const look = () => {
    tree.frames(3);
    seen.push(count());
  };
  await tree.show(empty);
  look();
  const smoke = await ready(tree, (events) => h(Fragment, null, empty, scene(events)));
  tree.frames(20);
  const handle = emitterRef.current!;
  look();
  await tree.show(empty);
  // The geometry of the collider is disposed when the browser is idle.
  await new Promise((resolve) => requestIdleCallback(resolve));
  look();
  const errors = [() => smoke.step(), () => handle.burst(1)].map(messageOf);
  const isOut = smoke.parent === null;
  await tree.end();
  return { seen, errors, isOut };
}

function messageOf(act: () => void): string {
  try {
    act();
  } catch (error) {
    return String(error);
  }
  return '';
}

/** Particles after more emitters than a smoke has, one after the other, and after the last is gone. */
export async function manyEmitters(): Promise<{ errors: string[]; grown: number[] }> {
  const tree = await Tree.open({ isStrict: true });
  const errors: string[] = [];
  const values = { ...VALUES, 'emission.lifetime': 60 };
  const of = (events: Partial<SmokeProps>, inside: ReactNode) =>
    h(Smoke, { keyLight, values, onError: (error) => errors.push(error.message), ...events }, inside);
  const smoke = await ready(tree, (events) => of(events, null));
  for (let index = 0; index < 140; index++) await tree.show(of({}, h(Emitter, { key: index, rate: 60 })));
  const grown: number[] = [];
  const grow = () => {
    const { alive } = smoke.stats;
    tree.frames(20);
    grown.push(smoke.stats.alive - alive);
  };
  tree.frames(1);
  grow();
  await tree.show(of({}, null));
  grow();
  await tree.end();
  return { errors, grown };
}

function gateOf() {
  let resolve!: () => void;
  const promise = new Promise<void>((open) => (resolve = open));
  return { promise, resolve };
}

/** Smokes that exist after one was unmounted while it was created, and after its options changed. */
export async function recreated() {
  const tree = await Tree.open();
  const before = { ...census };
  const alive = () => census.created - before.created - (census.disposed - before.disposed);
  const { promise: gate, resolve } = gateOf();
  census.gate = gate;
  await tree.show(scene({}));
  await tree.show(null);
  resolve();
  await until(() => census.created > before.created);
  await new Promise((done) => setTimeout(done));
  const abandoned = [census.created - before.created, alive()];
  const first = await ready(tree, (events) => scene(events));
  const second = await ready(tree, (events) =>
    scene(events, { values: { ...VALUES, seed: 6, 'puff.size': 1.5 }, emitter: { rate: 90 } }),
  );
  tree.frames(30);
  const result = {
    abandoned,
    isNew: first !== second,
    alive: alive(),
    puffs: second.stats.alive,
  };
  await tree.end();
  return result;
}

/** Where a component that comes late has moved its object, and where smoke sees it, in the same frames. */
export async function order(): Promise<number[][]> {
  const tree = await Tree.open();
  const moved = new Group();
  const seen: number[][] = [];
  const Mover = () => {
    useFrame(() => void (moved.position.x += 0.01));
    return null;
  };
  const of = (events: Partial<SmokeProps>, inside?: ReactNode) =>
    h(Fragment, null, h(Smoke, { keyLight, values: VALUES, ...events }), inside);
  const smoke = await ready(tree, (events) => of(events));
  const update = smoke.update.bind(smoke);
  const places: number[] = [];
  smoke.update = (seconds) => {
    places.push(moved.position.x);
    update(seconds);
  };
  tree.frames(2);
  await tree.show(of({}, h(Mover)));
  for (let frame = 0; frame < 4; frame++) {
    tree.frames(1);
    seen.push([moved.position.x, places.at(-1)!]);
    // The component subscribes again between frames.
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
  await tree.end();
  return seen;
}

class Boundary extends Component<{ children?: ReactNode; caught: (message: string) => void }> {
  override state = { isBroken: false };

  static getDerivedStateFromError() {
    return { isBroken: true };
  }

  override componentDidCatch(error: Error) {
    this.props.caught(error.message);
  }

  override render() {
    return this.state.isBroken ? null : this.props.children;
  }
}

/** What is said about mistakes with `onError`, and to an error boundary without it. */
export async function mistakes() {
  const reported: string[] = [];
  const caught: string[] = [];
  const tree = await Tree.open();
  const onError = (error: Error) => void reported.push(error.message);
  const wrong = { sped: 3 } as EmitterProps;
  const of = (events: Partial<SmokeProps>, emitter: EmitterProps = {}, values = VALUES) =>
    h(Smoke, { keyLight, values, ...events }, h(Emitter, emitter));
  const smoke = await ready(tree, ({ onReady }) => of({ onReady, onError }, wrong));
  await tree.show(of({ onError }, { rate: 5 }));
  await tree.show(of({ onError }, { rate: -5 }));
  await tree.show(of({ onError }, { rate: 5 }, { ...VALUES, 'puff.size': -1 }));
  smoke.update(NaN);
  await tree.show(null);
  const boundary = (children: ReactNode) =>
    h(Boundary, { caught: (message) => caught.push(message), key: caught.length }, children);
  await tree.show(boundary(h(Emitter)));
  await ready(tree, ({ onReady }) => boundary(of({ onReady })));
  await tree.show(boundary(of({}, wrong)));
  await until(() => caught.length === 2);
  await tree.end();

  const plain = await Tree.open({ renderer: makeRenderer({ stencil: false }) });
  await plain.show(of({ onError }));
  await until(() => reported.length === 5);
  await plain.end();
  return { reported, caught };
}

async function until(isDone: () => boolean): Promise<void> {
  while (!isDone()) await new Promise((resolve) => setTimeout(resolve, 5));
}

/** The names of the key lights that `<Smoke>` without one uses, and what it says where it finds none. */
export async function lights() {
  const { create } = CartoonSmoke;
  const used: string[] = [];
  CartoonSmoke.create = (options) => {
    used.push(options.keyLight.name);
    return create.call(CartoonSmoke, options);
  };
  const said: string[] = [];
  const open = async (props: Partial<SmokeProps>, ...others: ReactNode[]) => {
    const tree = await Tree.open();
    await new Promise<void>((resolve) => {
      const onError = (error: Error) => resolve(void said.push(error.message));
      const all = { values: VALUES, onReady: () => resolve(), onError, ...props };
      void tree.show(h(Fragment, null, h(Smoke, all), ...others));
    });
    await tree.end();
  };
  const ambient = h('ambientLight', { key: 'ambient' });
  const sun = (name: string) => h('group', { key: name }, h('directionalLight', { name }));
  try {
    await open({}, ambient, sun('first'), sun('second'));
    await open({ keyLight }, sun('first'));
    await open({}, ambient);
    await open({ keylight: keyLight } as Partial<SmokeProps>, sun('first'));
    await open({ renderOrder: 3 } as Partial<SmokeProps>, sun('first'));
  } finally {
    CartoonSmoke.create = create;
  }
  return { used, said };
}
