/** `renderer.clippingPlanes` and smoke: the oracle is the place in the world that a pixel shows, from its depth. */
import {
  DepthStencilFormat,
  DepthTexture,
  FloatType,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  Plane,
  PlaneGeometry,
  Scene,
  ShaderMaterial,
  UnsignedInt248Type,
  Vector3,
  WebGLRenderTarget,
} from 'three';
import type { CartoonSmoke } from '../../../../src/three/cartoonSmoke.ts';
import type { Values } from '../../../../src/parameters/parameter.ts';
import {
  changedPixels,
  dispose,
  draw,
  emptyHost,
  HANGING,
  HEIGHT,
  smokeIn,
  WIDTH,
  type Host,
  type Pixels,
} from '../scene.ts';

/** Two pixels, metres: edges extend by a pixel beyond smoke, with the depth of a neighbour. */
const TOLERANCE = 0.06;

const LOOKS: Readonly<Record<string, Values>> = {
  lobes: {},
  billboards: { 'puff.form': 'billboards', 'style.volumes': 'receiver' },
  strokes: { 'style.strokes': 1 },
  simplified: { 'style.simplify': 0.5 },
};

/** Planes at the place of the smoke, by name. */
const PLANES: Readonly<Record<string, readonly Plane[]>> = {
  side: [new Plane(new Vector3(1, 0, 0.2).normalize(), 0.05)],
  front: [new Plane(new Vector3(0, 0, -1), 0)],
  'slab of three': [
    new Plane(new Vector3(0, 1, 0), -1.05),
    new Plane(new Vector3(0, -1, 0), 1.4),
    new Plane(new Vector3(-1, 0, 0), 0.25),
  ],
  nothing: [new Plane(new Vector3(0, 1, 0), 90)],
};

function floored(): Host {
  const host = emptyHost();
  const floor = new Mesh(new PlaneGeometry(8, 8), new MeshStandardMaterial({ color: '#c08860' }));
  floor.rotation.x = -Math.PI / 2;
  const pane = new Mesh(
    new PlaneGeometry(0.8, 3),
    new MeshBasicMaterial({ color: '#ff2020', transparent: true, opacity: 0.5 }),
  );
  pane.position.set(1.1, 0.7, -0.1);
  host.scene.add(floor, pane);
  return host;
}

export interface Cut {
  name: string;
  /** Pixels that show smoke on the side that is cut off, farther than rounding from the plane. */
  left: number;
  /** Pixels whose smoke was not cut off, and that changed: more than edges are smoothed. */
  changed: number;
  /** Pixels of smoke that are cut off, and of smoke that is left. */
  gone: number;
  kept: number;
  /** Pixels of transparent objects beside smoke that differ from those of the same scene without smoke. */
  others: number;
}

export async function cuts(look: string, scale = 1): Promise<{ results: Cut[]; first: number }> {
  const host = floored();
  // The first frame of all has planes, too.
  host.renderer.clippingPlanes = [...PLANES.side];
  const smoke = await smokeIn(host, { ...HANGING, ...LOOKS[look] });
  smoke.scale.setScalar(scale);
  smoke.step(4);
  await smoke.complete();
  const first = shown(host, smoke).places.filter(Boolean).length;
  const results: Cut[] = [];
  for (const [name, planes] of Object.entries(PLANES)) {
    host.renderer.clippingPlanes = [];
    const whole = shown(host, smoke);
    host.renderer.clippingPlanes = [...planes];
    const cut = shown(host, smoke);
    const isOff = (place: Vector3 | undefined) =>
      place && planes.some((plane) => plane.distanceToPoint(place) < -TOLERANCE * scale);
    const result = { name, left: 0, changed: 0, gone: 0, kept: 0, others: 0 };
    smoke.visible = false;
    const without = draw(host);
    smoke.visible = true;
    for (let pixel = 0; pixel < WIDTH * HEIGHT; pixel++) {
      const [before, after] = [whole.places[pixel], cut.places[pixel]];
      const isSame = [0, 1, 2].every((at) => Math.abs(cut.pixels[4 * pixel + at] - whole.pixels[4 * pixel + at]) < 9);
      if (isOff(after)) result.left++;
      if (before && isOff(before)) result.gone++;
      if (after) result.kept++;
      if (before && after && before.distanceTo(after) < 0.002 * scale && !isSame && !isShadeOf(cut.places, pixel))
        result.changed++;
    }
    result.others = changedPixels(panePixels(without), panePixels(cut.pixels));
    results.push(result);
  }
  dispose(smoke, host.renderer);
  return { results, first };
}

/** Whether a pixel is at the border of the smoke, where edges are smoothed. */
function isShadeOf(places: readonly (Vector3 | undefined)[], pixel: number): boolean {
  const around = [-1, 0, 1].flatMap((row) => [-1, 0, 1].map((column) => pixel + row * WIDTH + column));
  const near = around.map((at) => places[at]);
  return near.some((place) => !place || place.distanceTo(places[pixel]!) > 0.05);
}

interface Shown {
  pixels: Pixels;
  /** The place in the world of the smoke that a pixel shows. */
  places: (Vector3 | undefined)[];
}

/** The picture, and places from the depth of smoke alone. */
function shown(host: Host, smoke: CartoonSmoke): Shown {
  const { camera, renderer } = host;
  const pixels = draw(host);
  const alone = new Scene();
  alone.add(smoke);
  const depthTexture = new DepthTexture(WIDTH, HEIGHT, UnsignedInt248Type);
  depthTexture.format = DepthStencilFormat;
  const target = new WebGLRenderTarget(WIDTH, HEIGHT, { depthTexture, stencilBuffer: true });
  renderer.setRenderTarget(target);
  renderer.render(alone, camera);
  host.scene.add(smoke);
  const depths = new WebGLRenderTarget(WIDTH, HEIGHT, { type: FloatType });
  const reader = new Mesh(
    new PlaneGeometry(2, 2),
    new ShaderMaterial({
      uniforms: { depths: { value: depthTexture } },
      vertexShader: 'void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }',
      fragmentShader: `uniform sampler2D depths;
        void main() { gl_FragColor = vec4(texelFetch(depths, ivec2(gl_FragCoord.xy), 0).r); }`,
    }),
  );
  reader.frustumCulled = false;
  renderer.setRenderTarget(depths);
  renderer.render(reader, camera);
  const numbers = new Float32Array(4 * WIDTH * HEIGHT);
  renderer.readRenderTargetPixels(depths, 0, 0, WIDTH, HEIGHT, numbers);
  renderer.setRenderTarget(null);
  const world = new Matrix4().multiplyMatrices(camera.matrixWorld, camera.projectionMatrixInverse);
  const places = Array.from({ length: WIDTH * HEIGHT }, (_, pixel) => {
    const depth = numbers[4 * pixel];
    if (depth === 1) return undefined;
    const [x, y] = [((pixel % WIDTH) + 0.5) / WIDTH, (Math.floor(pixel / WIDTH) + 0.5) / HEIGHT];
    return new Vector3(2 * x - 1, 2 * y - 1, 2 * depth - 1).applyMatrix4(world);
  });
  dispose(target, depths, reader.geometry, reader.material);
  return { pixels, places };
}

/** Pixels of the pane. */
const panePixels = (pixels: Pixels) => pixels.filter((_, at) => (at / 4) % WIDTH > 0.75 * WIDTH);

/** The picture with planes, to look at. */
export async function picture(look: string, planes: string): Promise<number[]> {
  const host = floored();
  const smoke = await smokeIn(host, { ...HANGING, ...LOOKS[look] });
  await smoke.complete();
  host.renderer.clippingPlanes = [...PLANES[planes]];
  const pixels = draw(host);
  dispose(smoke, host.renderer);
  return [...pixels];
}
