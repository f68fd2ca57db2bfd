// The tables of the page, which follow the choice of case, norm and truth.
import { announce, byId, make } from './dom';
import type { Cell, Report } from './report';
import type { Selectors } from './selectors';
import type { State } from './state';
import { TableView } from './table';
import type { TableOptions } from './table';

// A section without rows says so rather than showing an empty grid; sections that would only say "none" go.
function show(report: Report, name: string, empty: string | null, options: TableOptions): TableView[] {
  const section = byId(name),
    table = report.tables[name];
  if (table.rows.length) {
    const view = new TableView(table, options);
    section.append(view.element);
    return [view];
  }
  if (empty) section.append(make('p', { class: 'empty' }, empty));
  else section.remove();
  return [];
}

function follow(evidence: string): void {
  const target = document.getElementById(`finding-${evidence}`) ?? document.getElementById(evidence);
  target?.scrollIntoView();
  announce(target ? `moved to ${evidence}` : `${evidence} is not in this report`);
}

export function drawTables(report: Report, selectors: Selectors, state: State): TableView[] {
  const ofChoice = (row: Cell[]): boolean => {
    const choice = selectors.choice();
    return row[0][0] === choice.case && row[1][0] === choice.profile && row[2][0] === selectors.truthName();
  };
  const common = { choose: ofChoice, hide: ['case', 'profile', 'truth'] };
  // Tables of all three norms follow the chosen one; any other quantity leaves them whole.
  const norms = new Set(report.tables['speed-up'].rows.map((row) => row[3][0]));
  const ofNorm = (row: Cell[]): boolean =>
    ofChoice(row) && (!norms.has(selectors.metric()) || row[3][0] === selectors.metric());
  return [
    ...show(report, 'matrix', 'Nothing was run.', {}),
    ...show(report, 'contenders', 'No contender has been graded.', { ...common, state, filter: true }),
    ...show(report, 'orders', null, { ...common, filter: true }),
    ...show(report, 'speed-up', 'No reduced run has both an error and a time.', { ...common, choose: ofNorm }),
    ...show(report, 'phases', null, { ...common, choose: ofNorm }),
    ...show(report, 'polynomial-modes', null, {}),
    ...show(report, 'claims', null, { link: { column: 'evidence', follow } }),
    ...show(report, 'hard-cases', null, {}),
    ...show(report, 'hard-integrators', null, {}),
    ...show(report, 'checks', 'No case states a check.', {}),
    ...show(report, 'probes', null, common),
    ...show(report, 'failures', null, {}),
    ...show(report, 'environment', 'Nothing is known of it.', {}),
  ];
}
