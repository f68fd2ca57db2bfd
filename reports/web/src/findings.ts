// What analyses found: one section an analysis, of which the chosen case is shown, figures before tables.
import { byId, make } from './dom';
import { drawFigure, forget } from './plots';
import type { Figure, FindingGroup } from './report';
import type { Choice } from './selectors';
import { TableView } from './table';

export class Findings {
  private sections: { group: FindingGroup; section: HTMLElement; body: HTMLElement }[] = [];
  private shown = '';

  constructor(groups: FindingGroup[]) {
    for (const group of groups) {
      const id = `finding-${group.analysis}`,
        body = make('div');
      const section = make(
        'section',
        { id, 'aria-labelledby': `${id}-title` },
        make('h2', { id: `${id}-title` }, group.heading),
        body,
      );
      byId(group.before_speed_up ? 'findings-before' : 'findings-after').append(section);
      this.sections.push({ group, section, body });
    }
  }

  async draw(choice: Choice, force: boolean): Promise<void> {
    const wanted = `${choice.case}\n${choice.profile}`;
    if (wanted === this.shown && !force) return;
    this.shown = wanted;
    for (const { group, section, body } of this.sections) {
      body.querySelectorAll<HTMLElement>('.plot').forEach(forget);
      body.replaceChildren();
      const own = group.tables.filter((one) => one.case === choice.case && one.profile === choice.profile);
      section.hidden = own.length === 0;
      const hosts: [HTMLElement, Figure, string][] = [];
      for (const { table, figures } of own) {
        const pair = make('div', { class: 'pair' }),
          article = make('div', { class: 'finding' }, make('h3', {}, table.title));
        for (const figure of figures) {
          const host = make('div', { class: 'plot bars' }),
            words = String(figure.specification.description ?? '');
          pair.append(make('figure', {}, make('figcaption', {}, make('p', {}, words)), host));
          hosts.push([host, figure, `${table.name}-${figure.name}`]);
        }
        if (figures.length) article.append(pair);
        article.append(new TableView(table).element);
        body.append(article);
      }
      for (const [host, figure, name] of hosts) {
        if (this.shown !== wanted) return; // another case was chosen meanwhile
        await drawFigure(host, figure, name); // once all have their places, hence their widths
      }
    }
  }
}
