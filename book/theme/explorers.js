// The explorers: figures that answer to the hand. What they show is asked of the crate itself, compiled to WebAssembly;
// here it is only drawn.
'use strict';

(() => {
    const here = document.currentScript.src;
    const fixed = SlipbookPlot.fixed;

    // Questions and second ones are kept apart by their numbers.
    const BESIDE = 100;
    const PENDING = Symbol('the answer is not there yet');

    // The door to the crate.
    async function door() {
        await new Promise((loaded, failed) => {
            const script = document.createElement('script');
            script.src = new URL('explorers-module.js', here);
            script.onload = loaded;
            script.onerror = failed;
            document.head.append(script);
        });
        const bytes = Uint8Array.from(atob(slipbookModule), c => c.charCodeAt(0));
        const last = [];
        const known = (number, given) => last[number]?.key === given.join() ? last[number].answer : null;
        const keep = (number, given, answer) => { last[number] = { key: given.join(), answer }; };
        const heard = [];

        // What is asked is answered beside the page's own thread; where there is no worker, by that thread.
        let worker, put;
        try {
            const work = `${opened}; let put; onmessage = async ({ data }) => {
                // Questions that come while it opens wait for the same module.
                put ||= opened(data.bytes);
                const list = (await put)(data.number % ${BESIDE}, data.given);
                postMessage({ ...data, bytes: null, list }, list.buffer ? [list.buffer] : []);
            };`;
            worker = new Worker(URL.createObjectURL(new Blob([work], { type: 'text/javascript' })));
        } catch {
            put = await opened(bytes);
        }
        const wanted = [];
        let first = bytes;
        const send = number => {
            worker.postMessage({ number, given: wanted[number].given, bytes: first });
            first = null;
        };
        if (worker) {
            worker.onmessage = ({ data: { number, given, list } }) => {
                keep(number, given, apart(list));
                if (wanted[number].given.join() === given.join()) wanted[number] = null;
                else send(number);
                // What waits for several answers is drawn once.
                if (!wanted.some(want => want?.needed)) heard.forEach(hear => hear());
            };
            worker.onerror = async () => {
                worker = null;
                put = await opened(bytes);
                heard.forEach(hear => hear());
            };
        }
        // The answer, if it is there; else it is sent for, and those who wait hear of it.
        const answer = (number, given, needed) => {
            if (!known(number, given) && put) keep(number, given, apart(put(number % BESIDE, given)));
            if (!known(number, given) && worker) {
                const idle = !wanted[number];
                wanted[number] = { given, needed };
                if (idle) send(number);
            }
            return known(number, given);
        };
        // Without this answer nothing new is shown.
        const ask = (number, ...given) => {
            const found = answer(number, given, true);
            if (!found) throw PENDING;
            return found;
        };
        // Without this one, the one before it.
        ask.later = (number, ...given) => {
            const found = answer(number, given, false);
            ask.whole &&= Boolean(found);
            return found || last[number]?.answer || { values: [], curves: [] };
        };
        // A second answer to the same question, beside the first.
        ask.beside = (number, ...given) => ask(number + BESIDE, ...given);
        ask.heard = heard;
        return ask;
    }

    // An answer from its list: values, then curves. One in words stays what it is.
    function apart(list) {
        if (typeof list === 'string') return list;
        let at = 0;
        const take = n => Array.from(list.subarray(at, at += n));
        const [count] = take(1), values = take(count), [many] = take(1);
        return { values, curves: Array.from({ length: many }, () => take(2 * take(1)[0])) };
    }

    // Opens the module: one function, which returns a list or, asked in words, a text.
    async function opened(bytes) {
        const { exports } = (await WebAssembly.instantiate(bytes)).instance;
        return (number, given) => {
            if (typeof given[0] === 'string') {
                const asked = new TextEncoder().encode(given[0]), room = exports.room(asked.length);
                new Uint8Array(exports.memory.buffer, room, asked.length).set(asked);
                const told = exports.tell(), { buffer } = exports.memory;
                return new TextDecoder().decode(new Uint8Array(buffer, told + 4, new DataView(buffer).getUint32(told, true)));
            }
            const start = exports.ask(number, ...[...given, 0, 0, 0, 0].slice(0, 4));
            const length = new Float64Array(exports.memory.buffer, start, 1)[0];
            if (!length) throw new Error(`question ${number} has no answer at ${given}`);
            return new Float64Array(exports.memory.buffer, start + 8, length).slice();
        };
    }

    function start(host, ask) {
        const name = host.dataset.explorer;
        const { inputs, plots, show, predict, ...explorer } = slipbookExplorers[name];
        const keys = Object.keys(inputs);
        // What is asked about stands there before it moves.
        const first = Object.fromEntries(keys.map(key => [key, inputs[key].start ?? predict.at[key]]));
        const state = {};
        const digits = key => (String(inputs[key].step).split('.')[1] || '').length;
        const snap = (key, value) => {
            const { range: [from, to], step } = inputs[key];
            return Number((from + Math.round((Math.min(to, Math.max(from, value)) - from) / step) * step).toFixed(digits(key)));
        };

        const hint = `<span class="hint">${explorer.hint}</span>`;
        host.innerHTML = `<p><span class="name">${explorer.name}</span> ${explorer.asksFirst ? '' : hint}</p>
            <div><div class="theatre"></div><div class="plots"></div>
            <div class="controls"><div class="inputs">${keys.map(key => `<label>${inputs[key].label} <output></output>
                <input type="range" name="${key}" min="${inputs[key].range[0]}" max="${inputs[key].range[1]}" step="${inputs[key].step}"></label>`).join('')}
                <div><button type="button">As at first</button> <button type="button" class="copy">Copy link</button>${explorer.scene ? ' <a class="as-scene">As a scene</a>' : ''}</div></div></div></div>`;
        host.classList.toggle('bare', Boolean(explorer.bare));
        // What is asked about is not told before it has been guessed, or seen, or something has been taken in hand.
        let told = false;
        const tell = () => {
            told = true;
            host.classList.remove('asking', 'untold', 'guessed');
        };
        host.classList.add('asking');
        host.classList.toggle('untold', Boolean(explorer.asksFirst));
        const printed = (host.dataset.printed || '').split(/[ ,]+/).filter(Boolean).map(Number);
        const sliders = Object.fromEntries([...host.querySelectorAll('input')].map(slider => [slider.name, slider]));
        let noted;
        // A number sets an input, a list of one number moves it by so many steps.
        const set = changes => {
            if (!curtain) tell();
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
        // What comes of it stands under the film, where the controls do not cover it.
        const says = '<p class="says" role="status"></p>';
        if (!explorer.asksFirst) host.querySelector('.theatre').insertAdjacentHTML('afterend', says);
        host.querySelector('.plots').insertAdjacentHTML('beforeend', `<div class="readout">${explorer.asksFirst ? `<p>${hint}</p>${says}` : ''}<dl></dl></div>`);

        // Where an intuition is usually wrong, the reader guesses before the bodies move.
        const { asks, options, right, says: answer, at } = predict;
        // Above the part in which the controls stay in view, so that they never cover it.
        host.querySelector('.theatre').parentElement.insertAdjacentHTML('beforebegin', `<div class="predict" role="group" aria-label="Your guess"><p>${asks}</p>
            <div>${options.map(option => `<button type="button" aria-pressed="false">${option}</button>`).join('')}</div><span role="status"></span></div>`);
        const box = host.querySelector('.predict'), buttons = [...box.querySelectorAll('button')];
        buttons.forEach((button, i) => button.addEventListener('click', () => {
            buttons.forEach(other => other.setAttribute('aria-pressed', other === button));
            box.querySelector('[role=status]').textContent = `${i === right ? 'Yes.' : `No: ${options[right].replace(/^It /, 'it ')}.`} ${answer}`;
            // What was asked about is what one sees.
            curtain = true;
            host.classList.add('guessed');
            if (!explorer.asksFirst) tell();
            set(at);
        }));

        let places = [], curtain = false, aim = null;
        const stage = new SlipbookStage(host.querySelector('.theatre'), host.querySelector(explorer.bare ? '.theatre' : '.controls'),
            i => panels.forEach((panel, k) => panel.now(places[k] && i > 0 ? places[k](i) : null)), () => drawn());
        const showAll = () => {
            if (told) return;
            tell();
            drawn();
        };
        if (explorer.asksFirst) stage.ended = showAll;
        else for (const kind of ['click', 'input']) host.querySelector('.film').addEventListener(kind, showAll);

        let due = null;
        let anew = false;
        const draw = () => {
            anew = true;
            // What is shown is no longer what is asked for.
            delete host.dataset.shown;
            delete host.dataset.whole;
            // At once, and what follows before the next picture is drawn with it.
            if (due) {
                due = 'again';
                return;
            }
            due = 'once';
            drawn();
            requestAnimationFrame(() => {
                const again = due === 'again';
                due = null;
                if (again) drawn();
            });
        };
        // While a hand moves, answers may be coarse.
        let moving = false;
        host.addEventListener('pointerdown', () => { moving = true; }, { capture: true });
        for (const end of ['pointerup', 'pointercancel']) {
            addEventListener(end, () => {
                if (!moving) return;
                moving = false;
                drawn();
            });
        }
        const drawn = () => {
            for (const key of keys) {
                sliders[key].value = state[key];
                const said = `${fixed(state[key], digits(key))}${inputs[key].unit || ''}`;
                sliders[key].previousElementSibling.textContent = said;
                sliders[key].setAttribute('aria-valuetext', said);
            }
            ask.whole = true;
            // All parts send for their answers before any waits.
            const made = [
                () => show(state, ask, { printed, moving }),
                () => explorer.now ? explorer.now(state, ask) : [],
                () => explorer.scene && Object.entries(explorer.scene(state, ask)).map(([word, text]) => `&${word}=${text}`).join(''),
                () => explorer.film(state, ask, { printed, moving, told, set, narrow: stage.narrow, held: stage.held }),
            ].map(part => {
                try {
                    return part();
                } catch (pending) {
                    if (pending !== PENDING) throw pending;
                    return PENDING;
                }
            });
            if (made.includes(PENDING)) return;
            const [shown, now, scene, film] = made;
            if (scene) host.querySelector('.as-scene').href = `scenes.html#${explorer.body || 'block'}${scene}`;
            panels.forEach((panel, i) => panel.draw(shown.draw[i]));
            places = now;
            stage.load(film, !anew);
            anew = false;
            host.querySelector('dl').innerHTML = Object.entries(shown.values)
                .map(([term, value]) => `<div><dt>${term.replace(/_(.)/g, '<sub>$1</sub>')}</dt><dd>${value}</dd></div>`).join('');
            host.querySelector('.says').textContent = shown.says;
            // Its place is known when it has been drawn.
            aim?.scrollIntoView({ block: 'center' });
            aim = null;
            host.dataset.shown = address();
            if (ask.whole) host.dataset.whole = address();
            if (curtain) {
                curtain = false;
                stage.play();
                stage.rewind = !told;
            }
        };

        // What the address says of this explorer, and for the rest where it starts.
        const read = () => {
            const [id, query = ''] = location.hash.slice(1).split('?');
            const given = new URLSearchParams(id === host.id ? query : '');
            for (const key of keys) {
                // Nothing behind the sign is not 0.
                const value = given.get(key) ? Number(given.get(key)) : NaN;
                state[key] = snap(key, Number.isFinite(value) ? value : first[key]);
            }
            // Who follows a link to a state wants to watch it, and is not asked about another.
            const linked = Boolean(query) && id === host.id;
            box.toggleAttribute('hidden', linked);
            if (linked) {
                tell();
                curtain = !matchMedia('(prefers-reduced-motion: reduce)').matches;
            }
            aim = panels[linked ? given.get('plot') - 1 : -1]?.svg;
            for (const { svg } of panels) svg.classList.toggle('aimed', svg === aim);
            draw();
            if (id === host.id && !aim) host.scrollIntoView();
        };
        host.addEventListener('input', event => event.target.name in inputs && set({ [event.target.name]: Number(event.target.value) }));
        // mdBook turns pages with the arrow keys.
        host.addEventListener('keydown', event => event.key.startsWith('Arrow') && event.stopPropagation());
        host.querySelector('.inputs button').addEventListener('click', () => set(first));
        host.querySelector('.copy').addEventListener('click', async event => {
            const link = new URL(address(), location.href).href;
            try {
                await navigator.clipboard.writeText(link);
                event.target.textContent = 'Copied';
            } catch {
                location.hash = address();
                event.target.textContent = 'It is in the address';
            }
            setTimeout(() => { event.target.textContent = 'Copy link'; }, 1500);
        });
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
        ask.heard.push(drawn);
        host.hidden = false;
        read();
        unfold();
    }

    const hosts = [...document.querySelectorAll('[data-explorer]')];
    let opening;
    const open = () => opening ||= door().then(ask => {
        hosts.forEach(host => start(host, ask));
        return ask;
    });
    window.slipbookDoor = open;
    // The module is loaded as soon as the page is there, wherever one reads: what came later would move it.
    (window.requestIdleCallback || setTimeout)(open);
    const linked = () => hosts.some(host => location.hash.startsWith(`#${host.id}`)) && open();
    addEventListener('hashchange', linked);
    // The address says where to, also when the page is loaded again.
    if (linked()) history.scrollRestoration = 'manual';
})();
