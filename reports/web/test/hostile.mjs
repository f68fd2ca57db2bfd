// Opens a report whose texts hold markup:  node hostile.mjs REPORT.html OUT_DIRECTORY [BROWSER]
// Fails where any of it is more than text: an element, a title set by a script, a request, a word of the console, a
// formula in a spreadsheet, a command of TeX; and where the page's policy lets run what was put into it all the same.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { openReport } from './fixture.mjs';

const [report, out, given] = process.argv.slice(2);
if (!report || !out) {
  console.error('usage: node hostile.mjs REPORT.html OUT_DIRECTORY [BROWSER]');
  process.exit(2);
}

const opened = await openReport(report, out, given);
const { page, open, areDrawn, picture, saved, faults, browser } = opened;

async function isTextOnly(where) {
  await areDrawn();
  const found = await page.evaluate(() => ({
    title: document.title,
    elements: document.querySelectorAll('img, iframe, object, a[href^="javascript:"], [onerror], [onload]').length,
    outward: [...document.links].filter((one) => !one.getAttribute('href').startsWith('#')).map((one) => one.href),
    scripts: [...document.scripts].filter((one) => one.textContent.startsWith('document.title')).length,
    shown: document.body.innerText.split('<img src=x onerror=').length - 1,
  }));
  assert.ok(!found.title.startsWith('hostile'), `${where}: a script ran`);
  assert.equal(found.elements, 0, `${where}: markup became elements`);
  assert.deepEqual(found.outward, [], `${where}: a link leads out of the page`);
  assert.equal(found.scripts, 0, `${where}: markup became a script`);
  assert.ok(found.shown > 20, `${where}: the texts are shown, ${found.shown} times`);
  console.log(`ok   ${where}: markup shown as text ${found.shown} times`);
}

// Whatever a spreadsheet takes for a formula begins with an apostrophe; nothing moves a terminal's cursor.
function isSafeCsv(text, name) {
  const formula = /(^|,)"?[ \u00a0\u3000]*([=+@\uff1d\uff0b\uff0d\uff20]|-(?![\d.]+(e-?\d+)?("|,|\r|$)))/m; // -0.5 is a number
  assert.doesNotMatch(text, formula, `${name}: a cell begins a formula`);
  assert.doesNotMatch(text, /[\x00-\x08\x0b-\x1f\x7f]/, `${name}: a control character`);
}
function isSafeLatex(text, name) {
  assert.doesNotMatch(text, /\\input|[^{]\*|[\x00-\x08\x0b-\x1f\x7f]/, `${name}: more than text`);
  assert.match(text, /\\textbackslash\{\}input/, `${name}: the text is there`);
}

async function savesTextOnly() {
  const ask = { csv: isSafeCsv, latex: isSafeLatex };
  let asked = 0;
  for (const button of await page.locator('button[data-format=csv], button[data-format=latex]').all()) {
    if (!(await button.isVisible())) continue;
    const format = await button.getAttribute('data-format'),
      name = await button.getAttribute('aria-label');
    const text = await saved(button, name);
    if (format === 'csv' || text.includes('input')) ask[format](text, name);
    asked += text.includes('input');
    await page.waitForTimeout(120); // Chromium drops the eleventh download of a second
  }
  assert.ok(asked > 3, `markup in ${asked} files saved`);
  console.log(`ok   ${asked} files saved with markup in them`);
}

// What none of the texts may do is done here: the page's policy stops it.
async function stopsWhatIsInjected() {
  const before = faults.length;
  const found = await page.evaluate(async () => {
    const stopped = [];
    document.addEventListener('securitypolicyviolation', (event) => stopped.push(event.effectiveDirective));
    const script = document.createElement('script'),
      holder = document.createElement('div');
    script.textContent = 'window.injected = 1';
    holder.innerHTML = '<img src="https://127.0.0.1/x" onerror="window.injected = 1"><b onclick="window.injected = 1">';
    document.body.append(script, holder);
    holder.querySelector('b').click();
    let evaluated = false;
    setTimeout(() => (evaluated = new Function('return true')())); // later: not under the debugger's own policy
    await new Promise((done) => setTimeout(done, 300));
    holder.remove();
    return { stopped, evaluated, injected: window.injected };
  });
  assert.deepEqual([found.evaluated, found.injected], [false, undefined], 'what was injected ran');
  for (const directive of ['script-src-elem', 'script-src-attr', 'img-src'])
    assert.ok(found.stopped.includes(directive), `${directive}: ${found.stopped}`);
  const others = faults.slice(before).filter((one) => !/Content Security Policy|127\.0\.0\.1/.test(one));
  assert.deepEqual(others, []);
  faults.length = before;
  console.log('ok   what is injected is stopped');
}

// Drawn without a browser, hence without a policy.
function drawsTextOnly() {
  const figures = join(dirname(report), 'figures');
  const script = join(dirname(fileURLToPath(import.meta.url)), '..', 'svg.mjs');
  const { status, stderr } = spawnSync('node', [script, figures], { encoding: 'utf8' });
  assert.equal(status, 0, stderr);
  const drawings = readdirSync(figures).filter((one) => one.endsWith('.svg'));
  assert.ok(drawings.length > 1);
  const active = /<(script|img|image|a|foreignObject)\b|<\w+(\s+[\w:-]+="[^"]*")*\s+(on\w+|[\w:]*href)=/;
  for (const name of drawings) assert.doesNotMatch(readFileSync(join(figures, name), 'utf8'), active, name);
  console.log(`ok   ${drawings.length} figures drawn`);
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
  const data = join(dirname(report), 'data');
  for (const name of readdirSync(data).filter((one) => one.endsWith('.csv')))
    isSafeCsv(readFileSync(join(data, name), 'utf8'), name);
  await savesTextOnly();
  await stopsWhatIsInjected();
  drawsTextOnly();
} catch (error) {
  faults.push(error.message);
}
await browser.close();
if (faults.length) {
  console.error(`${faults.length} faults\n${faults.join('\n')}`);
  process.exit(1);
}
