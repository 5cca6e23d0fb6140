import type { Stage } from '../../index.ts';
import { encodesWebp, type ClipFormat, type Task } from '../../internal.ts';
import { strings } from '../strings.ts';
import { capture } from './capture.ts';
import { hevcWithAlpha } from './clips/hevc.ts';
import { makeLoops } from './clips/loops.ts';
import { COMPARED, FASTEST_GIF, FORMATS, pixelSize, type CaptureSettings, type ComparedFormat } from './settings.ts';
import { openCopy, VideoError } from './studio.ts';

export interface Compared {
  readonly format: ComparedFormat;
  /** Undefined if there is none. */
  readonly file?: Blob;
  /** Why there is no file, or what differs in it. */
  readonly note?: string;
}

const VIDEOS = ['webm', 'mp4'] as const;

/**
 * Captures the same clip in all formats for clips. The stage is not modified.
 * @param settings their format is ignored
 * @returns a row for each format, in the order of COMPARED
 * @throws the reason of the task's signal when it is aborted
 */
export async function compareFormats(
  stage: Stage,
  settings: CaptureSettings,
  { signal, onProgress }: Task,
): Promise<readonly Compared[]> {
  const found: Compared[] = [];
  let finished = 0;
  // One pass for all loops, and one for each video.
  const pass = () => {
    const before = finished++;
    return { signal, onProgress: (share: number) => onProgress((before + share) / (1 + VIDEOS.length)) };
  };
  const loops: ClipFormat[] = ['apng'];
  if (await encodesWebp()) loops.push('webp');
  else found.push({ format: 'webp', note: strings.capture.missing });
  if (settings.rate <= FASTEST_GIF) loops.push('gif');
  else found.push({ format: 'gif', note: strings.capture.tooFast(FASTEST_GIF) });
  const files = await captureLoops(loops, stage, settings, pass());
  loops.forEach((format, at) => found.push({ format, file: files[at] }));
  for (const format of VIDEOS) {
    const hasAlpha = format === 'mp4' ? await encodesAlpha(settings) : FORMATS[format].hasAlpha;
    const hasBackground = settings.hasBackground || !hasAlpha;
    const note = hasBackground === settings.hasBackground ? undefined : strings.capture.opaque;
    const video = capture(stage, { ...settings, format, hasBackground }, pass());
    found.push(await video.then((file) => ({ format, file, note }), missing(format)));
  }
  return found.sort((a, b) => COMPARED.indexOf(a.format) - COMPARED.indexOf(b.format));
}

async function captureLoops(
  formats: readonly ClipFormat[],
  stage: Stage,
  settings: CaptureSettings,
  task: Task,
): Promise<readonly Blob[]> {
  const studio = await openCopy(stage, { ...settings, format: formats[0] });
  try {
    return await makeLoops(formats, studio, { ...settings, format: formats[0] }, task);
  } finally {
    studio.stage.dispose();
  }
}

async function encodesAlpha(settings: CaptureSettings): Promise<boolean> {
  const [width, height] = pixelSize({ ...settings, format: 'mp4' });
  return (await hevcWithAlpha({ width, height, rate: settings.rate })) !== undefined;
}

/** The row of a format that the browser does not encode. */
function missing(format: ComparedFormat): (error: unknown) => Compared {
  return (error) => {
    if (!(error instanceof VideoError)) throw error;
    return { format, note: strings.capture.missing };
  };
}
