import { ParameterError } from '../base/errors.ts';

/**
 * Rejects invalid indices before conversion: a Uint32Array would wrap -1 to a valid number.
 * @throws ParameterError for an index that is not an unsigned 32-bit integer
 */
export function requireIndices(indices: ArrayLike<number>, name: string): void {
  for (let index = 0; index < indices.length; index++) {
    const vertex = indices[index];
    if (!Number.isInteger(vertex) || vertex < 0 || vertex > 0xffffffff) {
      throw new ParameterError(`${name}.indices.${index}`, vertex, 'a vertex index');
    }
  }
}
