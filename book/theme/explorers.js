// The explorers: figures that answer to the hand. What they show is asked of the crate itself, compiled to WebAssembly;
// here it is only drawn.
'use strict';

(() => {
    const here = document.currentScript.src;
    const fixed = SlipbookPlot.fixed;

    // The module's one function, with the list that it returns taken apart: values, then curves.
    async function door() {
        await new Promise((loaded, failed) => {
            const script = document.createElement('script');
            script.src = new URL('explorers-module.js', here);
            script.onload = loaded;
            script.onerror = failed;
            document.head.append(script);
        });
        const bytes = Uint8Array.from(atob(slipbookModule), c => c.charCodeAt(0));
        const { exports } = (await WebAssembly.instantiate(bytes)).instance;
        const last = [];
        return (number, ...given) => {
            const key = given.join();
            if (last[number]?.key === key) return last[number].answer;
            const start = exports.ask(number, ...[...given, 0, 0, 0, 0].slice(0, 4));
            const length = new Float64Array(exports.memory.buffer, start, 1)[0];
            const list = Array.from(new Float64Array(exports.memory.buffer, start + 8, length));
            if (!length) throw new Error(`question ${number} has no answer at ${key}`);
            const values = list.splice(0, list.shift());
            const curves = Array.from({ length: list.shift() }, () => list.splice(0, 2 * list.shift()));
            last[number] = { key, answer: { values, curves } };
            return last[number].answer;
        };
    }

    function start(host, ask) {
        const name = host.dataset.explorer;
        const { inputs, plots, show, ...explorer } = slipbookExplorers[name];
        const keys = Object.keys(inputs);
        const state = {};
        const digits = key => (String(inputs[key].step).split('.')[1] || '').length;
        const snap = (key, value) => {
            const { range: [from, to], step } = inputs[key];
            return Number((from + Math.round((Math.min(to, Math.max(from, value)) - from) / step) * step).toFixed(digits(key)));
        };

        host.innerHTML = `<p><span class="name">${explorer.name}</span> <span class="hint">${explorer.hint}</span></p>
            <div class="inputs">${keys.map(key => `<label>${inputs[key].label} <output></output>
                <input type="range" name="${key}" min="${inputs[key].range[0]}" max="${inputs[key].range[1]}" step="${inputs[key].step}"></label>`).join('')}
                <div><button type="button">As at first</button></div></div>
            <div class="plots"></div>`;
        const sliders = Object.fromEntries([...host.querySelectorAll('input')].map(slider => [slider.name, slider]));
        let noted;
        // A number sets an input, a list of one number moves it by so many steps.
        const set = changes => {
            for (const [key, value] of Object.entries(changes)) {
                state[key] = snap(key, Array.isArray(value) ? state[key] + value[0] * inputs[key].step : value);
            }
            draw();
            // Browsers slow a page down that changes its address all the time.
            clearTimeout(noted);
            const from = location.href;
            // A link that is followed meanwhile leads elsewhere: its address stays.
            noted = setTimeout(() => location.href === from && history.replaceState(history.state, '', address()), 200);
        };
        const address = () => `#${host.id}?${keys.map(key => `${key}=${state[key]}`).join('&')}`;
        const panels = plots(set).map((options, i) => new SlipbookPlot(host.querySelector('.plots'), `${host.id}-${i}`, options));
        host.querySelector('.plots').insertAdjacentHTML('beforeend', '<div class="readout"><p class="says" role="status"></p><dl></dl></div>');

        let due = false;
        const draw = () => {
            // What is shown is no longer what is asked for.
            delete host.dataset.shown;
            if (due) return;
            due = true;
            requestAnimationFrame(() => {
                due = false;
                const shown = show(state, ask);
                for (const key of keys) {
                    sliders[key].value = state[key];
                    const said = `${fixed(state[key], digits(key))}${inputs[key].unit || ''}`;
                    sliders[key].previousElementSibling.textContent = said;
                    sliders[key].setAttribute('aria-valuetext', said);
                }
                panels.forEach((panel, i) => panel.draw(shown.draw[i]));
                host.querySelector('dl').innerHTML = Object.entries(shown.values)
                    .map(([term, value]) => `<div><dt>${term.replace(/_(.)/g, '<sub>$1</sub>')}</dt><dd>${value}</dd></div>`).join('');
                host.querySelector('.says').textContent = shown.says;
                host.dataset.shown = address();
            });
        };

        // What the address says of this explorer, and for the rest where it starts.
        const read = () => {
            const [id, query = ''] = location.hash.slice(1).split('?');
            const given = new URLSearchParams(id === host.id ? query : '');
            for (const key of keys) {
                const value = given.has(key) ? Number(given.get(key)) : NaN;
                state[key] = snap(key, Number.isFinite(value) ? value : inputs[key].start);
            }
            draw();
            if (id === host.id) host.scrollIntoView();
        };
        host.addEventListener('input', event => set({ [event.target.name]: Number(event.target.value) }));
        // mdBook turns pages with the arrow keys.
        host.addEventListener('keydown', event => event.key.startsWith('Arrow') && event.stopPropagation());
        host.querySelector('button').addEventListener('click', () => set(Object.fromEntries(keys.map(key => [key, inputs[key].start]))));
        const figure = host.nextElementSibling;
        const still = document.createElement('details');
        still.className = 'explorer-static';
        still.innerHTML = '<summary>The same as a still figure, with its data</summary>';
        figure.replaceWith(still);
        still.append(figure);
        const unfold = () => { still.open ||= location.hash === `#${figure.id}`; };
        addEventListener('hashchange', () => {
            if (location.hash.slice(1).split('?')[0] === host.id) read();
            unfold();
        });
        host.hidden = false;
        read();
        unfold();
    }

    // The page for printing keeps its still figures.
    if (!location.pathname.endsWith('/print.html')) {
        const hosts = [...document.querySelectorAll('[data-explorer]')];
        door().then(ask => hosts.forEach(host => start(host, ask)));
    }
})();
