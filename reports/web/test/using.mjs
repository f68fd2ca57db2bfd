// What a reader does with the page.
import assert from 'node:assert/strict';

const ascending = (values) => values.every((value, i) => i === 0 || value >= values[i - 1]);

async function sorts({ cells, numbers, heading }) {
  const before = await cells('online time');
  await heading('online time').click();
  assert.ok(ascending(await numbers('online time')));
  await heading('online time').click();
  assert.ok(ascending((await numbers('online time')).reverse()));
  await heading('online time').click();
  assert.deepEqual(await cells('online time'), before);
}

async function filters({ page, cells }) {
  const all = (await cells('method')).length;
  await page.fill('#contenders input[type=search]', 'static');
  const some = await cells('method');
  assert.ok(some.length > 0 && some.length < all);
  assert.ok(some.every((text) => text.includes('static')));
  await page.fill('#contenders input[type=search]', 'no such word');
  assert.equal((await cells('method')).length, 0);
  await page.fill('#contenders input[type=search]', '');
  assert.equal((await cells('method')).length, all);
}

async function opensOnTheMedian({ choice, data }) {
  const { opening } = (await data()).verdict;
  if (opening) assert.equal((await choice())[0], `${opening.case} (${opening.profile})`);
}

async function selects({ page, isReady, forgetReady }) {
  const title = () => page.$eval('#work svg', (svg) => svg.textContent);
  const before = await title();
  await forgetReady();
  await page.selectOption('#select-norm', { index: 1 });
  await isReady();
  assert.notEqual(await title(), before);
  assert.match(page.url(), /norm=/);
  const truths = await page.$$eval('#select-truth option', (options) => options.length);
  if (truths < 2) return;
  await forgetReady();
  await page.selectOption('#select-truth', { index: 1 });
  await isReady();
  assert.match(page.url(), /truth=/);
}

async function restoresTheView({ page, open, isReady }) {
  const linked = page.url();
  await page.goto('about:blank');
  await page.goto(linked);
  await isReady();
  assert.equal(await page.$eval('#select-norm', (select) => select.selectedIndex), 1);
  await open('#norm=%3Cscript%3E&case=none&sort=nothing');
  assert.equal(await page.$eval('#select-norm', (select) => select.selectedIndex), 0);
  await open();
}

// Whatever the contents name is on the page, and they lead there.
async function leadsToSections({ page }) {
  const shown = await page.$$eval('main section:not([hidden]):not(#verdict)', (all) =>
    all.filter((one) => one.offsetParent).map((one) => one.querySelector('h2').textContent),
  );
  const buttons = await page.locator('#contents li:not([hidden]) button').all();
  assert.deepEqual(await Promise.all(buttons.map((button) => button.textContent())), shown);
  assert.ok(buttons.length > 3);
  for (const button of buttons) {
    await button.click();
    const at = await page.evaluate((name) => {
      const heading = [...document.querySelectorAll('main section:not([hidden]) h2')];
      return heading.find((one) => one.textContent === name).getBoundingClientRect().top / innerHeight;
    }, await button.textContent());
    assert.ok(at >= 0 && at < 1, `${await button.textContent()} at ${at} of the window`);
  }
  await page.evaluate(() => scrollTo(0, 0));
}

async function downloads({ page, saved, areDrawn }) {
  await areDrawn();
  const buttons = await page.locator('button[data-format]').all();
  assert.ok(buttons.length >= 8);
  for (const button of buttons) {
    await saved(button, await button.getAttribute('aria-label'));
    await page.waitForTimeout(120); // Chromium drops the eleventh download of a second
  }
  await saved(page.locator('#download-all'), 'everything');
}

async function namesAPoint({ page }) {
  await page.locator('#work svg .mark-symbol path').nth(3).hover();
  await page.waitForSelector('#tip:not([hidden])');
  assert.match(await page.textContent('#tip'), /contender/);
  await page.mouse.move(2, 2);
}

// What the tabulator key comes to, 120 times.
async function reachedByTab(page) {
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
  return seen;
}

async function worksByKeyboard({ page, heading }) {
  await page.evaluate(() => {
    document.body.tabIndex = -1;
    document.body.focus();
    scrollTo(0, 0);
  });
  await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => document.activeElement.className), 'skip');
  const seen = await reachedByTab(page);
  for (const wanted of ['select-case', 'select-norm', 'select-truth', 'search', 'scroller', 'download-all']) {
    assert.ok(seen.has(wanted), `${wanted} was not reached by Tab`);
  }
  await heading('online time').focus();
  await page.keyboard.press('Enter');
  assert.equal(await page.locator('#contenders th[aria-sort=ascending]').count(), 1);
  const isFocused = await page.evaluate(() => document.activeElement.closest('th')?.textContent ?? '');
  assert.match(isFocused, /online time/);
}

export const steps = [
  ['sorts by value in both directions and back', sorts],
  ['filters by words', filters],
  ['it opens on the case whose speed-up is the median', opensOnTheMedian],
  ['selectors change plots and hash', selects],
  ['the hash restores the view', restoresTheView],
  ['contents lead to the sections that are shown', leadsToSections],
  ['every download yields a file', downloads],
  ['a point names its contender', namesAPoint],
  ['works by keyboard alone', worksByKeyboard],
];
