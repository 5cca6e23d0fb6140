/**
 * Rules of the linter for code that feeds the simulator: its numbers have the same bits in every engine.
 *
 * The language fixes what + - * / % and the members of Math in EXACT give, and leaves the last bits of all others and of
 * the operator ** to each engine.
 */

const CONSTANTS = ['E', 'LN10', 'LN2', 'LOG10E', 'LOG2E', 'PI', 'SQRT1_2', 'SQRT2'];
const FUNCTIONS = ['abs', 'ceil', 'clz32', 'floor', 'fround', 'imul', 'max', 'min', 'round', 'sign', 'sqrt', 'trunc'];
const EXACT = new Set([...CONSTANTS, ...FUNCTIONS]);
/** Classes of three.js whose methods for vectors use arithmetic and square roots only, as exactScenes.test.ts shows. */
const EXACT_CLASSES = new Set(['Vector2', 'Vector3']);

const REASON =
  'its last bits differ between engines, and what follows from them ends in another state: use src/sim/exact.';

/** Refuses engine-dependent functions of Math and the operator **. */
const math = {
  /** @param {Context} context */
  create: (context) => ({
    /** @param {Node} node */
    Identifier(node) {
      if (node.name !== 'Math') return;
      const { type, object, computed, property } = node.parent;
      const member = type === 'MemberExpression' && object === node && (computed ? property.value : property.name);
      if (!EXACT.has(member)) report(context, node.parent, member ? `Math.${member}` : 'Math itself');
    },
    /** @param {Node} node */
    BinaryExpression(node) {
      if (node.operator === '**') report(context, node, 'The operator **');
    },
    /** @param {Node} node */
    AssignmentExpression(node) {
      if (node.operator === '**=') report(context, node, 'The operator **=');
    },
  }),
};

/** Refuses what three.js turns things with, which uses Math.sin and its like. */
const three = {
  /** @param {Context} context */
  create: (context) => ({
    /** @param {Node} node */
    ImportDeclaration(node) {
      if (!/^three(\/|$)/.test(node.source.value) || node.importKind === 'type') return;
      for (const specifier of node.specifiers) {
        const name = specifier.imported?.name ?? 'all';
        if (specifier.importKind !== 'type' && !EXACT_CLASSES.has(name))
          report(context, specifier, `${name} of three.js`);
      }
    },
  }),
};

/** @param {Context} context @param {Node} node @param {string} what */
function report(context, node, what) {
  context.report({ node, message: `${what} feeds the simulator here: ${REASON}` });
}

export default { meta: { name: 'exact' }, rules: { math, three } };

/** @typedef {any} Node of the syntax tree, as ESLint has it */
/** @typedef {{ report(problem: { node: Node, message: string }): void }} Context */
