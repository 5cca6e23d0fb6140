/** Smoke whose object has a transform, in a host's scene. */
import {
  BoxGeometry,
  Euler,
  Group,
  Matrix4,
  Mesh,
  MeshStandardMaterial,
  OrthographicCamera,
  PlaneGeometry,
  Vector3,
  type Camera,
} from 'three';
import type { CartoonSmoke } from '../../../src/three/cartoonSmoke.ts';
import type { SmokeSpace } from '../../../src/three/frame.ts';
import {
  changedPixels,
  differences,
  dispose,
  draw,
  emptyHost,
  furnishedHost,
  HANGING,
  HEIGHT,
  readCanvas,
  smokeIn,
  smokePixels,
  WIDTH,
  type Host,
  type Pixels,
} from './scene.ts';

/** A host whose floor, box, light and camera are in a rig. The box casts a shadow on smoke and floor. */
async function rigged(space: SmokeSpace, camera?: Camera) {
  const host = emptyHost();
  const rig = new Group();
  const floor = new Mesh(new PlaneGeometry(8, 8), new MeshStandardMaterial({ color: '#c08860' }));
  floor.rotation.x = -Math.PI / 2;
  const box = new Mesh(new BoxGeometry(0.4, 0.4, 0.4), new MeshStandardMaterial({ color: '#30a060' }));
  box.position.set(0.55, 1.9, 0.5);
  host.scene.add(rig);
  rig.add(floor, box, host.keyLight, host.keyLight.target);
  if (camera) host.camera = camera as Host['camera'];
  rig.add(host.camera);
  const smoke = await smokeIn(host, { ...HANGING, 'style.gradient': 'height' }, { space });
  rig.add(smoke);
  smoke.cast(box);
  smoke.step(4);
  return { host, rig, smoke, shared: draw(host) };
}

/** Pixels that differ after all of the scene has moved together, of those that the smoke and its shadow change. */
export async function together(kind: 'perspective' | 'orthographic'): Promise<Record<string, number>> {
  let camera: OrthographicCamera | undefined;
  if (kind === 'orthographic') {
    camera = new OrthographicCamera(-2.2, 2.2, 1.6, -1.6, 0.1, 50);
    camera.position.set(0.4, 2.2, 4.2);
    camera.lookAt(0, 0.8, 0);
  }
  const { host, rig, smoke, shared } = await rigged('local', camera);
  const hash = smoke.hash();
  const near = { near: camera?.near, far: camera?.far };
  const compare = () => changedPixels(draw(host), shared, 8);
  const seen: Record<string, number> = {};
  rig.position.set(30, -12, 7);
  rig.rotation.set(0.8, -0.4, 2.1);
  seen.moved = compare();
  rig.scale.setScalar(2);
  // three.js leaves the scale out of the view, so the camera is outside of the rig's scale.
  const { camera: eye } = host;
  seen.large = scaledView(host, () => compare());
  rig.scale.setScalar(1);
  // A frame of another rig, as a control.
  rig.remove(eye);
  host.scene.add(eye);
  seen.left = compare();
  smoke.visible = false;
  rig.add(eye);
  seen.smoke = compare();
  if (smoke.hash() !== hash || near.near !== camera?.near) throw new Error('Drawing changed the smoke.');
  dispose(smoke, host.renderer);
  return seen;
}

/** Doubles the planes of a projection while `act` runs, and the half sides of an orthographic one. */
function scaledView<Result>({ camera }: Host, act: () => Result): Result {
  const any = camera as unknown as Record<string, number> & Camera & { updateProjectionMatrix(): void };
  const sides = ['near', 'far', 'left', 'right', 'top', 'bottom'].filter((side) => any[side] !== undefined);
  for (const side of sides) (any as Record<string, number>)[side] *= 2;
  any.updateProjectionMatrix();
  try {
    return act();
  } finally {
    for (const side of sides) (any as Record<string, number>)[side] /= 2;
    any.updateProjectionMatrix();
  }
}

/** Pixels that smoke in a turned and scaled parent changes outside of itself and its shadow, and inside. */
export async function beside(): Promise<{ outside: number; inside: number }> {
  const host = furnishedHost();
  const plain = draw(host);
  const parent = new Group();
  host.scene.add(parent);
  const smoke = await smokeIn(host, { ...HANGING, 'style.shadows': 0 }, { space: 'local' });
  parent.position.set(0.6, 0.4, 0);
  parent.rotation.set(0.3, 0.2, 0.5);
  parent.scale.setScalar(0.7);
  parent.add(smoke);
  const drawn = draw(host);
  const isSmoke = smokePixels(host, smoke);
  const changed = differences(plain, drawn).map((difference) => difference > 0);
  const count = (inside: boolean) => changed.filter((is, pixel) => is && isSmoke[pixel] === inside).length;
  const seen = { outside: count(false), inside: count(true) };
  dispose(smoke, host.renderer);
  return seen;
}

/** Offsets in pixels of the smoke's centroid from that of its projected place, and of its shadow on the floor. */
export async function places(space: SmokeSpace): Promise<{ name: string; smoke: number; shadow: number }[]> {
  const host = emptyHost();
  host.camera.position.set(0, 6, 9);
  host.camera.lookAt(0, 0, 0);
  host.keyLight.position.set(0.5, 5, 0.4);
  const floor = new Mesh(new PlaneGeometry(20, 20), new MeshStandardMaterial({ color: '#c08860' }));
  floor.rotation.x = -Math.PI / 2;
  host.scene.add(floor);
  const bare = draw(host);
  const smoke = await smokeIn(host, { ...HANGING, 'emitters.0.position.y': 0 }, { space });
  const seen: { name: string; smoke: number; shadow: number }[] = [];
  const look = (name: string, place: Vector3) => {
    const isSmoke = smokePixels(host, smoke);
    const changed = differences(draw(host), bare).map((difference) => difference > 8);
    const shadow = place.clone().addScaledVector(host.keyLight.position, -place.y / host.keyLight.position.y);
    seen.push({
      name,
      smoke: offset(isSmoke, place, host),
      shadow: offset(
        changed.map((is, pixel) => is && !isSmoke[pixel]),
        shadow,
        host,
      ),
    });
  };
  smoke.position.set(-1.5, 1.4, 0);
  host.scene.updateMatrixWorld();
  smoke.step(60);
  const first = new Vector3(-1.5, 1.4, 0);
  look('placed', space === 'local' ? first : new Vector3());
  dispose(smoke, host.renderer);
  return seen;
}

function offset(pixels: readonly boolean[], place: Vector3, { camera }: Host): number {
  const { x, y } = place.clone().project(camera);
  const found = pixels.flatMap((is, pixel) => (is ? [[pixel % WIDTH, Math.floor(pixel / WIDTH)]] : []));
  const mean = (axis: number) => found.reduce((sum, each) => sum + each[axis], 0) / found.length + 0.5;
  return Math.hypot(mean(0) - ((x + 1) / 2) * WIDTH, mean(1) - ((y + 1) / 2) * HEIGHT);
}

/** Errors of frames with invalid transforms, and what they lose: changed pixels and the particles. */
export async function invalid(): Promise<{ said: string[]; changed: number[]; alive: number[] }> {
  const host = furnishedHost();
  const smoke = await smokeIn(host, HANGING, { space: 'local' });
  const said: string[] = [];
  smoke.addEventListener('error', ({ error }) => said.push(`${error.name}: ${error.message}`));
  smoke.position.x = 0.3;
  smoke.step(1);
  const shown = draw(host);
  const alive = [smoke.stats.alive];
  const changed: number[] = [];
  const look = (spoil: () => void) => {
    spoil();
    smoke.step(1);
    smoke.step(1);
    changed.push(changedPixels(draw(host), shown));
    alive.push(smoke.stats.alive);
    smoke.position.set(0.3, 0, 0);
    smoke.scale.set(1, 1, 1);
    smoke.step(1);
  };
  look(() => (smoke.position.y = NaN));
  look(() => smoke.scale.set(1, 2, 1));
  changed.push(changedPixels(draw(host), shown));
  dispose(smoke, host.renderer);
  return { said, changed, alive };
}
