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
  pools: ((Cell | string)[] | null)[];
  rows: Cell[][];
}

export interface Run {
  case: string;
  profile: string;
  series: string;
  family: string;
  run: string;
  reduced: boolean;
  mesh: string;
  unknowns: number;
  against_modes: boolean;
  against_step: boolean;
  r?: number;
  r_used?: number;
  time_step?: number;
  time?: number;
  spread?: number;
}
export interface Quantity {
  metric: string;
  subject: string;
  unit: string;
  title: string;
}
export type Kind = 'work' | 'modes' | 'steps';
// Indices into runs, quantities and truths; value null: failed.
export type Measure = [run: number, quantity: number, truth: number, value: number | null, bar: number];
// What legends say of a series; run: any of the case.
export type Labels = [run: number, quantity: number, truth: number, kind: Kind, labels: Record<string, string>];

// A specification with its data as rows: names of the fields stand once.
export interface Figure {
  name: string;
  specification: Record<string, unknown>;
  fields: string[];
  rows: unknown[][];
}
export interface FindingGroup {
  analysis: string;
  heading: string;
  before_speed_up: boolean;
  tables: { case: string; profile: string; table: Table; figures: Figure[] }[];
}

export interface Report {
  schema: number;
  verdict: {
    cases: number;
    cases_within: number;
    checks: number;
    hold: number;
    not_decidable: number;
    not_measured: number;
    timed: boolean;
    at_target: number;
    compared: number;
    failed_runs: number;
    unstable_runs: number;
    median: string | null;
    sentences: string[];
    opening: { case: string; profile: string } | null; // the page opens on it
  };
  cases: {
    name: string;
    profile: string;
    title: string;
    purpose: string;
    source: string;
    line: string;
    truth: string[];
    duration: number;
    frame_rate: number;
    samples_per_second: number;
  }[];
  tables: Record<string, Table>;
  findings: FindingGroup[];
  plots: {
    runs: Run[];
    quantities: Quantity[];
    specifications: Record<Kind, object>;
    speed_up: Figure | null;
    labels: Labels[];
    truths: string[];
    measures: Measure[];
  };
  definitions: [term: string, text: string][];
  commands: string[];
}

// Undoes what keeps the page small: pools of cells that recur, text alone without brackets, the status "ok" left out.
function unpack(table: Table): void {
  const { pools } = table;
  for (const row of table.rows as (Cell | string | number)[][]) {
    row.forEach((packed, j) => {
      const cell = typeof packed === 'number' ? pools[j]![packed] : packed;
      if (typeof cell === 'string') row[j] = [cell];
      else if (cell.length === 3) row[j] = [cell[0], cell[1], cell[2], 'ok'];
      else row[j] = cell;
    });
  }
}

// What the environment has under a name: one value, or each of several.
export function environmentOf(report: Report, what: string): string {
  const rows = report.tables.environment.rows.filter(([name]) => name[0] === what);
  return rows.map(([, value]) => value[0]).join(', ');
}

export function readReport(): Report {
  const report = JSON.parse(document.getElementById('report')!.textContent!) as Report;
  Object.values(report.tables).forEach(unpack);
  for (const group of report.findings) group.tables.forEach((one) => unpack(one.table));
  return report;
}
