// The parts of the page that are text: contents, cases, definitions, environment.
import { byId, make } from './dom';
import type { Report } from './report';

// Sections by name, those that the case shown has. Buttons, as the hash keeps what the reader chose.
export function drawContents(): void {
  const sections = [...document.querySelectorAll<HTMLElement>('main section')].filter((one) => one.id !== 'verdict');
  const buttons = sections.map((section) => {
    const button = make('button', { type: 'button', class: 'link' }, section.querySelector('h2')?.textContent ?? '');
    button.addEventListener('click', () => section.scrollIntoView());
    const item = make('li', {}, button);
    const follow = (): void => {
      item.hidden = section.hidden;
    };
    follow();
    new MutationObserver(follow).observe(section, { attributes: true, attributeFilter: ['hidden'] });
    return item;
  });
  byId('contents').append(make('ul', {}, ...buttons));
}

export function drawCases(report: Report): void {
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
        make('p', {}, one.line),
        make('p', {}, [one.purpose, ...one.truth].join(' ')),
        ...(one.source ? [make('p', { class: 'note' }, `Source: ${one.source}`)] : []),
      ),
    );
  }
}

export function drawDefinitions(report: Report): void {
  byId('definitions').append(
    make(
      'dl',
      { class: 'definitions' },
      ...report.definitions.flatMap(([term, text]) => [make('dt', {}, term), make('dd', {}, text)]),
    ),
  );
}

export function drawCommands(report: Report): void {
  byId('environment').append(
    make('h3', {}, 'To reproduce'),
    make('pre', { tabindex: '0' }, report.commands.join('\n')),
  );
}
