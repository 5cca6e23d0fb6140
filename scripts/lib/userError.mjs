/** Error output of a command: one sentence, a nonzero exit status, no stack trace. */

/** An error for the user. The message is one sentence that says what happened and what to do. */
export class UserError extends Error {
  /**
   * @param {string} sentence
   * @param {string} [evidence] output of a tool, printed above the sentence for details
   */
  constructor(sentence, evidence = '') {
    super(sentence);
    this.name = 'UserError';
    this.evidence = evidence;
  }
}

/**
 * Runs the body of a command and reports errors as described above.
 *
 * @param {() => Promise<number | void>} body resolves to the exit status
 */
export async function conclude(body) {
  try {
    process.exitCode = (await body()) ?? 0;
  } catch (error) {
    process.exitCode = 1;
    if (error instanceof UserError && error.evidence) console.error(error.evidence.trimEnd());
    console.error(error instanceof Error ? error.message : String(error));
  }
}
