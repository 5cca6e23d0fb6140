/** The release workflow. */
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parse } from 'yaml';

interface Workflow {
  jobs: Record<string, { steps: { name?: string; run?: string }[] }>;
}

export const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
const { jobs } = parse(readFileSync(join(ROOT, '.github/workflows/release.yml'), 'utf8')) as Workflow;

/** The command of a step; fails if the step is missing. */
export function commandOf(job: string, name: string): string {
  const command = jobs[job].steps.find((step) => step.name === name)?.run;
  if (command === undefined) throw new Error(`The job ${job} has no step ${name}.`);
  return command;
}
