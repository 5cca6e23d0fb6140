/** Errors of the film page. They are not in strings.ts, which every visitor of the demo downloads. */
export const messages = {
  badLink: (problems: readonly string[]) => `The link has mistakes: ${problems.join(' ')}`,
  otherState: (saved: string, found: string) =>
    `A saved state has the hash ${saved}, but ${found} after it was read: delete the folder of the states.`,
  failed: (what: string, status: number) => `${what}: the command answered ${status}.`,
};
