import { fileURLToPath } from 'node:url';
import type { Plugin } from 'vite';

const SOURCE = fileURLToPath(new URL('../../src/app/offline/worker.ts', import.meta.url));
const NAME = 'sw.js';

/** Builds the service worker with the site, so that it contains the file names of its version. */
export function serviceWorker(): Plugin {
  return {
    name: 'service-worker',
    apply: 'build',
    buildStart() {
      // Without a hash in the name, because browsers check this URL for updates.
      this.emitFile({ type: 'chunk', id: SOURCE, fileName: NAME });
    },
    generateBundle: {
      order: 'post',
      handler(_, bundle) {
        const chunk = bundle[NAME];
        if (chunk?.type !== 'chunk' || chunk.imports.length > 0) this.error(`${NAME} has to be one plain script.`);
        const files = Object.keys(bundle).filter((name) => name.startsWith('assets/') && !name.endsWith('.map'));
        chunk.code = chunk.code.replace('HASHED_FILES', JSON.stringify(files.sort()));
      },
    },
  };
}
