/** The video of a shot, from its finished frames. */

import { spawn, spawnSync } from 'node:child_process';
import { renameSync, rmSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { UserError } from '../lib/userError.mjs';

const MISSING = '--video with .mov needs ffmpeg for ProRes 4444: install ffmpeg, or choose .webm or .mp4.';

/** @throws {UserError} when ffmpeg does not start */
export function requireFfmpeg() {
  if (spawnSync('ffmpeg', ['-version'], { stdio: 'ignore' }).status !== 0) throw new UserError(MISSING);
}

/**
 * Encodes PNG files as ProRes 4444 with alpha.
 *
 * @param {string} file
 * @param {{ folder: string, first: number, last: number, fps: number }} frames the last one included
 */
export async function encodeByFfmpeg(file, { folder, first, last, fps }) {
  const part = join(dirname(file), `.${basename(file, '.mov')}.part.mov`);
  const input = ['-framerate', String(fps), '-start_number', String(first), '-i', join(folder, 'frame-%06d.png')];
  const codec = ['-c:v', 'prores_ks', '-profile:v', '4444', '-pix_fmt', 'yuva444p10le', '-vendor', 'apl0'];
  const count = ['-frames:v', String(last - first + 1)];
  const child = spawn('ffmpeg', ['-v', 'error', '-y', ...input, ...codec, ...count, part], {
    stdio: ['ignore', 'ignore', 'pipe'],
  });
  let output = '';
  child.stderr.setEncoding('utf8').on('data', (text) => (output += text));
  const status = await new Promise((resolve) => child.once('close', resolve).once('error', () => resolve(127)));
  if (status !== 0) {
    rmSync(part, { force: true });
    throw new UserError(`ffmpeg could not write ${file}.`, output);
  }
  renameSync(part, file);
}
