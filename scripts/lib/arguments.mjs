/** Parses the command-line arguments of the scripts. */

import { parseArgs } from 'node:util';
import { UserError } from './userError.mjs';

/**
 * Parses the arguments of this process.
 *
 * @template {import('node:util').ParseArgsConfig['options']} Options
 * @param {Options} options as for `util.parseArgs`
 * @param {string} usage printed when the arguments are invalid
 */
export function readArguments(options, usage) {
  try {
    return parseArgs({ options, allowPositionals: true, strict: true });
  } catch (error) {
    throw new UserError(`${firstSentence(error)} Usage: ${usage}`);
  }
}

/**
 * Parses a TCP port.
 *
 * @param {string | boolean | undefined} text
 * @param {number} otherwise the default port
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
