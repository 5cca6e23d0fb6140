import type { Device } from '../device/device.ts';
import { lobeBodyShaders } from '../passes/bodies.ts';
import { lobeVolumeShaders } from '../passes/volumes.ts';
import type { Values } from '../preset/parameter.ts';

/**
 * Has the two programs compiled that take longest, those of puffs as these values describe them, while other things are on
 * their way. Other programs are small, or belong to what few people ask for.
 */
export function compileAhead(device: Device, values: Values): void {
  if (!device.isUsable || values['puff.form'] !== 'lobes') return;
  const lobes = values['puff.lobes'] as number;
  device.programs.compile(device.renderer, lobeBodyShaders(lobes, !device.writesDepth));
  if (device.writesDepth) device.programs.compile(device.renderer, lobeVolumeShaders(lobes));
}
