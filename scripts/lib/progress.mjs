/**
 * Shows the progress of a command. A terminal gets one line that is redrawn; a log gets a line at the start, at
 * intervals, and at the end. Concurrent tasks share the terminal's line.
 */

const LOG_INTERVAL = 10_000;
const REDRAW_INTERVAL = 200;

/**
 * The status of each running task.
 * @type {Map<symbol, string>}
 */
const notified = new Map();

/**
 * Runs a task under a title and shows its elapsed time and last status line.
 *
 * @template T
 * @param {string} title
 * @param {(say: (line: string) => void) => Promise<T>} work
 * @param {(result: T) => string} [summary] printed after the title at the end
 * @returns {Promise<T>}
 */
export async function withProgress(title, work, summary = () => 'done') {
  const began = Date.now();
  const elapsed = () => `${((Date.now() - began) / 1000).toFixed(1)} s`;
  const key = Symbol(title);
  let last = '';
  const show = process.stdout.isTTY
    ? (/** @type {string} */ line) => redraw(notified.set(key, line))
    : (/** @type {string} */ line) => console.log(line);
  if (!process.stdout.isTTY) console.log(`${title} ...`);
  const timer = setInterval(
    () => show(`${title}: ${elapsed()}${last && `, ${last}`}`),
    process.stdout.isTTY ? REDRAW_INTERVAL : LOG_INTERVAL,
  );
  try {
    const result = await work((line) => (last = line));
    finish(`${title}: ${summary(result)} (${elapsed()})`);
    return result;
  } catch (error) {
    finish(`${title}: stopped after ${elapsed()}`);
    throw error;
  } finally {
    clearInterval(timer);
    notified.delete(key);
  }
}

function redraw(/** @type {Map<symbol, string>} */ lines) {
  const width = (process.stdout.columns || 80) - 1;
  process.stdout.write(`\r\u001b[2K${[...lines.values()].join(' | ').slice(0, width)}`);
}

function finish(/** @type {string} */ line) {
  process.stdout.write(process.stdout.isTTY ? `\r\u001b[2K${line}\n` : `${line}\n`);
}
