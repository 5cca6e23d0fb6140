/** The figures `sim.cost.CONTESTANT.PARTICLES` as a table: a row per contestant, a column per number of particles. */

const PREFIX = 'sim.cost.';

/**
 * @param {import('../../../scripts/bench/table.mjs').Figure[]} figures
 * @returns {string | undefined}
 */
export function costsTable(figures) {
  const costs = figures.filter(({ name }) => name.startsWith(PREFIX));
  if (costs.length === 0) return undefined;
  const part = (/** @type {number} */ index) => [...new Set(costs.map(({ name }) => name.split('.')[index]))];
  const counts = part(3).sort((a, b) => Number(a) - Number(b));
  const cell = (/** @type {string} */ contestant, /** @type {string} */ count) => {
    const cost = costs.find(({ name }) => name === `${PREFIX}${contestant}.${count}`);
    return cost ? cost.value.toPrecision(3) : 'not measured';
  };
  const rows = part(2).map((contestant) => [contestant, ...counts.map((count) => cell(contestant, count))]);
  return format([['ns a particle and step', ...counts.map((count) => Number(count).toLocaleString('en'))], ...rows]);
}

/** @param {string[][]} rows the first column is text, the others are numbers */
function format(rows) {
  const widths = rows[0].map((_, column) => Math.max(...rows.map((row) => row[column].length)));
  const pad = (/** @type {string} */ cell, /** @type {number} */ column) =>
    column === 0 ? cell.padEnd(widths[0]) : cell.padStart(widths[column]);
  return rows.map((row) => row.map(pad).join('  ')).join('\n');
}
