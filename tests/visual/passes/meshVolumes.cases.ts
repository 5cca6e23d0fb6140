/** Shadow volumes of closed meshes, when the light changes, and with the camera outside of them and in them. */
import { Lab, frontCamera, takePicture, type LabScene } from '../lab.ts';
import { box, ground } from '../solids.ts';

/** Pixels whose shadow of a box depends on the light of the picture before, when a lamp replaces a sun. */
export function staleAfterSun(): { shadowed: number; stale: number } {
  const scene: LabScene = {
    width: 160,
    height: 120,
    puffs: [],
    camera: frontCamera(160, 120, 8),
    surfaces: [
      ground(-1, 3),
      { name: 'box', mesh: box([0, 0, 0], [0.4, 0.4, 0.4]), color: [200, 60, 60], casts: true, inked: false },
    ],
    readCounts: true,
  };
  // The lamp is where the direction of the sun is as a point, but the faces of the box face it differently.
  const towardsLight = [0.28, 0.96, 0] as const;
  const lab = new Lab(scene);
  lab.draw({ ...scene, towardsLight });
  const { counts } = lab.draw({ ...scene, lamp: towardsLight });
  lab.dispose();
  const fresh = takePicture({ ...scene, lamp: towardsLight }).counts;
  return {
    shadowed: fresh.filter((count) => count > 0).length,
    stale: fresh.filter((count, pixel) => count !== counts[pixel]).length,
  };
}

/**
 * Pixels of a ground whose shadow is not that of the closed volumes, which the view of the counts draws, and pixels of
 * the backdrop that the shadow changes.
 * @param place, target of the camera, and the direction towards the light
 */
export function shadowSeenFrom([place, target, towardsLight]: readonly (readonly [number, number, number])[]) {
  const scene: LabScene = {
    width: 200,
    height: 150,
    puffs: [],
    camera: frontCamera(200, 150),
    surfaces: [
      ground(-1, 2),
      { name: 'box', mesh: box([0, 0, 0], [0.4, 0.4, 0.4]), color: [200, 60, 60], casts: true, inked: false },
      { name: 'slab', mesh: box([-1, 1, 0], [0.2, 0.01, 0.5]), color: [60, 60, 200], casts: true, inked: false },
    ],
    backdrop: { top: [40, 90, 160], bottom: [220, 220, 255] },
    towardsLight,
    readCounts: true,
  };
  scene.camera!.position.set(...place);
  scene.camera!.lookAt(...target);
  const lab = new Lab(scene);
  const { pixels, counts } = lab.draw(scene);
  const lit = lab.draw({ ...scene, style: { shadows: false } }).pixels;
  lab.dispose();
  const seen = { shadowed: 0, lit: 0, wrong: 0, backdrop: 0, changed: 0 };
  counts.forEach((count, pixel) => {
    const isDifferent = [0, 1, 2].some((channel) => pixels[4 * pixel + channel] !== lit[4 * pixel + channel]);
    const [red, green, blue] = lit.subarray(4 * pixel, 4 * pixel + 3);
    if (blue > red) {
      seen.backdrop++;
      if (isDifferent) seen.changed++;
    } else if (green > 100) {
      seen[isDifferent ? 'shadowed' : 'lit']++;
      if (isDifferent !== count > 0) seen.wrong++;
    }
  });
  return seen;
}
