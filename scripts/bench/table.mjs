/**
 * @typedef {object} Figure
 * @property {string} name
 * @property {number} value
 * @property {string} unit
 * @property {[number, number]} [range] minimum and maximum of the rounds
 * @property {number} [rounds]
 * @property {string} [note]
 */

/**
 * Formats figures as text columns: name, value with unit, range, rounds, note.
 *
 * @param {Figure[]} figures
 */
export function figuresTable(figures) {
  const rows = [['figure', 'value', 'range', 'rounds', 'note'], ...figures.map(cells)];
  const widths = rows[0].map((_, column) => Math.max(...rows.map((row) => row[column].length)));
  return rows
    .map((row) =>
      row
        .map((cell, column) => cell.padEnd(widths[column]))
        .join('  ')
        .trimEnd(),
    )
    .join('\n');
}

function cells(/** @type {Figure} */ { name, value, unit, range, rounds, note }) {
  const span = range ? `${short(range[0])} to ${short(range[1])}` : '';
  return [name, `${short(value)} ${unit}`.trim(), span, rounds === undefined ? '' : String(rounds), note ?? ''];
}

/** Four significant digits: more would be noise on a shared machine. */
function short(/** @type {number} */ value) {
  return Number.isInteger(value) ? String(value) : String(Number(value.toPrecision(4)));
}
