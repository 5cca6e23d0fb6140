/** Shadow volumes in tiles, compared with the same volumes as one quad each. */
import { OrthographicCamera, PerspectiveCamera, type Camera } from 'three';
import { Lab, type LabPuff, type LabScene } from '../../../lab.ts';
import { random } from '../../../random.ts';
import { ground } from '../../../solids.ts';

const [WIDTH, HEIGHT] = [320, 180];

type View = Pick<LabScene, 'camera' | 'towardsLight' | 'lamp' | 'reversedDepth' | 'style'>;

export const VIEWS = {
  sun: () => ({ camera: inside(), towardsLight: [-0.5, 0.8, 0.4] }),
  backlit: () => ({ camera: inside(), towardsLight: [0.9, 0.3, -0.5] }),
  lamp: () => ({ camera: inside(), lamp: [0.3, 1.2, 0.4] }),
  reversedDepth: () => ({ camera: inside(), towardsLight: [-0.5, 0.8, 0.4], reversedDepth: true }),
  orthographic: () => ({ camera: orthographic(), towardsLight: [-0.5, 0.3, 0.4] }),
} satisfies Record<string, () => View>;

export interface TilesReport {
  /** Whether volumes were drawn in tiles. */
  hasTiles: boolean;
  /** Pixels in shadow, and pixels whose count differs between tiles and whole quads. */
  shadowed: number;
  differing: number;
}

export function compareTiles(name: keyof typeof VIEWS): TilesReport {
  const scene: LabScene = {
    width: WIDTH,
    height: HEIGHT,
    puffs: cloud(),
    surfaces: [ground(-1, 4)],
    readCounts: true,
    ...(VIEWS[name]() as View),
  };
  const lab = new Lab(scene);
  const { passes } = lab['smoke'];
  const tiled = lab.draw(scene);
  const { hasTiles } = passes.extras.tiledVolumes!['tiled']!;
  Object.defineProperty(passes.extras, 'tiledVolumes', { value: undefined });
  const whole = lab.draw(scene);
  lab.dispose();
  return {
    hasTiles,
    shadowed: tiled.counts.filter((count) => count > 0).length,
    differing: tiled.counts.filter((count, pixel) => count !== whole.counts[pixel]).length,
  };
}

/** Puffs around the camera; the first is large in the picture. */
function cloud(): LabPuff[] {
  const next = random(5);
  const others = Array.from({ length: 90 }, (): LabPuff => ({
    place: [4 * next() - 2, 2 * next() - 0.8, 4 * next() - 2],
    radius: 0.1 + 0.2 * next(),
    seed: Math.floor(256 * next()),
    roll: 6 * next(),
  }));
  return [{ place: [0.3, 0.2, -0.1], radius: 0.35 }, ...others];
}

function inside(): Camera {
  const camera = new PerspectiveCamera(50, WIDTH / HEIGHT, 0.1, 100);
  camera.position.set(0.2, 0.3, 0.6);
  camera.lookAt(-0.3, -0.1, -1);
  camera.updateMatrixWorld();
  return camera;
}

function orthographic(): Camera {
  const camera = new OrthographicCamera(-1.6, 1.6, 0.9, -0.9, 0.1, 20);
  camera.position.set(0.7, 1, 2.8);
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  return camera;
}
