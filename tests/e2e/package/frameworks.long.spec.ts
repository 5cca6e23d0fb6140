/**
 * The element in frameworks, in new projects: server-side rendering, properties and events in the browser, type-checked
 * markup.
 */
import { readFileSync, writeFileSync } from 'node:fs';
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

/** The examples for frameworks of the package's README by their languages. `jsx` is the one for server-side rendering. */
const [, ...blocks] = readFileSync(
  fileURLToPath(new URL('../../../scripts/package/README.md', import.meta.url)),
  'utf8',
).split('### Frameworks');
const README = Object.fromEntries(
  [...blocks[0].matchAll(/^```(\w+)\n([^]*?)^```/gm)].map(([, language, code]) => [language, code]),
);

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

/** What Vite's plugin for Vue and the type checker of templates need. */
const VUE = {
  'vite.config.js': `import vue from '@vitejs/plugin-vue';

export default { plugins: [vue({ template: { compilerOptions: { isCustomElement: (tag) => tag === 'cartoon-smoke' } } })] };
`,
  'main.ts': `import { createApp } from 'vue';
import Smoke from './Smoke.vue';

createApp(Smoke).mount('#root');
`,
  'Smoke.vue': `<script setup lang="ts">
import 'cartoon-smoke/vue';
import type { CartoonSmokeElement } from 'cartoon-smoke';
import { nextTick, ref } from 'vue';

const smoke = ref<CartoonSmokeElement>();
const thread = ref<string>();
async function show(started: string) {
  thread.value = started;
  await nextTick();
  const { paused, emissionRate, simulationMaxParticles } = smoke.value!;
  document.title = [thread.value, paused, emissionRate, simulationMaxParticles].join();
}
</script>

<template>
  <cartoon-smoke
    ref="smoke"
    preset="wisp"
    :simulation-max-particles="300"
    emitters-0-speed="0.5"
    :paused="thread !== undefined"
    :emission-rate="thread && 12"
    style="height: 200px"
    @ready="({ detail }) => show(detail.thread)"
  />
</template>
`,
};

test('Vue 3: attributes, properties, events and types', async ({ page, project }) => {
  const place = project(
    ['vue@3', 'vite@8', '@vitejs/plugin-vue@6', 'vue-tsc@3', 'typescript@5', '@types/three@0.187'],
    {
      'index.html': `${PAGE}<div id="root"></div><script type="module" src="/main.ts"></script>`,
      'tsconfig.json': JSON.stringify({
        compilerOptions: {
          strict: true,
          target: 'es2023',
          module: 'esnext',
          moduleResolution: 'bundler',
          skipLibCheck: true,
          noEmit: true,
        },
        vueCompilerOptions: { strictTemplates: true },
        include: ['*.ts', '*.vue'],
      }),
      ...VUE,
    },
  );
  const check = () => bin(place, 'vue-tsc/bin/vue-tsc.js', '-p', '.');
  check();
  bin(place, 'vite/bin/vite.js', 'build');
  await expectTitle(page, join(place, 'dist'), READY);
  writeFileSync(join(place, 'Smoke.vue'), README.vue);
  check();
  for (const wrong of [':emission-rate="{}"', ':emitters-3-speed="{}"', 'no-such-attribute="1"']) {
    writeFileSync(join(place, 'Smoke.vue'), VUE['Smoke.vue'].replace('preset="wisp"', wrong));
    expect(check, wrong).toThrow('Smoke.vue');
  }
});

const SVELTE = `<script lang="ts">
  import 'cartoon-smoke/svelte';
  import type { CartoonSmokeElement } from 'cartoon-smoke';
  import { tick } from 'svelte';

  let smoke: CartoonSmokeElement;
  let thread = $state<string>();
  async function show(started: string) {
    thread = started;
    await tick();
    const { paused, emissionRate, simulationMaxParticles } = smoke;
    document.title = [thread, paused, emissionRate, simulationMaxParticles].join();
  }
</script>

<cartoon-smoke
  bind:this={smoke}
  preset="wisp"
  simulation-max-particles={300}
  emitters-0-speed="0.5"
  paused={thread !== undefined}
  emission-rate={thread && 12}
  style="height: 200px"
  onready={({ detail }) => show(detail.thread)}
></cartoon-smoke>
`;

test('Svelte 5: attributes, properties, events and types', async ({ page, project }) => {
  const place = project(
    ['svelte@5', 'vite@8', '@sveltejs/vite-plugin-svelte@7', 'svelte-check@4', 'typescript@5', '@types/three@0.187'],
    {
      'index.html': `${PAGE}<div id="root"></div><script type="module" src="/main.ts"></script>`,
      'vite.config.js': `import { svelte, vitePreprocess } from '@sveltejs/vite-plugin-svelte';

export default { plugins: [svelte({ preprocess: vitePreprocess() })] };
`,
      'main.ts': `import { mount } from 'svelte';
import Smoke from './Smoke.svelte';

mount(Smoke, { target: document.getElementById('root')! });
`,
      'tsconfig.json': JSON.stringify({
        compilerOptions: {
          strict: true,
          module: 'esnext',
          moduleResolution: 'bundler',
          skipLibCheck: true,
          verbatimModuleSyntax: true,
        },
      }),
      'Smoke.svelte': SVELTE,
    },
  );
  const check = () => bin(place, 'svelte-check/bin/svelte-check', '--tsconfig', './tsconfig.json');
  check();
  bin(place, 'vite/bin/vite.js', 'build');
  await expectTitle(page, join(place, 'dist'), READY);
  writeFileSync(join(place, 'Smoke.svelte'), README.svelte);
  check();
  for (const wrong of ['emission-rate={{}}', 'emitters-3-speed={{}}']) {
    writeFileSync(
      join(place, 'Smoke.svelte'),
      SVELTE.replace('preset="wisp"', wrong).replace('emission-rate={thread && 12}', ''),
    );
    expect(check, wrong).toThrow('Smoke.svelte');
  }
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
    'app/Steam.jsx': README.jsx,
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
export const smoke = <cartoon-smoke preset="wisp" emission-rate={12} emitters-3-speed={0.5} paused onready={({ detail }) => detail.thread} />;
`,
      'readme.tsx': README.tsx.replace('cartoon-smoke/react', `cartoon-smoke/${entry}`),
      'wrong.tsx': `import 'cartoon-smoke/${entry}';
export const smoke = <cartoon-smoke emission-rate={{}} />;
`,
      // TypeScript does not check hyphenated attributes of JSX against patterns, so it accepts any value of a list item.
      'wrongItem.ts': `import type { CartoonSmokeElement } from 'cartoon-smoke';
export const change = (smoke: CartoonSmokeElement) => (smoke.emitters3Speed = {});
`,
    });
    expectTypes(place, options, ['right.tsx', 'readme.tsx']);
    expect(() => expectTypes(place, options, ['wrong.tsx'])).toThrow('emission-rate');
    expect(() => expectTypes(place, options, ['wrongItem.ts'])).toThrow(/wrongItem\.ts.*TS2322/);
  });
}
