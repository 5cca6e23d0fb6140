/** Exports of cartoon-smoke/fiber. No module of the library imports this file. */
'use client';
export {
  Caster,
  Collider,
  Emitter,
  type CasterProps,
  type ColliderProps,
  type EmitterProps,
  type HandleProps,
} from './fiber/handles.ts';
export type { PlacementProps, Target } from './fiber/hooks.ts';
export { Smoke, useSmoke, type SmokeProps } from './fiber/smoke.ts';
