// A report open in a real browser, and what steps of the test ask of it.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

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

// Whatever the page itself does wrong.
function collectFaults(page) {
  const faults = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) faults.push(`console ${message.type()}: ${message.text()}`);
  });
  page.on('pageerror', (error) => faults.push(`page error: ${error.message}`));
  page.on('request', (request) => {
    if (!/^(file|data|blob):/.test(request.url())) faults.push(`request: ${request.url()}`);
  });
  return faults;
}

// The contenders' table, by the names of its columns.
function tableOf(page) {
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
  const heading = (name) => page.locator('#contenders thead button', { hasText: name }).first();
  return { cells, numbers, heading };
}

// What is asked of the page as a whole.
function stateOf(page, report) {
  const url = pathToFileURL(resolve(report)).href;
  const isReady = () => page.waitForFunction(() => document.documentElement.dataset.ready);
  const areDrawn = () => page.waitForFunction(() => document.documentElement.dataset.figures);
  const open = async (hash = '') => {
    await page.goto('about:blank');
    await page.goto(url + hash);
    await isReady();
  };
  const forgetReady = () => page.evaluate(() => delete document.documentElement.dataset.ready);
  const data = () => page.$eval('#report', (element) => JSON.parse(element.textContent));
  const choice = () => page.$$eval('#selectors select', (menus) => menus.map((menu) => menu.value));
  const marks = (id) => page.$$eval(`#${id} svg .mark-symbol path`, (paths) => paths.length);
  return { report, url, isReady, areDrawn, open, forgetReady, data, choice, marks };
}

export async function openReport(report, out, browserPath) {
  mkdirSync(out, { recursive: true });
  const browser = await chromium.launch({ executablePath: browserPath ?? findBrowser(), args: ['--no-sandbox'] });
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, acceptDownloads: true });
  const page = await context.newPage();
  const faults = collectFaults(page);
  const picture = (name, options = {}) => page.screenshot({ path: join(out, name), ...options });
  async function saved(button, name) {
    const [file] = await Promise.all([page.waitForEvent('download'), button.click()]);
    const path = join(out, file.suggestedFilename());
    await file.saveAs(path);
    const text = readFileSync(path, 'utf8');
    assert.ok(text.length > 100, `${name} is empty`);
    return text;
  }
  return { browser, page, faults, out, picture, saved, ...tableOf(page), ...stateOf(page, report) };
}

// The text of a packed cell: report.ts unpacks them likewise.
export function textOf(table, row, j) {
  const cell = typeof row[j] === 'number' ? table.pools[j][row[j]] : row[j];
  return typeof cell === 'string' ? cell : cell[0];
}
