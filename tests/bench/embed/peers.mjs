/** Comparable libraries from npm, in fixed versions, installed for this benchmark only. */

import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { run } from '../../../scripts/lib/command.mjs';
import { inRoot } from '../../../scripts/lib/paths.mjs';
import { UserError } from '../../../scripts/lib/userError.mjs';

export const VERSIONS = { '@google/model-viewer': '4.4.0', '@tsparticles/slim': '4.4.0' };
/** Relative to the root. */
export const PEERS = '.cache/bench-embed';

/** Self-contained scripts, which their documentation recommends for pages. */
export const SCRIPTS = {
  modelViewer: `${PEERS}/node_modules/@google/model-viewer/dist/model-viewer.min.js`,
  tsParticles: `${PEERS}/node_modules/@tsparticles/slim/tsparticles.slim.bundle.min.js`,
};

/** @param {(line: string) => void} say */
export async function bringPeers(say) {
  if (Object.values(SCRIPTS).every((file) => existsSync(inRoot(file)))) return;
  say('fetching model-viewer and tsParticles');
  const folder = inRoot(PEERS);
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, 'package.json'), JSON.stringify({ private: true, dependencies: VERSIONS }));
  // The scripts bundle three.js, so peer dependencies are not needed.
  const parameters = ['install', '--legacy-peer-deps', '--ignore-scripts', '--no-audit', '--no-fund'];
  const { status, output } = await run('npm', parameters, { folder, onLine: say });
  if (status !== 0) throw new UserError('model-viewer and tsParticles could not be fetched from npm.', output);
}
