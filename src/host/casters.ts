import { Matrix4, Quaternion, Vector3, type Mesh, type Object3D, type WebGLRenderer } from 'three';
import type { Eye } from '../device/eye.ts';
import { MeshVolumesPass } from '../passes/meshVolumes.ts';
import { ParameterError } from '../preset/errors.ts';
import type { Rows } from '../sim/rows.ts';
import type { Simulator } from '../sim/simulator.ts';
import type { View } from '../sim/view.ts';
import type { Arranger } from '../smoke/frame.ts';
import { ballsOf, follow, type BallAt, type ProxyBall } from './proxies.ts';
import { poseOf, scaleOf, trianglesOf, type Pose } from './shapes.ts';

/** The most balls that can stand in for what bends or is open. */
export const MOST_BALLS = 512;

const UNSCALED = new Vector3(1, 1, 1);

/** A rigid closed mesh and its shadow volume. */
interface MeshCaster {
  mesh: Mesh;
  volume: MeshVolumesPass;
}

/**
 * What throws shadow volumes in a stranger's scene: rigid closed meshes by their silhouettes; what is skinned, instanced
 * or open by balls, which are casters among the particles. Stands for the simulator where a frame asks for rows.
 */
export class Casters implements Arranger {
  private readonly simulator: Simulator;
  private readonly eye: Eye;
  private readonly meshes: MeshCaster[] = [];
  private readonly balls: BallAt[] = [];
  private readonly place: Float32Array;
  private readonly look: Uint32Array;
  private readonly shadowRadius: () => number;

  /**
   * @param capacity the most rows of the simulator
   * @param shadowRadius radius of a caster's volume in radii of its row
   */
  constructor(simulator: Simulator, eye: Eye, capacity: number, shadowRadius: () => number) {
    this.simulator = simulator;
    this.eye = eye;
    this.shadowRadius = shadowRadius;
    this.place = new Float32Array(4 * (capacity + MOST_BALLS));
    this.look = new Uint32Array(2 * (capacity + MOST_BALLS));
  }

  /** @throws ParameterError when a mesh is open and has no proxies, or when there are too many balls */
  add(object: Object3D, proxies: readonly ProxyBall[] | undefined): void {
    object.updateWorldMatrix(true, true);
    if (proxies) this.addBalls(proxies.map(follow));
    else object.traverse((part) => ('isMesh' in part ? this.addMesh(part as Mesh) : undefined));
  }

  get bounds(): Simulator['bounds'] {
    return this.simulator.bounds;
  }

  arrange(view: View): Rows {
    const rows = this.simulator.arrange(view);
    return view.purpose === 'light' && this.balls.length > 0 ? this.withBalls(rows) : rows;
  }

  /** Counts the volumes of the meshes; those of the balls are drawn with the particles'. */
  draw(renderer: WebGLRenderer): void {
    const pose: Pose = poseScratch;
    for (const { mesh, volume } of this.meshes) {
      poseOf(mesh.matrixWorld, pose);
      volume.place(0, world.compose(pose.position, pose.rotation, UNSCALED));
      if (mesh.visible) volume.draw(renderer);
    }
  }

  dispose(): void {
    for (const { volume } of this.meshes) volume.dispose();
  }

  private addMesh(mesh: Mesh): void {
    const balls = ballsOf(mesh);
    if (balls.length > 0) return this.addBalls(balls);
    const triangles = trianglesOf(mesh.geometry, scaleOf(mesh.matrixWorld));
    try {
      const surface = { name: mesh.name, mesh: triangles, color: [0, 0, 0], casts: true, inked: false } as const;
      this.meshes.push({ mesh, volume: new MeshVolumesPass(this.eye, [surface]) });
    } catch (error) {
      if (error instanceof RangeError) throw openMesh(mesh);
      throw error;
    }
  }

  private addBalls(balls: readonly BallAt[]): void {
    if (this.balls.length + balls.length > MOST_BALLS)
      throw new ParameterError('cast.proxies', this.balls.length + balls.length, `at most ${MOST_BALLS} balls in all`);
    this.balls.push(...balls);
  }

  private withBalls({ count, place, look }: Rows): Rows {
    const perRow = 1 / this.shadowRadius();
    this.place.set(place.subarray(0, 4 * count));
    this.look.set(look.subarray(0, 2 * count));
    this.look.fill(0, 2 * count);
    this.balls.forEach((ballAt, index) => {
      const { center, radius } = ballAt();
      center.toArray(this.place, 4 * (count + index));
      this.place[4 * (count + index) + 3] = radius * perRow;
    });
    return { count: count + this.balls.length, place: this.place, look: this.look };
  }
}

const world = new Matrix4();
const poseScratch: Pose = { position: new Vector3(), rotation: new Quaternion() };

function openMesh({ name, type }: Mesh): ParameterError {
  return new ParameterError(
    'cast',
    name || type,
    'a closed mesh, whose every edge joins two triangles, or an object with proxies: cast(mesh, { proxies })',
  );
}
