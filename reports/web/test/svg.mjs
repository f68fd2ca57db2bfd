// Drawings of figures, where the disk is full, where one was cut, and where a link stands in its place:
//
//   node svg.mjs FIGURES_DIRECTORY    a copy of the directory is drawn; exit code 0 all as it should be
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cpSync, lstatSync, mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const [figures] = process.argv.slice(2);
const script = join(dirname(fileURLToPath(import.meta.url)), '..', 'svg.mjs');
const scratch = mkdtempSync(join(tmpdir(), 'modalbench-svg-'));
process.on('exit', () => rmSync(scratch, { recursive: true, force: true }));

const directory = join(scratch, 'figures');
cpSync(figures, directory, { recursive: true });
for (const name of readdirSync(directory)) if (name.endsWith('.svg')) rmSync(join(directory, name));
const drawings = () => readdirSync(directory).filter((name) => name.includes('.svg'));
const whole = (name) => readFileSync(join(directory, name), 'utf8').endsWith('</svg>');
// No file may grow beyond so many KiB.
const draw = (most = 'unlimited') =>
  spawnSync('bash', ['-c', `trap '' XFSZ; ulimit -f ${most}; exec node "$0" "$1"`, script, directory], {
    encoding: 'utf8',
  });

const starved = draw(4);
assert.equal(starved.status, 1, starved.stderr);
assert.match(starved.stderr, /not drawn: EFBIG/);
assert.ok(drawings().every((name) => name.endsWith('.svg') && whole(name)), 'nothing is cut, nothing left behind');

const all = draw();
assert.equal(all.status, 0, all.stderr);
const [first, second] = drawings();
assert.ok(drawings().length > 1 && drawings().every(whole));

// Data from elsewhere are not fetched.
const fetching = join(directory, 'fetching.vl.json');
const elsewhere = { data: { url: join(directory, first) }, mark: 'point' };
writeFileSync(fetching, JSON.stringify({ ...elsewhere, encoding: { x: { field: 'a', type: 'nominal' } } }));
const refused = draw();
rmSync(fetching);
assert.equal(refused.status, 1, refused.stderr);
assert.match(refused.stderr, /fetching.vl.json: not drawn: a figure holds its own data/);
assert.ok(!drawings().includes('fetching.svg'));

const outside = join(scratch, 'outside');
writeFileSync(outside, 'mine</svg>');
writeFileSync(join(directory, first), '<svg>cut');
rmSync(join(directory, second));
symlinkSync(outside, join(directory, second));
const again = draw();
assert.match(again.stderr, /^2 figures drawn/m, 'what is cut or elsewhere is no drawing');
assert.ok(drawings().every(whole));
assert.equal(readFileSync(outside, 'utf8'), 'mine</svg>');
assert.ok(lstatSync(join(directory, second)).isFile());
