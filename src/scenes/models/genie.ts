/** The solid parts of the genie: head, turban and hands. Metres, about the centre of the chest, which faces +z. */
import type { Color } from '../../renderer/gpu/ramps.ts';
import type { TriangleMesh } from '../../renderer/passes/extrusion.ts';
import type { SurfaceDescription } from '../../renderer/passes/surface.ts';
import { cos, sin } from '../../simulator/exact/sine.ts';
import type { Vector } from '../scene.ts';
import { ballMesh } from './ball.ts';
import { lathe, pipe } from './lathe.ts';
import { merged, placed } from './place.ts';

const SKIN: Color = [112, 186, 228];
const DARK: Color = [44, 40, 84];
const WHITE: Color = [255, 250, 240];
const GOLD: Color = [250, 198, 78];
const SILK: Color = [250, 226, 196];
const RUBY: Color = [226, 70, 96];
const CHEEK: Color = [236, 132, 158];

/** Centre of the head, and its radius. */
export const HEAD: Vector = [0, 0.72, 0.06];
export const HEAD_RADIUS = 0.42;
/** Positions of the shoulder at +x and of both wrists: one hand on the hip, the other one waving. */
export const SHOULDER: Vector = [0.46, 0.2, 0];
export const HIP: Vector = [-0.62, -0.42, 0.3];
export const WAVE: Vector = [0.98, 0.46, 0.22];

/**
 * @param rigid index of the rigid that carries the genie
 * @param hand index of the part that waves, about its wrist
 */
export function genie(rigid: number, hand: number): SurfaceDescription[] {
  const look = { casts: true, inked: true, rigid };
  const quiet = { ...look, casts: false };
  const flat = { ...quiet, inked: false };
  return [
    { name: 'head', mesh: head(), color: SKIN, ...look, group: 'head' },
    { name: 'ears', mesh: both(ear), color: SKIN, ...look, group: 'head' },
    { name: 'rings', mesh: both(earring), color: GOLD, ...quiet },
    { name: 'whites', mesh: both(white), color: WHITE, ...quiet, group: 'eyes' },
    { name: 'pupils', mesh: both(pupil), color: DARK, ...flat, group: 'eyes' },
    { name: 'brows', mesh: both(brow), color: DARK, ...flat },
    { name: 'nose', mesh: onHead(ballMesh(1, 12), [0, -0.04, 0.42], [0.085, 0.075, 0.085]), color: SKIN, ...quiet },
    { name: 'smile', mesh: smile(), color: DARK, ...flat },
    { name: 'teeth', mesh: teeth(), color: WHITE, ...flat },
    { name: 'cheeks', mesh: both(cheek), color: CHEEK, ...flat },
    { name: 'beard', mesh: beard(), color: DARK, ...quiet },
    { name: 'turban', mesh: turban(), color: SILK, ...look, group: 'turban' },
    { name: 'feather', mesh: feather(), color: RUBY, ...look },
    { name: 'jewel', mesh: onHead(ballMesh(1, 12), [0, 0.37, 0.4], [0.075, 0.1, 0.06]), color: RUBY, ...quiet },
    { name: 'fist', mesh: placed(mitten(-1), { at: HIP, angles: [0, 0.4, 0.7] }), color: SKIN, ...look },
    { name: 'cuff', mesh: placed(cuff(), { at: HIP, angles: [0, 0.4, 0.7] }), color: GOLD, ...quiet },
    { name: 'hand', mesh: openHand(), color: SKIN, casts: true, inked: true, part: hand, group: 'hand' },
    { name: 'bangle', mesh: cuff(), color: GOLD, casts: false, inked: true, part: hand },
  ];
}

function onHead(
  mesh: TriangleMesh,
  [x, y, z]: Vector,
  scale: Vector = [1, 1, 1],
  angles: Vector = [0, 0, 0],
): TriangleMesh {
  return placed(mesh, { at: [HEAD[0] + x, HEAD[1] + y, HEAD[2] + z], scale, angles });
}

function both(make: (side: 1 | -1) => TriangleMesh): TriangleMesh {
  return merged(make(1), make(-1));
}

/** Round, with a strong chin. */
function head(): TriangleMesh {
  return merged(
    onHead(ballMesh(HEAD_RADIUS, 24), [0, 0.02, 0], [0.94, 1, 0.94]),
    onHead(ballMesh(1, 20), [0, -0.2, 0.04], [0.34, 0.26, 0.34]),
  );
}

function ear(side: 1 | -1): TriangleMesh {
  return onHead(ballMesh(1, 12), [side * 0.41, -0.02, 0], [0.07, 0.12, 0.06], [0, 0, -0.3 * side]);
}

function earring(side: 1 | -1): TriangleMesh {
  return onHead(ballMesh(0.05, 10), [side * 0.44, -0.17, 0.02]);
}

function white(side: 1 | -1): TriangleMesh {
  return onHead(ballMesh(1, 14), [side * 0.14, 0.08, 0.345], [0.1, 0.12, 0.06], [0, 0.35 * side, 0]);
}

function pupil(side: 1 | -1): TriangleMesh {
  return onHead(ballMesh(1, 10), [side * 0.12, 0.07, 0.395], [0.045, 0.06, 0.03], [0, 0.3 * side, 0]);
}

function brow(side: 1 | -1): TriangleMesh {
  return onHead(ballMesh(1, 10), [side * 0.17, 0.245, 0.35], [0.12, 0.032, 0.05], [0, 0.4 * side, -0.22 * side]);
}

function cheek(side: 1 | -1): TriangleMesh {
  return onHead(ballMesh(1, 10), [side * 0.26, -0.08, 0.29], [0.07, 0.05, 0.04], [0, 0.7 * side, 0]);
}

function smile(): TriangleMesh {
  return onHead(ballMesh(1, 16), [0, -0.2, 0.32], [0.19, 0.1, 0.08], [0.25, 0, 0]);
}

function teeth(): TriangleMesh {
  return onHead(ballMesh(1, 12), [0, -0.165, 0.36], [0.14, 0.04, 0.06], [0.25, 0, 0]);
}

/** A pointed tuft that curls to the front. */
function beard(): TriangleMesh {
  const tuft = pipe(
    12,
    [[0, 0], [0.02, -0.12], [0.1, -0.22], [0.22, -0.24], [0.27, -0.16]],
    [[0, 0], [0.1, 0.02]],
    [[0.1, 0.02], [0.11, 0.25], [0.06, 0.7], [0, 1]],
  ); // prettier-ignore
  return onHead(tuft, [0, -0.36, 0.24], [1, 1, 1], [0, -Math.PI / 2, 0]);
}

/** Bands of cloth, smaller towards the top. */
function turban(): TriangleMesh {
  const band = (y: number, radius: number, height: number, lean: number) =>
    onHead(ballMesh(1, 20), [0, y, -0.03], [radius, height, radius], [0.1, 0, lean]);
  return merged(
    band(0.36, 0.47, 0.14, 0.08),
    band(0.47, 0.43, 0.15, -0.12),
    band(0.58, 0.33, 0.15, 0.1),
    band(0.68, 0.18, 0.12, 0),
  );
}

function feather(): TriangleMesh {
  const plume = pipe(
    12,
    [[0, 0], [-0.02, 0.16], [0.03, 0.32], [0.15, 0.42], [0.27, 0.38]],
    [[0, 0], [0.03, 0.01]],
    [[0.03, 0.01], [0.09, 0.35], [0.085, 0.75], [0, 1]],
  ); // prettier-ignore
  return onHead(plume, [0, 0.42, 0.38], [1, 1, 0.5], [0.15, 0.2, 0]);
}

/** A hand about its wrist; the arm joins from below. */
function mitten(side: 1 | -1): TriangleMesh {
  return merged(
    placed(ballMesh(1, 14), { at: [0, 0.15, 0], scale: [0.15, 0.15, 0.13] }),
    placed(ballMesh(1, 10), { at: [side * 0.12, 0.12, 0.06], scale: [0.09, 0.055, 0.055] }),
  );
}

function openHand(): TriangleMesh {
  const finger = (index: number) => {
    const lean = 0.42 - 0.32 * index;
    return placed(ballMesh(1, 10), {
      at: [-0.42 * sin(lean) * 0.8, 0.34 * cos(lean), 0],
      scale: [0.052, 0.13, 0.055],
      angles: [0, 0, lean],
    });
  };
  const thumb = placed(ballMesh(1, 10), { at: [-0.17, 0.14, 0.03], scale: [0.11, 0.052, 0.055], angles: [0, 0, -0.5] });
  return merged(
    placed(ballMesh(1, 14), { at: [0, 0.16, 0], scale: [0.15, 0.14, 0.1] }),
    thumb,
    ...[0, 1, 2].map(finger),
  );
}

function cuff(): TriangleMesh {
  const outline = lathe(20, [[0, -0.09], [0.13, -0.09]], [[0.13, -0.09], [0.155, -0.03], [0.155, 0.03], [0.13, 0.06]], [[0.13, 0.06], [0, 0.06]]); // prettier-ignore
  return outline;
}
