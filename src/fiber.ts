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
} from './three/fiber/handles.ts';
export type { PlacementProps, Target } from './three/fiber/hooks.ts';
export { Smoke, useSmoke, type SmokeProps } from './three/fiber/smoke.ts';
