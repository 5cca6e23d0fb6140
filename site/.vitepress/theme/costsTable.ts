import type { CaseCost, CostReport } from '../../../src/demo/costs/report.ts';

const BROWSERS: readonly (readonly [string, RegExp])[] = [
  ['Edge', /\bEdgA?\/(\d+)/],
  ['Opera', /\bOPR\/(\d+)/],
  ['Samsung Internet', /\bSamsungBrowser\/(\d+)/],
  ['Firefox', /\b(?:Firefox|FxiOS)\/(\d+)/],
  ['Chrome', /\b(?:HeadlessChrome|Chrome|CriOS)\/(\d+)/],
  ['Safari', /\bVersion\/([\d.]+).* Safari\//],
];

/** Name and version of the browser with this user agent string. */
export function browserName(userAgent: string): string {
  for (const [name, pattern] of BROWSERS) {
    const version = pattern.exec(userAgent)?.[1];
    if (version) return `${name} ${version}`;
  }
  return 'Unknown browser';
}

/** The columns of a report and the cells of its rows, as text. */
export function cellsOf({ cases }: CostReport): { head: string[]; rows: string[][] } {
  const hasGpu = cases.some(({ gpuMilliseconds }) => gpuMilliseconds !== undefined);
  const head = ['case', 'ratio', 'ms a frame', 'ms a step', ...(hasGpu ? ['ms on the GPU'] : []), 'frames a second'];
  const row = (each: CaseCost) => [
    each.name,
    short(each.ratio),
    short(each.milliseconds),
    short(each.stepMilliseconds),
    ...(hasGpu ? [each.gpuMilliseconds === undefined ? '' : short(each.gpuMilliseconds)] : []),
    short(each.framesPerSecond),
  ];
  return { head, rows: cases.map(row) };
}

/** A sentence about the passes on the GPU; empty if they were not measured. */
export function passesOf({ cases, passes }: CostReport): string {
  if (passes.length === 0) return '';
  const parts = passes.map(({ name, milliseconds }) => `${name} ${short(milliseconds)} ms`);
  return `Draw calls of ${cases[0].name} on the GPU: ${parts.join(', ')}.`;
}

/** A report in Markdown. */
export function markdownOf(report: CostReport, userAgent: string): string {
  const { gpu, width, height, rounds } = report;
  const { head, rows } = cellsOf(report);
  const line = (cells: readonly string[]) => `| ${cells.join(' | ')} |`;
  const passes = passesOf(report);
  const rule = head.map((_, column) => (column === 0 ? '---' : '---:'));
  return [
    `${gpu.replaceAll('|', '/')}, ${browserName(userAgent)}, ${width} x ${height} CSS pixels, rounds: ${rounds}`,
    '',
    ...[head, rule, ...rows].map(line),
    ...(passes ? ['', passes] : []),
    '',
  ].join('\n');
}

/** Three significant digits. */
function short(value: number): string {
  return value >= 100 ? value.toFixed(0) : value.toPrecision(3);
}
