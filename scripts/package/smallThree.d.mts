import type { Plugin } from 'rolldown';

type BuildPlugin = Plugin & { apply: 'build' };

export declare function withoutShaders(): BuildPlugin;
export declare function withoutHeadsets(): BuildPlugin;
export declare function withoutAnimation(): BuildPlugin;
export declare function withoutJson(): BuildPlugin;
