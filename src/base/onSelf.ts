type Member = (...given: unknown[]) => unknown;
type Run = (member: Member, given: readonly unknown[]) => unknown;

const RUN = Symbol('run');
const prepared = new Set<object>();

/**
 * Makes members of the classes of an object run on the object itself when they are called on a Proxy of it, as reactive
 * libraries make them: private fields and the objects inside never pass through the Proxy. Call it in the constructor.
 * @param base the prototype of the first class that is not ours
 */
export function runOnSelf(object: object, base: object = Object.prototype): void {
  const run: Run = (member, given) => Reflect.apply(member, object, given);
  Object.defineProperty(object, RUN, { value: run, configurable: true });
  // Vue makes no Proxy of an object with this key. three.js cannot draw a Proxy of a mesh.
  Object.defineProperty(object, '__v_skip', { value: true, configurable: true });
  for (let at = Object.getPrototypeOf(object); at !== base && !prepared.has(at); at = Object.getPrototypeOf(at)) {
    prepared.add(at);
    for (const [name, member] of Object.entries(Object.getOwnPropertyDescriptors(at))) {
      if (name === 'constructor') continue;
      for (const part of ['value', 'get', 'set'] as const)
        if (typeof member[part] === 'function') member[part] = onSelf(member[part]);
      Object.defineProperty(at, name, member);
    }
  }
}

/** Wraps a member, so that a call on a Proxy runs on the object itself. See {@link runOnSelf}. */
export function onSelf(given: (this: never, ...given: never[]) => unknown): Member {
  const member = given as Member;
  return function (this: { readonly [RUN]?: Run }, ...values) {
    const run = this[RUN];
    return run ? run(member, values) : member.apply(this, values);
  };
}
