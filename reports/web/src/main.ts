// The page in reading order; text first, plots once the browser has painted.
import { byId, make } from './dom';
import { drawPlots } from './plots';
import { readReport } from './report';
import type { Cell, Report, Table } from './report';
import { Selectors } from './selectors';
import { State } from './state';
import { TableView } from './table';
import { drawVerdict } from './verdict';

// A section without rows says so rather than showing an empty grid; sections that would only say "none" go.
function tableSection(
  report: Report,
  name: string,
  empty: string | null,
  make_: (table: Table) => TableView,
): TableView | null {
  const section = byId(name),
    table = report.tables[name];
  if (table.rows.length) {
    const view = make_(table);
    section.append(view.element);
    return view;
  }
  if (empty) section.append(make('p', { class: 'empty' }, empty));
  else section.remove();
  return null;
}

function drawCases(report: Report): void {
  const section = byId('cases');
  if (!report.cases.length) {
    section.remove();
    return;
  }
  for (const one of report.cases) {
    section.append(
      make(
        'article',
        {},
        make('h3', {}, one.title || one.name),
        make(
          'p',
          { class: 'mono' },
          `${one.name} · profile ${one.profile} · ${one.duration} s · ${one.frame_rate} frames/s · ` +
            `${one.samples_per_second} samples/s`,
        ),
        make('p', {}, [one.purpose, ...one.truth].join(' ')),
        ...(one.source ? [make('p', { class: 'note' }, `Source: ${one.source}`)] : []),
      ),
    );
  }
}

function drawDefinitions(report: Report): void {
  byId('definitions').append(
    make(
      'dl',
      { class: 'definitions' },
      ...report.definitions.flatMap(([term, text]) => [make('dt', {}, term), make('dd', {}, text)]),
    ),
  );
}

function drawEnvironment(report: Report): void {
  const section = byId('environment');
  section.append(
    make(
      'dl',
      { class: 'environment' },
      ...Object.entries(report.environment).flatMap(([key, value]) => [make('dt', {}, key), make('dd', {}, value)]),
    ),
  );
  section.append(make('h3', {}, 'To reproduce'), make('pre', { tabindex: '0' }, report.commands.join('\n')));
}

function start(): void {
  const report = readReport(),
    state = new State();
  drawVerdict(report);
  byId('plots').hidden = report.plots.runs.length === 0;
  const selectors = new Selectors(report, state);
  const ofChoice = (row: Cell[]): boolean => {
    const choice = selectors.choice();
    return row[0][0] === choice.case && row[1][0] === choice.profile && row[2][0] === selectors.truthName();
  };
  const common = { choose: ofChoice, hide: ['case', 'profile', 'truth'] };
  const views = [
    tableSection(
      report,
      'contenders',
      'No contender has been graded.',
      (table) => new TableView(table, { ...common, state, filter: true }),
    ),
    tableSection(
      report,
      'speed-up',
      'No reduced run has both an error and a time.',
      (table) => new TableView(table, common),
    ),
    tableSection(report, 'checks', 'No case states a check.', (table) => new TableView(table)),
    tableSection(report, 'probes', null, (table) => new TableView(table, common)),
    tableSection(report, 'failures', null, (table) => new TableView(table)),
  ];
  drawCases(report);
  drawDefinitions(report);
  drawEnvironment(report);

  let drawn = '';
  const drawChosen = (force = false): void => {
    if (!report.plots.runs.length) return;
    const choice = JSON.stringify(selectors.choice());
    if (!force && choice === drawn) return;
    drawn = choice;
    void drawPlots(report, selectors.choice()).then(() => {
      document.documentElement.dataset.ready = choice;
    });
  };
  state.onChange(() => {
    selectors.follow();
    for (const view of views) view?.draw();
    const { case: name, profile } = selectors.choice();
    document.title = name ? `${name} (${profile}), Modalbench report` : 'Modalbench report';
    drawChosen();
  });
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => drawChosen(true));
  let width = innerWidth,
    timer = 0;
  addEventListener('resize', () => {
    if (innerWidth === width) return;
    width = innerWidth;
    clearTimeout(timer);
    timer = window.setTimeout(() => drawChosen(true), 150);
  });
  // After the first paint: compiling the plots takes longer than everything above.
  requestAnimationFrame(() => setTimeout(() => drawChosen(), 0));
}

start();
