// The explorer of the turntable as the book's pages run it: seconds for an answer, and its values.

import { readFile } from "node:fs/promises";
import { performance } from "node:perf_hooks";

const book = new URL("../../target/book/theme/explorers-module.js", import.meta.url);
const [, coded] = /"(.*)"/.exec(await readFile(book, "utf8"));
const { ask, memory } = (await WebAssembly.instantiate(Buffer.from(coded, "base64"))).instance.exports;
const repeats = Number(process.argv[2] ?? 20);
const seconds = [];
let at = 0;
for (let i = 0; i < repeats; i++) {
    const before = performance.now();
    at = ask(4, 0.8, -0.6, 0.4, 0);
    seconds.push((performance.now() - before) / 1000);
}
seconds.sort((a, b) => a - b);
// The length of the list, the number of values, the values.
const [, count] = new Float64Array(memory.buffer, at, 2);
const values = [...new Float64Array(memory.buffer, at + 16, count)];
console.log(JSON.stringify({
    workload: "W7", peer: "slipbook", n: 1, seconds: seconds[repeats >> 1], seconds_min: seconds[0], accuracy: { values }, versions: { node: process.version },
}));
