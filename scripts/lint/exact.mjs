/**
 * Lint rules for code that feeds the simulator, whose numbers must be bit-identical in every JavaScript engine.
 *
 * ECMAScript defines the exact results of + - * / % and of the members of Math in EXACT. The last bits of all other
 * members and of the operator ** are implementation-defined.
 */

const CONSTANTS = ['E', 'LN10', 'LN2', 'LOG10E', 'LOG2E', 'PI', 'SQRT1_2', 'SQRT2'];
const FUNCTIONS = ['abs', 'ceil', 'clz32', 'floor', 'fround', 'imul', 'max', 'min', 'round', 'sign', 'sqrt', 'trunc'];
const EXACT = new Set([...CONSTANTS, ...FUNCTIONS]);
/** three.js classes whose vector methods use only arithmetic and square roots, as exactScenes.test.ts shows. */
const EXACT_CLASSES = new Set(['Vector2', 'Vector3']);

const REASON =
  'its last bits differ between engines, and what follows from them ends in another state: use src/simulator/exact.';

/** Reports engine-dependent functions of Math and the operator **. */
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

/** Reports imports of three.js classes that rotate with Math.sin and similar functions. */
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

/**
 * @param {Context} context
 * @param {Node} node
 * @param {string} what
 */
function report(context, node, what) {
  context.report({ node, message: `${what} feeds the simulator here: ${REASON}` });
}

export default { meta: { name: 'exact' }, rules: { math, three } };

/** @typedef {any} Node an ESTree node */
/** @typedef {{ report(problem: { node: Node, message: string }): void }} Context */
