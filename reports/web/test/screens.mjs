// The page on other screens and on paper.
import assert from 'node:assert/strict';

async function fitsANarrowScreen({ page, open, picture }) {
  await page.setViewportSize({ width: 400, height: 860 });
  await open();
  const excess = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert.ok(excess <= 0, `the page is ${excess} px too wide`);
  await picture('narrow.png', { fullPage: true });
}

async function isDarkAndPrints({ page, open, picture }) {
  await page.setViewportSize({ width: 1280, height: 900 });
  await page.emulateMedia({ colorScheme: 'dark', reducedMotion: 'reduce' });
  await open();
  await picture('dark.png', { fullPage: true });
  await page.emulateMedia({ colorScheme: 'light', media: 'print' });
  await page.waitForTimeout(400);
  await picture('print.png', { fullPage: true });
}

export const steps = [
  ['fits a narrow screen', fitsANarrowScreen],
  ['dark and print', isDarkAndPrints],
];
