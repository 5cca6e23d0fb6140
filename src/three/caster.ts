import type { InstancedMesh, Object3D } from 'three';
import type { HostCaster, HostCasters } from './casters.ts';
import { requireOptions } from '../base/errors.ts';
import type { SmokeFrame } from './smokeSpace.ts';
import { Handle } from './handle.ts';
import type { CastOptions } from './options.ts';
import { requireProxies } from './proxies.ts';
import { worldPose } from './objectParts.ts';
import { meshesIn, newPose } from './shapes.ts';

/** An object of the host's scene that casts shadow volumes. */
export class Caster extends Handle {
  private readonly casters: HostCasters;
  private readonly frame: SmokeFrame;
  private readonly options: CastOptions;
  private added: readonly HostCaster[] = [];
  /** Scale of the smoke for which its volumes were made. */
  private scale = 1;
  /** What its shapes were made for, besides. */
  private drawn = '';

  /** @throws ParameterError for an unknown option or a proxy without a radius */
  constructor(casters: HostCasters, frame: SmokeFrame, object: Object3D, options: CastOptions) {
    super('cast', object);
    requireOptions('cast', options, ['proxies']);
    requireProxies('cast', options.proxies);
    this.casters = casters;
    this.frame = frame;
    this.options = options;
  }

  protected start(): void {
    this.requireSound(worldPose(this.object, pose));
    this.scale = this.frame.now.scale;
    this.drawn = drawnOf(this.object);
    this.added = this.casters.add(this.object, this.options.proxies);
  }

  protected override follow(): void {
    this.requireSound(worldPose(this.object, pose));
    if (this.frame.now.scale === this.scale && drawnOf(this.object) === this.drawn) return;
    this.stop();
    this.start();
  }

  protected stop(): void {
    this.casters.remove(this.added);
  }
}

const pose = newPose();

/** What changes the shapes of meshes: morph targets and numbers of instances. */
function drawnOf(object: Object3D): string {
  const numbers = meshesIn(object).map((mesh) => [mesh.morphTargetInfluences, (mesh as InstancedMesh).count]);
  return JSON.stringify(numbers);
}
