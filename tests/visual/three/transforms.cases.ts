/** Smoke whose object has a transform, in a host's scene. */
import {
  BoxGeometry,
  Fog,
  Group,
  Mesh,
  MeshStandardMaterial,
  Object3D,
  OrthographicCamera,
  PlaneGeometry,
  Vector3,
  type Camera,
  type PerspectiveCamera,
} from 'three';
import type { Values } from '../../../src/parameters/parameter.ts';
import { Reflector } from 'three/examples/jsm/objects/Reflector.js';
import {
  changedPixels,
  differences,
  dispose,
  draw,
  emptyHost,
  furnishedHost,
  HANGING,
  HEIGHT,
  smokeIn,
  smokePixels,
  WIDTH,
  type Host,
  type Pixels,
} from './scene.ts';

/**
 * Pixels that differ when the whole scene is elsewhere: floor, mirror, fog, a box that casts, light, camera and smoke. As a
 * control, those that differ when the smoke is turned in it, or away.
 */
export async function together(
  kind: 'perspective' | 'orthographic',
  values: Values = { ...HANGING, 'style.gradient': 'height' },
): Promise<Record<string, number>> {
  const [first, moved] = [
    await pictures(kind, values, () => {}),
    await pictures(kind, values, (rig, camera, fog) => {
      rig.position.set(30, -12, 7);
      rig.rotation.set(0.8, -0.4, 2.1);
      rig.scale.setScalar(2);
      enlarge(camera);
      fog.near *= 2;
      fog.far *= 2;
    }),
  ];
  const changed = (pixels: Pixels) => changedPixels(pixels, first.smoke, 8);
  return {
    moved: changed(moved.smoke),
    rotated: changed(first.rotated),
    without: changed(first.without),
  };
}

async function pictures(kind: string, values: Values, move: (rig: Group, camera: PerspectiveCamera, fog: Fog) => void) {
  const host = emptyHost();
  if (kind === 'orthographic') {
    const camera = new OrthographicCamera(-2.2, 2.2, 1.6, -1.6, 0.1, 50);
    camera.position.set(0.4, 2.2, 4.2);
    camera.lookAt(0, 0.8, 0);
    host.camera = camera as unknown as PerspectiveCamera;
  }
  const rig = new Group();
  const floor = new Mesh(new PlaneGeometry(8, 8), new MeshStandardMaterial({ color: '#c08860' }));
  floor.rotation.x = -Math.PI / 2;
  const box = new Mesh(new BoxGeometry(0.4, 0.4, 0.4), new MeshStandardMaterial({ color: '#30a060' }));
  box.position.set(0.55, 1.9, 0.5);
  const mirror = new Reflector(new PlaneGeometry(3, 2), { textureWidth: WIDTH, textureHeight: HEIGHT });
  mirror.position.set(0, 1, -1.5);
  const fog = new Fog('#406080', 3, 12);
  host.scene.fog = fog;
  host.scene.add(rig);
  const anchor = new Object3D();
  anchor.position.set(-0.7, 1.9, 0.5);
  rig.add(floor, box, mirror, anchor, host.keyLight, host.keyLight.target, host.camera);
  const smoke = await smokeIn(host, values, { space: 'local' });
  rig.add(smoke);
  smoke.cast(box);
  smoke.cast(anchor, { proxies: [{ follows: anchor, radius: 0.2 }] });
  move(rig, host.camera, fog);
  smoke.step(4);
  draw(host);
  await smoke.complete();
  const shown = draw(host);
  smoke.rotation.y = 0.3;
  const rotated = draw(host);
  smoke.visible = false;
  const without = draw(host);
  dispose(smoke, host.renderer);
  return { smoke: shown, rotated, without };
}

/** Doubles the lengths of a projection. The view has no scale in three.js. */
function enlarge(camera: Camera & { updateProjectionMatrix(): void }): void {
  const lengths = camera as unknown as Record<string, number | undefined>;
  for (const key of ['near', 'far', 'left', 'right', 'top', 'bottom'])
    if (lengths[key] !== undefined) lengths[key] *= 2;
  camera.updateProjectionMatrix();
}

/** Pixels that turned and scaled smoke changes outside of itself, and inside. */
export async function beside(): Promise<{ outside: number; inside: number }> {
  const host = furnishedHost();
  const plain = draw(host);
  const smoke = await smokeIn(host, { ...HANGING, 'style.shadows': 0 }, { space: 'local' });
  smoke.position.set(0.6, 0.4, 0);
  smoke.rotation.set(0.3, 0.2, 0.5);
  smoke.scale.setScalar(0.7);
  const drawn = draw(host);
  const isSmoke = smokePixels(host, smoke);
  const changed = differences(plain, drawn).map((difference) => difference > 0);
  // The antialiased edge of smoke in front of another colour may be a pixel wider.
  const isNear = (pixel: number) => [0, -1, 1, -WIDTH, WIDTH].some((step) => isSmoke[pixel + step]);
  const count = (inside: boolean) => changed.filter((is, pixel) => is && isNear(pixel) === inside).length;
  const seen = { outside: count(false), inside: count(true) };
  dispose(smoke, host.renderer);
  return seen;
}

/** Distances in pixels of smoke and shadow from where the object of local smoke and the light place them. */
export async function places(): Promise<{ smoke: number; shadow: number }[]> {
  const host = emptyHost();
  host.camera.position.set(0, 6, 9);
  host.camera.lookAt(0, 0, 0);
  host.keyLight.position.set(0.5, 5, 0.4);
  const floor = new Mesh(new PlaneGeometry(20, 20), new MeshStandardMaterial({ color: '#c08860' }));
  floor.rotation.x = -Math.PI / 2;
  host.scene.add(floor);
  const bare = draw(host);
  const smoke = await smokeIn(host, { ...HANGING, 'emitters.0.position.y': 0 }, { space: 'local' });
  const seen = [new Vector3(-1.5, 1.6, 0), new Vector3(1.8, 2, -1)].map((place, index) => {
    // Moved after the step: a picture shows the smoke where its object is.
    smoke.position.copy(place);
    smoke.rotation.set(index, 2 * index, 0);
    const changed = differences(draw(host), bare).map((difference) => difference > 8);
    const isSmoke = smokePixels(host, smoke);
    const shadow = place.clone().addScaledVector(host.keyLight.position, -place.y / host.keyLight.position.y);
    const isShadow = changed.map((is, pixel) => is && !isSmoke[pixel]);
    return { smoke: offset(isSmoke, place, host), shadow: offset(isShadow, shadow, host) };
  });
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
  let shown = draw(host);
  const alive = [smoke.stats.alive];
  const changed: number[] = [];
  const look = (spoil: () => void) => {
    spoil();
    changed.push(changedPixels(draw(host), shown));
    smoke.update(0);
    for (let frame = 0; frame < 3; frame++) smoke.update(1 / 60);
    draw(host);
    alive.push(smoke.stats.alive);
    smoke.position.set(0.3, 0, 0);
    smoke.scale.set(1, 1, 1);
    smoke.step(1);
    shown = draw(host);
  };
  look(() => (smoke.position.y = NaN));
  look(() => smoke.scale.set(1, 2, 1));
  dispose(smoke, host.renderer);
  return { said, changed, alive };
}

/**
 * Pixels that change in the shadow of a box while the smoke has another scale than at the latest `update`, and those of the
 * shadow.
 */
export async function rescaled(): Promise<{ changed: number; shadow: number }> {
  const host = furnishedHost();
  const box = new Mesh(new BoxGeometry(0.5, 0.5, 0.5), new MeshStandardMaterial());
  box.position.set(0.2, 1, 0.5);
  host.scene.add(box);
  const without = draw(host);
  const smoke = await smokeIn(host, { 'emission.rate': 0 }, { space: 'local' });
  smoke.cast(box);
  const before = draw(host);
  smoke.scale.setScalar(2.5);
  const after = draw(host);
  dispose(smoke, host.renderer);
  return { changed: changedPixels(before, after, 8), shadow: changedPixels(without, before, 8) };
}
