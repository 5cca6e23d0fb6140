/** Plays an atlas of `npm run flipbook`: on the left frame by frame, on the right with blended frames. */
import * as THREE from 'three';
import atlas from './color.png';
import layout from './flipbook.json';

const { columns, rows, frames, rate } = layout;
const vertexShader =
  'varying vec2 at; void main() { at = uv; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }';
const fragmentShader = `uniform sampler2D map; uniform float frame; varying vec2 at;
  vec4 cell(float n) {
    vec2 place = vec2(mod(n, GRID.x), GRID.y - 1.0 - floor(n / GRID.x));
    return texture2D(map, (place + at) / GRID);
  }
  void main() {
    float next = mod(floor(frame) + 1.0, FRAMES);
    gl_FragColor = BLENDS ? mix(cell(floor(frame)), cell(next), fract(frame)) : cell(floor(frame));
  }`;

const map = new THREE.TextureLoader().load(atlas);
map.premultiplyAlpha = true;
const frame = { value: 0 };
const scene = new THREE.Scene();
for (const [x, BLENDS] of [
  [-0.55, 'false'],
  [0.55, 'true'],
] as const) {
  const defines = { BLENDS, GRID: `vec2(${columns}.0, ${rows}.0)`, FRAMES: `${frames}.0` };
  const options = { defines, vertexShader, fragmentShader, uniforms: { map: { value: map }, frame } };
  const material = new THREE.ShaderMaterial({ ...options, transparent: true, premultipliedAlpha: true });
  scene.add(new THREE.Mesh(new THREE.PlaneGeometry(), material).translateX(x));
}

const renderer = new THREE.WebGLRenderer({ alpha: true, antialias: true });
const camera = new THREE.PerspectiveCamera(40, innerWidth / innerHeight);
camera.position.z = 2.2;
document.body.append(renderer.domElement);
renderer.setPixelRatio(devicePixelRatio);
renderer.setSize(innerWidth, innerHeight, false);
renderer.setAnimationLoop((time) => {
  frame.value = ((time / 1000) * rate) % frames;
  renderer.render(scene, camera);
});
