import { Vector3, type Object3D } from 'three';

/** Where an emitter is, while it follows an object. */
export class Nozzle {
  private readonly object: Object3D;
  private readonly key: string;
  private readonly position = new Vector3();
  private readonly direction = new Vector3();

  constructor(object: Object3D, emitter: number) {
    this.object = object;
    this.key = `emitters.${emitter}`;
  }

  /** The simulator's values for it as the object stands now. */
  values(): Record<string, number> {
    const { object, key, position, direction } = this;
    object.updateWorldMatrix(true, false);
    position.setFromMatrixPosition(object.matrixWorld);
    direction.set(0, 1, 0).transformDirection(object.matrixWorld);
    return { ...vectorValues(`${key}.position`, position), ...vectorValues(`${key}.direction`, direction) };
  }
}

function vectorValues(key: string, { x, y, z }: Vector3): Record<string, number> {
  return { [`${key}.x`]: x, [`${key}.y`]: y, [`${key}.z`]: z };
}
