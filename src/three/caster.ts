import { Quaternion, Vector3, type Object3D } from 'three';
import type { HostCaster, HostCasters } from './casters.ts';
import { Handle } from './handle.ts';
import type { CastOptions } from './options.ts';
import { requireProxies } from './proxies.ts';
import { requireKnown } from './requirements.ts';
import { worldPose } from './riders.ts';
import type { Pose } from './shapes.ts';

/** An object of the host's scene that casts shadow volumes. */
export class Caster extends Handle {
  private readonly casters: HostCasters;
  private readonly options: CastOptions;
  private added: readonly HostCaster[] = [];

  /** @throws ParameterError for an unknown option or a proxy without a radius */
  constructor(casters: HostCasters, object: Object3D, options: CastOptions) {
    super('cast', object);
    requireKnown('cast', options, ['proxies']);
    requireProxies('cast', options.proxies);
    this.casters = casters;
    this.options = options;
  }

  protected start(): void {
    this.follow();
    this.added = this.casters.add(this.object, this.options.proxies);
  }

  protected override follow(): void {
    this.requireSound(worldPose(this.object, pose));
  }

  protected stop(): void {
    this.casters.remove(this.added);
  }
}

const pose: Pose = { position: new Vector3(), rotation: new Quaternion() };
