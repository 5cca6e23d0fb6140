/**
 * A bundler plugin that shortens TypeScript's private members; minifiers do not rename properties. A private name is
 * used by one class only. If that class accesses it on anything but `this`, it is not renamed. `#names` would be as
 * short but fail on objects that a page wraps in a Proxy. The minifier's `mangleProps` selects by name, and private
 * names are common words that three.js uses as well.
 */

import { parseSync, Visitor } from 'rolldown/utils';

/** Letters by their frequency in minified code: frequent ones compress better. */
const LETTERS = [...'etnriaosclufdpmhgvybxwkjqz'];

/**
 * @typedef {import('rolldown/utils').ESTree.Class} Class
 * @typedef {{ start: number, end: number, isShorthand?: boolean }} Place position of a name
 * @typedef {Map<string, Place[]>} Places where a class declares its private names and accesses them on `this`
 */

/** @returns {import('rolldown').Plugin} */
export function shortMembers() {
  return {
    name: 'short-members',
    transform: {
      order: 'pre',
      filter: { id: /\/src\/.*\.ts$/, code: /\bprivate / },
      handler(code, id, { magicString }) {
        if (!magicString) throw new Error('Short members need experimental.nativeMagicString.');
        for (const places of privatePlaces(id, code)) {
          [...places].forEach(([name, said], index) => {
            const short = LETTERS[index] ?? `$${index}`;
            for (const { start, end, isShorthand } of said)
              magicString.update(start, end, isShorthand ? `${short}:${name}` : short);
          });
        }
        return { code: magicString };
      },
    },
  };
}

/**
 * The private names of each class of a module.
 *
 * @param {string} file
 * @param {string} code
 */
export function privatePlaces(file, code) {
  /** @type {Places[]} */
  const found = [];
  /**
   * The meaning of `this` in each enclosing scope: a class, or something else.
   * @type {(Places | undefined)[]}
   */
  const owners = [];
  const methods = new Set();
  const spoil = (/** @type {string} */ name) => owners.forEach((privates) => privates?.delete(name));
  const enterClass = (/** @type {Class} */ node) => void owners.push(privatesOf(node));
  const leaveClass = () => void found.push(owners.pop() ?? new Map());
  const enter = (/** @type {object} */ node) => void (methods.has(node) || owners.push(undefined));
  const leave = (/** @type {object} */ node) => void (methods.has(node) || owners.pop());
  new Visitor({
    ClassDeclaration: enterClass,
    'ClassDeclaration:exit': leaveClass,
    ClassExpression: enterClass,
    'ClassExpression:exit': leaveClass,
    MethodDefinition: ({ value }) => void methods.add(value),
    FunctionExpression: enter,
    'FunctionExpression:exit': leave,
    FunctionDeclaration: enter,
    'FunctionDeclaration:exit': leave,
    MemberExpression({ object, property }) {
      if (property.type !== 'Identifier') return;
      if (object.type === 'ThisExpression') owners.at(-1)?.get(property.name)?.push(property);
      else spoil(property.name);
    },
    VariableDeclarator({ id, init }) {
      if (init?.type !== 'ThisExpression' || id.type !== 'ObjectPattern') return;
      for (const property of id.properties) {
        if (property.type !== 'Property' || property.key.type !== 'Identifier') continue;
        const { key, shorthand } = property;
        owners.at(-1)?.get(key.name)?.push({ start: key.start, end: key.end, isShorthand: shorthand });
      }
    },
  }).visit(parseSync(file, code).program);
  return found;
}

/**
 * Members of a class with a superclass or with a name of one letter are not renamed, because the short names could
 * collide.
 *
 * @param {Class} node
 * @returns {Places}
 */
function privatesOf({ superClass, body }) {
  /** @type {Places} */
  const places = new Map();
  const members = body.body.flatMap((member) =>
    'key' in member && member.key.type === 'Identifier' && !member.computed
      ? [{ key: member.key, isPrivate: 'accessibility' in member && member.accessibility === 'private' }]
      : [],
  );
  if (superClass || members.some(({ key }) => key.name.length === 1)) return places;
  for (const { key, isPrivate } of members) {
    if (isPrivate && key.name !== 'constructor') places.set(key.name, [...(places.get(key.name) ?? []), key]);
  }
  return places;
}
