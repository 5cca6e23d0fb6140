/** What `collide` loads, and what smoke does meanwhile. */
import {
  BoxGeometry,
  CapsuleGeometry,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  SphereGeometry,
  TorusGeometry,
  type BufferGeometry,
} from 'three';
import type { CartoonSmoke } from '../../../../src/three/cartoonSmoke.ts';
import type { Simulator } from '../../../../src/simulator/simulator.ts';
import { ALL_PARTICLES } from '../../../../src/simulator/view.ts';
import { dispose, emptyHost, smokeIn, type Host } from '../scene.ts';

/** A jet that hits what is 1 m above the origin. */
const JET = {
  'emission.rate': 200,
  'emission.lifetime': 2,
  'emitters.0.speed': 2,
  'emitters.0.spread': 0,
  'drag.rate': 0,
  'buoyancy.acceleration': 0,
  'turbulence.speed': 0,
};

function put(host: Host, geometry: BufferGeometry, y: number): Mesh {
  const mesh = new Mesh(geometry, new MeshBasicMaterial());
  mesh.position.y = y;
  host.scene.add(mesh);
  return mesh;
}

function simulatorOf(smoke: CartoonSmoke): Simulator {
  return (smoke as unknown as { simulator: Simulator }).simulator;
}

/** Height that the particles of a jet reach in 3 s. */
function top(smoke: CartoonSmoke): number {
  smoke.step(180);
  return simulatorOf(smoke).arrange({ ...ALL_PARTICLES, blend: 1 }).bounds.max[1];
}

/** Heights of a jet without and with each simple shape, whose lower end is 1 m above the origin. */
export async function simple() {
  const host = emptyHost();
  const smoke = await smokeIn(host, JET, { physics: undefined });
  const said: string[] = [];
  smoke.addEventListener('error', ({ error }) => said.push(error.name));
  smoke.addEventListener('progress', () => said.push('progress'));
  const heights = [top(smoke)];
  const shapes = [new SphereGeometry(0.5), new BoxGeometry(1, 1, 1), new CapsuleGeometry(0.3, 0.4)];
  for (const geometry of shapes) {
    const handle = smoke.collide(put(host, geometry, 1.5), { action: 'kill' });
    heights.push(top(smoke));
    handle.remove();
  }
  const ceiling = put(host, new PlaneGeometry(1, 1).rotateX(Math.PI / 2), 1);
  smoke.collide(ceiling, { shape: 'plane', action: 'kill' });
  heights.push(top(smoke));
  await smoke.complete();
  dispose(smoke, host.renderer);
  return { heights, said };
}

/** A mesh that only rigids have, beside a ball: what is said, and the heights of the jet before and after they are loaded. */
export async function needy() {
  const host = emptyHost();
  const smoke = await smokeIn(host, JET, { physics: undefined });
  const said: string[] = [];
  const heights: number[] = [];
  const failed = new Promise<void>((resolve) =>
    smoke.addEventListener('error', ({ error }) => {
      said.push(error.name);
      resolve();
    }),
  );
  smoke.addEventListener('progress', ({ loaded }) => said.push(loaded > 0 ? 'progress' : 'nothing'));
  smoke.collide(put(host, new SphereGeometry(0.5), 8));
  smoke.collide(put(host, new TorusGeometry(0.3, 0.3).rotateX(Math.PI / 2), 1.3), { action: 'kill' });
  await failed;
  heights.push(top(smoke));
  const state = smoke.save();
  const rigids = [simulatorOf(smoke).rigidCount];
  // The test lets the second request pass.
  await smoke.complete();
  heights.push(top(smoke));
  rigids.push(simulatorOf(smoke).rigidCount);
  const after = smoke.save();
  smoke.restore(state);
  smoke.restore(after);
  dispose(smoke, host.renderer);
  // A state of smoke with rigids, in smoke without.
  const other = await smokeIn(emptyHost(), JET, { physics: undefined });
  other.restore(after);
  const { steps } = other.stats;
  dispose(other);
  return { said, heights, rigids, steps };
}

/**
 * A torus and a lantern that falls, the second lantern when all is loaded: the rigids, the heights of both, and the names of the
 * events.
 */
export async function both() {
  const host = emptyHost();
  const smoke = await smokeIn(host, JET, { physics: undefined });
  const said = new Set<string>();
  smoke.addEventListener('error', ({ error }) => said.add(error.message));
  smoke.addEventListener('progress', () => said.add('progress'));
  smoke.collide(put(host, new TorusGeometry(0.3, 0.3), 1.3));
  const lanterns = [0, 0].map((y) => put(host, new SphereGeometry(0.2), y));
  lanterns.forEach((lantern, index) => (lantern.position.x = 3 + index));
  const drop = async (lantern: Mesh) => {
    smoke.collide(lantern, { feelsSmoke: true });
    await smoke.complete();
    smoke.step(60);
    return simulatorOf(smoke).rigidCount;
  };
  const early = await drop(lanterns[0]);
  const late = await drop(lanterns[1]);
  const heights = lanterns.map(({ position }) => position.y);
  dispose(smoke, host.renderer);
  return { early, late, heights, said: [...said] };
}
