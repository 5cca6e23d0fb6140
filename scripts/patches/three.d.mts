import type { Plugin } from 'rolldown';

export declare function smallThree(options?: { hasLoaders?: boolean }): (Plugin & { apply: 'build' })[];
