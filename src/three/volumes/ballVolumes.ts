import type { Object3D, WebGLRenderer } from 'three';
import type { Device } from '../../renderer/gpu/device.ts';
import { ONE_QUAD } from '../../renderer/gpu/drawnRows.ts';
import type { FrameView } from '../../renderer/gpu/frameView.ts';
import { PuffTextures } from '../../renderer/gpu/puffTextures.ts';
import { PuffRows } from '../../renderer/gpu/puffRows.ts';
import { CountedVolumesPass } from '../../renderer/passes/countedVolumes.ts';
import { ParameterError } from '../../base/errors.ts';
import type { PuffShape } from '../../renderer/puffs/shapes.ts';
import { ATTRIBUTE_WORDS, NO_END } from '../../simulator/layout.ts';
import type { Rows } from '../../simulator/rows.ts';
import { bakedPuffs } from '../../renderer/bakedPuffs.ts';
import { toSmoke, type Placement } from '../smokeSpace.ts';
import type { BallAt } from '../proxies.ts';
import { newPose } from '../shapes.ts';

/** Maximum number of proxy balls for deforming or open objects. */
const MAX_BALLS = 512;
/** A puff with one lobe, which is a ball with the particle's radius. */
const BALL: readonly PuffShape[] = [{ name: 'ball', lobes: [{ center: [0, 0, 0], radius: 1 }] }];
/** N . L above which the host's materials count as lit. A ball's volume begins behind its whole lit side. */
const LIT_THRESHOLD = 0;

/** Proxy balls of an object. */
export interface BallsOf {
  readonly object: Object3D;
  readonly balls: readonly BallAt[];
}

/** Shadow volumes of balls. They use the particles' shader: each ball is a puff with one lobe. */
export class BallVolumes {
  private readonly groups = new Set<BallsOf>();
  private count = 0;
  private readonly puffs: PuffTextures;
  private readonly rows = new PuffRows(MAX_BALLS, ONE_QUAD);
  private readonly volumes: CountedVolumesPass;
  private readonly place = new Float32Array(4 * MAX_BALLS);
  // The shadows may fall on any surface of the host's scene.
  private readonly attributes = new Uint32Array(ATTRIBUTE_WORDS * MAX_BALLS).map((_, word) =>
    word % ATTRIBUTE_WORDS === 0 ? NO_END : 0,
  );

  constructor(device: Device, eye: FrameView) {
    this.puffs = new PuffTextures(device.puffs, bakedPuffs(BALL));
    this.volumes = new CountedVolumesPass(eye, this.puffs);
    this.volumes.setForm('lobes', LIT_THRESHOLD);
    this.volumes.keepSize();
  }

  get isEmpty(): boolean {
    return this.count === 0;
  }

  /** @throws ParameterError when the total exceeds the maximum */
  add(balls: readonly BallAt[], object: Object3D): BallsOf {
    const count = this.count + balls.length;
    if (count > MAX_BALLS) throw new ParameterError('cast.proxies', count, `at most ${MAX_BALLS} balls in all`);
    this.count = count;
    const group = { object, balls };
    this.groups.add(group);
    return group;
  }

  remove(group: BallsOf): void {
    if (this.groups.delete(group)) this.count -= group.balls.length;
  }

  /**
   * @param scene the rendered scene; objects that are hidden or outside it cast no shadow
   * @param placement of the smoke in the world
   */
  draw(renderer: WebGLRenderer, scene: Object3D, placement: Placement): void {
    const balls = [...this.groups].flatMap((group) => (isShown(group.object, scene) ? group.balls : []));
    if (balls.length === 0) return;
    this.rows.fill(this.rowsOf(balls, placement));
    this.volumes.draw(renderer, this.rows.geometry);
  }

  /** Frees the GPU resources. The next draw recreates them. */
  release(): void {
    this.rows.dispose();
    this.volumes.dispose();
  }

  dispose(): void {
    this.release();
    this.puffs.dispose();
  }

  private rowsOf(balls: readonly BallAt[], placement: Placement): Rows {
    const { place, attributes } = this;
    balls.forEach((ballAt, index) => {
      const { center, radius } = ballAt();
      ball.position.copy(center);
      toSmoke(ball, placement).position.toArray(place, 4 * index);
      place[4 * index + 3] = radius / placement.scale;
    });
    return { count: balls.length, whole: balls.length, place, attributes };
  }
}

const ball = newPose();

/** Whether an object is drawn with a scene: it is a descendant, and neither it nor an ancestor is hidden. */
export function isShown(object: Object3D, scene: Object3D): boolean {
  for (let at: Object3D | null = object; at?.visible; at = at.parent) if (at === scene) return true;
  return false;
}
