// Opens a report from disk in a real browser:  node browser.mjs REPORT.html OUT_DIRECTORY [BROWSER]
// Fails on console errors, page errors and requests other than file: and on any part that does not do its work.
import { openReport } from './fixture.mjs';
import { steps as reading } from './reading.mjs';
import { steps as using } from './using.mjs';
import { steps as screens } from './screens.mjs';

const [report, out, given] = process.argv.slice(2);
if (!report || !out) {
  console.error('usage: node browser.mjs REPORT.html OUT_DIRECTORY [BROWSER]');
  process.exit(2);
}

const opened = await openReport(report, out, given);
const { faults } = opened;
for (const [name, step] of [...reading, ...using, ...screens]) {
  try {
    await step(opened);
    console.log(`ok   ${name}`);
  } catch (error) {
    faults.push(`${name}: ${error.message}`);
    console.log(`FAIL ${name}: ${error.message}`);
  }
}
await opened.browser.close();

if (faults.length) {
  console.error(`\n${faults.length} faults\n${faults.join('\n')}`);
  process.exit(1);
}
