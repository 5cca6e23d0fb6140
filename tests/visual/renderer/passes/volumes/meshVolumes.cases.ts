/** Shadow volumes of closed meshes, when the light changes. */
import { Lab, frontCamera, takePicture, type LabScene } from '../../../lab.ts';
import { box, ground } from '../../../solids.ts';

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
