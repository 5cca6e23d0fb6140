import { names } from '../../../../src/page/element/attributes/names.ts';
import { watchConsole } from '../../../support/consoleErrors.ts';
import { expect, MODULES, stands, test, WISP } from '../../../support/embed.ts';
import { longIf } from '../../../support/fixtures.ts';

const OWN = [
  'preset',
  'src',
  'start',
  'alt',
  'label-play',
  'label-pause',
  'thread',
  'loading',
  'collide',
  'emit-from',
  'emit-on',
  'paused',
  'transparent',
  'interactive',
];
const SCRIPT = `javascript:document.body.remove()`;
const VALUES = ['', '0', '1', '-1', '1e308', 'NaN', '-Infinity', '\u0000', '9'.repeat(400), 'lamp', 'box', '#ffffff', '*', 'html', '::before', '#v=1&preset=fog&take=AAAA', '#v=1&z=AAAA', `<img src=x onerror="${SCRIPT}">`, SCRIPT, '__proto__', '0:1,1:0', '0:333344,1:ffffff', '{}', '\ud800', 'constructor']; // prettier-ignore

test('2,000 hostile attributes change nothing outside the element, and the smoke continues', async ({
  page,
  openPage,
}) => {
  const lines = watchConsole(page);
  await openPage(`<p id="neighbour">Somebody's text</p>
    <cartoon-smoke ${WISP} paused style="width: 64px; height: 48px"></cartoon-smoke>`);
  await stands(page);
  const report = await page.evaluate(
    async ({ attributes, values, own }) => {
      const smoke = document.querySelector('cartoon-smoke')!;
      const failures: string[] = [];
      smoke.addEventListener('error', ({ detail }) => failures.push(detail.error.message));
      const before = document.body.innerHTML.replace(/<cartoon-smoke[^]*/, '');
      // A linear congruential generator, so that failures are reproducible.
      let state = 7;
      const pick = <Item>(list: readonly Item[]): Item => {
        state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
        return list[state % list.length];
      };
      for (let round = 0; round < 20; round++) {
        for (let count = 0; count < 100; count++) {
          const name = pick(pick([own, attributes, attributes, attributes]));
          // Scenes with rigids would need requests; other tests cover them.
          if (name === 'scene' || name === 'preset' || name === 'src') continue;
          if (pick([0, 1, 1, 1])) smoke.setAttribute(name, pick(values));
          else smoke.removeAttribute(name);
        }
        smoke.setAttribute('preset', 'wisp');
        await new Promise((resolve) => setTimeout(resolve));
      }
      for (const name of smoke.getAttributeNames())
        if (!['style', 'thread'].includes(name)) smoke.removeAttribute(name);
      Object.assign(smoke, { preset: 'wisp', paused: true, emissionRate: 41 });
      return { failures, isSame: before === document.body.innerHTML.replace(/<cartoon-smoke[^]*/, '') };
    },
    { attributes: names.map(({ attribute }) => attribute), values: VALUES, own: OWN },
  );
  expect(report).toEqual({ failures: [], isSame: true });
  const rate = () => page.evaluate(async () => (await document.querySelector('cartoon-smoke')!.get())['emission.rate']);
  await expect.poll(rate).toBe(41);
  expect(lines).toEqual([]);
});

for (const link of [
  '#v=1&z=AAAA',
  '#v=1&take=AAAA&preset=wisp',
  'https://[',
  `#preset=${'x'.repeat(70_000)}`,
  SCRIPT,
  '#v=9&preset=wisp&simulation.maxParticles=1e9',
]) {
  const tag = longIf(!link.startsWith('#v=9'));
  test(`a link such as ${link.slice(0, 40)} shows working smoke and reports its faults${tag}`, async ({
    page,
    openPage,
  }) => {
    await openPage(`<cartoon-smoke paused scene="wisp" thread="main" simulation-max-particles="300" style="width: 64px; height: 48px"></cartoon-smoke>
      <script>
        window.notices = [];
        document.querySelector('cartoon-smoke').addEventListener('statechange', ({ detail }) => window.notices.push(...detail.notices));
        document.querySelector('cartoon-smoke').setAttribute('src', ${JSON.stringify(link)});
      </script>`);
    await stands(page);
    const notified = await page.evaluate(() => (Reflect.get(window, 'notices') as unknown[]).length);
    expect(notified).toBeGreaterThan(0);
  });
}

test('works under a strict policy, in a worker', async ({ page, openPage }) => {
  const rules =
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval' 'sha256-HASH'; worker-src 'self'; connect-src 'self'; style-src 'self'";
  const { createHash } = await import('node:crypto');
  const map = /<script type="importmap">(.*?)<\/script>/.exec(MODULES)![1];
  const hash = createHash('sha256').update(map).digest('base64');
  await openPage(`<cartoon-smoke preset="wisp" simulation-max-particles="300" paused></cartoon-smoke>`, {
    style: '',
    headers: { 'content-security-policy': rules.replace('HASH', hash) },
  });
  await stands(page);
  const writesDepth = await page.evaluate(
    async () => (await document.querySelector('cartoon-smoke')!.stats()).writesDepth,
  );
  expect(writesDepth).toBe(true);
});
