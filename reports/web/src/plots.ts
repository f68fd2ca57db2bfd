// Draws the specifications that the C++ side wrote, on the data of the choice. Expressions are interpreted, never
// compiled: the content security policy allows no eval.
import { expressionInterpreter } from 'vega-interpreter';
import { parse, View } from 'vega';
import type { Spec } from 'vega';
import { compile } from 'vega-lite';
import type { TopLevelSpec } from 'vega-lite';
import { byId, make } from './dom';
import { download } from './download';
import type { Report, Run } from './report';
import type { Choice } from './selectors';

interface Datum extends Run {
  value: number;
  bar: number;
}
const views = new Map<string, View>();

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

async function draw(id: 'work' | 'modes', specification: object, data: Datum[]): Promise<void> {
  const host = byId(id);
  views.get(id)?.finalize();
  if (data.length === 0) {
    views.delete(id);
    host.replaceChildren(make('p', { class: 'empty' }, 'Nothing to draw: no contender has this number.'));
    return;
  }
  const width = Math.max(220, host.clientWidth - 76);
  const columns = width < 380 ? 1 : width < 560 ? 2 : 3;
  const narrow = JSON.parse(JSON.stringify(specification), (key, value) => (key === 'columns' ? columns : value));
  const spec = {
    ...narrow,
    width,
    height: Math.round(Math.min(380, Math.max(260, width * 0.72))),
    data: { name: 'rows', values: data },
    config: { ...narrow.config, ...colours() },
  } as TopLevelSpec;
  const compiled = compile(spec).spec as Spec;
  const drawing = make('div');
  host.replaceChildren(drawing);
  const view = new View(parse(compiled, undefined, { ast: true }), {
    expr: expressionInterpreter,
    renderer: 'svg',
    container: drawing,
    hover: true,
    tooltip: tip as never,
  });
  views.set(id, view);
  await view.runAsync();
  const save = make(
    'button',
    { type: 'button', 'data-format': 'svg', 'aria-label': `Download the plot ${id} as SVG` },
    'SVG',
  );
  save.addEventListener('click', async () => download(`${id}.svg`, 'image/svg+xml', await view.toSVG()));
  const source = make(
    'button',
    { type: 'button', 'data-format': 'vl', 'aria-label': `Download the Vega-Lite source of ${id}` },
    'Vega-Lite',
  );
  source.addEventListener('click', () =>
    download(
      `${id}.vl.json`,
      'application/json',
      JSON.stringify({ ...specification, data: { name: 'rows', values: data } }),
    ),
  );
  host.append(make('p', { class: 'tools' }, save, source));
}

export async function drawPlots(report: Report, choice: Choice): Promise<void> {
  const quantity = report.plots.quantities[choice.quantity];
  const { data, failed } = select(report, choice);
  const lost = failed ? ` ${failed} failed ${failed === 1 ? 'contender is' : 'contenders are'} not drawn.` : '';
  byId('work-note').textContent =
    `Grey steps: the least error for a given time. Hollow marks lie below the truth\u2019s error bar ` +
    `(grey band).${lost}`;
  byId('modes-note').textContent = 'Reduced methods only; whiskers show the truth\u2019s error bar.';
  await Promise.all([
    draw(
      'work',
      quantity?.work ?? {},
      data.filter((datum) => (datum.time ?? 0) > 0),
    ),
    draw(
      'modes',
      quantity?.modes ?? {},
      data.filter((datum) => datum.reduced),
    ),
  ]);
}
