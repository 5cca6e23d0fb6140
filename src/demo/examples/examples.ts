/** The examples of the page, with the sources of their projects. */

export interface Example {
  /** Folder in examples/. */
  readonly name: string;
  readonly title: string;
  readonly text: string;
  /** Folder of the page that plays: frameworks with a build of their own are not part of the site. */
  readonly played: string;
  /** File names and texts, the most important file first. */
  readonly files: readonly (readonly [name: string, text: string])[];
}

const FOLDER = '../../../examples/';
const sources: Readonly<Record<string, string>> = import.meta.glob(
  '../../../examples/{cdn,game,lantern,next,product,react,svelte,three,vite,vue}/{,app/}*.{html,js,json,jsx,mjs,svelte,ts,tsx,vue}',
  { eager: true, query: '?raw', import: 'default' },
);

export const examples: readonly Example[] = [
  example('three', 'A three.js scene', 'main.ts', 'Smoke rises through a loaded model and every kind of mesh.'),
  example(
    'game',
    'A small game',
    'main.ts',
    'Twenty explosions a second, dust at each step, and a jet with a trail. Click on the ground for one more.',
  ),
  example('lantern', 'Light things', 'main.ts', 'The smoke of a fire lifts a feather and a paper lantern.'),
  example(
    'react',
    'React Three Fiber',
    'main.tsx',
    'Components for smoke, emitters, colliders and casters. Drag to orbit, click the ring for another colour.',
  ),
  example('product', 'A product page', 'main.ts', 'Steam beside the text, and a puff from the button.'),
  example('vite', 'The element', 'main.ts', 'A custom element that a slider controls, bundled by Vite.'),
  example('vue', 'Vue', 'App.vue', 'The element in a template, with typed attributes and events.', 'vite'),
  example('svelte', 'Svelte', 'App.svelte', 'The element in a component, with typed attributes and events.', 'vite'),
  example('next', 'Next.js', 'app/Smoke.jsx', 'The element in a page that a server renders.', 'vite'),
  example('cdn', 'Without a build', 'index.html', 'One script from a CDN, and one tag.', 'vite'),
];

function example(name: string, title: string, main: string, text: string, played = name): Example {
  const start = `${FOLDER}${name}/`;
  const found = Object.entries(sources).filter(([path]) => path.startsWith(start));
  const files = found.map(([path, source]) => [path.slice(start.length), source] as const);
  const order = ([path]: readonly [string, string]) => (path === main ? 0 : 1);
  return { name, title, text, played, files: files.toSorted((one, other) => order(one) - order(other)) };
}
