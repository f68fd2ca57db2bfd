// Files made in the page. Spreadsheets run cells that begin with = + - @, behind blanks and in wide forms, too: such
// texts get a leading apostrophe, as by csv.cc.
import { announce, make } from './dom';
import type { Cell, Column } from './report';

export function download(name: string, type: string, text: string): void {
  const url = URL.createObjectURL(new Blob([text], { type }));
  const link = make('a', { href: url, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
  announce(`${name} was saved`);
}

const formula = /^[ \u00a0\u1680\u2000-\u200a\u202f\u205f\u3000]*[=+\-@\t\r\n\uff1d\uff0b\uff0d\uff20]/;
function csvText(text: string): string {
  const prints = text.replace(/[\x00-\x08\x0b\x0c\x0e-\x1f\x7f]/g, ' ');
  const safe = formula.test(prints) ? `'${prints}` : prints;
  return /[",;\t\r\n]/.test(safe) ? `"${safe.replace(/"/g, '""')}"` : safe;
}

const label = (column: Column): string => (column.unit ? `${column.name} [${column.unit}]` : column.name);
const hasBar = (column: Column): boolean => column.kind === 'error' || column.kind === 'time';

export function toCsv(columns: Column[], rows: Cell[][]): string {
  const head = columns.flatMap((column) =>
    hasBar(column) ? [label(column), `${column.name} bar`, `${column.name} status`] : [label(column)],
  );
  const lines = rows.map((row) =>
    columns
      .flatMap((column, j) => {
        const [text, value, bar, status] = row[j];
        if (hasBar(column))
          return [value == null ? '' : String(value), bar == null ? '' : String(bar), csvText(status ?? '')];
        return [value == null ? csvText(text) : String(value)];
      })
      .join(','),
  );
  return [head.map(csvText).join(','), ...lines].join('\n') + '\n';
}

export function toJson(columns: Column[], rows: Cell[][]): string {
  const objects = rows.map((row) =>
    Object.fromEntries(
      columns.map((column, j) => {
        const [text, value, bar, status] = row[j];
        return [
          label(column),
          hasBar(column) ? { value: value ?? null, bar: bar ?? null, status: status ?? '' } : (value ?? text),
        ];
      }),
    ),
  );
  return JSON.stringify(objects, null, 1) + '\n';
}

const inTex: Record<string, string> = {
  '\\': '\\textbackslash{}',
  '~': '\\textasciitilde{}',
  '^': '\\textasciicircum{}',
  '<': '\\textless{}',
  '>': '\\textgreater{}',
  '|': '\\textbar{}',
  '"': '\\textquotedbl{}',
  '`': '\\textasciigrave{}',
  '[': '{[}',
  ']': '{]}',
  '*': '{*}',
  '<=': '$\\le$',
  '>=': '$\\ge$',
  '±': '$\\pm$',
  '✔': '$\\surd$',
  '▲': '$\\triangle$',
  '⚡': '$\\uparrow$',
  '✘': '$\\times$',
  '–': '--',
};

// As latex.cc writes it: what stands in a cell prints as itself.
function texText(text: string): string {
  return text.replace(/<=|>=|[\\~^<>|"`[\]*±✔▲⚡✘–]|[{}$&#_%]|[\x00-\x1f\x7f]/g, (c) =>
    c < ' ' || c === '\x7f' ? ' ' : (inTex[c] ?? `\\${c}`),
  );
}

export function toLatex(caption: string, columns: Column[], rows: Cell[][]): string {
  const line = (cells: string[]): string => `${cells.map((cell) => texText(cell) || '{}').join(' & ')} \\\\\n`;
  return (
    '% \\usepackage[T1]{fontenc} \\usepackage{booktabs,longtable,textcomp}\n' +
    `\\begin{longtable}{${columns.map((column) => (column.kind === 'text' ? 'l' : 'r')).join('')}}\n` +
    `\\caption{${texText(caption)}}\\\\\n\\toprule\n${line(columns.map(label))}` +
    '\\midrule\\endhead\n\\bottomrule\\endfoot\n' +
    rows.map((row) => line(row.map((cell) => cell[0]))).join('') +
    '\\end{longtable}\n'
  );
}
