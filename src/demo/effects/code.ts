import type { PuffOptions } from '../../puff.ts';

/** The line of code of a call with these options. @param target as an expression */
export function puffCode(target: string, options: PuffOptions): string {
  const given = Object.entries(options).filter(([, value]) => value !== undefined);
  if (given.length === 0) return `puff(${target});`;
  const pairs = given.map(([name, value]) => `${name}: ${typeof value === 'string' ? quoted(value) : value}`);
  return `puff(${target}, { ${pairs.join(', ')} });`;
}

function quoted(text: string): string {
  return `'${text.replace(/[\\']/g, '\\$&')}'`;
}
