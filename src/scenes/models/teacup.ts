import type { Color } from '../../renderer/gpu/ramps.ts';
import type { TriangleMesh } from '../../renderer/passes/extrusion.ts';
import type { SurfaceDescription } from '../../renderer/passes/surface.ts';
import { ballMesh } from './ball.ts';
import { lathe, pipe } from './lathe.ts';
import { merged, placed } from './place.ts';

const CUP: Color = [246, 222, 190];
const INSIDE: Color = [250, 244, 232];
const TEA: Color = [190, 106, 58];
const SAUCER: Color = [231, 122, 104];
const FACE: Color = [70, 42, 52];
const CHEEK: Color = [240, 142, 126];

/** Height and radius of the tea surface; metres. */
export const TEA_LEVEL = 0.82;
export const TEA_RADIUS = 0.6;

/** A smiling cup of tea on its saucer, 1.3 m wide: oversized, so that the scene's values have convenient magnitudes. */
export function teacup(): SurfaceDescription[] {
  const still = { casts: true, inked: true };
  return [
    { name: 'saucer', mesh: saucer(), color: SAUCER, ...still },
    { name: 'cup', mesh: cup(), color: CUP, ...still, group: 'cup' },
    { name: 'handle', mesh: handle(), color: CUP, ...still, group: 'cup' },
    { name: 'lip', mesh: lip(), color: INSIDE, ...still, group: 'lip' },
    { name: 'tea', mesh: tea(), color: TEA, ...still, casts: false, inked: false },
    { name: 'cheeks', mesh: cheeks(), color: CHEEK, casts: false, inked: false },
    { name: 'face', mesh: face(), color: FACE, casts: false, inked: false },
  ];
}

/** Outer radius of the cup by height. */
const SIDE = [
  [0.36, 0.1],
  [0.56, 0.24],
  [0.66, 0.5],
  [0.7, 0.92],
] as const;

function cup(): TriangleMesh {
  return lathe(
    48,
    [[0, 0.06], [0.32, 0.06]],
    [[0.32, 0.06], ...SIDE],
    [[0.7, 0.92], [0.6, TEA_LEVEL - 0.1]],
    [[0.6, TEA_LEVEL - 0.1], [0, TEA_LEVEL - 0.1]],
  ); // prettier-ignore
}

function lip(): TriangleMesh {
  const wall = 0.645;
  return lathe(
    48,
    [[0, TEA_LEVEL - 0.06], [0.5, TEA_LEVEL - 0.06]],
    [[0.5, TEA_LEVEL - 0.06], [0.69, 0.9], [0.715, 0.945], [0.69, 0.98], [0.66, 0.96], [wall, TEA_LEVEL]],
    [[wall, TEA_LEVEL], [0, TEA_LEVEL]],
  ); // prettier-ignore
}

function tea(): TriangleMesh {
  const [low, high] = [TEA_LEVEL - 0.03, TEA_LEVEL + 0.012];
  return lathe(48, [[0, low], [0.64, low]], [[0.64, low], [0.648, high]], [[0.648, high], [0, high]]); // prettier-ignore
}

function saucer(): TriangleMesh {
  return lathe(
    56,
    [[0, -0.02], [0.5, -0.02]],
    [[0.5, -0.02], [0.86, 0.05], [1.08, 0.14], [1.1, 0.17], [1.05, 0.17]],
    [[1.05, 0.17], [0.8, 0.1], [0.45, 0.065], [0, 0.06]],
  ); // prettier-ignore
}

function handle(): TriangleMesh {
  return pipe(
    16,
    [[0.6, 0.74], [0.84, 0.8], [1.02, 0.62], [0.92, 0.36], [0.6, 0.28]],
    [[0, 0], [0.075, 0]],
    [[0.075, 0], [0.07, 0.5], [0.08, 1]],
    [[0.08, 1], [0, 1]],
  ); // prettier-ignore
}

/** Two eyes and a smile, embedded in the front of the cup. */
function face(): TriangleMesh {
  const eye = (x: number) => placed(ballMesh(1, 10), { at: onFront(x, 0.56), scale: [0.05, 0.065, 0.04] });
  const smile = pipe(
    10,
    [[-0.1, 0.03], [-0.06, -0.02], [0, -0.04], [0.06, -0.02], [0.1, 0.03]],
    [[0, 0], [0.016, 0.01]],
    [[0.016, 0.01], [0.024, 0.5], [0.016, 0.99]],
    [[0.016, 0.99], [0, 1]],
  ); // prettier-ignore
  return merged(eye(-0.24), eye(0.24), placed(smile, { at: [0, 0.47, 0.655] }));
}

function cheeks(): TriangleMesh {
  const cheek = (x: number) => placed(ballMesh(1, 10), { at: onFront(x, 0.44), scale: [0.075, 0.045, 0.05] });
  return merged(cheek(-0.33), cheek(0.33));
}

/** The point on the front of the cup at these picture coordinates. */
function onFront(x: number, y: number): [number, number, number] {
  const radius = 0.66;
  return [x, y, Math.sqrt(radius * radius - x * x) - 0.005];
}
