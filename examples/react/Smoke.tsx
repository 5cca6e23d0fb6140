/** Smoke as a component of React Three Fiber. */
import { useFrame, useThree } from '@react-three/fiber';
import { useEffect, useState, type ReactNode, type RefObject } from 'react';
import type { Object3D } from 'three';
import { CartoonSmoke, type KeyLight, type Values } from '../../src/index.ts';

export interface SmokeProps {
  keyLight: RefObject<KeyLight | null>;
  /** The object that emits the smoke. */
  source: RefObject<Object3D | null>;
  /** Objects that collide with the smoke and cast shadow on it. */
  solids: readonly RefObject<Object3D | null>[];
  /** Applied at the start and on every change. */
  values: Values;
}

export function Smoke({ keyLight, source, solids, values }: SmokeProps): ReactNode {
  const renderer = useThree(({ gl }) => gl);
  const [smoke, setSmoke] = useState<CartoonSmoke>();

  useEffect(() => {
    let isWanted = true;
    const creation = CartoonSmoke.create({ renderer, keyLight: keyLight.current! }).then((made) => {
      made.emitFrom(source.current!);
      for (const solid of solids) {
        made.collide(solid.current!);
        made.cast(solid.current!);
      }
      if (isWanted) setSmoke(made);
      return made;
    });
    return () => {
      isWanted = false;
      void creation.then((made) => made.dispose());
    };
  }, [renderer]);

  useEffect(() => smoke?.set(values), [smoke, values]);
  useFrame((_, seconds) => smoke?.update(seconds));
  return smoke ? <primitive object={smoke} /> : null;
}
