import type { Plugin } from 'rolldown';

export declare function withoutShaders(): Plugin & { apply: 'build' };
