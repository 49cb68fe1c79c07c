/** Number in the declared unit of the parameter, or the word of a choice. */
export type Value = number | string;

/** Something wrong with the text of a document. Line and column begin at 1. */
export interface Finding {
  severity: "error" | "warning";
  message: string;
  remedy: string;
  line: number;
  column: number;
}

/** State of the run; the time is in the unit of the independent variable. */
export interface Run {
  status: "paused" | "playing" | "full" | "failed" | "ended";
  time: number;
}

/** An answer that was checked. Questions count from 1. */
export interface Answer {
  question: number;
  typed: string;
  grade: "correct" | "close" | "sign" | "scale" | "wrong" | "unreadable" | "unanswerable";
}

export interface MeniscusEvents {
  /** The simulation is there: the values of all parameters. */
  ready: CustomEvent<Record<string, Value>>;
  /** A parameter has changed: the values of all. */
  parameters: CustomEvent<Record<string, Value>>;
  /** The run has started or stopped. */
  run: CustomEvent<Run>;
  answer: CustomEvent<Answer>;
  /** A text was compiled: what is wrong with it. */
  findings: CustomEvent<Finding[]>;
}

/**
 * A simulation in a page: `<meniscus-simulation src="utube.html">`. Attributes: `src`, `inline`, `parameters`, `show`, `lock`,
 * `language`.
 */
export class MeniscusSimulation extends HTMLElement {
  /** Values of all parameters, once the simulation is ready. Assign those that are to change. */
  parameters: Record<string, Value>;
  /** Text of the document, in place of an address. */
  text: string;
  addEventListener<K extends keyof MeniscusEvents>(type: K, listener: (event: MeniscusEvents[K]) => void, options?: boolean | AddEventListenerOptions): void;
  addEventListener(type: string, listener: EventListenerOrEventListenerObject, options?: boolean | AddEventListenerOptions): void;
}

declare global {
  interface HTMLElementTagNameMap {
    "meniscus-simulation": MeniscusSimulation;
  }
}
