import type { WebGLRenderer } from 'three';

/** Counts objects of a context that are created and not deleted yet. */
export function liveObjects(renderer: WebGLRenderer): () => Record<string, number> {
  const gl = renderer.getContext() as unknown as Record<string, (object?: unknown) => unknown>;
  const live: Record<string, number> = {};
  for (const kind of ['Buffer', 'Texture', 'Program', 'Framebuffer', 'Renderbuffer', 'VertexArray']) {
    live[kind] = 0;
    for (const [verb, change] of [
      ['create', 1],
      ['delete', -1],
    ] as const) {
      const name = verb + kind;
      const native = gl[name].bind(gl);
      gl[name] = (object) => {
        if (verb === 'create' || object) live[kind] += change;
        return native(object);
      };
    }
  }
  return () => ({ ...live });
}
