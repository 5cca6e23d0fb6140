/** Migrates links of older versions to the current version. */

/** Keys and values of a link, as text. */
type Pairs = ReadonlyMap<string, string>;

/** Returns the pairs of a link of one version as those of the next. */
export type Migration = (pairs: Pairs) => Pairs;

/** The first entry migrates version 1 to version 2. */
const MIGRATIONS: readonly Migration[] = [];

/** Current version of the link format. */
export const VERSION = String(MIGRATIONS.length + 1);

/** The version of a link or a file. A link that names none has version 1. */
export function versionOf(pairs: Pairs): string {
  return pairs.get('v') ?? (pairs.size > 0 ? '1' : VERSION);
}

/** Migrates the pairs of a link to the current version. Leaves unknown versions unchanged. */
export function migrate(pairs: Pairs, migrations = MIGRATIONS): Pairs {
  const version = Number(versionOf(pairs));
  if (!Number.isInteger(version) || version < 1 || version > migrations.length) return pairs;
  const migrated = migrations.slice(version - 1).reduce((older, migration) => migration(older), pairs);
  return new Map([...migrated, ['v', String(migrations.length + 1)]]);
}
