import { Box3, type InstancedMesh, type Mesh, type Object3D, type SkinnedMesh } from 'three';
import { isBlended, materialsOf } from './materials.ts';

const scratch = new Box3();

/** The box of all that is opaque in a scene, world space: beyond it no shadow can be seen. */
export function receiversIn(scene: Object3D, into: Box3): Box3 {
  into.makeEmpty();
  scene.traverseVisible((object) => {
    if (!('isMesh' in object)) return;
    const mesh = object as Mesh;
    if (materialsOf(mesh).some((material) => !isBlended(material))) into.union(boxOf(mesh, scratch));
  });
  return into;
}

/** As three.js bounds them for culling: deformed meshes by a sphere that they themselves keep. */
function boxOf(mesh: Mesh, into: Box3): Box3 {
  const deformed = mesh as Mesh &
    Partial<Pick<SkinnedMesh | InstancedMesh, 'boundingSphere' | 'computeBoundingSphere'>>;
  if (deformed.computeBoundingSphere) {
    if (!deformed.boundingSphere) deformed.computeBoundingSphere();
    deformed.boundingSphere!.getBoundingBox(into);
  } else {
    if (!mesh.geometry.boundingBox) mesh.geometry.computeBoundingBox();
    into.copy(mesh.geometry.boundingBox!);
  }
  return into.applyMatrix4(mesh.matrixWorld);
}
