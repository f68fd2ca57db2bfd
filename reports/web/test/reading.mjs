// What stands on the page once it is open.
import assert from 'node:assert/strict';
import { statSync } from 'node:fs';
import { join } from 'node:path';
import { textOf } from './fixture.mjs';

async function opens({ page, url, report, isReady }) {
  await page.goto(url);
  await isReady();
  assert.ok(statSync(report).size < 8e6);
  const paint = await page.evaluate(() => performance.getEntriesByName('first-contentful-paint')[0]?.startTime);
  console.log(`     first contentful paint ${Math.round(paint)} ms`);
  assert.ok(paint < 1000, `first paint after ${paint} ms`);
}

async function showsTheVerdict({ page }) {
  assert.equal(await page.locator('.tile').count(), 4);
  assert.ok((await page.locator('.sentences li').count()) >= 3);
}

async function listsThePairsOfTheHeadline({ page, data }) {
  const { tables, verdict } = await data();
  const rows = page.locator('#verdict tbody tr');
  const ofTheHeadline = rows.filter({ has: page.getByRole('cell', { name: '1 %', exact: true }) });
  assert.equal(await rows.count(), tables['speed-up-at-target'].rows.length);
  assert.equal(await ofTheHeadline.count(), verdict.at_target);
}

async function drawsBothPlots({ page, marks }) {
  assert.ok((await marks('work')) > 10, 'work against precision has marks');
  assert.ok((await marks('modes')) > 4, 'error against modes has marks');
  for (const id of ['work', 'modes']) {
    assert.ok((await page.locator(`#${id} svg .role-legend-label text`).count()) > 1, `${id} has a legend`);
  }
  const unseen = await page.$$eval(
    '.plot svg .mark-symbol path',
    (paths) =>
      paths.filter(
        (path) => (path.getAttribute('stroke') ?? 'none') === 'none' && path.getAttribute('fill-opacity') === '0',
      ).length,
  );
  assert.equal(unseen, 0, 'hollow marks have an outline');
}

async function drawsStepsAndFindings({ page, data, choice, marks, areDrawn }) {
  await areDrawn();
  assert.ok((await marks('steps')) > 4, 'error against step has marks');
  const legend = await page.$$eval('#steps svg .role-legend-label text', (all) => all.map((one) => one.textContent));
  assert.ok(
    legend.some((text) => /: dt\^\d/.test(text)),
    `orders in the legend: ${legend.join('; ')}`,
  );
  const { findings, plots } = await data();
  const [group] = await choice();
  const own = findings.flatMap((one) => one.tables).filter((one) => `${one.case} (${one.profile})` === group);
  const figures = own.flatMap((one) => one.figures).length;
  assert.equal(await page.locator('.finding .plot svg').count(), figures, 'figures of findings');
  assert.equal(await page.locator('.finding table').count(), own.length, 'tables of findings');
  if (plots.speed_up) assert.equal(await page.locator('#speed-up-bars svg').count(), 1);
}

// Bars are labelled by whole contenders: no label is cut short, and none sticks out of its drawing.
async function labelsBarsInFull({ page }) {
  const labels = await page.$$eval('.bars svg .role-axis-label text', (all) =>
    all.map((text) => ({
      text: text.textContent,
      outside: text.ownerSVGElement.getBoundingClientRect().left - text.getBoundingClientRect().left,
    })),
  );
  for (const { text, outside } of labels) {
    assert.ok(!text.endsWith('…'), `cut short: ${text}`);
    assert.ok(outside <= 1, `${text} begins ${outside} px outside`);
  }
  const wide = await page.$$eval(
    '.bars',
    (all) => all.filter((host) => host.scrollWidth > host.clientWidth + 1).length,
  );
  assert.equal(wide, 0, 'figures of bars are as wide as their place');
}

async function setsSymbolsBesideColours({ page }) {
  const matrix = await page.$$eval('#matrix tbody td:nth-child(n+2)', (all) => all.map((one) => one.textContent));
  assert.ok(matrix.length > 0 && matrix.every((text) => /^[✔▲⚡✘–?] /.test(text)), matrix.join('; '));
  const verdicts = await page.$$eval('#claims tbody td:nth-child(3)', (all) => all.map((one) => one.textContent));
  assert.equal(verdicts.length, 16);
  assert.ok(verdicts.every((text) => /^([✔◐✘≈] |not measured here$)/.test(text)), verdicts.join('; '));
}

async function leadsFromAClaimToItsEvidence({ page }) {
  const link = page.locator('#claims button.link').first();
  await link.click();
  const target = await link.textContent();
  const top = await page.evaluate(
    (name) => (document.getElementById(`finding-${name}`) ?? document.getElementById(name)).getBoundingClientRect().top,
    target,
  );
  assert.ok(Math.abs(top) < 60, `${target} stands ${top} px from the top`);
  await page.evaluate(() => scrollTo(0, 0));
}

async function showsFailedRunsAsFailed({ page, cells, data, choice }) {
  const errors = await cells('displacement-error');
  const { tables, verdict } = await data();
  const { columns, rows } = tables.contenders;
  const text = (row, k) => textOf(tables.contenders, row, k);
  const j = columns.findIndex((one) => one.name === 'displacement-error');
  const [group, , truth] = await choice();
  const [, name, profile] = group.match(/^(.*) \((.*)\)$/);
  const chosen = rows.filter((row) => text(row, 0) === name && text(row, 1) === profile && text(row, 2) === truth);
  const failed = chosen.filter((row) => text(row, j).startsWith('failed')).length;
  assert.equal(errors.filter((one) => one.startsWith('⚠ failed')).length, failed);
  assert.ok(errors.every((one) => !/nan|null|infinity/i.test(one)));
  const reasons = await page.$$eval('#failures tbody tr', (all) => all.length);
  assert.equal(reasons, tables.failures.rows.length);
  assert.ok(verdict.failed_runs === 0 || reasons > 0, 'failed runs are listed');
}

async function saysWhatIsKnownOfTruths({ page, data }) {
  const { cases } = await data();
  const text = await page.locator('#cases').allTextContents();
  for (const sentence of cases.flatMap((one) => [one.line, ...one.truth]))
    assert.ok(text.join(' ').includes(sentence), sentence);
}

async function namesEveryEnvironment({ page, data }) {
  const { tables } = await data();
  const shown = await page.$$eval('#environment tbody tr', (rows) =>
    rows.map((row) => [row.cells[0].textContent, row.cells[1].textContent]),
  );
  const known = tables.environment.rows.map((row) => [0, 1].map((j) => textOf(tables.environment, row, j)));
  assert.deepEqual(shown, known);
  const stamp = await page.textContent('#stamp');
  for (const [what, value] of known) if (what === 'processor') assert.ok(stamp.includes(value), stamp);
}

async function keepsPictures({ page, picture, out }) {
  await picture('first-screen.png');
  await picture('wide.png', { fullPage: true });
  for (const id of await page.$$eval('main section:not([hidden])', (all) => all.map((one) => one.id))) {
    await page.locator(`[id="${id}"]`).screenshot({ path: join(out, `section-${id}.png`) });
  }
}

export const steps = [
  ['opens from disk, page below 8 MB, first paint below 1 s', opens],
  ['shows the verdict', showsTheVerdict],
  ['lists the pairs of the headline', listsThePairsOfTheHeadline],
  ['draws both plots', drawsBothPlots],
  ['draws the step figure and what analyses found', drawsStepsAndFindings],
  ['labels of bars can be read', labelsBarsInFull],
  ['symbols stand beside colours', setsSymbolsBesideColours],
  ['a claim leads to its evidence', leadsFromAClaimToItsEvidence],
  ['failed runs are shown as failed', showsFailedRunsAsFailed],
  ['cases say what they are and what is known of their truths', saysWhatIsKnownOfTruths],
  ['every environment is named', namesEveryEnvironment],
  ['pictures are kept', keepsPictures],
];
