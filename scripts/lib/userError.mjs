/**
 * How a command ends when it cannot do what it was asked for: one sentence, a status other than zero, no stack trace.
 */

/** A reason to stop that is meant for a person. The message is one sentence that says what happened and what to do. */
export class UserError extends Error {
  /**
   * @param {string} sentence
   * @param {string} [evidence] what a tool printed, shown above the sentence when the sentence cannot stand alone
   */
  constructor(sentence, evidence = '') {
    super(sentence);
    this.name = 'UserError';
    this.evidence = evidence;
  }
}

/**
 * Runs the body of a command and turns whatever it throws into the ending described above.
 *
 * @param {() => Promise<number | void>} body its number becomes the process's status
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
