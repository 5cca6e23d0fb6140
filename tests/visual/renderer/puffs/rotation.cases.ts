/**
 * Puffs rotate by small angles while time is stopped: the change of the picture, and its difference from the reference.
 */
import { FloatType, PerspectiveCamera, WebGLRenderTarget } from 'three';
import attributesChunk from '../../../../shaders/lib/attributes.glsl';
import orientationChunk from '../../../../shaders/lib/orientation.glsl';
import { SEEDS } from '../../../../src/base/constants.ts';
import { createDevice } from '../../../../src/renderer/gpu/device.ts';
import { FullScreen } from '../../../../src/renderer/gpu/fullScreen.ts';
import { orientationOf } from '../../../../src/renderer/puffs/orientation.ts';
import type { Drawn } from '../../../support/reference.ts';
import { describe } from '../../description.ts';
import { inputOf, Lab, takePicture, type LabPicture, type LabPuff, type LabScene } from '../../lab.ts';

export type RotationKind = 'orbit' | 'roll';

/** Share of the smoke's pixels that change between two pictures. */
export interface RotationReport {
  /** Maximum and mean of all steps. */
  largest: number;
  mean: number;
  /** Smallest number of pixels that smoke covers. */
  covered: number;
}

const SIZE = 200;
const TOWARDS_LIGHT = [0.5, 0.8, 0.6] as const;
/** Two intersecting puffs: their seam shows depth, three tones show normals, and there are inner and outer lines. */
const PUFFS: readonly LabPuff[] = [
  { place: [-0.25, 0.05, 0.1], radius: 0.7, variation: 0, seed: 90, roll: 2 },
  { place: [0.4, -0.1, -0.15], radius: 0.6, variation: 1, seed: 17, roll: 5, tint: 1 },
];

/** Rotates the camera around the puffs, or each puff around its own axis. */
export function rotating(by: RotationKind, degrees: number, steps: number): RotationReport {
  const lab = new Lab(sceneAt(by, 0));
  const report = { largest: 0, mean: 0, covered: Infinity };
  let before = lab.draw(sceneAt(by, 0));
  for (let step = 1; step <= steps; step++) {
    const now = lab.draw(sceneAt(by, step * degrees));
    const covered = now.pixels.filter((value, index) => index % 4 === 3 && value > 0).length;
    const share = differing(before, now) / covered;
    report.largest = Math.max(report.largest, share);
    report.mean += share / steps;
    report.covered = Math.min(report.covered, covered);
    before = now;
  }
  lab.dispose();
  return report;
}

/** A picture at an angle, for comparison with the reference. */
export function rotated(by: RotationKind, degrees: number): Drawn {
  const scene = { ...sceneAt(by, degrees), readCounts: true };
  const { pixels, counts } = takePicture(scene);
  return {
    description: describe({ input: inputOf(scene), surfaces: [] }),
    pixels: base64(pixels),
    counts: base64(counts),
  };
}

/** One pixel for each column of a rotation: seeds and columns from left to right, rolls from bottom to top. */
const COLUMNS_OF_ROTATIONS = `
precision highp float;
precision highp int;
out vec4 pixel;
${attributesChunk}
${orientationChunk}
void main() {
  uvec2 at = uvec2(gl_FragCoord.xy);
  pixel = vec4(worldFromPuff(uvec4(at.y * 4096u, (at.x / 3u) << 8u, 0u, 0u))[at.x % 3u], 0.0);
}`;
const ROLLS = 16;

/** The largest difference of an element between the rotations of shader and CPU, over all seeds and 16 rolls. */
export function differenceOfRotations(): number {
  const device = createDevice(new OffscreenCanvas(1, 1));
  const target = new WebGLRenderTarget(3 * SEEDS, ROLLS, { type: FloatType, depthBuffer: false });
  const shown = new FullScreen(COLUMNS_OF_ROTATIONS, {});
  device.renderer.getContext().getExtension('EXT_color_buffer_float');
  device.renderer.setRenderTarget(target);
  shown.draw(device.renderer);
  const found = new Float32Array(4 * 3 * SEEDS * ROLLS);
  device.renderer.readRenderTargetPixels(target, 0, 0, 3 * SEEDS, ROLLS, found);
  for (const part of [target, shown, device]) part.dispose();
  const differences = Array.from({ length: SEEDS * ROLLS }, (_, each) => {
    const [seed, roll] = [each % SEEDS, Math.floor(each / SEEDS)];
    const expected = orientationOf(seed, (roll / ROLLS) * 2 * Math.PI).flat();
    const first = 3 * (roll * SEEDS + seed);
    return expected.map((value, at) => Math.abs(value - found[4 * (first + Math.floor(at / 3)) + (at % 3)]));
  });
  return Math.max(...differences.flat());
}

function sceneAt(by: RotationKind, degrees: number): LabScene {
  const angle = (degrees * Math.PI) / 180;
  const puffs = by === 'orbit' ? PUFFS : PUFFS.map((puff) => ({ ...puff, roll: puff.roll! + angle }));
  const camera = new PerspectiveCamera(32, 1, 0.1, 50);
  const azimuth = by === 'orbit' ? angle : 0;
  camera.position.set(4 * Math.sin(azimuth), 1, 4 * Math.cos(azimuth));
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  return { width: SIZE, height: SIZE, puffs, camera, towardsLight: TOWARDS_LIGHT, style: { tones: 3, innerLine: 0.3 } };
}

function differing(a: LabPicture, b: LabPicture): number {
  const [from, to] = [a, b].map(({ pixels }) => new Uint32Array(pixels.buffer));
  return from.reduce((count, pixel, index) => count + (pixel === to[index] ? 0 : 1), 0);
}

function base64(bytes: Uint8Array): string {
  let text = '';
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text);
}
