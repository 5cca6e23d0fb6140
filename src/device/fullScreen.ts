import { BufferAttribute, BufferGeometry, Mesh, type RawShaderMaterial } from 'three';

/** One triangle that covers the viewport; its vertex shader is shaders/lib/fullScreen.vert. */
export function fullScreenMesh(material: RawShaderMaterial): Mesh<BufferGeometry, RawShaderMaterial> {
  const geometry = new BufferGeometry();
  geometry.setAttribute('corner', new BufferAttribute(new Float32Array([-1, -1, 3, -1, -1, 3]), 2));
  geometry.setDrawRange(0, 3);
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  return mesh;
}
