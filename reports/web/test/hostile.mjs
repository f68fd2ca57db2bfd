// Opens a report whose texts hold markup:  node hostile.mjs REPORT.html OUT_DIRECTORY [BROWSER]
// Fails where any of it is more than text: an element, a title set by a script, a request, a word of the console.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { openReport } from './fixture.mjs';

const [report, out, given] = process.argv.slice(2);
if (!report || !out) {
  console.error('usage: node hostile.mjs REPORT.html OUT_DIRECTORY [BROWSER]');
  process.exit(2);
}

const opened = await openReport(report, out, given);
const { page, open, areDrawn, picture, faults, browser } = opened;

async function isTextOnly(where) {
  await areDrawn();
  const found = await page.evaluate(() => ({
    title: document.title,
    elements: document.querySelectorAll('img, iframe, object, a[href^="javascript:"], [onerror], [onload]').length,
    scripts: [...document.scripts].filter((one) => one.textContent.startsWith('document.title')).length,
    shown: document.body.innerText.split('<img src=x onerror=').length - 1,
  }));
  assert.ok(!found.title.startsWith('hostile'), `${where}: a script ran`);
  assert.equal(found.elements, 0, `${where}: markup became elements`);
  assert.equal(found.scripts, 0, `${where}: markup became a script`);
  assert.ok(found.shown > 20, `${where}: the texts are shown, ${found.shown} times`);
  console.log(`ok   ${where}: markup shown as text ${found.shown} times`);
}

try {
  await open();
  await isTextOnly('as it opens');
  await page.$$eval('details', (all) => all.forEach((one) => (one.open = true)));
  await isTextOnly('with all parts open');
  await picture('hostile.png', { fullPage: true });
  for (const menu of await page.$$('#selectors select')) {
    const values = await menu.$$eval('option', (all) => all.map((one) => one.value));
    for (const value of values) await menu.selectOption(value);
  }
  await isTextOnly('after every choice');
  // Whatever a spreadsheet takes for a formula begins with an apostrophe.
  const data = join(dirname(report), 'data');
  for (const name of readdirSync(data).filter((one) => one.endsWith('.csv')))
    assert.doesNotMatch(readFileSync(join(data, name), 'utf8'), /(^|,)"?[=+@]/m, `${name}: a cell begins a formula`);
} catch (error) {
  faults.push(error.message);
}
await browser.close();
if (faults.length) {
  console.error(`${faults.length} faults\n${faults.join('\n')}`);
  process.exit(1);
}
