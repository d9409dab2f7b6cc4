// Break it yourself: a formula with a mistake in it, and what the trials of its claim say of it. They are the crate's own,
// compiled to WebAssembly, and run beside the page's thread.
'use strict';

(() => {
    const here = document.currentScript.src;
    const host = document.getElementById('broken');
    host.hidden = false;
    host.innerHTML = `<p>Sections 2.1 and 3 take part, and escape and rest of section 4, with all the trials of their claims.
        <button type="button">Load the trials (${host.dataset.size})</button> <span role="status"></span></p>`;
    host.querySelector('button').addEventListener('click', load, { once: true });
    // An address may name a claim: `#broken?claim=eq-135`.
    const asked = new URLSearchParams(location.hash.split('?')[1]).get('claim');
    if (asked) host.querySelector('button').click();

    async function load() {
        host.querySelector('[role=status]').textContent = 'Loading…';
        const script = document.createElement('script');
        script.src = new URL('breaks-module.js', here);
        script.onload = () => start(Uint8Array.from(atob(slipbookBreaks), c => c.charCodeAt(0)));
        script.onerror = () => { host.querySelector('[role=status]').textContent = 'The module could not be loaded.'; };
        document.head.append(script);
    }

    // Opens the module: its questions, each answered with JSON behind its length.
    async function opened(bytes) {
        const { exports } = (await WebAssembly.instantiate(bytes)).instance;
        return ({ question, given }) => {
            const at = exports[question](...given);
            const length = new DataView(exports.memory.buffer).getUint32(at, true);
            return JSON.parse(new TextDecoder().decode(new Uint8Array(exports.memory.buffer, at + 4, length)));
        };
    }

    async function door(bytes) {
        const work = `${opened}; let put; onmessage = async ({ data }) => {
            put ||= await opened(data.bytes);
            postMessage(put(data));
        };`;
        let worker;
        try {
            worker = new Worker(URL.createObjectURL(new Blob([work], { type: 'text/javascript' })));
        } catch {
            const put = await opened(bytes);
            return async (question, ...given) => put({ question, given });
        }
        // One question at a time.
        let last = Promise.resolve();
        return (question, ...given) => last = last.then(() => new Promise((answer, failed) => {
            worker.onmessage = ({ data }) => answer(data);
            worker.onerror = failed;
            worker.postMessage({ question, given, bytes });
            bytes = undefined;
        }));
    }

    const escaped = text => text.replace(/[&<>]/g, c => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;' })[c]);
    // The parts of a formula in plain text: a derivative and a logarithm that are symbols, functions, symbols, numbers, signs.
    const PARTS = /\(d\(tan θ\/2\)\^λ\/dθ\)|ln r|(?:arc)?(?:sin|cos|tan|cot)h?(?=\()|(?:exp|ln|√)(?=\()|\p{L}[\p{L}\p{M}₀-₉ₓ₊₋]*(?:_\p{L})?|\d+| [+−] |; |./gu;
    const parts = text => text.match(PARTS) || [];

    // The parts of the wrong formula; marked are those that are not in the right one, all but their longest common parts, and
    // cut are those before which something is missing.
    function compared(right, wrong) {
        const [a, b] = [parts(right), parts(wrong)];
        const common = Array.from({ length: a.length + 1 }, () => new Uint16Array(b.length + 1));
        for (let i = a.length; i-- > 0;) {
            for (let k = b.length; k-- > 0;) {
                common[i][k] = a[i] === b[k] ? common[i + 1][k + 1] + 1 : Math.max(common[i + 1][k], common[i][k + 1]);
            }
        }
        const out = b.map(text => ({ text }));
        const silent = text => /^[() ]$/.test(text);
        let i = 0, k = 0;
        while (i < a.length || k < b.length) {
            if (a[i] === b[k]) { i++; k++; }
            else if (k < b.length && (i === a.length || common[i][k + 1] >= common[i + 1][k])) { out[k].marked = true; k++; }
            else { if (!silent(a[i]) && out.length) out[Math.min(k, out.length - 1)].cut = true; i++; }
        }
        // What has another thing in its place lacks nothing.
        out.forEach((part, n) => { part.cut &&= !part.marked && !out[n - 1]?.marked; });
        return out;
    }

    // A formula as MathML, from its parts. Sums, products, powers and what stands in brackets, as the crate writes them.
    function typeset(list) {
        let at = 0;
        const is = text => list[at]?.text === text;
        const dressed = (html, ...own) => {
            const kind = own.some(part => part?.marked) ? 'wrong' : own.some(part => part?.cut) ? 'cut' : '';
            const ways = own.flatMap(part => part?.ways || []);
            if (ways.length) return `<mrow class="sign" data-ways="${ways.join(' ')}">${html}</mrow>`;
            return kind ? `<mrow class="${kind}">${html}</mrow>` : html;
        };
        const row = html => `<mrow>${html}</mrow>`;
        const sign = part => dressed(`<mo>${part.text.trim()}</mo>`, part);
        function symbol(part) {
            const [, letters, low] = part.text.match(/^(.*?)((?:[₀-₉ₓ₊₋]+\p{L}*|_\p{L})?)$/u);
            const plain = [...low].map(c => ({ 'ₓ': 'x', '_': '', '₊': '+', '₋': '−' })[c] ?? ('₀₁₂₃₄₅₆₇₈₉'.includes(c) ? '₀₁₂₃₄₅₆₇₈₉'.indexOf(c) : c)).join('');
            const letter = `<mi>${escaped(letters)}</mi>`;
            return plain ? `<msub>${letter}${/^\d+$/.test(plain) ? `<mn>${plain}</mn>` : `<mi>${plain}</mi>`}</msub>` : letter;
        }
        // Each of these gives the MathML of what it reads, and `bare`, the same without brackets around it.
        function atom() {
            const part = list[at++];
            if (part.text === '(') {
                let { html } = sum();
                // A vector that is multiplied as a whole.
                while (is('; ')) html += sign(list[at++]) + sum().html;
                const end = list[at++];
                const as = html.includes('<mfrac') ? '' : ' stretchy="false"';
                return { html: row(`${dressed(`<mo${as}>(</mo>`, part)}${html}${dressed(`<mo${as}>)</mo>`, end)}`), bare: dressed(row(html), part, end) };
            }
            if (part.text.startsWith('(d')) {
                const html = dressed('<mfrac><mrow><mi>d</mi><msup><mrow><mo>(</mo><mi>tan</mi><mfrac><mi>θ</mi><mn>2</mn></mfrac><mo>)</mo></mrow><mi>λ</mi></msup></mrow><mrow><mi>d</mi><mi>θ</mi></mrow></mfrac>', part);
                return { html: row(html), bare: row(html) };
            }
            let html = part.text === 'ln r' ? '<mi>ln</mi><mi>r</mi>' : /^\d/.test(part.text) ? `<mn>${part.text}</mn>` : symbol(part);
            if (is('(') && /^(arc|sin|cos|tan|cot|exp|ln|√)/.test(part.text)) {
                const argument = atom();
                html = part.text === '√' ? `<msqrt>${argument.bare}</msqrt>` : `<mi>${part.text}</mi><mo>&#x2061;</mo>${argument.html}`;
            }
            html = row(dressed(html, part));
            return { html, bare: html };
        }
        function power() {
            const base = atom();
            if (!is('^')) return base;
            const raised = list[at++];
            const html = dressed(`<msup>${base.html}${atom().bare}</msup>`, raised);
            return { html, bare: html };
        }
        function product() {
            let left = power();
            while (is(' ') || is('/')) {
                const joint = list[at++], right = power();
                const html = joint.text === '/' ? dressed(`<mfrac>${left.bare}${right.bare}</mfrac>`, joint)
                    : row(`${left.html}${dressed('<mo>&#x2062;</mo>', joint)}${right.html}`);
                left = { html, bare: html };
            }
            return left;
        }
        const term = () => /^[−-]$/.test(list[at]?.text) ? { html: `${sign(list[at++])}${product().html}` } : product();
        function sum() {
            let { html } = term();
            while (/^ [+−] $/.test(list[at]?.text)) html += sign(list[at++]) + term().html;
            return { html: row(html) };
        }
        const components = [];
        do components.push(sum().html); while (list[at++]?.text === '; ');
        const plain = list.map(part => part.text).join('');
        return components.map((html, i) => `<math display="block"${i ? '' : ` alttext="${escaped(plain)}"`}>${html}</math>`).join('');
    }

    // The parts of a formula, each with the ways to break it there.
    function breakable(formula, ways) {
        const out = parts(ways.find(way => way.formula === formula).right).map(text => ({ text, ways: [] }));
        ways.forEach((way, number) => {
            if (way.formula !== formula) return;
            compared(way.wrong, way.right).forEach((part, i) => {
                if ((part.marked || part.cut) && part.text.trim()) out[i].ways.push(number);
            });
        });
        return out;
    }

    // A sentence of the trials: powers of ten as such, and of a place as many digits as one looks at.
    const said = text => escaped(text).replace(/\d+\.\d{6}/g, number => Number(Number(number).toPrecision(3)))
        .replace(/(\d)e(-?)(\d+)/g, (_, digit, minus, power) => `${digit} × 10<sup>${minus && '−'}${power}</sup>`)
        .replace(/(^|[\s(])-(?=\d)/g, '$1−');

    async function start(bytes) {
        const ask = await door(bytes);
        const claims = await ask('claims');
        const sections = [...new Set(claims.map(([, section]) => section))];
        const option = ([id, section, title], i) => [section, `<option value="${i}">${/^eq-/.test(id) ? `(${id.slice(3)}) ` : ''}${escaped(title)}</option>`];
        const options = claims.map(option);
        host.innerHTML = `<div class="inputs">
            <label>Formula <select name="claim">${sections.map(section => `<optgroup label="Section ${section}">${
                options.filter(([own]) => own === section).map(([, html]) => html).join('')}</optgroup>`).join('')}</select></label>
            <label>Mistake <output></output><input type="range" name="way" min="0" step="1"></label>
            <div><button type="button">One at random</button></div></div>
            <dl><div><dt>As it stands: click on a sign <select aria-label="Which formula" name="formula"></select></dt><dd class="stands"></dd></div><div><dt>Broken; what is changed is marked</dt><dd class="broken"></dd></div></dl>
            <p class="says" role="status"></p><ul class="said"></ul>`;
        const [claim, formula] = host.querySelectorAll('select'), way = host.querySelector('input');
        const find = name => host.querySelector(name);
        let ways = [], last = 0;

        async function choose(number) {
            delete host.dataset.shown;
            const chosen = ++last;
            ways = await ask('ways', Number(claim.value));
            if (chosen !== last) return;
            way.max = ways.length - 1;
            const names = [...new Set(ways.map(way => way.formula))];
            formula.innerHTML = names.map(name => `<option>${name}</option>`).join('');
            formula.hidden = names.length < 2;
            stand(names[0]);
            show(number ?? Math.floor(Math.random() * ways.length));
        }

        function stand(name) {
            formula.value = name;
            find('.stands').innerHTML = typeset(breakable(name, ways));
        }

        async function show(number) {
            delete host.dataset.shown;
            const now = ++last;
            way.value = number;
            const { formula: name, right, wrong } = ways[way.value];
            if (formula.value !== name) stand(name);
            find('output').textContent = `${Number(way.value) + 1} of ${ways.length}`;
            way.setAttribute('aria-valuetext', wrong);
            host.querySelectorAll('.sign').forEach(sign => sign.classList.toggle('chosen', sign.dataset.ways.split(' ').includes(way.value)));
            find('.broken').innerHTML = typeset(compared(right, wrong));
            find('.says').textContent = 'The trials run…';
            // Only the last of many mistakes that are passed over.
            await new Promise(rest => setTimeout(rest, 120));
            if (now !== last) return;
            const { verdicts, trials } = await ask('broken', Number(claim.value), Number(way.value));
            if (now !== last) return;
            const red = trials.filter(({ agrees }) => agrees[0] && !agrees[1]).length;
            const read = trials.filter(({ reads }) => reads).length;
            const [before, after] = verdicts;
            find('.says').textContent = `${red} of ${read} ${read === 1 ? 'trial' : 'trials'} that read the formula ${red === 1 ? 'turns' : 'turn'} red. `
                + (before === after ? `The verdict of the claim alone stays: ${before}.` : `The claim alone, ${before} before, is now ${after}${after === 'undecided' ? ': it fails, and no correction is tried' : ''}.`);
            const redFirst = [...trials].sort((a, b) => (b.agrees[0] && !b.agrees[1]) - (a.agrees[0] && !a.agrees[1]));
            find('.said').innerHTML = redFirst.map(({ trial, compared, reads, agrees, measured }) => {
                const [mark, word, kind] = !reads ? ['–', 'does not read it', 'idle'] : agrees[1] ? ['✓', 'agrees', 'green']
                    : agrees[0] ? ['✗', 'turns red', 'red'] : ['✗', 'disagrees, as before', 'idle'];
                return `<li class="${kind}"><b>${mark} ${word}</b> <code>${escaped(trial)}</code> ${said(compared)} <em>${said(measured[reads ? 1 : 0])}</em></li>`;
            }).join('');
            host.dataset.shown = way.value;
        }

        claim.addEventListener('change', () => choose());
        way.addEventListener('input', () => show(way.value));
        formula.addEventListener('change', () => show(ways.findIndex(way => way.formula === formula.value)));
        // The ways to break it at a sign, one after the other.
        find('.stands').addEventListener('click', event => {
            const own = event.target.closest('.sign')?.dataset.ways.split(' ');
            if (own) show(Number(own[(own.indexOf(way.value) + 1) % own.length]));
        });
        find('button').addEventListener('click', () => show(Math.floor(Math.random() * ways.length)));
        claim.value = claims.findIndex(([id]) => id === (asked || 'eq-13'));
        choose(0);
    }
})();
