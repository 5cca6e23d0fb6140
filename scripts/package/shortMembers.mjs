/**
 * A plugin for the bundler: what TypeScript calls private gets a short name, which no minifier dares to give to a property.
 * It is known to one class alone; where that says it of anything but `this`, it stays as it is. `#names` would be as short,
 * but fail on objects that a page wraps in a proxy.
 */

import { parseSync, Visitor } from 'rolldown/utils';

/**
 * @typedef {import('rolldown/utils').ESTree.Class} Class
 * @typedef {{ start: number, end: number, isShorthand?: boolean }} Place where a name stands
 * @typedef {Map<string, Place[]>} Places where a class says its private names, of `this` and where it declares them
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
            const short = `$${index.toString(36)}`;
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
  /** What `this` is where we are: a class, or something else. @type {(Places | undefined)[]} */
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
 * Those of a class that extends another stay, because they would meet the other's.
 *
 * @param {Class} node
 * @returns {Places}
 */
function privatesOf({ superClass, body }) {
  /** @type {Places} */
  const places = new Map();
  for (const member of superClass ? [] : body.body) {
    if (!('accessibility' in member) || member.accessibility !== 'private') continue;
    if (member.key.type !== 'Identifier' || member.computed || member.key.name === 'constructor') continue;
    places.set(member.key.name, [...(places.get(member.key.name) ?? []), member.key]);
  }
  return places;
}
