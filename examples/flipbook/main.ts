/** An atlas frame by frame, with blended frames, and with blended frames that follow the motion vectors. */
import { Mesh, PerspectiveCamera, PlaneGeometry, Scene, TextureLoader, WebGLRenderer } from 'three';
import color from './color.png';
import { frames, rate } from './flipbook.json';
import motion from './motion.png';
import { flipbookMaterial } from './player.ts';

const [map, vectors] = [color, motion].map((file) => new TextureLoader().load(file));
map.premultiplyAlpha = true;
const frame = { value: 0 };
const materials = [
  flipbookMaterial(frame, map, false),
  flipbookMaterial(frame, map, true),
  flipbookMaterial(frame, map, true, vectors),
];
const geometry = new PlaneGeometry();
const scene = new Scene();
scene.add(...materials.map((material, at) => new Mesh(geometry, material).translateX(1.05 * (at - 1))));

const renderer = new WebGLRenderer({ alpha: true, antialias: true });
const camera = new PerspectiveCamera(40, innerWidth / innerHeight);
camera.position.z = 3.4;
document.body.append(renderer.domElement);
renderer.setPixelRatio(devicePixelRatio);
renderer.setSize(innerWidth, innerHeight, false);
renderer.setAnimationLoop((time) => {
  frame.value = ((time / 1000) * rate) % frames;
  renderer.render(scene, camera);
});
