import { GLSL3, RawShaderMaterial, type WebGLRenderer } from 'three';
import { nextTask } from '../../base/work.ts';
import { DrawnMesh } from './drawnMesh.ts';
import { executed } from './framesInFlight.ts';
import { triangle } from './fullScreen.ts';

/** The shaders of a program, as three.js takes them. */
export interface Shaders {
  readonly vertexShader: string;
  readonly fragmentShader: string;
  readonly defines?: Record<string, unknown>;
}

/**
 * Replaces LOBES by the number of lobes. three.js unrolls loops only with literal bounds; unrolled loops need no
 * dynamic indexing.
 */
export function withLobes(shader: string, lobes: number): string {
  return shader.replaceAll(/\bLOBES\b/g, String(lobes));
}

/** Adds code to a shader. Firefox requires outputs to be declared before main. */
export function withCodeBeforeMain(shader: string, code: string): string {
  return shader.replace('void main(', (main) => `\n${code}\n${main}`);
}

/** Defines of programs whose puffs turn, stretch or unfold; see shaders/lib/orientation.glsl. */
export const DEFORMED = { DEFORMED: '' };

/**
 * Compiles programs in the background. three.js compiles a program when it first draws with it and waits for the
 * result. The materials here draw nothing: they keep programs in the cache of three.js, which finds them by their
 * source text when another material has the same shaders.
 */
export class ProgramsAhead {
  private readonly programs = new Map<string, RawShaderMaterial>();

  /** Compiles a program unless it was compiled before. Does not wait for the result. */
  compile(renderer: WebGLRenderer, { vertexShader, fragmentShader, defines = {} }: Shaders): void {
    const shaders = { vertexShader, fragmentShader, defines };
    const key = JSON.stringify(shaders);
    if (this.programs.has(key)) return;
    const material = new RawShaderMaterial({ ...shaders, glslVersion: GLSL3 });
    this.programs.set(key, material);
    new DrawnMesh(material, triangle()).compile(renderer);
  }

  /**
   * Resolves when programs can be drawn with at once. Browsers with KHR_parallel_shader_compile compile in the
   * background and report the end. Others compile in the order of the commands, so that a fence reports it.
   */
  async finished(renderer: WebGLRenderer): Promise<void> {
    const context = renderer.getContext() as WebGL2RenderingContext;
    const programs = renderer.info.programs as unknown as readonly Compiled[];
    // After a timeout, the first draw waits for the programs.
    if (!(await executed(context, () => programs.every((program) => program.isReady())))) return;
    // In the first frame this would wait for the draw calls before it. Each program waits for the GPU, so each has a task
    // of its own.
    for (const program of programs) {
      program.getUniforms();
      await nextTask();
    }
  }

  dispose(): void {
    for (const material of this.programs.values()) material.dispose();
    this.programs.clear();
  }
}

/** The shaders that a pass draws with: of its fields, and of the elements of its arrays. */
export function shadersOf(pass: object): Shaders[] {
  const parts = Object.values(pass).flat();
  return parts.map((part) => part?.material ?? part).filter((material) => material instanceof RawShaderMaterial);
}

/** A program of three.js, with a method that its types lack. */
interface Compiled {
  /** Whether the browser has finished it; always true without KHR_parallel_shader_compile. */
  isReady(): boolean;
  getUniforms(): unknown;
}
