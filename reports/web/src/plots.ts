// Draws the specifications that the C++ side wrote, on the data of the choice. Expressions are interpreted, never
// compiled: the content security policy allows no eval.
import { expressionInterpreter } from 'vega-interpreter';
import { parse, View } from 'vega';
import type { Spec } from 'vega';
import { compile } from 'vega-lite';
import type { TopLevelSpec } from 'vega-lite';
import { byId, make } from './dom';
import { download } from './download';
import type { Figure, Kind, Report, Run } from './report';
import type { Choice } from './selectors';

interface Datum extends Run {
  value: number;
  bar: number;
}
const views = new Map<HTMLElement, View>();

function select(report: Report, choice: Choice): { data: Datum[]; failed: number } {
  const data: Datum[] = [];
  let failed = 0;
  for (const [run, quantity, truth, value, bar] of report.plots.measures) {
    const of = report.plots.runs[run];
    if (of.case !== choice.case || of.profile !== choice.profile) continue;
    if (quantity !== choice.quantity || truth !== choice.truth) continue;
    if (value === null) failed += 1;
    else data.push({ ...of, value, bar });
  }
  return { data, failed };
}

function colours(): object {
  const style = getComputedStyle(document.documentElement);
  const ink = style.getPropertyValue('--ink').trim(),
    faint = style.getPropertyValue('--rule').trim();
  const axis = {
    labelColor: ink,
    titleColor: ink,
    gridColor: faint,
    domainColor: ink,
    tickColor: faint,
    titleFontWeight: 500,
    labelFontSize: 11,
    titleFontSize: 12,
    titlePadding: 8,
  };
  return { background: 'transparent', axis, legend: { labelColor: ink, labelFontSize: 12 }, view: { stroke: null } };
}

// Lines of a tooltip arrive as an object of texts.
function tip(_: unknown, event: MouseEvent, _item: unknown, value: unknown): void {
  const box = byId('tip');
  box.hidden = value === null || value === undefined || typeof value !== 'object';
  if (box.hidden) return;
  box.replaceChildren(
    make(
      'dl',
      {},
      ...Object.entries(value as Record<string, unknown>).flatMap(([name, text]) => [
        make('dt', {}, name),
        make('dd', {}, String(text)),
      ]),
    ),
  );
  const right = event.clientX + 16 + box.offsetWidth > innerWidth;
  box.style.left = `${Math.max(4, right ? event.clientX - box.offsetWidth - 16 : event.clientX + 16) + scrollX}px`;
  box.style.top = `${event.clientY + 16 + scrollY}px`;
}

interface Fitting {
  quantity?: { title: string; unit: string }; // of the placeholders
  series?: Set<string>; // that occur: legends name no other
  labels?: Record<string, string>;
  columns: number; // of legends
}

// A specification made to fit its place and its data.
function fitted(specification: object, fit: Fitting): Record<string, unknown> {
  const { quantity, series, labels } = fit;
  return JSON.parse(JSON.stringify(specification), (_, value) => {
    if (typeof value === 'string' && quantity)
      return value.replace('@QUANTITY@', quantity.title).replace('@UNIT@', quantity.unit);
    if (Array.isArray(value) && quantity && quantity.unit !== '-') return value.filter((one) => one?.name !== 'target');
    if (value && typeof value === 'object' && series && Array.isArray(value.domain) && Array.isArray(value.range)) {
      const kept = value.domain.map((name: string, i: number) => [name, value.range[i]]);
      const present = kept.filter(([name]: [string]) => series.has(name));
      const [domain, range] = [0, 1].map((i) => present.map((pair: string[]) => pair[i]));
      return { ...value, domain, range };
    }
    if (value && typeof value === 'object' && 'labelLimit' in value && 'symbolSize' in value) {
      const texts = labels && Object.keys(labels).length;
      const expression = texts ? { labelExpr: `(${JSON.stringify(labels)})[datum.label] || datum.label` } : {};
      return { ...value, columns: fit.columns, ...expression };
    }
    return value;
  });
}

function saveButtons(name: string, specification: object, data: object[], view: View): HTMLElement {
  const save = make(
    'button',
    { type: 'button', 'data-format': 'svg', 'aria-label': `Download the plot ${name} as SVG` },
    'SVG',
  );
  save.addEventListener('click', async () => download(`${name}.svg`, 'image/svg+xml', await view.toSVG()));
  const source = make(
    'button',
    { type: 'button', 'data-format': 'vl', 'aria-label': `Download the Vega-Lite source of ${name}` },
    'Vega-Lite',
  );
  const text = (): string => JSON.stringify({ ...specification, data: { name: 'rows', values: data } });
  source.addEventListener('click', () => download(`${name}.vl.json`, 'application/json', text()));
  return make('p', { class: 'tools' }, save, source);
}

async function draw(
  host: HTMLElement,
  name: string,
  specification: object,
  data: object[],
  fit: Omit<Fitting, 'columns'> = {},
): Promise<void> {
  views.get(host)?.finalize();
  views.delete(host);
  if (data.length === 0) {
    host.replaceChildren(make('p', { class: 'empty' }, 'Nothing to draw: no contender has this number.'));
    return;
  }
  const width = Math.max(220, host.clientWidth - 76);
  const columns = width < 380 ? 1 : width < 560 ? 2 : 3;
  const filled = fitted(specification, { ...fit, columns: fit.labels ? Math.min(2, columns) : columns });
  const { title, ...rest } = filled; // headings stand beside the figure
  const bars = typeof filled.height === 'object'; // whose height follows from their number, labels of any length
  const spec = {
    ...rest,
    width: bars ? Math.max(320, host.clientWidth) : width,
    height: bars ? filled.height : Math.round(Math.min(380, Math.max(260, width * 0.72))),
    data: { name: 'rows', values: data },
    config: { ...(filled.config as object), ...colours() },
  } as TopLevelSpec;
  const drawing = make('div');
  host.replaceChildren(drawing);
  const compiled = compile(spec).spec as Spec;
  // Labels take of the width what they need. Vega-Lite itself warns of this beside a height in steps.
  if (bars) compiled.autosize = { type: 'fit-x', contains: 'padding' };
  const view = new View(parse(compiled, undefined, { ast: true }), {
    expr: expressionInterpreter,
    renderer: 'svg',
    container: drawing,
    hover: true,
    tooltip: tip as never,
  });
  views.set(host, view);
  await view.runAsync();
  host.append(saveButtons(name, { ...filled, title }, data, view));
}

export async function drawFigure(host: HTMLElement, figure: Figure, name = figure.name): Promise<void> {
  const data = figure.rows.map((row) =>
    Object.fromEntries(figure.fields.map((field, j) => [field, row[j]]).filter(([, value]) => value !== null)),
  );
  await draw(host, name, figure.specification, data);
}

// Frees what a host that leaves the document drew.
export function forget(host: HTMLElement): void {
  views.get(host)?.finalize();
  views.delete(host);
}

const wanted: Record<Kind, (datum: Datum) => boolean> = {
  work: (datum) => (datum.time ?? 0) > 0,
  modes: (datum) => datum.against_modes && datum.r_used !== undefined,
  steps: (datum) => datum.against_step && datum.time_step !== undefined,
};

export async function drawPlots(report: Report, choice: Choice): Promise<void> {
  const { plots } = report;
  const quantity = plots.quantities[choice.quantity];
  const { data, failed } = select(report, choice);
  const lost = failed ? ` ${failed} ${failed === 1 ? 'contender' : 'contenders'} without a number not drawn.` : '';
  byId('work-note').textContent =
    `Grey steps: the least error for a given time. Hollow marks lie below the truth\u2019s error bar ` +
    `(grey band).${lost}`;
  byId('modes-note').textContent =
    'Reduced methods, each integrator at its smallest step; whiskers show the truth\u2019s error bar.';
  byId('steps-note').textContent =
    'Reduced methods at their largest r, full order on the mesh with most unknowns of each degree. Legends give ' +
    'fitted orders where there are any.';
  for (const kind of ['work', 'modes', 'steps'] as const) {
    const shown = data.filter(wanted[kind]);
    const found = plots.labels.find(
      ([run, q, t, of]) =>
        of === kind &&
        q === choice.quantity &&
        t === choice.truth &&
        plots.runs[run].case === choice.case &&
        plots.runs[run].profile === choice.profile,
    );
    const series = new Set(shown.map((datum) => datum.series));
    await draw(byId(kind), kind, plots.specifications[kind], shown, { quantity, series, labels: found?.[4] });
  }
}
