/** What calls take from a preset. The rest of it is motion, which the effects have. */
const PARTS = ['style.', 'light.', 'puff.'];

/** Whether a parameter is part of the look. */
export function isOfLook(key: string): boolean {
  return PARTS.some((part) => key.startsWith(part));
}
