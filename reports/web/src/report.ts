// The data of the page as the C++ side writes them (page.cc). Every text is untrusted: it reaches the document through
// textContent alone.

export type Cell = [text: string, value?: number | null, bar?: number | null, status?: string];
export interface Column {
  name: string;
  unit: string;
  kind: 'text' | 'number' | 'error' | 'time';
}
export interface Table {
  name: string;
  title: string;
  note: string;
  columns: Column[];
  rows: Cell[][];
}

export interface Run {
  case: string;
  profile: string;
  series: string;
  run: string;
  reduced: boolean;
  mesh: string;
  unknowns: number;
  r?: number;
  r_used?: number;
  time_step?: number;
  time?: number;
  spread?: number;
}
export interface Quantity {
  metric: string;
  subject: string;
  title: string;
  modes: object;
  work: object;
}
// Indices into runs, quantities and truths; value null: failed.
export type Measure = [run: number, quantity: number, truth: number, value: number | null, bar: number];

export interface Report {
  schema: number;
  verdict: {
    cases: number;
    cases_within: number;
    checks: number;
    hold: number;
    not_decidable: number;
    not_measured: number;
    at_target: number;
    failed_runs: number;
    median: string | null;
    sentences: string[];
  };
  environment: Record<string, string>;
  cases: {
    name: string;
    profile: string;
    title: string;
    purpose: string;
    source: string;
    truth: string[];
    duration: number;
    frame_rate: number;
    samples_per_second: number;
  }[];
  tables: Record<string, Table>;
  plots: { runs: Run[]; quantities: Quantity[]; truths: string[]; measures: Measure[] };
  definitions: [term: string, text: string][];
  commands: string[];
}

export function readReport(): Report {
  return JSON.parse(document.getElementById('report')!.textContent!) as Report;
}
