/** Meshes of every type, opaque and transparent, among smoke. */
import { Mesh, MeshBasicMaterial, PlaneGeometry, Sprite, SpriteMaterial, Vector3, type Object3D } from 'three';
import {
  changedPixels,
  dispose,
  draw,
  emptyHost,
  HEIGHT,
  makeInstanced,
  makeSkinned,
  smokeIn,
  smokePixels,
  WIDTH,
  type Pixels,
} from './scene.ts';

/** Pixels that differ between a deformed mesh among smoke and the same triangles as a plain mesh. */
export async function deformed(
  kind: 'skinned' | 'instanced',
): Promise<{ changed: number; hidden: number; shown: number }> {
  const host = emptyHost();
  const red = new MeshBasicMaterial({ color: '#ff0000' });
  const mesh = kind === 'skinned' ? makeSkinned(red).mesh : makeInstanced(red);
  mesh.position.y += kind === 'skinned' ? 0.4 : 0.1;
  host.scene.add(mesh);
  const alone = draw(host);
  const smoke = await smokeIn(host);
  const pixels = draw(host);
  host.scene.remove(mesh);
  host.scene.add(kind === 'skinned' ? frozen(mesh as never) : separate(mesh as never));
  const ordinary = draw(host);
  dispose(smoke, host.renderer);
  const isRed = (picture: Pixels, pixel: number) => picture[4 * pixel] === 255 && picture[4 * pixel + 1] === 0;
  const covered = Array.from({ length: WIDTH * HEIGHT }, (_, pixel) => pixel).filter((pixel) => isRed(alone, pixel));
  const shown = covered.filter((pixel) => isRed(pixels, pixel)).length;
  return { changed: changedPixels(pixels, ordinary), hidden: covered.length - shown, shown };
}

function frozen(mesh: ReturnType<typeof makeSkinned>['mesh']): Mesh {
  const geometry = mesh.geometry.clone();
  const { position } = geometry.attributes;
  const place = new Vector3();
  mesh.updateWorldMatrix(true, true);
  mesh.skeleton.update();
  for (let vertex = 0; vertex < position.count; ++vertex) {
    mesh.getVertexPosition(vertex, place);
    position.setXYZ(vertex, place.x, place.y, place.z);
  }
  const copy = new Mesh(geometry, mesh.material);
  copy.position.copy(mesh.position);
  return copy;
}

function separate(mesh: ReturnType<typeof makeInstanced>): Object3D {
  const parts = Array.from({ length: mesh.count }, (_, index) => {
    const part = new Mesh(mesh.geometry, mesh.material);
    mesh.getMatrixAt(index, part.matrix);
    part.matrix.decompose(part.position, part.quaternion, part.scale);
    return part;
  });
  const group = new Mesh();
  group.material = new MeshBasicMaterial({ visible: false });
  group.position.copy(mesh.position);
  return group.add(...parts);
}

/** Share of the smoke that an object with opacity 0.5 tints: in front of, inside and behind the smoke. */
export async function blended(
  kind: 'pane' | 'sprite',
): Promise<{ before: number; within: number; behind: number; wrong: number }> {
  const host = emptyHost();
  const smoke = await smokeIn(host);
  const untouched = draw(host);
  const mask = smokePixels(host, smoke);
  const thing = kind === 'pane' ? pane() : sprite();
  host.scene.add(thing);
  let wrong = 0;
  const forward = new Vector3(0, 1.2, 0).sub(host.camera.position).normalize();
  const tinted = [-1.2, 0, 1.2].map((along) => {
    thing.position.set(0, 1.2, 0).addScaledVector(forward, along);
    thing.lookAt(host.camera.position);
    const pixels = draw(host);
    const inner = mask.flatMap((isSmoke, pixel) => (isSmoke && !isEdge(mask, pixel) ? [pixel] : []));
    const isTinted = inner.filter((pixel) => differs(pixels, untouched, pixel));
    wrong += isTinted.filter((pixel) => !isHalfGreen(pixels, untouched, pixel)).length;
    return isTinted.length / inner.length;
  });
  dispose(smoke, host.renderer);
  return { before: tinted[0], within: tinted[1], behind: tinted[2], wrong };
}

const HALF_GREEN = { color: '#00ff00', opacity: 0.5, transparent: true } as const;

function pane(): Mesh {
  return new Mesh(new PlaneGeometry(3, 3), new MeshBasicMaterial(HALF_GREEN));
}

function sprite(): Sprite {
  const thing = new Sprite(new SpriteMaterial(HALF_GREEN));
  thing.scale.setScalar(3);
  return thing;
}

function isEdge(mask: readonly boolean[], pixel: number): boolean {
  return [1, -1, WIDTH, -WIDTH, 2, -2, 2 * WIDTH, -2 * WIDTH].some((step) => !mask[pixel + step]);
}

function differs(a: Pixels, b: Pixels, pixel: number): boolean {
  return [0, 1, 2].some((channel) => a[4 * pixel + channel] !== b[4 * pixel + channel]);
}

function isHalfGreen(tinted: Pixels, plain: Pixels, pixel: number): boolean {
  return [0, 255, 0].every(
    (green, channel) => Math.abs(tinted[4 * pixel + channel] - (plain[4 * pixel + channel] + green) / 2) <= 1,
  );
}
