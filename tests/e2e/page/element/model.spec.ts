/** Models in elements of the package: their code loads by its URL, on the page and in the worker. */
import { expect, MODULES, stands, test } from '../../../support/embed.ts';
import { turningBox } from '../../../support/files/glb.ts';
import type { CartoonSmokeElement } from '../../../../src/page/element/cartoonSmokeElement.ts';

/** After a second, on any thread. */
const HASH = 'd28d15b1d4dd4c4e';

for (const thread of ['main', 'worker']) {
  test(`an element has a model: ${thread}`, async ({ page, openPage, server }) => {
    await openPage(`<cartoon-smoke preset="wisp" thread="${thread}" paused></cartoon-smoke>`);
    await stands(page);
    expect(server.sent.map(({ file }) => file).join()).not.toContain('stageModel');
    const found = await page.evaluate(
      async (bytes) => {
        const smoke = document.querySelector('cartoon-smoke') as CartoonSmokeElement;
        const model = await smoke.setModel(Uint8Array.from(bytes));
        const torn = await smoke.setModel(Uint8Array.of(1, 2, 3)).catch((error: Error) => error.name);
        await smoke.step(60);
        return { triangles: model?.triangles, torn, hash: await smoke.hash() };
      },
      [...turningBox().pack()],
    );
    expect(found).toEqual({ triangles: 22, torn: 'FileError', hash: HASH });
    const files = server.sent.map(({ file }) => file);
    expect(files.filter((file) => file.endsWith('stageModel.js')).length).toBe(1);
    expect(files.filter((file) => file.endsWith('meshes/bindings_bg.wasm')).length).toBe(1);
  });
}

test('the worker loads the code of models from the URL that the page sets', async ({ page, openPage, server }) => {
  const urls = `<script type="module">
      import { setAssetUrls } from '/package/dist/index.js';
      setAssetUrls({ stageModel: '/absent/stageModel.js' });
    </script>`;
  await openPage('<cartoon-smoke preset="wisp" thread="worker" paused></cartoon-smoke>', {
    script: MODULES.replace('<script type="module" src', `${urls}$&`),
  });
  await stands(page);
  const error = await page.evaluate(
    async (bytes) => {
      const smoke = document.querySelector('cartoon-smoke') as CartoonSmokeElement;
      return smoke.setModel(Uint8Array.from(bytes)).catch((reason: Error) => reason.name);
    },
    [...turningBox().pack()],
  );
  expect(error).toBe('LoadError');
  expect(server.sent.map(({ file }) => file).join()).not.toContain('dist/stageModel');
});
