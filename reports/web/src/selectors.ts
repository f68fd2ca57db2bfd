// Case, norm and truth: one choice for both plots and the table.
import { byId, make } from './dom';
import type { Report } from './report';
import type { State } from './state';

export interface Choice {
  case: string;
  profile: string;
  quantity: number;
  truth: number;
}

const groupName = (name: string, profile: string): string => `${name} (${profile})`;

type Key = 'case' | 'norm' | 'truth';

export class Selectors {
  private groups: { case: string; profile: string; name: string; quantities: Set<number>; truths: Set<number> }[] = [];
  private menus: Record<Key, HTMLSelectElement>;
  private opening = '';

  constructor(
    private report: Report,
    private state: State,
  ) {
    const { runs, measures } = report.plots;
    const byName = new Map<string, (typeof this.groups)[number]>();
    for (const [run, quantity, truth] of measures) {
      const of = runs[run],
        name = groupName(of.case, of.profile);
      let group = byName.get(name);
      if (!group) {
        group = { case: of.case, profile: of.profile, name, quantities: new Set(), truths: new Set() };
        byName.set(name, group);
      }
      group.quantities.add(quantity);
      group.truths.add(truth);
    }
    this.groups = [...byName.values()];
    this.menus = {
      case: this.menu('case', 'Case'),
      norm: this.menu('norm', 'Norm'),
      truth: this.menu('truth', 'Truth'),
    };
    this.fill('case', this.groups.map((group) => [group.name, group.name]));
    const { opening } = report.verdict;
    if (opening) this.opening = groupName(opening.case, opening.profile);
    byId('selectors').addEventListener('submit', (event) => event.preventDefault());
    this.follow();
  }

  private menu(key: Key, label: string): HTMLSelectElement {
    const select = make('select', { id: `select-${key}` });
    select.addEventListener('change', () => this.state.set({ [key]: select.value }));
    byId('selectors').append(make('label', { for: select.id }, label), select);
    return select;
  }

  private fill(key: Key, options: string[][]): void {
    const select = this.menus[key];
    const same = [...select.options].map((option) => option.value).join('\n') === options.map(([v]) => v).join('\n');
    if (!same) select.replaceChildren(...options.map(([value, text]) => make('option', { value }, text)));
  }

  private group(): (typeof this.groups)[number] | undefined {
    return this.groups[Math.max(0, this.menus.case.selectedIndex)];
  }

  private nameOf(quantity: number): string {
    const one = this.report.plots.quantities[quantity];
    return one.subject ? `${one.metric}:${one.subject}` : one.metric;
  }

  // What the hash names and the case does not offer: the same metric of another body, else the first choice: of cases
  // the one on which the page opens.
  private choose(key: Key): void {
    const select = this.menus[key],
      wanted = this.state.get(key),
      values = [...select.options].map((option) => option.value);
    const [metric] = wanted.split(':');
    const alike = values.find((value) => value === wanted) ?? values.find((value) => value.split(':')[0] === metric);
    const first = key === 'case' && values.includes(this.opening) ? this.opening : values[0];
    if (values.length) select.value = alike ?? first;
  }

  follow(): void {
    const { quantities, truths } = this.report.plots;
    this.choose('case');
    const group = this.group();
    const offered = quantities.map((_, i) => i).filter((i) => group?.quantities.has(i));
    this.fill('norm', offered.map((i) => [this.nameOf(i), quantities[i].title]));
    this.fill('truth', truths.filter((_, i) => group?.truths.has(i)).map((truth) => [truth, truth]));
    this.choose('norm');
    this.choose('truth');
  }

  choice(): Choice {
    const group = this.group();
    const { quantities, truths } = this.report.plots;
    return {
      case: group?.case ?? '',
      profile: group?.profile ?? '',
      quantity: Math.max(0, quantities.findIndex((_, i) => this.nameOf(i) === this.menus.norm.value)),
      truth: Math.max(0, truths.indexOf(this.menus.truth.value)),
    };
  }

  metric(): string {
    return this.report.plots.quantities[this.choice().quantity]?.metric ?? '';
  }

  truthName(): string {
    return this.report.plots.truths[this.choice().truth] ?? '';
  }
}
