/** The types that declarations name, read from the syntax of `.d.ts` files. */
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { parseSync } from 'rolldown/utils';

type Syntax = Readonly<Record<string, unknown>> & { readonly type: string };

/** Where a name comes from: its name in another file, or in the same file if `file` is missing. */
interface Origin {
  readonly file?: string;
  readonly name: string;
}

interface Module {
  /** Classes, interfaces and type aliases by name. Merged declarations share a name. */
  readonly types: Map<string, Syntax[]>;
  /** Functions and variables by name. */
  readonly values: Map<string, Syntax[]>;
  /** Names of other files of the package. */
  readonly imports: Map<string, Origin>;
  readonly exports: Map<string, Origin>;
}

const TYPES = ['ClassDeclaration', 'TSInterfaceDeclaration', 'TSTypeAliasDeclaration'];

/**
 * Types that a signature of an exported declaration names, and that no entry exports.
 * @param folder of the declarations
 * @param entries paths in it
 * @returns `Stage names stage/sight.d.ts Sight`, and the number of exported names
 */
export function hiddenTypes(folder: string, entries: readonly string[]): { hidden: string[]; exported: number } {
  const modules = new Map<string, Module>();
  const moduleOf = (file: string) => {
    if (!modules.has(file)) modules.set(file, read(folder, file));
    return modules.get(file)!;
  };
  const find = (file: string, name: string): { file: string; name: string } | undefined => {
    const { types, values, imports } = moduleOf(file);
    if (types.has(name) || values.has(name)) return { file, name };
    const origin = imports.get(name);
    return origin?.file ? exportOf(origin.file, origin.name) : undefined;
  };
  const exportOf = (file: string, exported: string): { file: string; name: string } | undefined => {
    const origin = moduleOf(file).exports.get(exported);
    if (!origin) return undefined;
    return origin.file ? exportOf(origin.file, origin.name) : find(file, origin.name);
  };
  const open = new Map<string, { file: string; name: string }>();
  for (const entry of entries) {
    for (const exported of moduleOf(entry).exports.keys()) {
      const found = exportOf(entry, exported);
      if (!found) throw new Error(`${entry} exports ${exported}, which no file declares.`);
      open.set(`${found.file} ${found.name}`, found);
    }
  }
  const hidden = [...open.values()].flatMap(({ file, name }) => {
    const { types, values } = moduleOf(file);
    const named = namesIn([...(types.get(name) ?? []), ...(values.get(name) ?? [])]);
    const own = [...named].map((each) => find(file, each)).filter((found) => found !== undefined);
    const closed = own.filter((found) => moduleOf(found.file).types.has(found.name));
    return closed
      .map((found) => `${found.file} ${found.name}`)
      .filter((each) => !open.has(each))
      .map((each) => `${name} names ${each}`);
  });
  return { hidden, exported: open.size };
}

function read(folder: string, file: string): Module {
  const { program, errors } = parseSync(file, readFileSync(join(folder, file), 'utf8'));
  if (errors.length > 0) throw new Error(`${file}: ${errors[0].message}`);
  const module: Module = { types: new Map(), values: new Map(), imports: new Map(), exports: new Map() };
  const fileOf = (source: string) =>
    source.startsWith('.') ? join(dirname(file), source).replace(/\.js$/, '.d.ts') : undefined;
  const declare = (declaration: Syntax): string[] => {
    const kind = TYPES.includes(declaration.type) ? module.types : module.values;
    const names = ((declaration.declarations as Syntax[] | undefined) ?? [declaration]).map(({ id }) => nameOf(id));
    for (const name of names) kind.set(name, [...(kind.get(name) ?? []), declaration]);
    return names;
  };
  for (const statement of program.body as unknown as Syntax[]) {
    const source = statement.source as { value: string } | null | undefined;
    const specifiers = (statement.specifiers ?? []) as Syntax[];
    if (statement.type === 'ImportDeclaration') {
      for (const { local, imported } of specifiers)
        module.imports.set(nameOf(local), { file: fileOf(source!.value), name: nameOf(imported ?? local) });
    } else if (statement.type === 'ExportNamedDeclaration' && statement.declaration) {
      for (const name of declare(statement.declaration as Syntax)) module.exports.set(name, { name });
    } else if (statement.type === 'ExportNamedDeclaration') {
      for (const { local, exported } of specifiers)
        module.exports.set(nameOf(exported), { file: source ? fileOf(source.value) : undefined, name: nameOf(local) });
    } else if (statement.id ?? statement.declarations) declare(statement);
    else throw new Error(`${file}: ${statement.type} is not expected in declarations.`);
  }
  return module;
}

/** Names of types, base classes and `typeof` queries. A name with dots counts as its first part. */
function namesIn(node: unknown, names = new Set<string>()): Set<string> {
  if (Array.isArray(node)) for (const each of node) namesIn(each, names);
  if (typeof node !== 'object' || node === null || Array.isArray(node)) return names;
  const { type, typeName, exprName, expression, superClass } = node as Syntax;
  if (type === 'TSTypeReference') names.add(nameOf(typeName));
  if (type === 'TSTypeQuery') names.add(nameOf(exprName));
  if (type === 'TSInterfaceHeritage' || type === 'TSClassImplements') names.add(nameOf(expression));
  if (type === 'ClassDeclaration' && superClass) names.add(nameOf(superClass));
  for (const each of Object.values(node)) namesIn(each, names);
  return names;
}

function nameOf(node: unknown): string {
  const { name, left, object } = node as { name?: string; left?: unknown; object?: unknown };
  return name ?? nameOf(left ?? object);
}
