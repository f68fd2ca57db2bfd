// The page in reading order; text first, plots once the browser has painted.
import { announce, byId, make } from './dom';
import { Findings } from './findings';
import { drawFigure, drawPlots } from './plots';
import { readReport } from './report';
import type { Cell, Report, Table } from './report';
import { Selectors } from './selectors';
import { State } from './state';
import { TableView } from './table';
import type { TableOptions } from './table';
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

// Sections by name. Buttons, as the hash keeps what the reader chose.
function drawContents(): void {
  const sections = [...document.querySelectorAll<HTMLElement>('main section')].filter((one) => one.id !== 'verdict');
  const buttons = sections.map((section) => {
    const button = make('button', { type: 'button', class: 'link' }, section.querySelector('h2')?.textContent ?? '');
    button.addEventListener('click', () => section.scrollIntoView());
    return make('li', {}, button);
  });
  byId('contents').append(make('ul', {}, ...buttons));
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
  // Tables of all three norms follow the chosen one; any other quantity leaves them whole.
  const norms = new Set(report.tables['speed-up'].rows.map((row) => row[3][0]));
  const ofNorm = (row: Cell[]): boolean =>
    ofChoice(row) && (!norms.has(selectors.metric()) || row[3][0] === selectors.metric());
  const show = (name: string, empty: string | null, options: TableOptions): TableView | null =>
    tableSection(report, name, empty, (table) => new TableView(table, options));
  const follow = (evidence: string): void => {
    const target = document.getElementById(`finding-${evidence}`) ?? document.getElementById(evidence);
    target?.scrollIntoView();
    announce(target ? `moved to ${evidence}` : `${evidence} is not in this report`);
  };
  const views = [
    show('matrix', 'Nothing was run.', {}),
    show('contenders', 'No contender has been graded.', { ...common, state, filter: true }),
    show('orders', null, { ...common, filter: true }),
    show('speed-up', 'No reduced run has both an error and a time.', { ...common, choose: ofNorm }),
    show('phases', null, { ...common, choose: ofNorm }),
    show('claims', null, { link: { column: 'evidence', follow } }),
    show('checks', 'No case states a check.', {}),
    show('probes', null, common),
    show('failures', null, {}),
  ];
  const findings = new Findings(report.findings);
  drawCases(report);
  drawDefinitions(report);
  drawEnvironment(report);
  drawContents();

  let drawn = '';
  const drawChosen = (force = false): void => {
    if (!report.plots.runs.length) return;
    const choice = JSON.stringify(selectors.choice());
    if (!force && choice === drawn) return;
    drawn = choice;
    const ofCase = selectors.choice();
    void drawPlots(report, ofCase).then(async () => {
      document.documentElement.dataset.ready = choice;
      await findings.draw(ofCase, force);
      const bars = report.plots.speed_up;
      byId('speed-up-figure').hidden = !bars;
      if (bars && (force || !byId('speed-up-bars').firstChild)) await drawFigure(byId('speed-up-bars'), bars);
      document.documentElement.dataset.figures = choice;
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
