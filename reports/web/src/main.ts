// The page in reading order; text first, plots once the browser has painted.
import { byId } from './dom';
import { Findings } from './findings';
import { drawFigure, drawPlots } from './plots';
import { readReport } from './report';
import type { Report } from './report';
import { drawCases, drawCommands, drawContents, drawDefinitions } from './sections';
import { Selectors } from './selectors';
import type { Choice } from './selectors';
import { State } from './state';
import { drawTables } from './tables';
import { drawVerdict } from './verdict';

async function drawSpeedUp(report: Report, force: boolean): Promise<void> {
  const bars = report.plots.speed_up;
  byId('speed-up-figure').hidden = !bars;
  if (bars && (force || !byId('speed-up-bars').firstChild)) await drawFigure(byId('speed-up-bars'), bars);
}

// What is drawn of a choice, once; `force` draws it again, in another size or other colours.
function figuresOf(report: Report, choose: () => Choice): (force?: boolean) => Promise<void> {
  const findings = new Findings(report.findings);
  let drawn = '';
  return async (force = false) => {
    if (!report.plots.runs.length) return;
    const choice = choose(),
      name = JSON.stringify(choice);
    if (!force && name === drawn) return;
    drawn = name;
    await drawPlots(report, choice);
    document.documentElement.dataset.ready = name;
    await findings.draw(choice, force);
    await drawSpeedUp(report, force);
    document.documentElement.dataset.figures = name;
  };
}

function drawAgainWhereTheLookChanges(draw: (force: boolean) => Promise<void>): void {
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => void draw(true));
  let width = innerWidth,
    timer = 0;
  addEventListener('resize', () => {
    if (innerWidth === width) return;
    width = innerWidth;
    clearTimeout(timer);
    timer = window.setTimeout(() => void draw(true), 150);
  });
}

function start(): void {
  const report = readReport(),
    state = new State();
  drawVerdict(report);
  byId('plots').hidden = report.plots.runs.length === 0;
  const selectors = new Selectors(report, state);
  const views = drawTables(report, selectors, state);
  const draw = figuresOf(report, () => selectors.choice());
  drawCases(report);
  drawDefinitions(report);
  drawCommands(report);
  drawContents();
  state.onChange(() => {
    selectors.follow();
    for (const view of views) view.draw();
    const { case: name, profile } = selectors.choice();
    document.title = name ? `${name} (${profile}), Modalbench report` : 'Modalbench report';
    void draw();
  });
  drawAgainWhereTheLookChanges(draw);
  // After the first paint: compiling the plots takes longer than everything above.
  requestAnimationFrame(() => setTimeout(() => void draw(), 0));
}

start();
