/**
 * Makes the GPU of a page appear idle, for tests that control the clock: sync objects are only signaled in real time,
 * and not during a task. Does not affect workers.
 */
export function gpuKeepsUp(): void {
  WebGL2RenderingContext.prototype.getSyncParameter = () => WebGL2RenderingContext.SIGNALED;
}
