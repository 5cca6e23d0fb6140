/**
 * Lets a page take its GPU for as fast as its clock, for tests that make time themselves: what has been drawn is told in real
 * time only, and not amid a task. Workers are not reached.
 */
export function gpuKeepsUp(): void {
  WebGL2RenderingContext.prototype.getSyncParameter = () => WebGL2RenderingContext.SIGNALED;
}
