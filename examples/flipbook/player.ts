/** Plays an atlas of `npm run flipbook`, with or without blended frames, as a material of three.js. */
import { ShaderMaterial, type Texture } from 'three';
import { columns, frame as size, frames, motionRange, rows } from './flipbook.json';

const vertexShader =
  'varying vec2 at; void main() { at = uv; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }';
const fragmentShader = `uniform sampler2D map, motion; uniform float frame; varying vec2 at;
  vec2 place(float n, vec2 shift) {
    return (vec2(mod(n, GRID.x), GRID.y - 1.0 - floor(n / GRID.x)) + clamp(at + shift, EDGE, 1.0 - EDGE)) / GRID;
  }
  vec2 moved(float n) { return RANGE * (2.0 * texture2D(motion, place(n, vec2(0.0))).xy - 1.0); }
  void main() {
    float now = floor(frame), next = mod(now + 1.0, FRAMES), share = BLENDING * fract(frame);
    vec4 later = texture2D(map, place(next, (1.0 - share) * moved(next)));
    gl_FragColor = mix(texture2D(map, place(now, -share * moved(now))), later, share);
  }`;

/** @param motion blended frames follow these motion vectors */
export function flipbookMaterial(frame: { value: number }, map: Texture, isBlended: boolean, motion?: Texture) {
  const grid = { GRID: `vec2(${columns}, ${rows})`, FRAMES: `${frames}.0`, EDGE: 0.5 / size[0] };
  const defines = { ...grid, BLENDING: isBlended ? '1.0' : '0.0', RANGE: motion ? motionRange : '0.0' };
  const uniforms = { frame, map: { value: map }, motion: { value: motion ?? map } };
  const options = { defines, uniforms, vertexShader, fragmentShader };
  return new ShaderMaterial({ ...options, transparent: true, premultipliedAlpha: true });
}
