/**
 * Warnings of development builds, which bundlers choose by the export condition `development`. Only the entries
 * `*.development.ts` import the modules that warn, so builds for production contain nothing of them. docs/warnings.md
 * lists the warnings.
 */

const warned = new Set<string>();

/**
 * Writes a warning to the console once in a page.
 * @param about what the warning concerns, such as `CartoonSmoke`
 * @param situation that is reported once, if the message has varying parts
 */
export function warnOnce(about: string, message: string, situation = message): void {
  const id = `${about} ${situation}`;
  if (warned.has(id)) return;
  warned.add(id);
  // oxlint-disable-next-line eslint/no-console -- only in development builds
  console.warn(`${about}: ${message}`);
}

export function warnOfError(about: string, { name, message }: Error): void {
  warnOnce(about, `${name}: ${message}`);
}

/**
 * Warns when a promise is used as the object that it resolves to. Otherwise the promise does not change.
 * @param names of members of that object
 */
export function warnUnawaited<Kind>(about: string, promise: Promise<Kind>, names: Iterable<string>): Promise<Kind> {
  for (const name of names) {
    if (name in promise) continue;
    const warn = () =>
      warnOnce(about, `.${name} was read from a promise. Write \u201cawait ${about}\u201d first.`, 'await');
    Reflect.defineProperty(promise, name, {
      configurable: true,
      get: warn,
      set(value) {
        warn();
        Reflect.defineProperty(promise, name, { value, writable: true });
      },
    });
  }
  return promise;
}
