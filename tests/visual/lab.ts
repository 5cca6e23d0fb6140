/**
 * A lab for pictures: draws given puffs and surfaces with the production passes, without a simulator, and reads back
 * colours and stencil counts. Runs inside a page.
 */
import {
  type Camera,
  type DataTexture,
  EqualStencilFunc,
  Matrix4,
  PerspectiveCamera,
  Vector3,
  WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';
import { finished } from '../../src/base/work.ts';
import { bakingPuffs } from '../../src/renderer/bakedPuffs.ts';
import { createDevice, Device } from '../../src/renderer/gpu/device.ts';
import { ADDS, FullScreen } from '../../src/renderer/gpu/fullScreen.ts';
import type { Color } from '../../src/renderer/gpu/ramps.ts';
import type { DebugView } from '../../src/parameters/quality.ts';
import type { SurfaceDescription } from '../../src/renderer/passes/surface.ts';
import { LOBE_SHAPES } from '../../src/renderer/puffs/lobeShapes.ts';
import type { PuffShape } from '../../src/renderer/puffs/shapes.ts';
import { ATTRIBUTE_BITS, ATTRIBUTE_WORDS, NO_END, PLACE_FLOATS, TEMPERATURE_MAX } from '../../src/simulator/layout.ts';
import type { Rows } from '../../src/simulator/rows.ts';
import { fetchExtras } from '../../src/renderer/extraPasses.ts';
import { drawFrame } from '../../src/renderer/frame.ts';
import type { Arranger, FrameInput } from '../../src/renderer/frameInput.ts';
import type { Falloff, Light } from '../../src/renderer/light.ts';
import { drawnSurfaces } from '../../src/renderer/sceneSurfaces.ts';
import { SmokeRenderer } from '../../src/renderer/smoke.ts';
import { styleOf, type Style } from '../../src/renderer/style.ts';
import { defaults } from '../../src/parameters/values.ts';
import { fitDevice, keepPrograms, pageDevice } from './pageDevice.ts';

// Tests read pictures synchronously, so load all optional renderer code first.
await fetchExtras({
  renderer: 'selle',
  form: 'billboards',
  isDeformed: false,
  volumes: 'counted',
  simplify: 0,
  plumeForm: 0,
  outlines: true,
  strokes: 0,
  isEroded: true,
  view: 'normals',
  isTiled: true,
});
await fetchExtras({
  renderer: 'nailboards',
  form: 'lobes',
  isDeformed: false,
  volumes: 'receiver',
  simplify: 1,
  plumeForm: 0,
  outlines: true,
  strokes: 1,
  isEroded: false,
  lampLight: [1, 1, 1],
  hasAdditionalLights: true,
  pattern: 'dots',
});

/** A particle in test units: lengths in metres, roll in radians, age as a fraction of the lifetime. */
export interface LabPuff {
  place: readonly [number, number, number];
  radius: number;
  roll?: number;
  variation?: number;
  /** 0 to 15. */
  tint?: number;
  /** Index of its look, 0 to 15. */
  look?: number;
  /** 0 to 255. */
  seed?: number;
  age?: number;
  /** 0 to 4. */
  temperature?: number;
  /** 0 to 1. */
  erosion?: number;
  /** Packed fields of its turn and its stretch. */
  deformation?: Partial<Record<Deformation, number>>;
}

type Deformation =
  'quaternionX' | 'quaternionY' | 'quaternionZ' | 'quaternionLargest' | 'stretchU' | 'stretchV' | 'stretch';

export interface LabScene {
  width: number;
  height: number;
  puffs: readonly LabPuff[];
  /** Shapes by variation; the default ones where absent. */
  shapes?: readonly PuffShape[];
  /** Shadow casters; the puffs where absent. */
  casters?: readonly LabPuff[];
  surfaces?: readonly SurfaceDescription[];
  /** World transforms of rigids and parts, by number; rigids are at the origin where absent. */
  rigids?: readonly Matrix4[];
  parts?: readonly Matrix4[];
  backdrop?: { top: Color; bottom: Color };
  camera?: Camera;
  towardsLight?: readonly [number, number, number];
  /** Draws with a reversed depth buffer, as the host's renderer may have. */
  reversedDepth?: boolean;
  /** Position of a lamp, instead of a sun, and how it weakens where the style has `lampLight`. */
  lamp?: readonly [number, number, number];
  falloff?: Falloff;
  style?: Partial<Style>;
  pixelRatio?: number;
  /** Simulated seconds. */
  time?: number;
  smoothEdges?: boolean;
  /** Debug view to draw instead of the picture. */
  view?: DebugView;
  /** Also counts the shadow volumes at each pixel. */
  readCounts?: boolean;
}

export const PLAIN_STYLE: Style = {
  ...styleOf(defaults()),
  renderer: 'nailboards',
  form: 'lobes',
  shading: true,
  outlines: true,
  creases: false,
  shadows: true,
  volumes: 'receiver',
  shadowSteps: 1,
  shadowDepth: 6,
  deepShadow: [160, 150, 200],
  gradient: 'none',
  gradientColor: [128, 128, 128],
  gradientHeights: [-1, 1],
  stops: [],
  isBlended: false,
  fill: 0,
  rim: 0,
  rimColor: [255, 246, 216],
  ageColors: [],
  heatColors: [],
  softColors: false,
  outlineWidth: 2,
  inkSwell: 0,
  boil: 0,
  innerLine: 0.5,
  innerTaper: 0,
  tones: 2,
  smokeColor: [240, 236, 224],
  tints: [
    [240, 138, 93],
    [127, 178, 229],
    [143, 207, 122],
  ],
  inkColor: [27, 26, 46],
  wash: undefined,
};

/** RGBA bytes, bottom row first, and optionally the stencil count of each pixel. */
export interface LabPicture {
  width: number;
  height: number;
  pixels: Uint8Array;
  counts: Uint8Array;
}

/** Packs puffs in the simulator's row format. */
export function rowsOf(puffs: readonly LabPuff[]): Rows {
  const place = new Float32Array(PLACE_FLOATS * puffs.length);
  const attributes = new Uint32Array(ATTRIBUTE_WORDS * puffs.length);
  const isEroded = ({ erosion = 0 }: LabPuff) => erosion > 0;
  const whole = puffs.filter((puff) => !isEroded(puff));
  [...whole, ...puffs.filter(isEroded)].forEach((puff, index) => {
    const rotation = (puff.roll ?? 0) / (2 * Math.PI);
    place.set([...puff.place, puff.radius], PLACE_FLOATS * index);
    const fields: Partial<Record<keyof typeof ATTRIBUTE_BITS, number>> = {
      ...puff.deformation,
      roll: Math.round((rotation - Math.floor(rotation)) * (ATTRIBUTE_BITS.roll.max + 1)),
      age: Math.round((puff.age ?? 0) * ATTRIBUTE_BITS.age.max),
      variation: puff.variation ?? 0,
      seed: puff.seed ?? 0,
      temperature: Math.round(((puff.temperature ?? 0) / TEMPERATURE_MAX) * ATTRIBUTE_BITS.temperature.max),
      tint: puff.tint ?? 0,
      look: puff.look ?? 0,
      erosion: Math.round((puff.erosion ?? 0) * ATTRIBUTE_BITS.erosion.max),
    };
    for (const [name, value] of Object.entries(fields)) {
      const { word, shift, max } = ATTRIBUTE_BITS[name as keyof typeof ATTRIBUTE_BITS];
      attributes[ATTRIBUTE_WORDS * index + word] |= (value & max) << shift;
    }
  });
  return { count: puffs.length, whole: whole.length, place, attributes };
}

/** The same rows as casters with unlimited shadow length. */
function castersOf(puffs: readonly LabPuff[]): Rows {
  const rows = rowsOf(puffs);
  const { attributes } = rows;
  for (let word = 0; word < attributes.length; word += ATTRIBUTE_WORDS) {
    attributes[word + 1] = (attributes[word + 1] & 0xffff) | (attributes[word] & 0xffff0000);
    attributes[word] |= NO_END;
  }
  return rows;
}

/** The camera of most tests: 4 m in front of the origin, looking along -z. */
export function frontCamera(width: number, height: number, distance = 4, fieldOfView = 40): PerspectiveCamera {
  const camera = new PerspectiveCamera(fieldOfView, width / height, 0.1, 100);
  camera.position.set(0, 0, distance);
  camera.updateMatrixWorld();
  return camera;
}

/** Draws one picture. */
export function takePicture(scene: LabOptions): LabPicture {
  const lab = new Lab(scene);
  try {
    return lab.draw(scene);
  } finally {
    lab.dispose();
  }
}

/** All scenes of a lab share these options. */
export interface LabOptions extends LabScene {
  /** Largest number of puffs in any scene, if larger than in this one. */
  capacity?: number;
  /** Sides of each variation of billboards, default 1. In rows a variation is variation * sides + side. */
  sides?: number;
  /** Draws as on a device that ignores fragment depth. */
  failsSelfTest?: boolean;
}

/** Draws many pictures with the same size, surfaces and backdrop. */
export class Lab {
  private readonly device: Device;
  private readonly smoke: SmokeRenderer;

  constructor(options: LabOptions) {
    const { puffs, casters = [], surfaces = [], backdrop, capacity = 1 } = options;
    this.device = deviceFor(options);
    const max = Math.max(capacity, puffs.length, casters.length);
    const baked = finished(bakingPuffs(options.shapes ?? LOBE_SHAPES, { sides: options.sides }));
    const drawn = { surfaces: drawnSurfaces(surfaces), backdrop };
    this.smoke = new SmokeRenderer(this.device, { capacity: max, ...drawn, puffs: baked });
  }

  /** The WebGL error since the last call; 0 for none. */
  get error(): number {
    return this.device.renderer.getContext().getError();
  }

  /** The ramp texture. */
  get ramps(): DataTexture {
    return this.smoke.passes.body.material.uniforms.ramps.value as DataTexture;
  }

  /** Draw calls of the latest picture. */
  get calls(): number {
    return this.device.renderer.info.render.calls;
  }

  draw(scene: LabScene): LabPicture {
    return this.drawFrame(inputOf(scene), scene);
  }

  /** Draws a complete frame input, such as one with the rows of a real simulator. */
  drawFrame(input: FrameInput, options: Pick<LabScene, 'smoothEdges' | 'readCounts'> = {}): LabPicture {
    const { width, height } = input;
    this.smoke.passes.resolve.smoothEdges = options.smoothEdges ?? false;
    fitDevice(this.device, width, height);
    drawFrame(this.smoke, input);
    keepPrograms(this.device.renderer);
    const pixels = new Uint8Array(4 * width * height);
    const gl = this.device.renderer.getContext();
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return {
      width,
      height,
      pixels,
      counts: options.readCounts ? countsOf(this.device, this.smoke, input) : new Uint8Array(0),
    };
  }

  dispose(): void {
    this.smoke.dispose();
  }
}

function deviceFor({ reversedDepth, failsSelfTest }: LabOptions): Device {
  if (reversedDepth) return pageDevice('reversed depth', reversedDevice);
  if (!failsSelfTest) return pageDevice();
  return pageDevice('fails self test', () => createDevice(new OffscreenCanvas(1, 1), { failsSelfTest }));
}

function reversedDevice(): Device {
  const renderer = new WebGLRenderer({ canvas: new OffscreenCanvas(1, 1), depth: false, reversedDepthBuffer: true });
  renderer.autoClear = false;
  renderer.sortObjects = false;
  if (!renderer.state.buffers.depth.getReversed()) throw new Error('This context cannot reverse its depth.');
  return new Device(renderer, true);
}

export function inputOf(scene: LabScene): FrameInput {
  return {
    simulator: fixedRows(scene.puffs, scene.casters ?? scene.puffs),
    camera: scene.camera ?? frontCamera(scene.width, scene.height),
    light: lightOf(scene),
    style: { ...PLAIN_STYLE, ...scene.style },
    blend: 1,
    width: scene.width,
    height: scene.height,
    pixelRatio: scene.pixelRatio ?? 1,
    time: scene.time,
    rigids: scene.rigids ?? (scene.surfaces ?? []).map(() => new Matrix4()),
    parts: scene.parts,
    cull: false,
    view: scene.view,
    output: null,
  };
}

function lightOf({ lamp, falloff, towardsLight = [0.5, 0.7, 0.5] }: LabScene): Light {
  if (lamp) return { kind: 'lamp', place: new Vector3(...lamp), falloff };
  return { kind: 'sun', towards: new Vector3(...towardsLight).normalize() };
}

function fixedRows(puffs: readonly LabPuff[], casters: readonly LabPuff[]): Arranger {
  const all = [...puffs, ...casters];
  const extreme = (axis: 0 | 1 | 2, sign: 1 | -1) =>
    sign * Math.max(...all.map(({ place, radius }) => sign * place[axis] + radius));
  const bounds = {
    min: [extreme(0, -1), extreme(1, -1), extreme(2, -1)],
    max: [extreme(0, 1), extreme(1, 1), extreme(2, 1)],
    greatestRadius: Math.max(0, ...all.map(({ radius }) => radius)),
  } as const;
  return {
    arrange: ({ purpose }) => ({
      rows: purpose === 'eye' ? rowsOf(puffs) : castersOf(casters),
      bounds,
      grid: undefined,
    }),
    moves: () => new Float32Array(3 * puffs.length),
  };
}

/** Number of shadow volumes that contain the place at each pixel; only this view counts all of them. */
export function countsOf(device: Device, smoke: SmokeRenderer, input: FrameInput): Uint8Array {
  drawFrame(smoke, { ...input, view: 'counts' });
  return readStencil(device, smoke.passes.targets.renderTarget);
}

/** Reads the stencil, which WebGL cannot read directly: one draw call per bit writes it as a colour. */
function readStencil({ renderer }: Device, target: WebGLRenderTarget): Uint8Array {
  const value = { value: 0 };
  const triangle = new FullScreen(
    `precision highp float;
      uniform float value;
      layout(location = 0) out vec4 first;
      layout(location = 1) out vec4 second;
      void main() { first = vec4(value / 255.0); second = first; }`,
    { value },
    { ...ADDS, stencilWrite: true, stencilFunc: EqualStencilFunc, stencilRef: 255 },
  );
  renderer.setRenderTarget(target);
  renderer.clear(true, false, false);
  for (let bit = 1; bit < 256; bit *= 2) {
    value.value = bit;
    triangle.material.stencilFuncMask = bit;
    triangle.draw(renderer);
  }
  const { width, height } = target;
  const pixels = new Uint8Array(4 * width * height);
  renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels);
  triangle.dispose();
  return pixels.filter((_, index) => index % 4 === 0);
}

/** Pixels as an image; WebGL returns the bottom row first. */
export function upright(pixels: Uint8Array, width: number, height: number): ImageData {
  const image = new ImageData(width, height);
  for (let row = 0; row < height; ++row) {
    const from = 4 * width * (height - 1 - row);
    image.data.set(pixels.subarray(from, from + 4 * width), 4 * width * row);
  }
  return image;
}

/** The bytes of a file in base64. */
export async function base64(blob: Blob): Promise<string> {
  const bytes = new Uint8Array(await blob.arrayBuffer());
  return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
}
