import {
  createElement,
  useCallback,
  useContext,
  useEffect,
  useRef,
  type DependencyList,
  type ReactNode,
  type Ref,
} from 'react';
import type { Group, Object3D } from 'three';
import { UnsupportedError } from '../../base/errors.ts';
import type { CartoonSmoke } from '../cartoonSmoke.ts';
import type { CollideOptions } from '../colliders.ts';
import type { EmitterOptions } from '../../simulator/emitterOptions.ts';
import type { EmitterHandle } from '../emitters.ts';
import type { SmokeHandle } from '../handle.ts';
import type { CastOptions } from '../options.ts';
import { assignRef, placementIn, targetOf, useLatest, useStable, type PlacementProps, type Target } from './hooks.ts';
import { SmokeContext } from './smoke.ts';

/** Props of all handles, besides their options. */
export interface HandleProps<Kind extends SmokeHandle> extends PlacementProps {
  /** The object of the handle, or a reference to it. Default: a group of this component with its children. */
  object?: Target<Object3D>;
  /** Whether it has an effect. Default true. */
  enabled?: boolean;
  /** The handle, null while it does not exist. */
  ref?: Ref<Kind>;
  children?: ReactNode;
}

/** Props of `<Emitter>`. A change of an option takes effect in the next step. */
export interface EmitterProps extends EmitterOptions, HandleProps<EmitterHandle> {
  /** Index of an emitter of the parameter table, 0 to 7. Default: an emitter of its own, without options as emitter 0. */
  emitter?: number;
}

/** Props of `<Collider>`. A change of an option adds the collider again. */
export interface ColliderProps extends CollideOptions, HandleProps<SmokeHandle> {}

/** Props of `<Caster>`. A change of `proxies` adds the caster again. */
export interface CasterProps extends CastOptions, HandleProps<SmokeHandle> {}

/** Emits puffs from the origin of an object along its y axis, see `CartoonSmoke.emitFrom`. */
export function Emitter({ emitter, ...props }: EmitterProps): ReactNode {
  const { options, ...parts } = useParts<EmitterHandle, EmitterOptions>(props);
  const start = (smoke: CartoonSmoke, object: Object3D) => {
    if (emitter === undefined) return smoke.emitFrom(object, Object.keys(options).length > 0 ? options : undefined);
    const handle = smoke.emitFrom(object, emitter);
    try {
      handle.set(options);
    } catch (error) {
      handle.remove();
      throw error;
    }
    return handle;
  };
  // `set` leaves the other options as they are, so an option that is gone needs a new handle.
  const change = useHandle('Emitter', parts, start, [emitter, Object.keys(options).sort().join()]);
  useEffect(() => change((handle) => handle.set(options)), [options, change]);
  return placed(parts);
}

/** Lets smoke collide with an object, see `CartoonSmoke.collide`. */
export function Collider(props: ColliderProps): ReactNode {
  const { options, ...parts } = useParts<SmokeHandle, CollideOptions>(props);
  useHandle('Collider', parts, (smoke, object) => smoke.collide(object, options), [options]);
  return placed(parts);
}

/** Lets an object cast a shadow on smoke and on the scene, see `CartoonSmoke.cast`. */
export function Caster(props: CasterProps): ReactNode {
  const { options, ...parts } = useParts<SmokeHandle, CastOptions>(props);
  useHandle('Caster', parts, (smoke, object) => smoke.cast(object, options), [options]);
  return placed(parts);
}

/** Props by their use. Unknown props are options, so that the call names them in its error. */
interface Parts<Kind extends SmokeHandle> extends Pick<HandleProps<Kind>, 'object' | 'ref' | 'children'> {
  readonly isEnabled: boolean;
  readonly group: Ref<Group> & { current: Group | null };
  readonly placement: object;
}

function useParts<Kind extends SmokeHandle, Options extends object>({
  object,
  enabled = true,
  ref,
  children,
  ...others
}: HandleProps<Kind> & Options): Parts<Kind> & { readonly options: Options } {
  const group = useRef<Group>(null);
  const [placement, rest] = placementIn(others);
  const options = useStable(rest as Options);
  return { object, ref, children, isEnabled: enabled, group, placement, options };
}

/**
 * Keeps a handle while its component and its smoke exist.
 * @param others what requires a new handle
 * @returns a function that changes the handle, if there is one
 */
function useHandle<Kind extends SmokeHandle>(
  name: string,
  { object, ref, isEnabled, group }: Parts<Kind>,
  start: (smoke: CartoonSmoke, object: Object3D) => Kind,
  others: DependencyList,
) {
  const context = useContext(SmokeContext);
  if (!context) throw new UnsupportedError(`<${name}> works inside <Smoke> only: put it among its children.`);
  const { smoke, live, report } = context;
  const latest = useLatest({ ref, isEnabled, start });
  const handle = useRef<Kind>(undefined);

  useEffect(() => {
    if (!smoke || live.current !== smoke) return undefined;
    const { ref: given, start: begin, isEnabled: isOn } = latest.current;
    let made: Kind;
    try {
      made = begin(smoke, object ? targetOf(object) : group.current!);
      made.enabled = isOn;
    } catch (error) {
      return report(error);
    }
    handle.current = made;
    assignRef(given, made);
    return () => {
      handle.current = undefined;
      assignRef(given, null);
      made.remove();
    };
  }, [smoke, live, object, latest, report, group, ...others]);

  const change = useCallback(
    (act: (handle: Kind) => void) => {
      try {
        if (handle.current && live.current) act(handle.current);
      } catch (error) {
        report(error);
      }
    },
    [live, report],
  );
  useEffect(() => change((each) => void (each.enabled = isEnabled)), [isEnabled, change]);

  return change;
}

function placed({ object, group, placement, children }: Parts<SmokeHandle>): ReactNode {
  return object ? children : createElement('group', { ref: group, ...placement }, children);
}
