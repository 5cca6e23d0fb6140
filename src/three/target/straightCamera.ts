import { Matrix4, Vector3, type Camera, type PerspectiveCamera } from 'three';
import { PassCamera } from '../../renderer/gpu/drawnMesh.ts';

/** Slant of a near plane that is rounding: matrices of maps have single precision. */
const ROUNDING = 3e-6;
/** The last entry of an orthographic depth row, and that of reversed depth: as far from the eye as between its planes. */
const [ORTHOGRAPHIC, REVERSED] = [-3, 2];

/**
 * A host's camera in the space of the smoke, with a rigid view and a projection of the form that the shaders know. Its
 * picture and window depths are those of the host's camera, whose matrices may be anything of the same product: map
 * layers have the view in the projection, and parents have scales.
 */
export class FactoredCamera extends PassCamera {
  /** As a mirror's projection needs them, which has an oblique plane in place of the near one. */
  near = 0;
  far = 0;
  isReversed = false;

  constructor() {
    super();
    this.matrixAutoUpdate = false;
  }

  override get reversedDepth(): boolean {
    return this.isReversed;
  }

  /**
   * @param world from the space of the smoke to the world
   * @param scale of `world`
   */
  copyHost(host: Camera, world: Matrix4, scale: number): this {
    host.updateMatrixWorld();
    const { projectionMatrix, matrixWorld } = this;
    const clip = projectionMatrix.multiplyMatrices(host.projectionMatrix, host.matrixWorldInverse).multiply(world);
    const axes = clip.clone().transpose();
    const [x, y, z, w] = [0, 1, 2, 3].map((row) => new Vector3().setFromMatrixColumn(axes, row));
    const [, , , atX, , , , atY, , , , atZ, , , , atW] = axes.elements;
    const isPerspective = w.length() > 1e-12 * Math.abs(atW);
    // Clip coordinates are homogeneous.
    const unit = isPerspective ? w.length() : atW;
    for (const row of [x, y, z]) row.divideScalar(unit);
    const back = isPerspective ? w.divideScalar(-unit) : w.crossVectors(x, y).normalize();
    if (!isPerspective && z.dot(back) > 0 !== host.reversedDepth) back.negate();
    const up = y.clone().addScaledVector(back, -y.dot(back)).normalize();
    const right = new Vector3().crossVectors(up, back);
    const depth = z.dot(back);
    const eye = new Vector3().setFromMatrixPosition(host.matrixWorld).applyMatrix4(shift.copy(world).invert());
    let backward = isPerspective ? -atW / unit : -back.dot(eye);
    // Shaders know reversed depth by the sign.
    if (!isPerspective && atZ / unit - depth * backward > 0 !== host.reversedDepth)
      backward = (atZ / unit - (host.reversedDepth ? REVERSED : ORTHOGRAPHIC)) / depth;
    const upward = (atY / unit - y.dot(back) * backward) / y.dot(up);
    const aside = (atX / unit - x.dot(up) * upward - x.dot(back) * backward) / x.dot(right);
    const slant = [z.dot(right), z.dot(up)];
    const rest = atZ / unit - slant[0] * aside - slant[1] * upward - depth * backward;
    const [slantX, slantY] = Math.hypot(...slant) > ROUNDING * Math.abs(depth) ? slant : [0, 0];
    matrixWorld.makeBasis(right, up, back).multiply(shift.makeTranslation(-aside, -upward, -backward));
    this.matrixWorldInverse.copy(matrixWorld).invert();
    const [across, along] = [x.dot(right), y.dot(up)];
    const whole = isPerspective ? [0, 0, -1, 0] : [0, 0, 0, 1];
    const others = [across, 0, x.dot(back), 0, 0, along, y.dot(back), 0, slantX, slantY, depth, rest];
    projectionMatrix.fromArray([...others, ...whole]).transpose();
    const { near = 0.1, far = 1e4 } = host as Partial<PerspectiveCamera>;
    this.near = near / scale;
    this.far = far / scale;
    this.isReversed = host.reversedDepth;
    return this;
  }
}

const shift = new Matrix4();

/** Whether a camera has a rigid view and a projection of the form that {@link FactoredCamera} gives, upright. */
export function isFactored({ projectionMatrix, matrixWorldInverse, reversedDepth }: Camera): boolean {
  const e = projectionMatrix.elements;
  const rotation = new Matrix4().extractRotation(matrixWorldInverse).elements;
  const isRigid = [0, 1, 2, 4, 5, 6, 8, 9, 10].every(
    (at) => Math.abs(rotation[at] - matrixWorldInverse.elements[at]) < 1e-6,
  );
  const zeros = e[11] === 0 ? [1, 3, 4, 7, 8, 9] : [1, 3, 4, 7, 12, 13, 15];
  const isKnown = zeros.every((at) => e[at] === 0) && (e[11] === 0 ? e[15] === 1 : e[11] === -1);
  const isOrdered = reversedDepth ? e[14] > 0 : e[14] <= 0;
  return (
    isRigid && Math.abs(matrixWorldInverse.determinant() - 1) < 1e-5 && isKnown && isOrdered && e[0] > 0 && e[5] > 0
  );
}

/** A camera as smoke can draw with it. */
export interface StraightCamera {
  /** A camera whose projection is neither oblique nor a mirror's. */
  camera: Camera;
  /** The projection of the host's picture and depth, if it has an oblique near plane or mirrors; otherwise undefined. */
  hosts: Matrix4 | undefined;
  /** Whether the picture of `camera` is the host's from right to left. */
  isMirrored: boolean;
}

/**
 * Reflector clips what is behind the mirror, by an oblique near plane (Lengyel, 'Oblique View Frustum Depth Projection and
 * Clipping', 2005).
 * @param camera with the form of {@link isFactored}, but maybe mirrored
 */
export function straightened(camera: Camera): StraightCamera {
  const { elements } = camera.projectionMatrix;
  const isMirrored = elements[0] < 0;
  const isOblique = elements[2] !== 0 || elements[6] !== 0;
  if (!isMirrored && !isOblique) return { camera, hosts: undefined, isMirrored };
  const straight = new FactoredCamera().copyHost(camera, new Matrix4(), 1);
  if (isMirrored) for (const at of [0, 8]) straight.projectionMatrix.elements[at] *= -1;
  if (isOblique) setRange(straight);
  return { camera: straight, hosts: camera.projectionMatrix, isMirrored };
}

/** Gives a camera's projection the near and far planes of its properties. */
function setRange(camera: FactoredCamera): void {
  const { near, far } = camera;
  const { elements } = camera.projectionMatrix;
  const isPerspective = elements[11] !== 0;
  elements[2] = elements[6] = 0;
  elements[10] = -(isPerspective ? far + near : 2) / (far - near);
  elements[14] = -(isPerspective ? 2 * far * near : far + near) / (far - near);
  camera.isReversed = false;
}
