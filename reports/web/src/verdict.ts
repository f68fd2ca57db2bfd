// The strip at the top: four tiles and the sentences they shorten.
import { byId, make } from './dom';
import { download } from './download';
import { environmentOf } from './report';
import type { Report } from './report';
import { TableView } from './table';

type Mood = 'good' | 'bad' | 'warn' | 'plain';
const symbols: Record<Mood, string> = { good: '✔', bad: '✘', warn: '⚠', plain: '' };

function tile(value: string, name: string, detail: string, mood: Mood): HTMLElement {
  const number = make(
    'p',
    { class: 'value' },
    ...(symbols[mood] ? [make('span', { 'aria-hidden': 'true' }, symbols[mood])] : []),
    value,
  );
  return make(
    'div',
    { class: `tile ${mood}` },
    make('p', { class: 'name' }, name),
    number,
    make('p', { class: 'detail' }, detail),
  );
}

const mostNamed = 8; // cases, in a tile

function tiles(report: Report): HTMLElement {
  const v = report.verdict;
  const names = [...new Set(report.cases.map((one) => one.name))];
  const profiles = [...new Set(report.cases.map((one) => one.profile))];
  const missing = [
    v.not_decidable ? `${v.not_decidable} not decidable` : '',
    v.not_measured ? `${v.not_measured} not measured` : '',
  ];
  const checks: Mood =
    v.checks === 0 ? 'plain' : v.hold === v.checks ? 'good' : v.hold + v.not_decidable === v.checks ? 'warn' : 'bad';
  const contenders = report.plots.runs.length;
  return make(
    'div',
    { class: 'tiles' },
    tile(
      `${v.cases_within} / ${v.cases}`,
      'cases within all checks',
      [`${v.hold} of ${v.checks} checks hold`, ...missing].filter(Boolean).join(', '),
      checks,
    ),
    tile(
      v.median ? `${v.median}×` : contenders && !v.timed ? 'not timed' : 'none reached',
      'speed-up at 1 % error',
      v.at_target
        ? `median over ${v.compared} of ${v.at_target} ${v.at_target === 1 ? 'case' : 'cases'}; ` +
          'both runs within 1 % displacement error'
        : !contenders
          ? 'nothing was run'
          : v.timed
            ? 'no reduced run is within 1 % with its error bar'
            : 'modalbench run without --untimed takes times',
      'plain',
    ),
    tile(
      String(v.failed_runs),
      'failed runs',
      `of ${contenders} contenders` + (v.unstable_runs ? `; ${v.unstable_runs} unstable` : ''),
      v.failed_runs ? 'bad' : contenders ? 'good' : 'plain',
    ),
    tile(
      profiles.join(', ') || 'unknown',
      profiles.length > 1 ? 'profiles' : 'profile',
      names.length > mostNamed ? `${names.length} cases` : names.join(', '),
      'plain',
    ),
  );
}

export function drawVerdict(report: Report): void {
  const section = byId('verdict');
  section.append(
    tiles(report),
    make('ul', { class: 'sentences' }, ...report.verdict.sentences.map((one) => make('li', {}, one))),
  );
  const pairs = report.tables['speed-up-at-target'];
  if (pairs.rows.length) section.append(make('h3', {}, pairs.title), new TableView(pairs).element);
  const all = make('button', { type: 'button', id: 'download-all' }, 'Everything as JSON');
  all.addEventListener('click', () => download('modalbench-report.json', 'application/json', JSON.stringify(report)));
  const print = make('button', { type: 'button', id: 'print' }, 'Print');
  print.addEventListener('click', () => window.print());
  section.append(make('p', { class: 'tools' }, all, print));
  const stamp = ['date', 'commit', 'processor'].map((what) => environmentOf(report, what)).filter(Boolean);
  byId('stamp').textContent = stamp.join(' · ');
}
