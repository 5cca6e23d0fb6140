import { GLSL3, RawShaderMaterial, type WebGLRenderer } from 'three';
import { DrawnMesh } from './drawnMesh.ts';
import { triangle } from './fullScreen.ts';

/** What makes a program, as three.js takes it. */
export interface Shaders {
  readonly vertexShader: string;
  readonly fragmentShader: string;
  readonly defines?: Record<string, string>;
}

/**
 * Programs that the browser compiles while the page goes on; three.js would wait for each where it is first drawn with, one
 * after the other. Nothing is drawn with these, but they keep the programs, which three.js knows by their text, for whoever
 * comes with the same.
 */
export class ProgramsAhead {
  private readonly programs = new Map<string, RawShaderMaterial>();

  /** Has a program compiled, unless it has been, and does not wait for it. */
  compile(renderer: WebGLRenderer, shaders: Shaders): void {
    const key = JSON.stringify(shaders);
    if (this.programs.has(key)) return;
    const material = new RawShaderMaterial({ ...shaders, glslVersion: GLSL3 });
    this.programs.set(key, material);
    new DrawnMesh(triangle(), material).compile(renderer);
  }

  dispose(): void {
    for (const material of this.programs.values()) material.dispose();
    this.programs.clear();
  }
}
