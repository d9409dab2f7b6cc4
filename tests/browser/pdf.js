// What is wrong with the sheets of a PDF: its words cannot be read, or some stand at the same place on most of its sheets, but in
// the foot, as what lies over all of them would. A browser prints glyphs; its fonts say which letters they are.
async data => {
    const objects = new Map([...atob(data).matchAll(/^(\d+) 0 obj\n([^]*?)\nendobj/gm)].map(([, number, body]) => [number, body]));
    const at = (body, key) => objects.get(body.match(new RegExp(`/${key} (\\d+) 0 R`))[1]);
    const stream = body => {
        const bytes = Uint8Array.from(body.match(/stream\n([^]*)\nendstream/)[1], c => c.charCodeAt(0));
        return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'))).text();
    };
    const letters = new Map();
    const learn = async number => {
        const map = new Map();
        for (const [, rows] of (await stream(at(objects.get(number), 'ToUnicode'))).matchAll(/beginbf\w+\n([^]*?)\nendbf/g)) {
            for (const row of rows.split('\n')) {
                const codes = row.match(/\w+/g).map(code => parseInt(code, 16));
                for (let i = codes[0]; i <= codes.at(-2); i += 1) map.set(i, String.fromCharCode(codes.at(-1) + i - codes[0]));
            }
        }
        letters.set(number, map);
    };
    const sheets = [];
    for (const body of objects.values()) {
        if (!/\/Type \/Page\b/.test(body)) continue;
        const fonts = new Map([...body.matchAll(/\/(F\d+) (\d+) 0 R/g)].map(([, name, number]) => [name, number]));
        for (const number of fonts.values()) if (!letters.has(number)) await learn(number);
        const words = [];
        let font;
        for (const [, part] of (await stream(at(body, 'Contents'))).matchAll(/BT\n([^]*?)ET/g)) {
            font = letters.get(fonts.get(part.match(/\/(F\d+)/)?.[1])) ?? font;
            const codes = [...part.matchAll(/<(\w+)>/g)].flatMap(([, codes]) => codes.match(/.{1,4}/g));
            words.push([codes.map(code => font.get(parseInt(code, 16)) ?? '').join(''), part.match(/(\S+) (\S+) Tm/) ?? []]);
        }
        sheets.push(words);
    }
    const bare = words => words.replace(/\s/g, ''), found = [], places = {};
    const title = bare(document.querySelector('main h1').textContent);
    const read = sheet => bare(sheet.map(([words]) => words).join(''));
    if (!sheets.some(sheet => read(sheet).includes(title))) found.push(`${title} is on no sheet: ${read(sheets[0]).slice(0, 60)}`);
    if (sheets.length < 5 || sheets.length > 40) found.push(`it has ${sheets.length} sheets`);
    for (const [words, [, x, y]] of sheets.flat()) {
        const key = `${words} at ${x} ${y}`;
        if (words.trim().length > 1 && !(y > 1060)) places[key] = (places[key] ?? 0) + 1;
    }
    for (const [key, times] of Object.entries(places)) {
        if (2 * times > sheets.length) found.push(`${key} on ${times} of ${sheets.length} sheets`);
    }
    return found;
}
