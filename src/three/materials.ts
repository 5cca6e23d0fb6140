import type { Material, Mesh } from 'three';

/** The materials of anything that is drawn; none of what is not. */
export function materialsOf({ material }: Partial<Pick<Mesh, 'material'>>): readonly Material[] {
  if (!material) return [];
  return Array.isArray(material) ? material : [material];
}

/** Whether a material is drawn after all opaque ones. */
export function isBlended(material: Material): boolean {
  return material.transparent || ('transmission' in material && (material.transmission as number) > 0);
}
