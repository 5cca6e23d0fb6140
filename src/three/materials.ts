import type { Material, Mesh } from 'three';

/** The materials of an object; empty for objects that are not drawn. */
export function materialsOf({ material }: Partial<Pick<Mesh, 'material'>>): readonly Material[] {
  if (!material) return [];
  return Array.isArray(material) ? material : [material];
}

/** Whether three.js draws a material after all opaque ones. */
export function isBlended(material: Material): boolean {
  return material.transparent || ('transmission' in material && (material.transmission as number) > 0);
}
