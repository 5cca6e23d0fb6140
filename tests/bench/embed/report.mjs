/** The results as figures, with notes about unequal work. */

import { spread } from '../support/spread.mjs';
import { TRIANGLES } from './ball.mjs';
import { CIRCLES } from './contestants.mjs';

/**
 * @typedef {import('../../../scripts/bench/table.mjs').Figure} Figure
 * @typedef {import('./visit.mjs').Window} Window
 *
 * @typedef {object} Measured Results of one contestant with one number of widgets.
 * @property {string} name
 * @property {number} count
 * @property {{ file: string, bytes: number }[]} files with their size on the wire
 * @property {import('./visit.mjs').Loaded[]} loads
 * @property {Window[]} seen
 * @property {Window[]} unseen
 * @property {number | undefined} megabytes more than the page without widgets
 */

const OURS = 'worker';
const BUDGET_MS = 0.5;

/** @param {Measured[]} all @returns {Figure[]} */
export function report(all) {
  const widgets = all.filter(({ name }) => name !== 'nothing');
  return [
    ...filesOf(widgets),
    ...widgets.flatMap(mainThread),
    ...all.flatMap(processor),
    ...widgets.flatMap(arrival),
    ...widgets.flatMap(memory),
    ...versus(all, 'tsParticles', 'embed.vsTsParticles', UNEQUAL.tsParticles),
    ...versus(all, 'modelViewer', 'embed.vsModelViewer', UNEQUAL.modelViewer),
    ...ratesVersus(all, 'modelViewer', 'embed.vsModelViewer', UNEQUAL.modelViewer),
  ];
}

const UNEQUAL = {
  tsParticles: `${CIRCLES} flat discs on a 2D canvas, drawn on the main thread, without shapes, shadows or ink`,
  modelViewer: `a ball of ${TRIANGLES} triangles that turns, lit by a map, without simulation; on one context as we are`,
};

/**
 * The element in a worker has the name without a suffix.
 * @param {string} stem
 * @param {Measured} of
 */
function nameOf(stem, { name, count }) {
  return `embed.${stem}${name === OURS ? '' : `.${name}`}${count === 1 ? '' : `.${count}`}`;
}

/** @param {Measured[]} all @returns {Figure[]} */
function filesOf(all) {
  const single = all.filter(({ count }) => count === 1);
  return single.flatMap((measured) => [
    { name: nameOf('bytes', measured), value: total(measured) / 1000, unit: 'kB', note: 'gzip, all files below' },
    ...measured.files.map(({ file, bytes }) => ({
      name: nameOf('bytes', measured),
      value: bytes / 1000,
      unit: 'kB',
      note: file,
    })),
  ]);
}

/** @param {Measured} measured */
function total({ files }) {
  return files.reduce((sum, { bytes }) => sum + bytes, 0);
}

/** @param {Measured} measured @returns {Figure[]} */
function mainThread(measured) {
  const frames = spread(framesASecond(measured)).value;
  const budget = measured.name === OURS && measured.count === 1 ? `; budget ${BUDGET_MS}` : '';
  const whose = measured.count === 1 ? '' : ` for all ${measured.count}`;
  const note = `a frame drawn${whose}, of all that the page does; ${frames.toFixed(1)} frames a second${budget}`;
  return [{ name: nameOf('mainThreadMs', measured), unit: 'ms', ...spread(perFrame(measured)), note }];
}

/**
 * By round.
 * @param {Measured} measured
 */
function framesASecond({ seen }) {
  return seen.map(({ frames, frameSeconds }) => frames / frameSeconds);
}

/**
 * By round.
 * @param {Measured} measured
 */
function perFrame({ seen }) {
  return seen.map(({ mainMs, frames }) => mainMs / frames);
}

/** @param {Measured} measured @returns {Figure[]} */
function processor(measured) {
  const shares = (/** @type {Window[]} */ windows) => spread(windows.map(shareOf));
  const unit = '% of a core';
  return [
    { name: nameOf('cpu', measured), unit, ...shares(measured.seen), note: 'in view, page and drawing process' },
    { name: nameOf('idleCpu', measured), unit, ...shares(measured.unseen), note: 'out of view' },
  ];
}

/**
 * Percent of a core.
 * @param {Window} window
 */
function shareOf({ processorSeconds, seconds }) {
  return (100 * processorSeconds) / seconds;
}

/** @param {Measured} measured @returns {Figure[]} */
function arrival(measured) {
  const all = spread(measured.loads.map((load) => load.all)).value;
  const note =
    measured.count === 1 ? 'nothing in any cache' : `of one, all ${measured.count} after ${all.toFixed(0)} ms`;
  return [
    { name: nameOf('firstSmoke', measured), unit: 'ms', ...spread(measured.loads.map(({ first }) => first)), note },
  ];
}

/** @param {Measured} measured @returns {Figure[]} */
function memory(measured) {
  if (measured.megabytes === undefined) return [];
  const value = measured.megabytes / measured.count;
  return [{ name: nameOf('memory', measured), value, unit: 'MB', note: 'a widget, page and drawing process' }];
}

/** @param {Measured[]} all @param {string} name @param {number} count of widgets */
function find(all, name, count) {
  const found = all.find((each) => each.name === name && each.count === count);
  if (!found) throw new Error(`${name} was not measured.`);
  return found;
}

/**
 * For each number of widgets above one, by round, ours divided by those of the other: frames of the page a second in
 * which a widget was drawn, and drawings of a widget a second. They differ where widgets are drawn in turns.
 *
 * @param {Measured[]} all
 * @param {string} other
 * @param {string} name
 * @param {string} unequal
 * @returns {Figure[]}
 */
function ratesVersus(all, other, name, unequal) {
  const several = all.filter((each) => each.name === OURS && each.count > 1);
  return several.flatMap((ours) => {
    const { count } = ours;
    const theirs = find(all, other, count);
    const goal = count === 40 ? '; goal >= 1' : '';
    /** @param {(of: Measured) => number[]} rate @param {(rates: string) => string} noteOf */
    const figure = (rate, noteOf) => {
      const [ofOurs, ofTheirs] = [rate(ours), rate(theirs)];
      const rates = [ofOurs, ofTheirs].map((rounds) => spread(rounds).value.toFixed(1)).join(' and ');
      return { unit: 'x', ...spread(ofOurs.map((value, round) => value / ofTheirs[round])), note: noteOf(rates) };
    };
    return [
      {
        name: `${name}.frames.${count}`,
        ...figure(framesASecond, (rates) => `frames of the page a second, ${rates}${goal}; theirs: ${unequal}`),
      },
      {
        name: `${name}.drawings.${count}`,
        ...figure(drawingsASecond, (rates) => `drawings of a widget a second, ${rates}`),
      },
    ];
  });
}

/**
 * By round, of one of several widgets.
 * @param {Measured} measured
 */
function drawingsASecond({ seen, count }) {
  return seen.map(({ drawings, frameSeconds }) => drawings / frameSeconds / count);
}

/**
 * Our value divided by the other one, with one widget, by round.
 *
 * @param {Measured[]} all
 * @param {string} other
 * @param {string} name
 * @param {string} unequal
 * @returns {Figure[]}
 */
function versus(all, other, name, unequal) {
  const [ours, theirs] = [find(all, OURS, 1), find(all, other, 1)];
  const [ofOurs, ofTheirs] = [perFrame(ours), perFrame(theirs)];
  const times = ofOurs.map((ms, round) => ms / ofTheirs[round]);
  const idle = ours.unseen.map((window, round) => shareOf(window) - shareOf(theirs.unseen[round]));
  return [
    { name, unit: '', ...spread(times), note: `main-thread time a frame; theirs: ${unequal}` },
    { name: `${name}.bytes`, value: total(ours) / total(theirs), unit: '', note: 'all that is fetched, gzip' },
    { name: `${name}.idleCpu`, unit: '% of a core', ...spread(idle), note: 'ours minus theirs, out of view' },
  ];
}
