import type { MethodName, RemoteMethods } from './calls.ts';

/** Makes methods of these names from one function that calls any of them. */
export function makeMethods<Name extends MethodName>(
  names: readonly Name[],
  call: (name: Name, args: unknown[]) => Promise<unknown>,
): Pick<RemoteMethods, Name> {
  const made = names.map((name) => [name, (...args: unknown[]) => call(name, args)]);
  return Object.fromEntries(made) as Pick<RemoteMethods, Name>;
}
