// Asks the program: over HTTP, or in a worker of the browser where the page has no server.

/** How long a question may be under way before a newer one ends it, in milliseconds. */
const PATIENCE = 1500;

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

  constructor(operation, answered) {
    this.operation = operation;
    this.answered = answered;
  }

  get isBusy() {
    return this.#running !== null;
  }

  ask(question, note) {
    this.#next = { question, note };
    if (!this.#running) this.#begin();
    else if (performance.now() - this.#running.since > PATIENCE) this.#running.abort.abort();
    else if (!this.#running.timer) {
      const running = this.#running;
      running.timer = setTimeout(() => this.#next && running.abort.abort(), PATIENCE - (performance.now() - running.since));
    }
  }

  async #begin() {
    const { question, note } = this.#next;
    this.#next = null;
    const running = { since: performance.now(), abort: new AbortController(), timer: 0 };
    this.#running = running;
    let answer = null;
    try {
      answer = await ask(this.operation, question, running.abort.signal);
    } catch {
      // Ended for a newer question.
    }
    clearTimeout(running.timer);
    this.#running = null;
    const isLast = this.#next === null;
    if (!isLast) this.#begin();
    if (answer) this.answered(answer, note, isLast);
  }
}
