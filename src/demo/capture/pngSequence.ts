import { Zip, ZipPassThrough } from 'fflate';
import { encodePng, shootClip, type Studio, type Task } from '../../internal.ts';
import { LayerCamera } from './layers.ts';
import { pixelSize, type CaptureSettings } from './settings.ts';

/** Encodes numbered PNGs with alpha in a zip; with layers, one folder for each layer. */
export async function makePngSequence(studio: Studio, settings: CaptureSettings, task: Task): Promise<Blob> {
  const archive = new Archive();
  const layers = settings.inLayers ? new LayerCamera(studio, ...pixelSize(settings)) : undefined;
  await shootClip(studio, settings, task, async (frame) => {
    const name = `${String(frame + 1).padStart(4, '0')}.png`;
    if (!layers) return archive.add(`frame-${name}`, await encodePng(studio.canvas));
    for (const [layer, pixels] of await layers.shoot()) {
      await archive.add(`${layer}/${name}`, await layers.encode(pixels));
    }
  });
  return archive.finish();
}

/** A zip without compression, because PNGs are compressed already. */
export class Archive {
  private readonly parts: Uint8Array<ArrayBuffer>[] = [];
  private failure: Error | undefined;
  private readonly zip = new Zip((error, part) => {
    if (error) this.failure = error;
    else this.parts.push(part);
  });

  async add(name: string, content: Blob): Promise<void> {
    const entry = new ZipPassThrough(name);
    this.zip.add(entry);
    entry.push(new Uint8Array(await content.arrayBuffer()), true);
  }

  finish(): Blob {
    this.zip.end();
    if (this.failure) throw this.failure;
    return new Blob(this.parts, { type: 'application/zip' });
  }
}
