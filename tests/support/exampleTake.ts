/** A take of one second as a stage gives it. */
export const EXAMPLE_TAKE = {
  values: { scene: 'wisp' },
  seed: 3,
  inputs: 2,
  start: 0,
  steps: 60,
  mostParticles: 300,
  isFresh: true,
  isTruncated: false,
  changed: ['style.rim'],
  toBytes: () => Uint8Array.of(1, 2, 3),
} as const;
