/** The keyframes of a camera, `--camera FILE` of `cartoon-smoke film`. */

import { readFileSync } from 'node:fs';
import { UserError } from '../lib/userError.mjs';

/** @typedef {import('../../src/demo/film/order.ts').Keyframe} Keyframe */

const CAMERA_KEYS = ['azimuth', 'elevation', 'distance', 'target.x', 'target.y', 'target.z'].map(
  (name) => `camera.${name}`,
);

/**
 * Reads the keyframes of a file.
 *
 * @param {string} file
 * @param {number} fps
 * @returns {Keyframe[]}
 * @throws {UserError} one line that names the keyframe
 */
export function readCamera(file, fps) {
  const keyframes = readJson(file);
  if (!Array.isArray(keyframes) || keyframes.length === 0) {
    throw new UserError(`--camera ${file}: it has to be a list of keyframes, [{ "frame": 0, "camera.azimuth": 20 }].`);
  }
  const read = keyframes.map((entry, at) => readKeyframe(entry, `--camera ${file}: keyframe ${at + 1}`, fps));
  read.forEach(({ seconds }, at) => {
    if (at > 0 && seconds <= read[at - 1].seconds) {
      throw new UserError(`--camera ${file}: keyframe ${at + 1} is not after the one before it.`);
    }
  });
  return read;
}

function readJson(/** @type {string} */ file) {
  try {
    return /** @type {unknown} */ (JSON.parse(readFileSync(file, 'utf8')));
  } catch (error) {
    throw new UserError(`--camera ${file} cannot be read: ${error instanceof Error ? error.message : String(error)}`);
  }
}

/**
 * @param {unknown} entry
 * @param {string} where
 * @param {number} fps
 * @returns {Keyframe}
 */
function readKeyframe(entry, where, fps) {
  const { frame, ...values } = /** @type {Record<string, unknown>} */ (Object(entry));
  if (typeof frame !== 'number' || !(frame >= 0)) throw new UserError(`${where} needs a frame of at least 0.`);
  for (const [key, value] of Object.entries(values)) {
    if (!CAMERA_KEYS.includes(key)) throw new UserError(`${where} has ${key}: the keys are ${CAMERA_KEYS.join(', ')}.`);
    if (typeof value !== 'number' || !Number.isFinite(value)) throw new UserError(`${where}: ${key} is not a number.`);
  }
  return { seconds: frame / fps, values: /** @type {Record<string, number>} */ (values) };
}
