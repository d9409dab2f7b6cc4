// Break it yourself: a formula with a mistake in it, and what the trials of its claim say of it. They are the crate's own,
// compiled to WebAssembly, and run beside the page's thread.
'use strict';

(() => {
    const here = document.currentScript.src;
    const host = document.getElementById('broken');
    host.hidden = false;
    host.innerHTML = `<p>Two sections take part, 2.1 and 3, with all the trials of their claims.
        <button type="button">Load the trials</button> <span role="status"></span></p>`;
    host.querySelector('button').addEventListener('click', load, { once: true });

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
    const parts = text => text.match(/[\p{L}₀₁₂'′]+|\d+|./gu) || [];

    // The wrong formula, with what is not in the right one marked: all but their longest common parts.
    function marked(right, wrong) {
        const [a, b] = [parts(right), parts(wrong)];
        const common = Array.from({ length: a.length + 1 }, () => new Uint16Array(b.length + 1));
        for (let i = a.length; i-- > 0;) {
            for (let k = b.length; k-- > 0;) {
                common[i][k] = a[i] === b[k] ? common[i + 1][k + 1] + 1 : Math.max(common[i + 1][k], common[i][k + 1]);
            }
        }
        const out = [];
        let i = 0, k = 0;
        while (i < a.length || k < b.length) {
            if (a[i] === b[k]) { out.push(escaped(b[k])); i++; k++; }
            else if (k < b.length && (i === a.length || common[i][k + 1] >= common[i + 1][k])) out.push(`<mark>${escaped(b[k++])}</mark>`);
            else { if (out.at(-1) !== '<s></s>') out.push('<s></s>'); i++; }
        }
        return out.join('').replaceAll('</mark><s></s>', '</mark>').replaceAll('<s></s><mark>', '<mark>').replaceAll('</mark><mark>', '');
    }

    async function start(bytes) {
        const ask = await door(bytes);
        const claims = await ask('claims');
        const sections = [...new Set(claims.map(([, section]) => section))];
        const option = ([id, section, title], i) => [section, `<option value="${i}">${id.replace(/^eq-(.*)/, '($1)')} ${escaped(title)}</option>`];
        const options = claims.map(option);
        host.innerHTML = `<div class="inputs">
            <label>Formula <select name="claim">${sections.map(section => `<optgroup label="Section ${section}">${
                options.filter(([own]) => own === section).map(([, html]) => html).join('')}</optgroup>`).join('')}</select></label>
            <label>Mistake <output></output><input type="range" name="way" min="0" step="1"></label>
            <div><button type="button">One at random</button></div></div>
            <dl><dt>As it stands</dt><dd><code class="right"></code></dd><dt>Broken</dt><dd><code class="wrong"></code></dd></dl>
            <p class="says" role="status"></p><ul class="said"></ul>`;
        const claim = host.querySelector('select'), way = host.querySelector('input');
        const find = name => host.querySelector(name);
        let ways = [], asked = 0;

        async function choose(number) {
            delete host.dataset.shown;
            const chosen = ++asked;
            ways = await ask('ways', Number(claim.value));
            if (chosen !== asked) return;
            way.max = ways.length - 1;
            show(number ?? Math.floor(Math.random() * ways.length));
        }

        async function show(number) {
            delete host.dataset.shown;
            const now = ++asked;
            way.value = number;
            const { right, wrong } = ways[way.value];
            find('output').textContent = `${Number(way.value) + 1} of ${ways.length}`;
            way.setAttribute('aria-valuetext', wrong);
            find('.right').textContent = right;
            find('.wrong').innerHTML = marked(right, wrong);
            find('.says').textContent = 'The trials run…';
            // Only the last of many mistakes that are passed over.
            await new Promise(rest => setTimeout(rest, 120));
            if (now !== asked) return;
            const { verdicts, trials } = await ask('broken', Number(claim.value), Number(way.value));
            if (now !== asked) return;
            const red = trials.filter(({ agrees }) => agrees[0] && !agrees[1]).length;
            const read = trials.filter(({ reads }) => reads).length;
            const [before, after] = verdicts;
            find('.says').textContent = `${red} of ${read} ${read === 1 ? 'trial' : 'trials'} that read the formula ${red === 1 ? 'turns' : 'turn'} red. `
                + (before === after ? `The verdict of the claim alone stays: ${before}.` : `The verdict of the claim alone: ${before} before, ${after} now.`);
            find('.said').innerHTML = trials.map(({ trial, compared, reads, agrees, measured }) => {
                const [mark, word, kind] = !reads ? ['–', 'does not read it', 'idle'] : agrees[1] ? ['✓', 'agrees', 'green']
                    : agrees[0] ? ['✗', 'turns red', 'red'] : ['✗', 'disagrees, as before', 'idle'];
                return `<li class="${kind}"><b>${mark} ${word}</b> <code>${escaped(trial)}</code> ${escaped(compared)} <em>${escaped(measured[reads ? 1 : 0])}</em></li>`;
            }).join('');
            host.dataset.shown = way.value;
        }

        claim.addEventListener('change', () => choose());
        way.addEventListener('input', () => show(way.value));
        find('button').addEventListener('click', () => show(Math.floor(Math.random() * ways.length)));
        claim.value = claims.findIndex(([id]) => id === 'eq-13');
        choose(0);
    }
})();
