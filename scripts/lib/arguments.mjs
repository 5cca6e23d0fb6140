/** Reads the arguments of the commands in this folder. */

import { parseArgs } from 'node:util';
import { UserError } from './userError.mjs';

/**
 * Parses the process's arguments.
 *
 * @template {import('node:util').ParseArgsConfig['options']} Options
 * @param {Options} options as `util.parseArgs` takes them
 * @param {string} usage the command's form, repeated when something else was given
 */
export function readArguments(options, usage) {
  try {
    return parseArgs({ options, allowPositionals: true, strict: true });
  } catch (error) {
    throw new UserError(`${firstSentence(error)} Usage: ${usage}`);
  }
}

/**
 * Reads a TCP port.
 *
 * @param {string | boolean | undefined} text
 * @param {number} otherwise the port when none was given
 */
export function readPort(text, otherwise) {
  if (text === undefined) return otherwise;
  const port = Number(text);
  if (/^\d+$/.test(String(text)) && port >= 1 && port <= 65535) return port;
  throw new UserError(`--port ${text} is not a port: give a whole number from 1 to 65535.`);
}

function firstSentence(/** @type {unknown} */ error) {
  const message = error instanceof Error ? error.message : String(error);
  return `${message.split(/\.\s/)[0]?.replace(/\.$/, '')}.`;
}
