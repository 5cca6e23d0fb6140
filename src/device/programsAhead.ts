import { GLSL3, RawShaderMaterial, type WebGLRenderer } from 'three';
import { DrawnMesh } from './drawnMesh.ts';
import { triangle } from './fullScreen.ts';

/** The shaders of a program, as three.js takes them. */
export interface Shaders {
  readonly vertexShader: string;
  readonly fragmentShader: string;
  readonly defines?: Record<string, string>;
}

/**
 * Compiles programs in the background. three.js compiles a program when it first draws with it and waits for the
 * result. The materials here draw nothing: they keep programs in the cache of three.js, which finds them by their
 * source text when another material has the same shaders.
 */
export class ProgramsAhead {
  private readonly programs = new Map<string, RawShaderMaterial>();

  /** Compiles a program unless it was compiled before. Does not wait for the result. */
  compile(renderer: WebGLRenderer, shaders: Shaders): void {
    const key = JSON.stringify(shaders);
    if (this.programs.has(key)) return;
    const material = new RawShaderMaterial({ ...shaders, glslVersion: GLSL3 });
    this.programs.set(key, material);
    new DrawnMesh(material, triangle()).compile(renderer);
  }

  dispose(): void {
    for (const material of this.programs.values()) material.dispose();
    this.programs.clear();
  }
}
