import type { Object3D } from 'three';

/** Whether an object is drawn with a scene: it is a descendant, and neither it nor an ancestor is hidden. */
export function isShown(object: Object3D, scene: Object3D): boolean {
  for (let at: Object3D | null = object; at?.visible; at = at.parent) if (at === scene) return true;
  return false;
}
