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

export class Selectors {
  private groups: { case: string; profile: string; name: string }[] = [];
  private menus: Record<'case' | 'norm' | 'truth', HTMLSelectElement>;

  constructor(
    private report: Report,
    private state: State,
  ) {
    for (const run of report.plots.runs) {
      const name = groupName(run.case, run.profile);
      if (!this.groups.some((group) => group.name === name))
        this.groups.push({ case: run.case, profile: run.profile, name });
    }
    const norms = report.plots.quantities.map((one) => [
      one.subject ? `${one.metric}:${one.subject}` : one.metric,
      one.title,
    ]);
    this.menus = {
      case: this.menu(
        'case',
        'Case',
        this.groups.map((group) => [group.name, group.name]),
      ),
      norm: this.menu('norm', 'Norm', norms),
      truth: this.menu(
        'truth',
        'Truth',
        report.plots.truths.map((truth) => [truth, truth]),
      ),
    };
    byId('selectors').addEventListener('submit', (event) => event.preventDefault());
    this.follow();
  }

  private menu(key: 'case' | 'norm' | 'truth', label: string, options: string[][]): HTMLSelectElement {
    const select = make(
      'select',
      { id: `select-${key}` },
      ...options.map(([value, text]) => make('option', { value }, text)),
    );
    select.addEventListener('change', () => this.state.set({ [key]: select.value }));
    byId('selectors').append(make('label', { for: select.id }, label), select);
    return select;
  }

  // The hash may come from anywhere: what it names and is not on offer leaves the first choice.
  follow(): void {
    for (const key of ['case', 'norm', 'truth'] as const) {
      const wanted = this.state.get(key),
        select = this.menus[key];
      const known = [...select.options].some((option) => option.value === wanted);
      if (select.options.length) select.value = known ? wanted : select.options[0].value;
    }
  }

  choice(): Choice {
    const group = this.groups[Math.max(0, this.menus.case.selectedIndex)];
    return {
      case: group?.case ?? '',
      profile: group?.profile ?? '',
      quantity: Math.max(0, this.menus.norm.selectedIndex),
      truth: Math.max(0, this.menus.truth.selectedIndex),
    };
  }

  truthName(): string {
    return this.report.plots.truths[this.choice().truth] ?? '';
  }
}
