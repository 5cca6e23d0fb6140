/** Values of an emitter in the rig of a scene. @param values by their names within the emitter, such as `speed` */
export function emitterRig(index: number, values: Readonly<Record<string, number>>): Record<string, number> {
  return Object.fromEntries(Object.entries(values).map(([name, value]) => [`emitters.${index}.${name}`, value]));
}
