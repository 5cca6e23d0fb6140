import type { JSHandle, Page } from '@playwright/test';

/**
 * Imports a module in a page. Its path on the server is its path in the repository.
 *
 * ```ts
 * const mesh = await load<typeof import('../../src/renderer/puffs/mesh')>('/src/renderer/puffs/billboards/mesh.ts');
 * const count = await mesh.evaluate((module, seed) => module.build(seed).length, 7);
 * ```
 *
 * Arguments and results of `evaluate` are serialized as JSON. The function has no access to the scope of the test file.
 */
export type LoadModule = <Module>(path: `/${string}`) => Promise<JSHandle<Module>>;

export async function loadModule<Module>(page: Page, path: string): Promise<JSHandle<Module>> {
  // A string, because the test runner rewrites an import() in code.
  return (await page.evaluateHandle(`import(${JSON.stringify(path)})`)) as JSHandle<Module>;
}
