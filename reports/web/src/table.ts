// A table that sorts by its headings and filters by words. Sorting compares full-precision values, failed runs last.
import { announce, make } from './dom';
import { download, toCsv, toJson, toLatex } from './download';
import type { Cell, Column, Table } from './report';
import type { State } from './state';

// Shown marks: never colour alone.
const marks: Record<string, [symbol: string, className: string]> = {
  yes: ['✔', 'good'],
  no: ['✘', 'bad'],
  holds: ['✔', 'good'],
  'does not hold': ['✘', 'bad'],
  'holds within stated limits': ['◐', 'warn'],
  faster: ['✔', 'good'],
  slower: ['✘', 'bad'],
  'within noise': ['≈', 'faint'],
  open: ['≈', 'faint'],
  'not decided': ['≈', 'faint'],
};
// Cells of the matrix begin with their symbol.
const moods: Record<string, string> = {
  '✔': 'good',
  '▲': 'warn',
  '⚡': 'bad',
  '✘': 'bad',
  '–': 'faint',
  '?': 'faint',
};

const faint = new Set(['none reached', 'undefined', 'not measured here', 'n/a', 'none']);

function compare(a: Cell, b: Cell): number {
  const x = a[1],
    y = b[1];
  if (x != null && y != null) return x - y;
  if (x != null) return -1;
  if (y != null) return 1;
  return a[0] < b[0] ? -1 : a[0] > b[0] ? 1 : 0;
}

function body(column: Column, cell: Cell): HTMLTableCellElement {
  const [text] = cell;
  const failed = text.startsWith('failed') || text === 'not measured' || text.startsWith('not decidable');
  const element = make('td', {
    class: [column.kind, failed && 'bad', faint.has(text) && 'faint', text.length > 42 && 'long']
      .filter(Boolean)
      .join(' '),
    'data-value': cell[1] == null ? undefined : String(cell[1]),
  });
  if (/^[✔▲⚡✘–?] /.test(text)) element.classList.add(moods[text[0]]);
  const mark = marks[text] ?? (text.startsWith('does not hold') ? marks['does not hold'] : undefined);
  if (mark) {
    element.classList.add(mark[1]);
    element.append(make('span', { 'aria-hidden': 'true' }, mark[0]), ` ${text}`);
  } else {
    element.textContent = failed ? `⚠ ${text}` : text;
  }
  return element;
}

export interface TableOptions {
  state?: State;
  choose?: (row: Cell[]) => boolean;
  hide?: string[];
  filter?: boolean;
  link?: { column: string; follow: (text: string) => void };
}

export class TableView {
  readonly element: HTMLElement;
  private head = make('thead');
  private rows = make('tbody');
  private count = make('p', { class: 'count' });
  private input = make('input', {
    type: 'search',
    placeholder: 'filter, e.g. static 32',
    'aria-label': 'Filter rows by words',
  });
  private sort = { column: '', descending: false };

  constructor(
    private table: Table,
    private options: TableOptions = {},
  ) {
    const grid = make('table', {}, make('caption', { class: 'unseen' }, table.title), this.head, this.rows);
    const tools = make(
      'div',
      { class: 'tools' },
      ...(options.filter ? [this.input] : []),
      this.button('CSV', () => download(`${table.name}.csv`, 'text/csv', toCsv(this.columns(), this.visible()))),
      this.button('JSON', () =>
        download(`${table.name}.json`, 'application/json', toJson(this.columns(), this.visible())),
      ),
      this.button('LaTeX', () => {
        const shown = this.shown(this.chosen());
        const pick = <T>(list: T[]): T[] => shown.map((j) => list[j]);
        const caption = [table.title, table.note].filter(Boolean).join('. ');
        download(
          `${table.name}.tex`,
          'application/x-tex',
          toLatex(caption, pick(this.columns()), this.visible().map(pick)),
        );
      }),
      this.count,
    );
    const scroller = make('div', { class: 'scroller', tabindex: '0', role: 'region', 'aria-label': table.title }, grid);
    this.element = make('div', { class: 'table' }, tools, scroller);
    if (table.note) this.element.append(make('p', { class: 'note' }, table.note));
    this.input.addEventListener('input', () => {
      if (this.options.state) this.options.state.set({ filter: this.input.value });
      else this.draw();
    });
    this.draw();
  }

  private button(text: string, action: () => void): HTMLButtonElement {
    const button = make(
      'button',
      { type: 'button', 'data-format': text.toLowerCase(), 'aria-label': `Download ${this.table.title} as ${text}` },
      text,
    );
    button.addEventListener('click', action);
    return button;
  }

  private linked(j: number, cell: Cell): HTMLTableCellElement | null {
    const { link } = this.options;
    if (!link || this.table.columns[j].name !== link.column || !cell[0]) return null;
    const button = make('button', { type: 'button', class: 'link' }, cell[0]);
    button.addEventListener('click', () => link.follow(cell[0]));
    return make('td', {}, button);
  }

  private columns(): Column[] {
    return this.table.columns;
  }

  // Columns that say something: not hidden, not empty in every row that may be shown; `r used` only where it differs.
  private shown(rows: Cell[][]): number[] {
    const { columns } = this.table,
      asked = columns.findIndex((column) => column.name === 'r');
    return columns
      .map((_, j) => j)
      .filter(
        (j) =>
          !this.options.hide?.includes(columns[j].name) &&
          rows.some((row) => row[j][0] !== '' && !(columns[j].name === 'r used' && row[j][0] === row[asked][0])),
      );
  }

  private chosen(): Cell[][] {
    return this.table.rows.filter((row) => this.options.choose?.(row) ?? true);
  }

  private visible(): Cell[][] {
    const words = this.options.filter ? this.input.value.toLowerCase().split(/\s+/).filter(Boolean) : [];
    const rows = this.chosen().filter((row) => {
      const text = row
        .map((cell) => cell[0])
        .join(' ')
        .toLowerCase();
      return words.every((word) => text.includes(word));
    });
    const j = this.table.columns.findIndex((column) => column.name === this.sort.column);
    if (j < 0) return rows;
    const sign = this.sort.descending ? -1 : 1;
    const numbers = rows.filter((row) => row[j][1] != null),
      others = rows.filter((row) => row[j][1] == null);
    const ordered = (list: Cell[][]) => list.slice().sort((a, b) => sign * compare(a[j], b[j]));
    return [...ordered(numbers), ...ordered(others)];
  }

  private heading(j: number): HTMLTableCellElement {
    const column = this.table.columns[j];
    const active = this.sort.column === column.name;
    const button = make(
      'button',
      { type: 'button' },
      column.name,
      ...(column.unit ? [' ', make('span', { class: 'unit' }, `[${column.unit}]`)] : []),
      make('span', { class: 'arrow', 'aria-hidden': 'true' }, active ? (this.sort.descending ? '▼' : '▲') : ''),
    );
    button.addEventListener('click', () => {
      const next = !active ? column.name : this.sort.descending ? '' : `-${column.name}`;
      this.setSort(next);
      announce(next ? `sorted by ${column.name}, ${next[0] === '-' ? 'descending' : 'ascending'}` : 'original order');
      (this.head.querySelectorAll('button')[this.shown(this.chosen()).indexOf(j)] as HTMLElement | undefined)?.focus();
    });
    return make(
      'th',
      {
        scope: 'col',
        class: column.kind,
        'aria-sort': active ? (this.sort.descending ? 'descending' : 'ascending') : 'none',
      },
      button,
    );
  }

  private setSort(sort: string): void {
    this.sort = { column: sort.replace(/^-/, ''), descending: sort.startsWith('-') };
    if (this.options.state) this.options.state.set({ sort });
    else this.draw();
  }

  draw(): void {
    if (this.options.state) {
      const { state } = this.options;
      const sort = state.get('sort');
      this.sort = { column: sort.replace(/^-/, ''), descending: sort.startsWith('-') };
      if (this.input.value !== state.get('filter')) this.input.value = state.get('filter');
    }
    const shown = this.shown(this.chosen()),
      rows = this.visible();
    this.head.replaceChildren(make('tr', {}, ...shown.map((j) => this.heading(j))));
    this.rows.replaceChildren(
      ...rows.map((row) => {
        return make('tr', {}, ...shown.map((j) => this.linked(j, row[j]) ?? body(this.table.columns[j], row[j])));
      }),
    );
    this.count.textContent = `${rows.length} of ${this.chosen().length} rows`;
  }
}
