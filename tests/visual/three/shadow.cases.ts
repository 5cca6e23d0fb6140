/** The shadow of smoke and of casters in the host's scene, compared with the same scene without its key light. */
import {
  ACESFilmicToneMapping,
  BoxGeometry,
  Group,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  NoToneMapping,
  PlaneGeometry,
  Vector3,
  type Object3D,
  type WebGLRendererParameters,
} from 'three';
import { pictureTarget } from '../../../src/renderer/passes/targets.ts';
import { drawFrame } from '../../../src/renderer/frame.ts';
import type { FrameInput } from '../../../src/renderer/frameInput.ts';
import type { ShownSmoke } from '../../../src/renderer/shownSmoke.ts';
import type { CartoonSmoke } from '../../../src/three/cartoonSmoke.ts';
import type { HostPasses } from '../../../src/three/hostPasses.ts';
import { lightFrom } from '../../../src/three/keyLight.ts';
import { boneBalls, capsule, worldBall, instanceBalls, type BallAt } from '../../../src/three/proxies.ts';
import type { Values } from '../../../src/parameters/parameter.ts';
import {
  changedPixels,
  differences,
  dispose,
  draw,
  drawUnlit,
  emptyHost,
  furnishedHost,
  HANGING,
  HEIGHT,
  makeInstanced,
  makeRenderer,
  makeSkinned,
  smokeIn,
  smokePixels,
  WIDTH,
  type Host,
  type Pixels,
} from './scene.ts';

/** Pixels outside the smoke, after smoke is added. */
export interface Census {
  /** Unchanged pixels. */
  lit: number;
  /** Changed pixels with the colour of the scene without the key light. */
  dark: number;
  /** A mixture of the two, along an edge that the canvas antialiases. */
  between: number;
  wrong: number;
}

/** A furnished scene before and after smoke is added. */
export async function lightAndShadow(parameters: WebGLRendererParameters, toneMapped: boolean): Promise<Census> {
  const toneMapping = toneMapped ? ACESFilmicToneMapping : NoToneMapping;
  const host = furnishedHost(makeRenderer(parameters, undefined, toneMapping));
  const [before, unlit] = [draw(host), drawUnlit(host)];
  const smoke = await smokeIn(host);
  const census = censusOf(before, unlit, draw(host), maskOf(host, smoke));
  dispose(smoke, host.renderer);
  return census;
}

/** Compares a picture with those without smoke and without the key light. @param isSmoke pixels to leave out */
export function censusOf(before: Pixels, unlit: Pixels, after: Pixels, isSmoke: readonly boolean[]): Census {
  const census = { lit: 0, dark: 0, between: 0, wrong: 0 };
  const [toBefore, toUnlit] = [differences(after, before), differences(after, unlit)];
  isSmoke.forEach((smoke, pixel) => {
    if (smoke) return;
    if (toBefore[pixel] === 0) ++census.lit;
    else if (toUnlit[pixel] === 0) ++census.dark;
    else if (isBetween(after, before, unlit, pixel)) ++census.between;
    else ++census.wrong;
  });
  return census;
}

function isBetween(value: Pixels, a: Pixels, b: Pixels, pixel: number): boolean {
  return [0, 1, 2, 3].every((channel) => {
    const at = 4 * pixel + channel;
    return value[at] >= Math.min(a[at], b[at]) - 1 && value[at] <= Math.max(a[at], b[at]) + 1;
  });
}

/** Pixels of smoke and their neighbours. */
export function maskOf(host: Host, smoke: CartoonSmoke): boolean[] {
  const isSmoke = smokePixels(host, smoke);
  return isSmoke.map((_, pixel) => [0, 1, -1, WIDTH, -WIDTH].some((step) => isSmoke[pixel + step]));
}

/** Floor pixels in the shadow of an invisible box. */
export async function meshShadow(): Promise<Census> {
  const host = furnishedHost();
  const box = new Mesh(new BoxGeometry(0.8, 0.6, 0.6), UNSEEN);
  box.position.set(0.9, 0.5, 0.9);
  box.scale.set(1.5, 0.8, 1);
  host.scene.add(box);
  const [before, unlit] = [draw(host), drawUnlit(host)];
  const smoke = await smokeIn(host, NO_SMOKE);
  smoke.cast(box);
  const census = censusOf(before, unlit, draw(host), Array<boolean>(WIDTH * HEIGHT).fill(false));
  dispose(smoke, host.renderer);
  return census;
}

const NO_SMOKE = { ...HANGING, 'emission.rate': 0 };
const UNSEEN = new MeshBasicMaterial({ colorWrite: false, depthWrite: false });

/** Agreement of the floor's pixels with rays towards the light that intersect a ball or not. */
export interface Agreement {
  dark: number;
  lit: number;
  wrong: number;
}

/** The shadow on the floor of the balls that approximate a mesh. @param isNear whether the camera is beside the balls */
export async function ballShadow(kind: 'capsules' | 'bones' | 'instances', isNear: boolean): Promise<Agreement> {
  const host = floorOnly();
  if (isNear) {
    host.camera.position.set(-0.35, 0.9, 0.65);
    host.camera.lookAt(-0.7, 0, 0.2);
  }
  const { mesh: skinned, bones } = makeSkinned(UNSEEN);
  const thing = kind === 'instances' ? makeInstanced(UNSEEN) : skinned;
  thing.position.set(-0.4, 0.4, 0.5);
  host.scene.add(thing);
  const unlit = drawUnlit(host);
  const smoke = await smokeIn(host, NO_SMOKE);
  const limbs = bones.flatMap((follows) =>
    capsule({ follows, from: new Vector3(0, 0.1, 0), to: new Vector3(0, 0.7, 0), radius: 0.15 }),
  );
  smoke.cast(thing, kind === 'capsules' ? { proxies: limbs } : {});
  const balls =
    'isInstancedMesh' in thing
      ? instanceBalls(thing)
      : (kind === 'capsules' ? limbs : boneBalls(skinned)).map(worldBall);
  const agreement = agreementOf(host, draw(host), unlit, balls);
  dispose(smoke, host.renderer);
  return agreement;
}

const WAYS_TO_GO: Readonly<Record<string, (thing: Object3D, group: Group) => void>> = {
  hidden: (thing) => void (thing.visible = false),
  inHidden: (_, group) => void (group.visible = false),
  removed: (_, group) => void group.removeFromParent(),
};

/**
 * Pixels in the shadow of an object: visible, hidden, inside a hidden parent, removed from the scene, and visible
 * again.
 */
export async function shadowsOfGone(
  kind: 'rigid' | 'bones' | 'instances' | 'proxies',
): Promise<Record<string, number>> {
  const host = floorOnly();
  const group = new Group();
  const thing = thingOf(kind);
  thing.position.set(-0.4, 0.4, 0.5);
  host.scene.add(group.add(thing));
  const bare = draw(host);
  const smoke = await smokeIn(host, NO_SMOKE);
  smoke.cast(thing, kind === 'proxies' ? { proxies: [{ follows: thing, radius: 0.3 }] } : {});
  const dark = () => differences(draw(host), bare).filter((difference) => difference > 0).length;
  const counts: Record<string, number> = { there: dark() };
  for (const [way, go] of Object.entries(WAYS_TO_GO)) {
    go(thing, group);
    counts[way] = dark();
    thing.visible = group.visible = true;
    host.scene.add(group);
  }
  counts.back = dark();
  dispose(smoke, host.renderer);
  return counts;
}

function thingOf(kind: string): Mesh {
  if (kind === 'bones') return makeSkinned(UNSEEN).mesh;
  if (kind === 'instances') return makeInstanced(UNSEEN);
  return new Mesh(new BoxGeometry(0.5, 0.5, 0.5), UNSEEN);
}

function floorOnly(): Host {
  const host = emptyHost();
  const floor = new Mesh(new PlaneGeometry(8, 8), new MeshStandardMaterial({ color: '#c08860' }));
  floor.rotation.x = -Math.PI / 2;
  host.scene.add(floor);
  return host;
}

/** Pixels whose ray misses a ball by less than this distance are ignored, metres. */
const EDGE = 0.03;

function agreementOf(host: Host, picture: Pixels, unlit: Pixels, balls: readonly BallAt[]): Agreement {
  const towardsLight = host.keyLight.position.clone().normalize();
  const solids = balls.map((ballAt) => ballAt()).map(({ center, radius }) => ({ center: center.clone(), radius }));
  const isDark = differences(picture, unlit).map((difference) => difference === 0);
  const agreement = { dark: 0, lit: 0, wrong: 0 };
  isDark.forEach((dark, pixel) => {
    const place = onFloor(host, pixel);
    if (!place) return;
    const gaps = solids.map(({ center, radius }) => gapOf(place, towardsLight, center) - radius);
    const nearest = Math.min(...gaps);
    if (Math.abs(nearest) < EDGE) return;
    if (dark !== nearest < 0) ++agreement.wrong;
    else ++agreement[dark ? 'dark' : 'lit'];
  });
  return agreement;
}

/** The point of the floor at a pixel; undefined where there is none. */
function onFloor({ camera }: Host, pixel: number): Vector3 | undefined {
  const x = (((pixel % WIDTH) + 0.5) / WIDTH) * 2 - 1;
  const y = ((Math.floor(pixel / WIDTH) + 0.5) / HEIGHT) * 2 - 1;
  const ray = new Vector3(x, y, 0.5).unproject(camera).sub(camera.position);
  if (ray.y >= 0) return undefined;
  const place = ray.multiplyScalar(-camera.position.y / ray.y).add(camera.position);
  return Math.max(Math.abs(place.x), Math.abs(place.z)) < 3.9 ? place : undefined;
}

/** Distance between a ray and a point, metres. */
function gapOf(origin: Vector3, direction: Vector3, point: Vector3): number {
  const beside = point.clone().sub(origin);
  return beside.addScaledVector(direction, -beside.dot(direction)).length();
}

/** The factor of the second shadow step. */
const DEEP = [128, 64, 255];
const TWO_STEPS: Values = { 'style.shadowSteps': 2, 'style.shadowDepth': 2, 'style.deepShadow': '#8040ff' };
/** Few puffs, so that some shadow pixels have a single caster. */
const SPREAD = { ...HANGING, 'emission.rate': 60, 'emitters.0.radius': 0.6, 'emitters.0.position.x': 0.3 };

/**
 * Shadow with two steps, cast by two boxes that overlap on the floor and by smoke: pixels by caster, and pixels with an
 * unexpected colour.
 */
export async function deepShadow(): Promise<{ byBoxes: number; byBoth: number; bySmoke: number; wrong: number }> {
  const host = floorOnly();
  const boxes = [0.9, 1.6].map((height) => {
    const box = new Mesh(new BoxGeometry(0.9, 0.3, 0.9), UNSEEN);
    box.position.set(0.2 * height, height, 0.3);
    host.scene.add(box);
    return box;
  });
  const [before, unlit] = [draw(host), drawUnlit(host)];
  const pictureOf = async (values: Values, casters: readonly Mesh[]) => {
    const smoke = await smokeIn(host, { ...values, ...TWO_STEPS });
    for (const box of casters) smoke.cast(box);
    const picture = { pixels: draw(host), isSmoke: maskOf(host, smoke) };
    dispose(smoke);
    return picture;
  };
  const lone = [await pictureOf(NO_SMOKE, [boxes[0]]), await pictureOf(NO_SMOKE, [boxes[1]])];
  const solid = await pictureOf(NO_SMOKE, boxes);
  const hazy = await pictureOf(SPREAD, []);
  const all = await pictureOf(SPREAD, boxes);
  dispose(host.renderer);
  const stepsIn = (picture: Pixels, pixel: number) =>
    [0, 1, 2].find((steps) =>
      isAt(picture, pixel, steps === 0 ? before : unlit, steps === 2 ? DEEP : [255, 255, 255]),
    )!;
  const result = { byBoxes: 0, byBoth: 0, bySmoke: 0, wrong: 0 };
  const isDark = lone.map(({ pixels }) => differences(pixels, before).map((gap) => gap > 0));
  all.isSmoke.forEach((isSmoke, pixel) => {
    const boxSteps = isDark.some((dark) => dark[pixel]) ? 1 : 0;
    if (stepsIn(solid.pixels, pixel) !== boxSteps) ++result.wrong;
    if (isSmoke) return;
    const smokeSteps = stepsIn(hazy.pixels, pixel);
    if (stepsIn(all.pixels, pixel) !== Math.min(2, smokeSteps + boxSteps)) ++result.wrong;
    if (isDark.every((dark) => dark[pixel])) ++result.byBoxes;
    if (smokeSteps === 1 && boxSteps === 1) ++result.byBoth;
    if (smokeSteps === 2) ++result.bySmoke;
  });
  return result;
}

function isAt(picture: Pixels, pixel: number, source: Pixels, factor: readonly number[]): boolean {
  return factor.every((share, channel) => {
    const at = 4 * pixel + channel;
    return Math.abs(picture[at] - (source[at] * share) / 255) <= 1;
  });
}

/** Smoke alone: pixels of its shadow on itself, and pixels that differ from the frame of a stage. */
export async function likeStage(values: Values = {}): Promise<{ shadowed: number; different: number }> {
  const host = emptyHost();
  const { renderer, scene, camera, keyLight } = host;
  scene.background = null;
  const smoke = await smokeIn(host, { ...SPREAD, 'emission.rate': 240, 'style.tones': 2, ...values });
  const shown = draw(host);
  renderer.autoClear = false;
  const output = pictureTarget();
  output.setSize(WIDTH, HEIGHT);
  const {
    passes,
    simulator,
    shown: look,
  } = smoke as unknown as Record<'passes', HostPasses> & Pick<FrameInput, 'simulator'> & { shown: ShownSmoke };
  const { style } = look;
  const input = { simulator, camera, light: lightFrom(keyLight), blend: 1, rigids: [], cull: true, output };
  const [stage, lit] = [style, { ...style, shadows: false }].map((each) => {
    drawFrame(passes.smoke, { ...input, style: each, width: WIDTH, height: HEIGHT, pixelRatio: 1 });
    const pixels = new Uint8Array(4 * WIDTH * HEIGHT);
    renderer.readRenderTargetPixels(output, 0, 0, WIDTH, HEIGHT, pixels);
    // The canvas has no alpha, and is black without smoke.
    return pixels.map((value, at) => (at % 4 === 3 ? 255 : value));
  });
  dispose(output, smoke, renderer);
  return { shadowed: changedPixels(stage, lit, 2), different: changedPixels(shown, stage, 2) };
}

/**
 * Draw calls with a stencil test into the canvas: for smoke alone, for smoke above a floor, and for smoke whose shadow falls
 * beside an object.
 */
export async function stencilDraws(): Promise<Record<'alone' | 'above' | 'beside', number>> {
  const host = emptyHost();
  const { renderer, scene } = host;
  const smoke = await smokeIn(host);
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const { drawElements } = gl;
  let draws = 0;
  gl.drawElements = (...call) => {
    if (gl.getParameter(gl.DRAW_FRAMEBUFFER_BINDING) === null && gl.isEnabled(gl.STENCIL_TEST)) ++draws;
    drawElements.apply(gl, call);
  };
  const drawsWith = (place: Vector3 | undefined) => {
    const floor = new Mesh(new BoxGeometry(1, 0.1, 1), new MeshStandardMaterial());
    if (place) scene.add(floor);
    floor.position.copy(place ?? floor.position);
    draws = 0;
    draw(host);
    floor.removeFromParent();
    return draws;
  };
  const counts = {
    alone: drawsWith(undefined),
    above: drawsWith(new Vector3()),
    beside: drawsWith(new Vector3(1.5, 0, 1)),
  };
  dispose(smoke, renderer);
  return counts;
}

/**
 * Pixels that differ if all volumes reach from their puffs through the whole scene, as an invisible object around it makes
 * them do, and pixels in the shadow.
 */
export async function longVolumes(
  parameters: WebGLRendererParameters,
  values: Values = {},
): Promise<{ different: number; dark: number }> {
  const host = furnishedHost(makeRenderer(parameters));
  host.camera.fov = 75;
  host.camera.updateProjectionMatrix();
  const before = draw(host);
  const smoke = await smokeIn(host, { ...SPREAD, ...values });
  const isSmoke = maskOf(host, smoke);
  const short = draw(host);
  host.scene.add(new Mesh(new BoxGeometry(60, 60, 60), UNSEEN));
  const long = draw(host);
  dispose(smoke, host.renderer);
  return {
    different: changedPixels(short, long),
    dark: differences(before, short).filter((difference, pixel) => !isSmoke[pixel] && difference > 0).length,
  };
}
