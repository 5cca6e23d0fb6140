/**
 * Plays an atlas of `npm run flipbook`: frame by frame, with blended frames, and with blended frames that follow the
 * motion vectors.
 */
import * as THREE from 'three';
import atlas from './color.png';
import layout from './flipbook.json';
import motion from './motion.png';

const { columns, rows, frames, rate, motionRange, frame: size } = layout;
const vertexShader =
  'varying vec2 at; void main() { at = uv; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }';
const fragmentShader = `uniform sampler2D map, motion; uniform float frame; varying vec2 at;
  vec2 place(float n, vec2 shift) {
    return (vec2(mod(n, GRID.x), GRID.y - 1.0 - floor(n / GRID.x)) + clamp(at + shift, EDGE, 1.0 - EDGE)) / GRID;
  }
  vec2 moved(float n) { return (2.0 * texture2D(motion, place(n, vec2(0.0))).xy - 1.0) * RANGE; }
  void main() {
    float now = floor(frame), next = mod(now + 1.0, FRAMES), share = fract(frame);
    vec4 color = texture2D(map, place(now, -share * moved(now)));
    gl_FragColor = BLENDS ? mix(color, texture2D(map, place(next, (1.0 - share) * moved(next))), share) : color;
  }`;

const map = new THREE.TextureLoader().load(atlas);
map.premultiplyAlpha = true;
const vectors = new THREE.TextureLoader().load(motion);
const frame = { value: 0 };
const scene = new THREE.Scene();
for (const [x, BLENDS, RANGE] of [
  [-1.05, 'false', '0.0'],
  [0, 'true', '0.0'],
  [1.05, 'true', String(motionRange)],
] as const) {
  const defines = { BLENDS, RANGE, GRID: `vec2(${columns}.0, ${rows}.0)`, FRAMES: `${frames}.0`, EDGE: 0.5 / size[0] };
  const uniforms = { map: { value: map }, motion: { value: vectors }, frame };
  const options = { defines, vertexShader, fragmentShader, uniforms };
  const material = new THREE.ShaderMaterial({ ...options, transparent: true, premultipliedAlpha: true });
  scene.add(new THREE.Mesh(new THREE.PlaneGeometry(), material).translateX(x));
}

const renderer = new THREE.WebGLRenderer({ alpha: true, antialias: true });
const camera = new THREE.PerspectiveCamera(40, innerWidth / innerHeight);
camera.position.z = 3.4;
document.body.append(renderer.domElement);
renderer.setPixelRatio(devicePixelRatio);
renderer.setSize(innerWidth, innerHeight, false);
renderer.setAnimationLoop((time) => {
  frame.value = ((time / 1000) * rate) % frames;
  renderer.render(scene, camera);
});
