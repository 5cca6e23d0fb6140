import type { Object3D } from 'three';
import { ParameterError } from '../base/errors.ts';
import { findParameter } from '../parameters/table.ts';
import { Handle } from './handle.ts';
import type { Overrides } from './overrides.ts';
import { worldPose, type ObjectPart, type ObjectParts } from './objectParts.ts';
import { newPose } from './shapes.ts';

/** What an attachment needs of its smoke. */
export interface AttachmentContext {
  readonly parts: ObjectParts;
  readonly overrides: Overrides;
  /** Items of the table that ride on an object. */
  readonly attached: Set<string>;
}

/** A force or an emitter of the parameter table that rides on an object. */
export class Attachment extends Handle {
  private readonly context: AttachmentContext;
  private readonly item: string;
  private part: ObjectPart | undefined;

  /** @param item such as `vortices.0` */
  constructor(context: AttachmentContext, item: string, object: Object3D) {
    super('attach', object);
    requireItem(item);
    if (context.attached.has(item))
      throw new ParameterError('attach', item, 'an item that is not attached yet; remove its handle first');
    this.requireSound(context.parts.frame.toSmoke(worldPose(object, pose)));
    this.context = context;
    this.item = item;
    context.attached.add(item);
  }

  protected start(): void {
    const { context, item, object } = this;
    this.requireSound(context.parts.frame.toSmoke(worldPose(object, pose)));
    this.part = context.parts.add(pose);
    context.overrides.put(`${item}.rigid`, this.part.number);
    context.overrides.unmute(item);
  }

  protected override follow(): void {
    const { parts } = this.context;
    this.requireSound(parts.frame.toSmoke(worldPose(this.object, pose)));
    parts.move(this.part!, pose);
  }

  protected stop(): void {
    this.context.parts.remove(this.part!);
    this.part = undefined;
    this.context.overrides.mute(this.item);
  }

  protected override release(): void {
    const { context, item } = this;
    context.attached.delete(item);
    context.overrides.drop(`${item}.rigid`);
    context.overrides.restore(item);
  }
}

const pose = newPose();

function requireItem(item: string): void {
  const isItem =
    typeof item === 'string' && ['rigid', 'envelope.duration'].every((key) => findParameter(`${item}.${key}`));
  if (!isItem) throw new ParameterError('attach', item, 'an item of a list of forces or emitters, such as vortices.0');
}
