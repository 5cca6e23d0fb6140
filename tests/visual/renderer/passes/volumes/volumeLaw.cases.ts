/** The values of shadow volumes in the shader, in TypeScript and in Rust, which has written them to a file. */
import { DoubleSide, FloatType, GLSL3, PerspectiveCamera, RawShaderMaterial, Vector3, WebGLRenderTarget } from 'three';
import volumeFrame from '../../../../../shaders/lib/volumeFrame.glsl';
import { NEAREST_LAMP } from '../../../../../src/base/constants.ts';
import {
  BeamSpan,
  growthOf,
  hasFullSize,
  latestStart,
  radiusOf,
} from '../../../../../src/renderer/passes/shadowVolume.ts';
import { farthestCorner } from '../../../../../src/renderer/passes/tiledVolumes/volumeBalls.ts';
import { NO_END } from '../../../../../src/simulator/layout.ts';
import { Lab, rowsOf, type LabScene } from '../../../lab.ts';
import { box } from '../../../solids.ts';
import written from './volumes.txt?raw';

const SIZE = 128;
/** As in sim-wasm/sim/src/arrange/coverage/outline.rs. */
const SHAPES = [{ name: 'lobe', lobes: [{ center: [0.3, -0.2, 0.25], radius: 0.7 }] }] as const;
const DEPTH = 0.8;

const FRAGMENT = `precision highp float;
  #define VOLUME flat in
  ${volumeFrame.replaceAll('LOBES', '1')}
  layout(location = 0) out vec4 values[4];
  void main() {
    values[0] = rightAndLength;
    values[1] = upAndScale;
    values[2] = eyeAndGrowth;
    values[3] = vec4(discs[0], 0.0);
  }`;

/** Pairs of values that should be the same, by what they are, for each puff. */
export type Compared = Record<string, [found: number, expected: number]>;

export interface LawReport {
  pairs: Compared[];
  /** Starts beyond their bound, in radii, and puffs smaller than their full size. */
  late: number;
  small: number;
}

export function compareLaw(): LawReport {
  const lines = written
    .trim()
    .split('\n')
    .map((line) => line.split(' ').map(Number));
  const lab = new Lab({ ...sceneOf([1, 0, 0, 0]), capacity: 1 });
  const report: LawReport = { pairs: [], late: 0, small: 0 };
  for (const line of lines) compare(lab, line, report);
  lab.dispose();
  return report;
}

function compare(lab: Lab, line: readonly number[], report: LawReport): void {
  const [x, y, z, radius, roll, seed, ...rest] = line;
  const [light, [drawn, growth, across, away, disc, start]] = [rest.slice(0, 4), rest.slice(4)];
  const scene = sceneOf(light);
  const puff = { place: [x, y, z], radius, roll: (roll / 65536) * 2 * Math.PI, seed } as const;
  lab.draw(scene);
  const found = volumeOf(lab, puff);

  const { passes } = lab['smoke'];
  const { eye, volumes } = passes;
  const extents = passes.extentsOf('lobes');
  const { lightInWorld, receiversMin, receiversMax } = eye.uniforms;
  const place = new Vector3(x, y, z);
  const travel = eye.travelAt(place);
  const begin = -found.eye[2] - place.dot(travel) / found.drawn;
  const ball = extents.reach * found.drawn;
  const distance = light[3] ? place.distanceTo(new Vector3(...light)) : Infinity;
  const metric = growthOf(distance, ball);
  const span = new BeamSpan();
  const widest = found.drawn * (Math.hypot(found.disc[0], found.disc[1]) + Math.sqrt(found.disc[2]));
  const limits = [...receiversMin.value, ...receiversMax.value];
  span.find(limits, [x, y, z], 0, travel.toArray(), widest, (widest * found.growth) / found.drawn);
  const corner = farthestCorner(lightInWorld.value, receiversMin.value, receiversMax.value) - distance;

  if (distance < NEAREST_LAMP * ball) throw new Error('A lamp is too near for this comparison.');
  report.pairs.push({
    'drawn radius in Rust': [found.drawn, drawn],
    'full size in TypeScript': [Number(hasFullSize(eye, place, radius)), Number(drawn === radius)],
    'growth in Rust': [found.growth, growth],
    'growth in TypeScript': [found.growth, metric * found.drawn],
    'ball in TypeScript and Rust': [radiusOf(ball, metric) / found.drawn, across],
    'place of the disc in Rust': [Math.hypot(found.disc[0], found.disc[1]), away],
    'radius of the disc in Rust': [Math.sqrt(found.disc[2]), disc],
    'start in Rust': [begin, volumes.minCap + start],
    'scale at the start': [found.scale, 1 + begin * growth],
    'end in TypeScript': [(found.length + begin) * found.drawn, Math.min(span.exit, light[3] ? corner : Infinity)],
  });
  if (begin > latestStart(eye, travel, extents, volumes.minCap)) report.late++;
  if (drawn < radius) report.small++;
}

function sceneOf([x, y, z, isLamp]: readonly number[]): LabScene {
  const light = isLamp ? { lamp: [x, y, z] as const } : { towardsLight: [x, y, z] as const };
  const floor = {
    name: 'floor',
    mesh: box([0, -3, -2], [6, 0.5, 6]),
    color: [200, 200, 200],
    casts: false,
    inked: false,
  } as const;
  // A ramp that is lighter from the start, so that all volumes start at one distance.
  const stops = [
    { from: 0, color: [50, 50, 50] },
    { from: 0.1, color: [200, 200, 200] },
  ] as const;
  const camera = new PerspectiveCamera((2 * Math.atan(0.5) * 180) / Math.PI, 1, 0.1, 100);
  return {
    width: SIZE,
    height: SIZE,
    puffs: [],
    shapes: SHAPES,
    surfaces: [floor],
    camera,
    style: { stops },
    ...light,
  };
}

/** What the vertex shader computes of a puff. */
function volumeOf(lab: Lab, puff: Parameters<typeof rowsOf>[0][0]) {
  const { renderer, casters, volumes } = lab['smoke'].passes;
  const rows = rowsOf([puff]);
  rows.attributes[0] |= NO_END;
  casters.fill(rows);
  volumes['form'].depth.value = DEPTH;
  const { vertexShader, uniforms } = volumes.material;
  const material = new RawShaderMaterial({
    vertexShader,
    fragmentShader: FRAGMENT,
    uniforms,
    glslVersion: GLSL3,
    side: DoubleSide,
    depthTest: false,
    depthWrite: false,
  });
  const target = new WebGLRenderTarget(SIZE, SIZE, { count: 4, type: FloatType, depthBuffer: false });
  renderer.setRenderTarget(target);
  renderer.clear();
  volumes.drawAs(renderer, material, casters.geometry);
  const read = (index: number) => {
    const values = new Float32Array(4 * SIZE * SIZE);
    renderer.readRenderTargetPixels(target, 0, 0, SIZE, SIZE, values, undefined, index);
    return values;
  };
  const scales = read(1);
  const pixel = scales.findIndex((value, at) => at % 4 === 3 && value !== 0) - 3;
  const [right, up, eye, disc] = [0, 1, 2, 3].map((index) => read(index).slice(pixel, pixel + 4));
  renderer.setRenderTarget(null);
  material.dispose();
  target.dispose();
  return {
    drawn: 1 / new Vector3(...right).length(),
    length: right[3],
    scale: up[3],
    eye,
    growth: eye[3],
    disc,
  };
}
