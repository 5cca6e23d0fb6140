import type { Material, Mesh } from 'three';

/** Draws once with a mesh in another material. */
export function withMaterial<Drawn extends Material>(
  mesh: { material: Drawn } & Mesh,
  other: Drawn,
  draw: () => void,
): void {
  const { material: present } = mesh;
  mesh.material = other;
  draw();
  mesh.material = present;
}
