import { useFrame, useThree } from '@react-three/fiber';
import {
  createContext,
  createElement,
  useCallback,
  useContext,
  useEffect,
  useLayoutEffect,
  useMemo,
  useRef,
  useState,
  type ReactNode,
  type Ref,
  type RefObject,
} from 'react';
import { ParameterError, requireOptions, type SmokeError } from '../../base/errors.ts';
import type { AnyValues, Values } from '../../parameters/parameter.ts';
import type { GivenValues } from '../../parameters/timeline.ts';
import { findParameter } from '../../parameters/table.ts';
import { differing } from '../../parameters/values.ts';
import { CartoonSmoke } from '../cartoonSmoke.ts';
import type { DirectionalLight, Scene } from 'three';
import type { KeyLight } from '../keyLight.ts';
import { changeable, startValues, type CartoonSmokeOptions } from '../options.ts';
import { placementIn, targetOf, useLatest, useStable, type PlacementProps, type Target } from './hooks.ts';

/**
 * Props of `<Smoke>`. A change of `values` sets them, a change of the placement moves the smoke with its children, and a
 * change of another option creates the smoke again.
 */
export interface SmokeProps extends Omit<CartoonSmokeOptions, 'renderer' | 'keyLight'>, PlacementProps {
  /** The light that shades smoke and that smoke blocks, or a reference to it. Default: the first directional light of the scene. */
  keyLight?: Target<KeyLight>;
  /** Called when the smoke is in the scene, with the handles of its children. */
  onReady?: (smoke: CartoonSmoke) => void;
  /**
   * Called for each error: of the creation, of props of this component and of its children, and of the event `error`.
   * Without it, errors of the creation and of props reach the next error boundary.
   */
  onError?: (error: Error) => void;
  /** The smoke, null until it is created. */
  ref?: Ref<CartoonSmoke>;
  /** Anything of the scene. Emitters, colliders and casters in it are those of this smoke. */
  children?: ReactNode;
}

/** What the handles of a smoke need of it. */
export interface SmokeContextValue {
  readonly smoke: CartoonSmoke | undefined;
  /** The smoke until it is disposed, which effects of the same commit may find before they know. */
  readonly live: RefObject<CartoonSmoke | undefined>;
  readonly report: (error: unknown) => void;
}

export const SmokeContext = createContext<SmokeContextValue | undefined>(undefined);

/** The smoke of the nearest `<Smoke>` around a component; undefined until it is created, and outside one. */
export function useSmoke(): CartoonSmoke | undefined {
  return useContext(SmokeContext)?.smoke;
}

/** Smoke in a scene of React Three Fiber. The canvas needs a stencil buffer: `<Canvas gl={{ stencil: true }}>`. */
export function Smoke({ children, ref, ...props }: SmokeProps): ReactNode {
  const [failure, setFailure] = useState<{ error: unknown }>();
  const latest = useLatest(props);
  const report = useCallback(
    (error: unknown) => {
      const { onError } = latest.current;
      if (onError) onError(error as Error);
      else setFailure({ error });
    },
    [latest],
  );
  const [smoke, live] = useCreated(props, report);
  const context = useMemo(() => ({ smoke, live, report }), [smoke, live, report]);
  useEffect(() => {
    if (smoke) latest.current.onReady?.(smoke);
  }, [smoke, latest]);
  if (failure) throw failure.error;
  const group = createElement(
    'group',
    placementIn(props)[0],
    children,
    smoke && createElement('primitive', { key: 'smoke', object: smoke, ref }),
  );
  return createElement(
    SmokeContext.Provider,
    { value: context },
    group,
    smoke && createElement(Updated, { key: 'updated', smoke }),
  );
}

/** Creates a smoke, sets changed values and disposes it. */
function useCreated(props: Omit<SmokeProps, 'children' | 'ref'>, report: (error: unknown) => void) {
  const { keyLight, light, lightReference, preset, physics, space, values } = props;
  const reference = useStable(lightReference ?? {});
  const renderer = useThree(({ gl }) => gl);
  const scene = useThree((state) => state.scene);
  const latest = useLatest(props);
  const applied = useRef<GivenValues>({});
  const [smoke, setSmoke] = useState<CartoonSmoke>();
  const live = useRef<CartoonSmoke>(undefined);

  useEffect(() => {
    let isWanted = true;
    const onError = ({ error }: { error: SmokeError }) => latest.current.onError?.(error);
    const create = async () => {
      requireOptions('Smoke', placementIn(latest.current)[1], PROPS);
      const { values: given = {} } = latest.current;
      const onRelight = (isInShadow: boolean) => latest.current.onRelight?.(isInShadow);
      const options = { renderer, light, lightReference: reference, preset, physics, space, values: given, onRelight };
      const created = await CartoonSmoke.create({ ...options, keyLight: lightOf(latest.current.keyLight, scene) });
      if (!isWanted) return created.dispose();
      live.current = created;
      created.addEventListener('error', onError);
      applied.current = changeable(given);
      setSmoke(created);
    };
    // StrictMode runs this effect, its end and this effect again: the first creates nothing.
    queueMicrotask(() => {
      if (isWanted) create().catch((error: unknown) => isWanted && report(error));
    });
    return () => {
      isWanted = false;
      live.current?.removeEventListener('error', onError);
      live.current?.dispose();
      live.current = undefined;
      setSmoke(undefined);
    };
  }, [
    renderer,
    scene,
    light,
    reference,
    preset,
    physics,
    space,
    latest,
    report,
    values?.seed,
    values?.['simulation.maxParticles'],
  ]);

  useEffect(() => {
    if (!smoke || live.current !== smoke) return;
    try {
      const changes = changesOf(applied.current, changeable(values ?? {}), preset);
      if (Object.keys(changes).length > 0) smoke.set(changes);
      applied.current = changeable(values ?? {});
    } catch (error) {
      report(error);
    }
  }, [smoke, values, preset, report]);

  useEffect(() => {
    if (!smoke || live.current !== smoke) return;
    try {
      smoke.keyLight = lightOf(keyLight, scene);
    } catch (error) {
      report(error);
    }
  }, [smoke, keyLight, scene, report]);

  return [smoke, live] as const;
}

const PROPS = 'keyLight light lightReference preset values physics space onRelight onReady onError'.split(' ');

/** @throws ParameterError if no light is given and the scene has no directional light */
function lightOf(given: SmokeProps['keyLight'], scene: Scene): KeyLight {
  if (given) return targetOf(given);
  const sun = scene.getObjectByProperty('isDirectionalLight', true) as DirectionalLight | undefined;
  if (sun) return sun;
  throw new ParameterError(
    'keyLight',
    undefined,
    'a light of the scene, which has no directional light to use instead',
  );
}

/** The values that differ. Keys that are no longer given have the values of the preset, or their defaults. */
function changesOf(before: GivenValues, now: GivenValues, preset: SmokeProps['preset']): GivenValues {
  const changed: GivenValues = differing(before as Values, now as Values);
  const gone = Object.keys(before).filter((key) => !(key in now));
  if (gone.length === 0) return changed;
  const start = startValues({ preset }) as AnyValues;
  const initial = gone.map((key) => [key, start[key] ?? findParameter(key)!.default]);
  return { ...Object.fromEntries(initial), ...changed };
}

/**
 * Updates a smoke in each frame after all other callbacks of `useFrame`, which move objects. Fiber calls them in the order in
 * which they subscribe, so it subscribes again when others have come.
 */
function Updated({ smoke }: { smoke: CartoonSmoke }): ReactNode {
  const [subscription, setSubscription] = useState(0);
  const advance = useCallback(() => setSubscription((last) => last + 1), []);
  return createElement(UpdatedLast, { key: subscription, smoke, onLater: advance });
}

function UpdatedLast({ smoke, onLater }: { smoke: CartoonSmoke; onLater: () => void }): ReactNode {
  const internal = useThree((state) => state.internal);
  const known = useRef(0);
  useFrame((_, seconds) => {
    const { length } = internal.subscribers;
    if (length > known.current) onLater();
    known.current = length;
    smoke.update(seconds);
  });
  useLayoutEffect(() => {
    known.current = internal.subscribers.length;
  }, [internal]);
  return null;
}
