import { ParameterError } from '../preset/errors.ts';

/** A typed array would wrap an index such as -1 into one that may exist; such an index is refused here. */
export function requireIndices(indices: ArrayLike<number>, name: string): void {
  for (let index = 0; index < indices.length; index++) {
    const vertex = indices[index];
    if (!Number.isInteger(vertex) || vertex < 0 || vertex > 0xffffffff) {
      throw new ParameterError(`${name}.indices.${index}`, vertex, 'a vertex index');
    }
  }
}
