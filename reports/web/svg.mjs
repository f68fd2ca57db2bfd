// Draws the archived specifications as SVG beside them:  node svg.mjs FIGURES_DIRECTORY
// Expressions are interpreted, as on the page; nothing is fetched. What cannot be drawn is named: then exit code 1. A
// drawing is there whole or not at all, and in the place of a link, not behind it.
import { lstatSync, readdirSync, readFileSync, renameSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { parse, View } from 'vega';
import { expressionInterpreter } from 'vega-interpreter';
import { compile } from 'vega-lite';

const [directory] = process.argv.slice(2);
if (!directory) {
  console.error('usage: node svg.mjs FIGURES_DIRECTORY');
  process.exit(2);
}

const ending = '.vl.json';
// Vega draws what it can without them, and says nothing: the first refusal is remembered.
let refusal;
const refuse = (text) => Promise.reject((refusal ??= new Error(text)));
const loader = {
  load: () => refuse('a figure holds its own data'),
  sanitize: () => refuse('a figure links to nothing'),
};
const isCurrent = (source, drawing) => {
  try {
    const { mtimeMs } = statSync(source),
      there = lstatSync(drawing);
    return there.isFile() && there.mtimeMs >= mtimeMs && readFileSync(drawing, 'utf8').endsWith('</svg>');
  } catch {
    return false;
  }
};
const write = (file, text) => {
  const unfinished = `${file}.tmp`;
  try {
    rmSync(unfinished, { force: true });
    writeFileSync(unfinished, text, { flag: 'wx', flush: true });
    renameSync(unfinished, file);
  } catch (error) {
    rmSync(unfinished, { force: true });
    throw error;
  }
};

let drawn = 0,
  failed = 0;
for (const name of readdirSync(directory).filter((one) => one.endsWith(ending)).sort()) {
  const source = join(directory, name),
    drawing = join(directory, name.slice(0, -ending.length) + '.svg');
  if (isCurrent(source, drawing)) continue;
  refusal = undefined;
  try {
    const { spec } = compile({ background: 'white', ...JSON.parse(readFileSync(source, 'utf8')) });
    const view = new View(parse(spec, undefined, { ast: true }), {
      expr: expressionInterpreter,
      renderer: 'none',
      loader,
    });
    const svg = await view.toSVG();
    if (refusal) throw refusal;
    write(drawing, svg);
    view.finalize();
    drawn += 1;
  } catch (error) {
    console.error(`${source}: not drawn: ${error.message}`);
    failed += 1;
  }
}
console.error(`${drawn} figures drawn${failed ? `, ${failed} failed` : ''}`);
process.exit(failed ? 1 : 0);
