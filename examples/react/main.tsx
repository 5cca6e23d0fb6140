/** A small React Three Fiber page with smoke: drag to orbit, click the ring to change the colour of the smoke. */
import { Caster, Collider, Emitter, Smoke } from 'cartoon-smoke/fiber';
import { Canvas, useFrame, useThree } from '@react-three/fiber';
import { useEffect, useMemo, useRef, useState, type ReactNode } from 'react';
import { createRoot } from 'react-dom/client';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import type { DirectionalLight, Mesh } from 'three';

const COLORS = ['#fff4e3', '#ffc1cf', '#bfe6ff'];

function Scene(): ReactNode {
  const keyLight = useRef<DirectionalLight>(null);
  const ring = useRef<Mesh>(null);
  const [color, setColor] = useState(0);
  const values = { 'emission.rate': 0, 'emission.lifetime': 5, 'style.smokeColor': COLORS[color] };
  const time = useRef(0);
  useFrame((_, seconds) => {
    // A slow machine shows everything in slow motion, as smoke does itself.
    time.current += Math.min(seconds, 1 / 15);
    ring.current!.rotation.set(1.57 + 0.35 * Math.sin(time.current), 0.3 * Math.cos(time.current), 0);
  });
  return (
    <Smoke keyLight={keyLight} values={values}>
      <color attach="background" args={['#f3d9a4']} />
      <ambientLight color="#b9a8ff" intensity={1.2} />
      <directionalLight ref={keyLight} position={[3, 6, 4]} intensity={2.6} />
      <mesh rotation-x={-Math.PI / 2}>
        <circleGeometry args={[2.6, 64]} />
        <meshStandardMaterial color="#d9825b" />
      </mesh>
      <Emitter rate={40} size={0.3} />
      <mesh position={[0, 0.2, 0]}>
        <cylinderGeometry args={[0.3, 0.22, 0.4, 48]} />
        <meshToonMaterial color="#3a8f8a" />
      </mesh>
      <mesh
        ref={ring}
        position={[0.1, 1.7, 0]}
        rotation-x={Math.PI / 2}
        onClick={() => setColor((color + 1) % COLORS.length)}
      >
        <torusGeometry args={[0.85, 0.13, 24, 64]} />
        <meshStandardMaterial color="#e8b53a" roughness={0.5} />
      </mesh>
      <mesh position={[0.9, 0.6, 0.8]}>
        <boxGeometry args={[0.7, 1.2, 0.03]} />
        <meshStandardMaterial color="#8fd3ff" transparent opacity={0.4} />
      </mesh>
      <Collider object={ring} />
      <Caster object={ring} />
    </Smoke>
  );
}

function Orbit(): null {
  const { camera, gl } = useThree();
  const controls = useMemo(() => new OrbitControls(camera), [camera]);
  useEffect(() => {
    controls.connect(gl.domElement);
    controls.target.set(0, 1, 0);
    return () => controls.dispose();
  }, [controls, gl]);
  useFrame(() => void controls.update());
  return null;
}

// Smoke counts its shadows in the stencil buffer, which three.js does not allocate by default.
createRoot(document.getElementById('root')!).render(
  <Canvas flat gl={{ stencil: true }} camera={{ position: [2.6, 2.7, 6.4], fov: 45 }}>
    <Orbit />
    <Scene />
  </Canvas>,
);
