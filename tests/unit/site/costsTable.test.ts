/** The table that a visitor can share, and the names of browsers in it. */
import { describe, expect, it } from 'vitest';
import { browserName, cellsOf, markdownOf } from '../../../site/.vitepress/theme/costsTable.ts';
import type { CostReport } from '../../../src/demo/costs/report.ts';

const CHROME = 'Mozilla/5.0 (X11; Linux x86_64) AppleWebKit/537.36 (KHTML, like Gecko) Chrome/143.0.0.0 Safari/537.36';
const REPORT: CostReport = {
  gpu: 'ANGLE (A | B)',
  width: 960,
  height: 540,
  rounds: 5,
  passes: [
    { name: 'puffs', milliseconds: 1.234 },
    { name: 'shadow volumes', milliseconds: 0.5 },
  ],
  cases: [
    {
      name: '2,000 puffs',
      puffs: 2000,
      framesPerSecond: 60.04,
      milliseconds: 4.321,
      ratio: 1,
      stepMilliseconds: 0.5,
      gpuMilliseconds: 3.1,
    },
    {
      name: '`cast` of a mesh',
      puffs: 2000,
      framesPerSecond: 9.5,
      milliseconds: 104.321,
      ratio: 24.143,
      stepMilliseconds: 0.0123,
    },
  ],
};

describe('browserName', () => {
  it.each([
    ['Chrome 143', CHROME],
    ['Chrome 143', CHROME.replace('Chrome/', 'HeadlessChrome/')],
    ['Edge 143', `${CHROME} Edg/143.0.0.0`],
    ['Opera 120', `${CHROME} OPR/120.0.0.0`],
    ['Samsung Internet 28', CHROME.replace('Chrome/', 'SamsungBrowser/28.0 Chrome/')],
    ['Firefox 145', 'Mozilla/5.0 (X11; Linux x86_64; rv:145.0) Gecko/20100101 Firefox/145.0'],
    [
      'Safari 26.1',
      'Mozilla/5.0 (Macintosh; Intel Mac OS X 10_15_7) AppleWebKit/605.1.15 (KHTML, like Gecko) Version/26.1 Safari/605.1.15',
    ],
    ['Unknown browser', 'curl/8'],
  ])('finds %s', (name, userAgent) => {
    expect(browserName(userAgent)).toBe(name);
  });
});

describe('the table', () => {
  it('is Markdown with three digits, and an empty cell for what was not measured', () => {
    expect(markdownOf(REPORT, CHROME)).toBe(`ANGLE (A / B), Chrome 143, 960 x 540 CSS pixels, rounds: 5

| case | ratio | ms a frame | ms a step | ms on the GPU | frames a second |
| --- | ---: | ---: | ---: | ---: | ---: |
| 2,000 puffs | 1.00 | 4.32 | 0.500 | 3.10 | 60.0 |
| \`cast\` of a mesh | 24.1 | 104 | 0.0123 |  | 9.50 |

Draw calls of 2,000 puffs on the GPU: puffs 1.23 ms, shadow volumes 0.500 ms.
`);
  });

  it('has no column of the GPU without timer queries', () => {
    const cases = REPORT.cases.map((each) => ({ ...each, gpuMilliseconds: undefined }));
    const report = { ...REPORT, cases, passes: [] };
    expect(markdownOf(report, CHROME)).not.toContain('on the GPU');
    const { head, rows } = cellsOf(report);
    expect(head).not.toContain('ms on the GPU');
    for (const row of rows) expect(row).toHaveLength(head.length);
  });
});
