/** A smiling toy rocket that stands on y = 0 with its nose up, and its launch pad. Metres. */
import type { Color } from '../../renderer/gpu/ramps.ts';
import type { TriangleMesh } from '../../renderer/passes/extrusion.ts';
import type { SurfaceDescription } from '../../renderer/passes/surface.ts';
import type { RigidShape } from '../../simulator/rigid.ts';
import { friendlyFace } from './face.ts';
import { lathe } from './lathe.ts';
import { merged, placed } from './place.ts';
import { roundedBox } from './roundedBox.ts';

const WHITE: Color = [252, 244, 230];
const RED: Color = [226, 76, 70];
const DARK: Color = [80, 66, 88];
const FACE: Color = [70, 42, 52];
const CHEEK: Color = [244, 148, 130];
const STEEL: Color = [176, 180, 200];
const PAD: Color = [206, 198, 204];
const SIGNAL: Color = [246, 186, 76];

/** Height of the nozzle's opening. */
export const NOZZLE = 0.16;

export function rocket(rigid: number): SurfaceDescription[] {
  const look = { casts: true, inked: true, rigid };
  const quiet = { ...look, casts: false, inked: false };
  const { features, cheeks } = friendlyFace(0.4, 0.37);
  const front = { at: [0, 1.02, 0.372] } as const;
  return [
    { name: 'body', mesh: body(), color: WHITE, ...look },
    { name: 'nose', mesh: nose(), color: RED, ...look },
    { name: 'belt', mesh: belt(), color: RED, ...quiet },
    { name: 'fins', mesh: fins(), color: RED, ...look },
    { name: 'nozzle', mesh: nozzle(), color: DARK, ...look },
    { name: 'face', mesh: placed(features, front), color: FACE, ...quiet },
    { name: 'cheeks', mesh: placed(cheeks, front), color: CHEEK, ...quiet },
  ];
}

/** The collider. */
export function rocketHull(): RigidShape {
  return {
    type: 'compound',
    parts: [{ shape: { type: 'capsule', halfHeight: 0.5, radius: 0.36 }, position: [0, 1.1, 0] }],
  };
}

/** A concrete pad with a tower beside it. */
export function launchPad(): SurfaceDescription[] {
  const look = { casts: true, inked: true };
  const level = (y: number) => placed(roundedBox([0.26, 0.03, 0.26], 0.03, 3), { at: [-1.05, y, -0.3] });
  const post = (x: number, z: number) =>
    placed(roundedBox([0.035, 1.15, 0.035], 0.02, 3), { at: [-1.05 + x, 1.15, -0.3 + z] });
  const arm = (y: number) =>
    placed(roundedBox([0.26, 0.03, 0.05], 0.025, 3), { at: [-0.66, y, -0.2], angles: [0, -0.25, 0] });
  const lamp = placed(lathe(16, [[0, 0], [0.09, 0]], [[0.09, 0], [0.09, 0.08], [0.05, 0.15], [0, 0.17]]), { at: [-1.05, 2.33, -0.3] }); // prettier-ignore
  return [
    { name: 'pad', mesh: pad(), color: PAD, ...look, casts: false },
    {
      name: 'tower',
      mesh: merged(
        ...[0.4, 0.95, 1.5, 2.05, 2.3].map(level),
        ...[-0.22, 0.22].flatMap((x) => [post(x, -0.22), post(x, 0.22)]),
      ),
      color: RED,
      ...look,
    },
    { name: 'arms', mesh: merged(arm(0.98), arm(1.53)), color: STEEL, ...look },
    { name: 'lamp', mesh: lamp, color: SIGNAL, ...look },
    { name: 'tanks', mesh: tanks(), color: STEEL, ...look },
    {
      name: 'bunker',
      mesh: placed(roundedBox([0.42, 0.2, 0.3], [0.1, 0.18, 0.1]), { at: [1.75, 0.14, 0.75], angles: [0, -0.5, 0] }),
      color: WHITE,
      ...look,
    },
    {
      name: 'window',
      mesh: placed(roundedBox([0.24, 0.05, 0.31], [0.04, 0.04, 0.03], 5), {
        at: [1.75, 0.2, 0.75],
        angles: [0, -0.5, 0],
      }),
      color: DARK,
      ...look,
      casts: false,
    },
  ];
}

function body(): TriangleMesh {
  return lathe(
    36,
    [[0, 0.3], [0.22, 0.3]],
    [[0.22, 0.3], [0.32, 0.55], [0.375, 0.95], [0.33, 1.35], [0.25, 1.58]],
    [[0.25, 1.58], [0, 1.58]],
  ); // prettier-ignore
}

function nose(): TriangleMesh {
  return lathe(
    32,
    [[0, 1.56], [0.262, 1.56]],
    [[0.262, 1.56], [0.19, 1.76], [0.085, 1.95], [0.035, 2.02], [0, 2.04]],
  ); // prettier-ignore
}

function belt(): TriangleMesh {
  return lathe(
    36,
    [[0, 0.585], [0.338, 0.585]],
    [[0.338, 0.585], [0.352, 0.66]],
    [[0.352, 0.66], [0, 0.66]],
  ); // prettier-ignore
}

function fins(): TriangleMesh {
  const fin = (angle: number) => {
    const blade = roundedBox([0.2, 0.34, 0.045], [0.14, 0.2, 0.045]);
    const swept = {
      ...blade,
      positions: blade.positions.map((value, i) =>
        i % 3 === 1 ? value - 0.8 * (blade.positions[i - 1] + 0.2) : value,
      ),
    };
    return placed(placed(swept, { at: [0.38, 0.46, 0] }), { angles: [0, angle, 0] });
  };
  return merged(...[0.5, 1.5, 2.5, 3.5].map((quarter) => fin((quarter * Math.PI) / 2)));
}

function nozzle(): TriangleMesh {
  return lathe(
    24,
    [[0, 0.2], [0.15, NOZZLE]],
    [[0.15, NOZZLE], [0.2, NOZZLE], [0.17, 0.24], [0.14, 0.32]],
    [[0.14, 0.32], [0, 0.32]],
  ); // prettier-ignore
}

function pad(): TriangleMesh {
  return lathe(
    48,
    [[0, -0.04], [1, -0.04]],
    [[1, -0.04], [0.92, 0.06]],
    [[0.92, 0.06], [0, 0.06]],
  ); // prettier-ignore
}

function tanks(): TriangleMesh {
  const tank = (x: number, z: number, size: number) =>
    placed(lathe(20, [[0, 0], [0.26, 0]], [[0.26, 0], [0.27, 0.5]], [[0.27, 0.5], [0.2, 0.62], [0, 0.68]]), { at: [x, -0.02, z], scale: size }); // prettier-ignore
  return merged(tank(1.4, -1.3, 1), tank(2, -0.95, 0.8));
}
