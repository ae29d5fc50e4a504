// Asks the program: over HTTP, or in a worker of the browser where the page has no server.

/** How long a question may be under way before a newer one ends it, in milliseconds; and one that is asked while nothing moves, such as an audit. */
const PATIENCE = 1500;
const PATIENCE_AT_REST = 60;

let transport = overHttp;

/** What answers from now on. */
export function answerBy(other) {
  transport = other;
}

async function overHttp(operation, question, signal) {
  const response = await fetch(`api/${operation}`, {
    method: "POST",
    headers: { "Content-Type": "application/json" },
    body: JSON.stringify(question ?? {}),
    signal,
  });
  if (response.ok) return response.json();
  const said = (await response.text()).trim();
  return { fault: { message: said || `the program answered ${response.status}`, what: said } };
}

/** The answer to a question; what cannot be answered has a `fault`. */
export async function ask(operation, question, signal) {
  try {
    return await transport(operation, question, signal);
  } catch (error) {
    if (error.name === "AbortError") throw error;
    const message = "The program does not answer: it has ended, or its window was closed. Start `shtaerman explore` again.";
    return { fault: { message, what: message, unanswered: true } };
  }
}

/** Asks one question at a time, and of those that come meanwhile only the last. */
export class Latest {
  #running = null;
  #next = null;

  /** `isAtRest` tells by the note of a question whether it is one for which what moves does not wait. */
  constructor(operation, answered, isAtRest = () => false) {
    Object.assign(this, { operation, answered, isAtRest });
    /** How long the last answer took, in milliseconds. */
    this.took = 0;
  }

  get isBusy() {
    return this.#running !== null;
  }

  ask(question, note) {
    this.#next = { question, note };
    const running = this.#running;
    if (!running) {
      this.#begin();
      return;
    }
    const left = (this.isAtRest(running.note) ? PATIENCE_AT_REST : PATIENCE) - (performance.now() - running.since);
    if (left <= 0) running.abort.abort();
    else if (!running.timer) running.timer = setTimeout(() => this.#next && running.abort.abort(), left);
  }

  async #begin() {
    const { question, note } = this.#next;
    this.#next = null;
    const running = { note, since: performance.now(), abort: new AbortController(), timer: 0 };
    this.#running = running;
    let answer = null;
    try {
      answer = await ask(this.operation, question, running.abort.signal);
    } catch {
      // Ended for a newer question.
    }
    clearTimeout(running.timer);
    this.took = performance.now() - running.since;
    this.#running = null;
    const isLast = this.#next === null;
    if (!isLast) this.#begin();
    if (answer) this.answered(answer, note, isLast);
  }
}
