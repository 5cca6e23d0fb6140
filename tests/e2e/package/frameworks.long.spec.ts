/**
 * The element in frameworks, in new projects: server-side rendering, properties and events in the browser, type-checked
 * markup.
 */
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { bin, expect, expectTitle, expectTypes, PAGE, test } from '../../support/freshProject.ts';

const TYPESCRIPT = 'typescript@7';
/** The second render sets one value and removes another. The title shows the element's state after it. */
const APP = `import 'cartoon-smoke/react';
import type { CartoonSmokeElement } from 'cartoon-smoke';
import { useRef, useState } from 'react';

export function Smoke() {
  const smoke = useRef<CartoonSmokeElement>(null);
  const [thread, setThread] = useState<string>();
  if (thread) {
    requestAnimationFrame(() => {
      const { paused, emissionRate, simulationMaxParticles } = smoke.current!;
      document.title = [thread, paused, emissionRate, simulationMaxParticles].join();
    });
  }
  return (
    <cartoon-smoke
      ref={smoke}
      preset="wisp"
      simulation-max-particles={300}
      paused={thread !== undefined}
      emission-rate={thread && 12}
      style={{ height: 200 }}
      onready={({ detail }) => setThread(detail.thread)}
      onerror={({ detail }) => (document.title = detail.error.message)}
    />
  );
}
`;
/** Hydration listens in an effect: React does not attach custom event listeners to server-rendered elements. */
const CLIENT = `'use client';
import 'cartoon-smoke/react';
import { useEffect, useRef, useState } from 'react';

export function Smoke() {
  const smoke = useRef(null);
  const [thread, setThread] = useState();
  useEffect(() => {
    smoke.current.stage.then((stage) => setThread(stage.thread));
  }, []);
  useEffect(() => {
    const { paused, emissionRate, simulationMaxParticles } = smoke.current;
    if (thread) document.title = [thread, paused, emissionRate, simulationMaxParticles].join();
  }, [thread]);
  return (
    <cartoon-smoke
      ref={smoke}
      preset="wisp"
      simulation-max-particles={300}
      paused={thread !== undefined}
      emission-rate={thread && 12}
      style={{ height: 200 }}
    />
  );
}
`;
const READY = 'worker,true,12,300';

/** The component that the package's README recommends for server-side rendering. */
function componentOfReadme(): string {
  const readme = readFileSync(fileURLToPath(new URL('../../../scripts/package/README.md', import.meta.url)), 'utf8');
  return /```jsx\n([^]*?)```/.exec(readme)![1];
}

test('React 19: attributes, properties, events and types', async ({ page, project }) => {
  const place = project(
    ['react@19', 'react-dom@19', '@types/react@19', '@types/react-dom@19', 'vite@8', TYPESCRIPT, '@types/three@0.187'],
    {
      'index.html': `${PAGE}<div id="root"></div><script type="module" src="/main.tsx"></script>`,
      'Smoke.tsx': APP,
      'main.tsx': `import { createRoot } from 'react-dom/client';
import { Smoke } from './Smoke.js';

createRoot(document.getElementById('root')!).render(<Smoke />);
`,
    },
  );
  expectTypes(place, { jsx: 'react-jsx' }, ['*.tsx']);
  bin(place, 'vite/bin/vite.js', 'build');
  await expectTitle(page, join(place, 'dist'), READY);
});

test('Next.js: imported on the server, in the server-rendered page, and smoke in the browser', async ({
  page,
  project,
}) => {
  const place = project(['next@16', 'react@19', 'react-dom@19'], {
    'next.config.mjs': `export default { output: 'export', devIndicators: false };`,
    'app/layout.jsx': `export default function Layout({ children }) {
  return <html lang="en"><head><title>Waiting</title><link rel="icon" href="data:," /></head><body>{children}</body></html>;
}
`,
    'app/page.jsx': `import { CartoonSmoke } from 'cartoon-smoke';
import { presets } from 'cartoon-smoke/preset';
import { Smoke } from './Smoke.jsx';
import { Steam } from './Steam.jsx';

export default function Page() {
  return <main><p>{typeof CartoonSmoke}, {presets.length > 5 ? 'presets' : 'none'}</p><Smoke /><Steam /></main>;
}
`,
    'app/Smoke.jsx': CLIENT,
    'app/Steam.jsx': componentOfReadme(),
  });
  bin(place, 'next/dist/bin/next', 'build');
  const rendered = readFileSync(join(place, 'out/index.html'), 'utf8');
  expect(rendered).toMatch(/<cartoon-smoke preset="wisp" simulation-max-particles="300"/);
  await expectTitle(page, join(place, 'out'), READY, async () => {
    await expect(page.getByText('The smoke is playing.')).toBeVisible();
    await page.locator('figure').getByRole('button').click();
    await expect(page.getByText('The smoke is paused.')).toBeVisible();
  });
});

for (const [name, packages, options] of [
  ['Preact', ['preact@11'], { jsx: 'react-jsx', jsxImportSource: 'preact' }],
  ['Solid', ['solid-js@1'], { jsx: 'preserve', jsxImportSource: 'solid-js' }],
] as const) {
  test(`${name} has types of the element and rejects invalid attributes`, ({ project }) => {
    const entry = name.toLowerCase();
    const place = project([...packages, TYPESCRIPT, '@types/three@0.187'], {
      'right.tsx': `import 'cartoon-smoke/${entry}';
export const smoke = <cartoon-smoke preset="wisp" emission-rate={12} paused onready={({ detail }) => detail.thread} />;
`,
      'wrong.tsx': `import 'cartoon-smoke/${entry}';
export const smoke = <cartoon-smoke emission-rate={{}} />;
`,
    });
    expectTypes(place, options, ['right.tsx']);
    expect(() => expectTypes(place, options, ['wrong.tsx'])).toThrow('emission-rate');
  });
}
