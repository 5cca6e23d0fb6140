/** A React tree in a scene of its own, whose frames tests request one by one. */
import { advance, createRoot, extend, type ReconcilerRoot, type RootState } from '@react-three/fiber';
import { createElement, StrictMode, useEffect, type ReactNode } from 'react';
import {
  AmbientLight,
  DirectionalLight,
  Group,
  Mesh,
  MeshBasicMaterial,
  Object3D,
  SphereGeometry,
  type WebGLRenderer,
} from 'three';
import { CartoonSmoke } from '../../../../src/three/cartoonSmoke.ts';
import { draw, HEIGHT, makeRenderer, WIDTH, type Pixels } from '../scene.ts';

extend({ AmbientLight, DirectionalLight, Group, Mesh, MeshBasicMaterial, Object3D, SphereGeometry });

/** Smokes that were created and that were disposed, by all trees; what creation waits for; how often `Mounted` was mounted. */
export const census = { created: 0, disposed: 0, mounts: 0, gate: Promise.resolve() };
const create = CartoonSmoke.create.bind(CartoonSmoke);
CartoonSmoke.create = async (options) => {
  const smoke = await create(options);
  await census.gate;
  census.created++;
  const dispose = smoke.dispose.bind(smoke);
  smoke.dispose = () => {
    census.disposed++;
    dispose();
  };
  return smoke;
};

export class Tree {
  readonly renderer: WebGLRenderer;
  private readonly root: ReconcilerRoot<OffscreenCanvas>;
  private readonly wrap: (tree: ReactNode) => ReactNode;
  private state!: RootState;
  private frame = 0;

  private constructor(renderer: WebGLRenderer, isStrict: boolean) {
    this.renderer = renderer;
    this.root = createRoot(renderer.domElement as unknown as OffscreenCanvas);
    this.wrap = (tree) => (isStrict ? createElement(StrictMode, null, tree) : tree);
  }

  static async open({ isStrict = false, renderer = makeRenderer() } = {}): Promise<Tree> {
    const tree = new Tree(renderer, isStrict);
    const size = { width: WIDTH, height: HEIGHT, top: 0, left: 0 };
    await tree.root.configure({ gl: renderer, frameloop: 'never', size, dpr: 1, flat: true });
    // React mounts twice what it adds to a strict tree, but not what a strict tree begins with.
    await tree.show(null);
    return tree;
  }

  /** Renders a tree. Resolves when its effects have run. */
  async show(tree: ReactNode): Promise<void> {
    await new Promise<void>((resolve) => {
      const done = createElement(Done, { key: 'done', resolve });
      const store = this.root.render(this.wrap([createElement('group', { key: 'tree' }, tree), done]));
      this.state = store.getState();
    });
  }

  /** Shows frames, each 1/60 s after the other. */
  frames(count: number): void {
    for (let taken = 0; taken < count; taken++) advance(++this.frame / 60);
  }

  get smokes(): CartoonSmoke[] {
    const found: CartoonSmoke[] = [];
    this.state.scene.traverse((object) => object instanceof CartoonSmoke && found.push(object));
    return found;
  }

  picture(): Pixels {
    const { renderer, state } = this;
    return draw({ renderer, scene: state.scene, camera: state.camera as never, keyLight: undefined as never });
  }

  async end(): Promise<void> {
    await this.show(null);
    this.root.unmount();
  }
}

/** Counts how often it is mounted. */
export function Mounted(): null {
  useEffect(() => void census.mounts++, []);
  return null;
}

function Done({ resolve }: { resolve: () => void }): null {
  useEffect(resolve, [resolve]);
  return null;
}
