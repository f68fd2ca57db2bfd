// Bundles the page into one template and the template into one C++ source:
//
//   node build.mjs OUT_DIRECTORY   ->   page.html (all but the data), page_template.cc
//
// The content security policy names script and style by the SHA-256 of their very text: nothing else runs.
import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const here = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2] ?? join(here, 'out');

async function bundle(entry, options = {}) {
  const result = await build({
    entryPoints: [join(here, entry)],
    bundle: true,
    minify: true,
    write: false,
    charset: 'utf8',
    legalComments: 'none',
    logLevel: 'warning',
    ...options,
  });
  return result.outputFiles[0].text.trim();
}

const hash = (text) => `'sha256-${createHash('sha256').update(text, 'utf8').digest('base64')}'`;

function fill(template, parts) {
  return template.replace(/@([A-Z]+)@/g, (whole, key) => parts[key] ?? whole);
}

// A C++ string literal; octal escapes end after three digits, so what follows cannot join them.
function literal(text) {
  const bytes = Buffer.from(text, 'utf8');
  const lines = [];
  for (let i = 0; i < bytes.length; i += 4096) {
    let line = '';
    for (const byte of bytes.subarray(i, i + 4096)) {
      const plain = byte >= 0x20 && byte < 0x7f && byte !== 0x22 && byte !== 0x5c && byte !== 0x3f;
      line += plain ? String.fromCharCode(byte) : `\\${byte.toString(8).padStart(3, '0')}`;
    }
    lines.push(`    "${line}"`);
  }
  return { text: lines.join('\n'), length: bytes.length };
}

const script = await bundle('src/main.ts', { format: 'iife', target: 'es2020' });
const style = await bundle('src/style.css');
for (const [name, text] of [
  ['script', script],
  ['style', style],
]) {
  if (/<\/(script|style)|<!--/i.test(text)) throw new Error(`the ${name} would end its own element`);
}
const policy =
  `default-src 'none'; script-src ${hash(script)}; style-src ${hash(style)}; img-src data: blob:; ` +
  `base-uri 'none'; form-action 'none'`;
const page = fill(readFileSync(join(here, 'src/page.html'), 'utf8'), { POLICY: policy, STYLE: style, SCRIPT: script });

mkdirSync(out, { recursive: true });
writeFileSync(join(out, 'page.html'), page);
const { text, length } = literal(page);
writeFileSync(
  join(out, 'page_template.cc'),
  `// Made by reports/web/build.mjs.
#include "reports/page.h"

namespace mb {
namespace {
constexpr char text[] =
${text};
}  // namespace
std::string_view page_template() { return {text, ${length}}; }
}  // namespace mb
`,
);
