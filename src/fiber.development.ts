/** `cartoon-smoke/fiber` with warnings. */
'use client';
import './three/warnings.ts';
// By name: frameworks reject `export *` after 'use client'.
export { Caster, Collider, Emitter, Smoke, useSmoke } from './fiber.ts';
