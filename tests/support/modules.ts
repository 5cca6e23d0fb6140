import type { JSHandle, Page } from '@playwright/test';

/**
 * Imports a module inside a page, by its path on the server, which is its path in the repository.
 *
 * ```ts
 * const mesh = await load<typeof import('../../src/puffs/mesh')>('/src/puffs/billboards/mesh.ts');
 * const count = await mesh.evaluate((module, seed) => module.build(seed).length, 7);
 * ```
 *
 * What `evaluate` is given and returns goes through JSON; the function itself sees nothing of the test's file.
 */
export type LoadModule = <Module>(path: `/${string}`) => Promise<JSHandle<Module>>;

export async function loadModule<Module>(page: Page, path: string): Promise<JSHandle<Module>> {
  // As text, because the test runner rewrites an import() that it finds in code.
  return (await page.evaluateHandle(`import(${JSON.stringify(path)})`)) as JSHandle<Module>;
}
