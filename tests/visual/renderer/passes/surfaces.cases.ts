/** Outlines of meshes that touch others, and the draw calls of a scene with many meshes. */
import { Matrix4, PerspectiveCamera } from 'three';
import { weld } from '../../../../src/renderer/passes/extrusion.ts';
import { Lab, PLAIN_STYLE, takePicture } from '../../lab.ts';
import { OUT_OF_SIGHT } from '../../../../src/renderer/sceneSurfaces.ts';
import { pageDevice } from '../../pageDevice.ts';
import { SceneLab } from '../../sceneLab.ts';
import { box } from '../../solids.ts';

const SIZE = 160;

/**
 * The ink of a moving plate that lies on a slab, compared with the ink of the plate alone: pixels of the outline, those
 * of them without ink on the slab, and ink on the plate itself.
 * @param creases whether the creases pass draws lines, too
 */
export function outlineOnSlab(creases: boolean): { outline: number; open: number; inside: number } {
  const camera = new PerspectiveCamera(40, 1, 0.1, 100);
  // From high above: the raised hull is too near the floor to close the line of a flat view.
  camera.position.set(0, 4, 2);
  camera.lookAt(0, 0, 0);
  const still = { casts: false, inked: false } as const;
  // So thin that the raised hull is before the plate.
  const { positions, indices } = box([0, 0, 0], [0.5, 0.02, 0.5]);
  // Faces that share vertices have no crease.
  const shared = weld(positions);
  const normals = positions.map((at) => Math.sign(at) / Math.sqrt(3));
  const mesh = { positions, normals, indices: indices.map((vertex) => shared[vertex]) };
  const slab = { ...still, name: 'slab', mesh: box([0, -0.6, 0], [2, 0.1, 2]), color: [90, 160, 90] } as const;
  const plate = { ...still, name: 'plate', mesh, color: [200, 120, 60], inked: true, rigid: 0 } as const;
  const style = { creases, outlineWidth: 3, shadows: false } as const;
  const rigids = [new Matrix4().makeTranslation(0, -0.48, 0)];
  const picture = { width: SIZE, height: SIZE, puffs: [], camera, style, rigids };
  const [bare, alone, standing] = [[{ ...plate, inked: false }], [plate], [slab, plate]].map((surfaces) =>
    takePicture({ ...picture, surfaces }),
  );
  const isInk = ({ pixels }: typeof bare, pixel: number) =>
    PLAIN_STYLE.inkColor.every((channel, index) => pixels[4 * pixel + index] === channel);
  const report = { outline: 0, open: 0, inside: 0 };
  for (let pixel = 0; pixel < SIZE * SIZE; ++pixel) {
    const isOnPlate = bare.pixels[4 * pixel + 3] > 0;
    if (isOnPlate) report.inside += Number(isInk(standing, pixel));
    else if (isInk(alone, pixel)) {
      report.outline++;
      report.open += Number(!isInk(standing, pixel));
    }
  }
  return report;
}

/**
 * The triangles and pixels of a frame with a moving box that is shown, out of sight, and shown again, and of a frame
 * without that box.
 */
export function comesAndGoes(): { triangles: number[]; isSame: boolean[] } {
  const plain = { color: [200, 120, 60], casts: true, inked: true } as const;
  const floor = { ...plain, name: 'floor', mesh: box([0, -0.5, 0], [1, 0.1, 1]) };
  const moving = { ...plain, name: 'box', mesh: box([0, 0, 0], [0.2, 0.2, 0.2]), rigid: 0 };
  const size = { width: SIZE, height: SIZE, puffs: [] };
  const [both, bare] = [
    { ...size, surfaces: [floor, moving] },
    { ...size, surfaces: [floor] },
  ];
  const [lab, without] = [new Lab(both), new Lab(bare)];
  const { render } = pageDevice().renderer.info;
  const frames = [0, 2 * OUT_OF_SIGHT, 0].map((height) => {
    const { pixels } = lab.draw({ ...both, rigids: [new Matrix4().makeTranslation(0, height, 0)] });
    return { pixels, triangles: render.triangles };
  });
  const { pixels } = without.draw(bare);
  frames.push({ pixels, triangles: render.triangles });
  for (const drawn of [lab, without]) drawn.dispose();
  const isSame = frames.map((frame) => frame.pixels.every((value, at) => value === pixels[at]));
  return { triangles: frames.map(({ triangles }) => triangles), isSame };
}

/** Draw calls of a whole frame of the train. */
export async function callsOfTrain(): Promise<number> {
  const lab = await SceneLab.create('train', { width: 64, height: 48, smoothEdges: true });
  lab.step(30);
  lab.draw();
  const { calls } = lab.drawn();
  lab.dispose();
  return calls;
}

/** Pixels drawn by pictures of growing size, with raised hulls or without, and the WebGL error after them; 0 for none. */
export function resized(hasRaisedHulls: boolean): { drawn: number[]; error: number } {
  const cube = { name: 'box', mesh: box([0, -0.4, 0], [0.3, 0.1, 0.3]), color: [200, 120, 60], casts: false } as const;
  const surfaces = hasRaisedHulls ? [{ ...cube, inked: true, rigid: 0 }] : [];
  const puffs = [{ place: [0, 0, 0] as const, radius: 0.5 }];
  const sizes = [40, 60, 80];
  const lab = new Lab({ width: sizes[2], height: sizes[2], puffs, surfaces });
  const drawn = sizes.map((size) => {
    const { pixels } = lab.draw({ width: size, height: size, puffs, surfaces });
    return pixels.filter((value, at) => at % 4 === 3 && value > 0).length;
  });
  const { error } = lab;
  lab.dispose();
  return { drawn, error };
}
