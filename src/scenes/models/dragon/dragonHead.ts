/** The head of the dragon, about the top of its neck, facing +x. Metres. */
import type { Color } from '../../../renderer/gpu/ramps.ts';
import type { TriangleMesh } from '../../../renderer/passes/extrusion.ts';
import type { SurfaceDescription } from '../../../renderer/passes/surface.ts';
import type { Vector } from '../../scene.ts';
import { ball, BELLY, both, FINS, HORN, NONE, SCALES, spike } from './dragon.ts';
import { lathe, tube } from '../lathe.ts';
import { merged, placed } from '../place.ts';

const MOUTH: Color = [142, 44, 66];
const TONGUE: Color = [240, 120, 130];
const WHITE: Color = [255, 253, 246];
const DARK: Color = [40, 34, 56];
const CHEEK: Color = [246, 158, 138];

/** The hinge of the jaw, the middle between the eyes, the middle of the mouth's opening, and the left nostril. */
export const HINGE: Vector = [0.14, -0.06, 0];
export const EYES: Vector = [0.34, 0.42, 0];
export const LIPS: Vector = [0.86, -0.16, 0];
export const NOSTRIL: Vector = [0.98, 0.2, 0.14];

const EYE = 0.25;
const EYE_RADIUS = 0.165;

/** @param parts indices of the parts that carry head, jaw and eyelids */
export function dragonHead(parts: {
  readonly head: number;
  readonly jaw: number;
  readonly lids: number;
}): SurfaceDescription[] {
  const look = { casts: true, inked: true, part: parts.head };
  const quiet = { ...look, casts: false };
  const flat = { ...quiet, inked: false };
  return [
    { name: 'skull', mesh: skull(), color: SCALES, ...look, group: 'head' },
    { name: 'nostrils', mesh: both(nostrilBump), color: SCALES, ...quiet, group: 'head' },
    { name: 'nostril holes', mesh: both(nostrilHole), color: DARK, ...flat },
    { name: 'palate', mesh: ball([0.52, -0.07, 0], [0.36, 0.13, 0.26]), color: MOUTH, ...quiet },
    { name: 'fangs', mesh: both(fang), color: HORN, ...quiet },
    { name: 'eyes', mesh: both(eye), color: WHITE, ...quiet, group: 'eyes' },
    { name: 'pupils', mesh: both(pupil), color: DARK, ...flat, group: 'eyes' },
    { name: 'glints', mesh: both(glint), color: WHITE, ...flat, group: 'eyes' },
    { name: 'cheeks', mesh: both(cheek), color: CHEEK, ...flat },
    { name: 'horns', mesh: both(horn), color: HORN, ...look },
    { name: 'ears', mesh: both(ear), color: FINS, ...look },
    { name: 'head spikes', mesh: merged(...SPIKES.map(spike)), color: FINS, ...look },
    { name: 'jaw', mesh: ball([0.4, -0.1, 0], [0.42, 0.13, 0.29]), color: BELLY, ...look, part: parts.jaw },
    { name: 'tongue', mesh: ball([0.4, -0.005, 0], [0.32, 0.06, 0.2]), color: TONGUE, ...quiet, part: parts.jaw },
    { name: 'teeth', mesh: both(tooth), color: HORN, ...quiet, part: parts.jaw },
    { name: 'eyelids', mesh: both(lid), color: SCALES, ...quiet, part: parts.lids },
  ];
}

const SPIKES = [[0.1, 0.62, 0, 0.2, 0.5], [-0.16, 0.58, 0, 0.22, 0.8], [-0.36, 0.36, 0, 0.22, 1.2]] as const; // prettier-ignore

function skull(): TriangleMesh {
  return merged(
    ball([0.06, 0.24, 0], [0.5, 0.45, 0.46], NONE, 24),
    ball([0.56, 0.06, 0], [0.5, 0.24, 0.35], [0, 0, -0.06], 20),
  );
}

function nostrilBump(side: 1 | -1): TriangleMesh {
  return ball([0.9, 0.17, side * 0.15], [0.13, 0.1, 0.1], [0, 0, 0.2]);
}

function nostrilHole(side: 1 | -1): TriangleMesh {
  return ball([0.98, 0.2, side * 0.17], [0.05, 0.045, 0.045], NONE, 8);
}

function fang(side: 1 | -1): TriangleMesh {
  return placed(lathe(8, [[0, 0], [0.055, 0]], [[0.055, 0], [0.035, 0.08], [0, 0.17]]), { at: [0.84, -0.06, side * 0.19], angles: [Math.PI, 0, 0.1] }); // prettier-ignore
}

function tooth(side: 1 | -1): TriangleMesh {
  const cone = lathe(8, [[0, 0], [0.045, 0]], [[0.045, 0], [0.025, 0.06], [0, 0.12]]); // prettier-ignore
  return merged(placed(cone, { at: [0.66, -0.04, side * 0.16] }), placed(cone, { at: [0.52, -0.02, side * 0.21] }));
}

function eye(side: 1 | -1): TriangleMesh {
  return ball([EYES[0], EYES[1], side * EYE], [EYE_RADIUS, EYE_RADIUS, EYE_RADIUS]);
}

function pupil(side: 1 | -1): TriangleMesh {
  return ball([EYES[0] + 0.115, EYES[1] - 0.01, side * (EYE + 0.055)], [0.065, 0.095, 0.07], [0, -0.35 * side, 0]);
}

function glint(side: 1 | -1): TriangleMesh {
  return ball([EYES[0] + 0.165, EYES[1] + 0.04, side * (EYE + 0.06)], [0.025, 0.03, 0.03], NONE, 8);
}

/** The upper half of a shell around each eye, about the middle between the eyes. */
function lid(side: 1 | -1): TriangleMesh {
  const out = EYE_RADIUS + 0.02;
  const half = lathe(20, [[0, 0], [out, 0]], [[out, 0], [0.87 * out, 0.5 * out], [0.5 * out, 0.87 * out], [0, out]]); // prettier-ignore
  return placed(half, { at: [0, 0, side * EYE] });
}

function cheek(side: 1 | -1): TriangleMesh {
  return ball([0.4, 0.1, side * 0.37], [0.12, 0.09, 0.06], [0, -0.4 * side, 0], 10);
}

function horn(side: 1 | -1): TriangleMesh {
  const path: readonly Vector[] = [[0, 0.52, side * 0.2], [-0.16, 0.78, side * 0.27], [-0.4, 0.92, side * 0.32], [-0.62, 0.9, side * 0.34]]; // prettier-ignore
  return tube(14, path, [0, 0, 1], [[0, 0], [0.1, 0.02]], [[0.1, 0.02], [0.08, 0.5], [0.02, 0.97]], [[0.02, 0.97], [0, 1]]); // prettier-ignore
}

/** A flat, pointed fin behind each cheek. */
function ear(side: 1 | -1): TriangleMesh {
  const leaf = lathe(12, [[0, -0.05], [0.1, 0.02], [0.15, 0.16], [0.1, 0.34], [0, 0.54]]); // prettier-ignore
  return placed(leaf, { at: [-0.12, 0.2, side * 0.4], angles: [side * 0.9, 0, 0.9], scale: [1, 1, 0.35] });
}
