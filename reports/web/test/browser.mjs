// Opens a report from disk in a real browser:  node browser.mjs REPORT.html OUT_DIRECTORY [BROWSER]
// Fails on console errors, page errors and requests other than file: and on any part that does not do its work.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, statSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const [report, out, given] = process.argv.slice(2);
if (!report || !out) {
  console.error('usage: node browser.mjs REPORT.html OUT_DIRECTORY [BROWSER]');
  process.exit(2);
}

function findBrowser() {
  for (const name of ['chromium-headless-shell', 'chromium']) {
    try {
      return execFileSync('sh', ['-c', `command -v ${name}`], { encoding: 'utf8' }).trim();
    } catch {
      /* try the next */
    }
  }
  throw new Error('no chromium-headless-shell and no chromium');
}

const faults = [];
let page;

async function step(name, work) {
  try {
    await work();
    console.log(`ok   ${name}`);
  } catch (error) {
    faults.push(`${name}: ${error.message}`);
    console.log(`FAIL ${name}: ${error.message}`);
  }
}

const column = (name) =>
  page.$$eval(
    '#contenders thead th',
    (heads, wanted) => heads.findIndex((head) => head.textContent.startsWith(wanted)),
    name,
  );
const cells = async (name) => {
  const j = await column(name);
  return page.$$eval('#contenders tbody tr', (rows, k) => rows.map((row) => row.cells[k].textContent), j);
};
const data = () => page.$eval('#report', (element) => JSON.parse(element.textContent));
// The text of a packed cell: report.ts unpacks them likewise.
const textOf = (table, row, j) => {
  const cell = typeof row[j] === 'number' ? table.pools[j][row[j]] : row[j];
  return typeof cell === 'string' ? cell : cell[0];
};
const heading = (name) => page.locator('#contenders thead button', { hasText: name }).first();
const marks = (id) => page.$$eval(`#${id} svg .mark-symbol path`, (paths) => paths.length);
const isReady = () => page.waitForFunction(() => document.documentElement.dataset.ready);

async function saved(button, name) {
  const [file] = await Promise.all([page.waitForEvent('download'), button.click()]);
  const path = join(out, file.suggestedFilename());
  await file.saveAs(path);
  assert.ok(statSync(path).size > 100, `${name} is empty`);
  return path;
}

mkdirSync(out, { recursive: true });
const browser = await chromium.launch({ executablePath: given ?? findBrowser(), args: ['--no-sandbox'] });
const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, acceptDownloads: true });
page = await context.newPage();
page.on('console', (message) => {
  if (['error', 'warning'].includes(message.type())) faults.push(`console ${message.type()}: ${message.text()}`);
});
page.on('pageerror', (error) => faults.push(`page error: ${error.message}`));
page.on('request', (request) => {
  if (!/^(file|data|blob):/.test(request.url())) faults.push(`request: ${request.url()}`);
});

const url = pathToFileURL(resolve(report)).href;
await step('opens from disk, page below 8 MB, first paint below 1 s', async () => {
  await page.goto(url);
  await isReady();
  assert.ok(statSync(report).size < 8e6);
  const paint = await page.evaluate(() => performance.getEntriesByName('first-contentful-paint')[0]?.startTime);
  console.log(`     first contentful paint ${Math.round(paint)} ms`);
  assert.ok(paint < 1000, `first paint after ${paint} ms`);
});
await step('shows the verdict', async () => {
  assert.equal(await page.locator('.tile').count(), 4);
  assert.ok((await page.locator('.sentences li').count()) >= 3);
});
await step('draws both plots', async () => {
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
});
const areDrawn = () => page.waitForFunction(() => document.documentElement.dataset.figures);
await step('draws the step figure and what analyses found', async () => {
  await areDrawn();
  assert.ok((await marks('steps')) > 4, 'error against step has marks');
  const legend = await page.$$eval('#steps svg .role-legend-label text', (all) => all.map((one) => one.textContent));
  assert.ok(legend.some((text) => /: dt\^\d/.test(text)), `orders in the legend: ${legend.join('; ')}`);
  const { findings, plots } = await data();
  const [group] = await page.$$eval('#selectors select', (menus) => menus.map((menu) => menu.value));
  const own = findings.flatMap((one) => one.tables).filter((one) => `${one.case} (${one.profile})` === group);
  const figures = own.flatMap((one) => one.figures).length;
  assert.equal(await page.locator('.finding .plot svg').count(), figures, 'figures of findings');
  assert.equal(await page.locator('.finding table').count(), own.length, 'tables of findings');
  if (plots.speed_up) assert.equal(await page.locator('#speed-up-bars svg').count(), 1);
});
await step('symbols stand beside colours', async () => {
  const matrix = await page.$$eval('#matrix tbody td:nth-child(n+2)', (all) => all.map((one) => one.textContent));
  assert.ok(matrix.length > 0 && matrix.every((text) => /^[✔▲⚡✘–?] /.test(text)), matrix.join('; '));
  const verdicts = await page.$$eval('#claims tbody td:nth-child(3)', (all) => all.map((one) => one.textContent));
  assert.equal(verdicts.length, 16);
  assert.ok(verdicts.every((text) => /^([✔◐✘] |not measured here$)/.test(text)), verdicts.join('; '));
});
await step('a claim leads to its evidence', async () => {
  const link = page.locator('#claims button.link').first();
  await link.click();
  const target = await link.textContent();
  const top = await page.evaluate(
    (name) => (document.getElementById(`finding-${name}`) ?? document.getElementById(name)).getBoundingClientRect().top,
    target,
  );
  assert.ok(Math.abs(top) < 60, `${target} stands ${top} px from the top`);
  await page.evaluate(() => scrollTo(0, 0));
});
await page.screenshot({ path: join(out, 'wide.png'), fullPage: true });
for (const id of await page.$$eval('main section:not([hidden])', (all) => all.map((one) => one.id))) {
  await page.locator(`[id="${id}"]`).screenshot({ path: join(out, `section-${id}.png`) });
}
await page.screenshot({ path: join(out, 'first-screen.png') });

// Cells show the digits that their spread allows, so that 0.6 may stand before 0.56: data-value has all of them.
const numbers = async (name) => {
  const j = await column(name);
  const values = await page.$$eval(
    '#contenders tbody tr',
    (rows, k) => rows.map((row) => row.cells[k].dataset.value).filter((value) => value !== undefined),
    j,
  );
  assert.ok(values.length > 1, `${name} has numbers`);
  return values.map(Number);
};
const ascending = (values) => values.every((value, i) => i === 0 || value >= values[i - 1]);
await step('sorts by value in both directions and back', async () => {
  const before = await cells('online time');
  await heading('online time').click();
  assert.ok(ascending(await numbers('online time')));
  await heading('online time').click();
  assert.ok(ascending((await numbers('online time')).reverse()));
  await heading('online time').click();
  assert.deepEqual(await cells('online time'), before);
});
await step('filters by words', async () => {
  const all = (await cells('method')).length;
  await page.fill('#contenders input[type=search]', 'static');
  const some = await cells('method');
  assert.ok(some.length > 0 && some.length < all);
  assert.ok(some.every((text) => text.includes('static')));
  await page.fill('#contenders input[type=search]', 'no such word');
  assert.equal((await cells('method')).length, 0);
  await page.fill('#contenders input[type=search]', '');
  assert.equal((await cells('method')).length, all);
});
await step('failed runs are shown as failed', async () => {
  const errors = await cells('displacement-error');
  const { tables, verdict } = await data();
  const { columns, rows } = tables.contenders;
  const text = (row, k) => textOf(tables.contenders, row, k);
  const j = columns.findIndex((one) => one.name === 'displacement-error');
  const [group, , truth] = await page.$$eval('#selectors select', (menus) => menus.map((menu) => menu.value));
  const [, name, profile] = group.match(/^(.*) \((.*)\)$/);
  const chosen = rows.filter((row) => text(row, 0) === name && text(row, 1) === profile && text(row, 2) === truth);
  const failed = chosen.filter((row) => text(row, j).startsWith('failed')).length;
  assert.equal(errors.filter((one) => one.startsWith('⚠ failed')).length, failed);
  assert.ok(errors.every((one) => !/nan|null|infinity/i.test(one)));
  const reasons = await page.$$eval('#failures tbody tr', (all) => all.length);
  assert.equal(reasons, tables.failures.rows.length);
  assert.ok(verdict.failed_runs === 0 || reasons > 0, 'failed runs are listed');
});
await step('cases say what is known of their truths', async () => {
  const { cases } = await data();
  const text = await page.locator('#cases').allTextContents();
  for (const sentence of cases.flatMap((one) => one.truth)) assert.ok(text.join(' ').includes(sentence), sentence);
});
await step('selectors change plots and hash', async () => {
  const title = () => page.$eval('#work svg', (svg) => svg.textContent);
  const before = await title();
  await page.evaluate(() => {
    delete document.documentElement.dataset.ready;
  });
  await page.selectOption('#select-norm', { index: 1 });
  await isReady();
  assert.notEqual(await title(), before);
  assert.match(page.url(), /norm=/);
  const truths = await page.$$eval('#select-truth option', (options) => options.length);
  if (truths > 1) {
    await page.evaluate(() => {
      delete document.documentElement.dataset.ready;
    });
    await page.selectOption('#select-truth', { index: 1 });
    await isReady();
    assert.match(page.url(), /truth=/);
  }
});
await step('the hash restores the view', async () => {
  const linked = page.url();
  await page.goto('about:blank');
  await page.goto(linked);
  await isReady();
  assert.equal(await page.$eval('#select-norm', (select) => select.selectedIndex), 1);
  await page.goto('about:blank');
  await page.goto(`${url}#norm=%3Cscript%3E&case=none&sort=nothing`);
  await isReady();
  assert.equal(await page.$eval('#select-norm', (select) => select.selectedIndex), 0);
  await page.goto('about:blank');
  await page.goto(url);
  await isReady();
});
await step('every download yields a file', async () => {
  const buttons = await page.locator('button[data-format]').all();
  assert.ok(buttons.length >= 8);
  for (const button of buttons) {
    await saved(button, await button.getAttribute('aria-label'));
    await page.waitForTimeout(120); // Chromium drops the eleventh download of a second
  }
  await saved(page.locator('#download-all'), 'everything');
});
await step('a point names its contender', async () => {
  await page.locator('#work svg .mark-symbol path').nth(3).hover();
  await page.waitForSelector('#tip:not([hidden])');
  assert.match(await page.textContent('#tip'), /contender/);
  await page.mouse.move(2, 2);
});
await step('works by keyboard alone', async () => {
  await page.evaluate(() => {
    document.body.tabIndex = -1;
    document.body.focus();
    scrollTo(0, 0);
  });
  await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => document.activeElement.className), 'skip');
  const seen = new Set();
  for (let i = 0; i < 120; ++i) {
    await page.keyboard.press('Tab');
    seen.add(
      await page.evaluate(
        () =>
          document.activeElement.id ||
          document.activeElement.type ||
          document.activeElement.className ||
          document.activeElement.tagName,
      ),
    );
  }
  for (const wanted of ['select-case', 'select-norm', 'select-truth', 'search', 'scroller', 'download-all']) {
    assert.ok(seen.has(wanted), `${wanted} was not reached by Tab`);
  }
  await heading('online time').focus();
  await page.keyboard.press('Enter');
  assert.equal(await page.locator('#contenders th[aria-sort=ascending]').count(), 1);
  const isFocused = await page.evaluate(() => document.activeElement.closest('th')?.textContent ?? '');
  assert.match(isFocused, /online time/);
});
await step('fits a narrow screen', async () => {
  await page.setViewportSize({ width: 400, height: 860 });
  await page.goto('about:blank');
  await page.goto(url);
  await isReady();
  const excess = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert.ok(excess <= 0, `the page is ${excess} px too wide`);
  await page.screenshot({ path: join(out, 'narrow.png'), fullPage: true });
});
await step('dark and print', async () => {
  await page.setViewportSize({ width: 1280, height: 900 });
  await page.emulateMedia({ colorScheme: 'dark', reducedMotion: 'reduce' });
  await page.goto('about:blank');
  await page.goto(url);
  await isReady();
  await page.screenshot({ path: join(out, 'dark.png'), fullPage: true });
  await page.emulateMedia({ colorScheme: 'light', media: 'print' });
  await page.waitForTimeout(400);
  await page.screenshot({ path: join(out, 'print.png'), fullPage: true });
});
await browser.close();

if (faults.length) {
  console.error(`\n${faults.length} faults\n${faults.join('\n')}`);
  process.exit(1);
}
