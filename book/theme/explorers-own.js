// A scene of one's own: words in, out what becomes of it, as the crate answers; and a recording that is dropped.
'use strict';

(async () => {
    // Numbers of questions in words, so that each keeps its last answer.
    const [SCENE, RECORDING, DROPPED] = [50, 51, 52];
    const SHOWN = 8;
    const host = document.getElementById('own'), drop = document.getElementById('recording');
    const one = selector => host.querySelector(selector);
    const fields = [...host.querySelectorAll('.inputs input')];
    // Those that have been dropped, by their names.
    const files = {};
    const FIRST = ['block', [['mu', '0.5'], ['throw', '6m/s@30deg']]];

    // A scene is its body and a list of words with their texts; several texts of one word stand behind semicolons.
    const texts = field => field.type === 'checkbox' ? (field.checked ? [''] : []) : field.value.split(';').map(text => text.trim()).filter(Boolean);
    const read = () => [one('[name=body]:checked').value, fields.flatMap(field => texts(field).map(text => [field.name, text]))];
    const write = ([body, words]) => {
        one(`[value=${body}]`).checked = true;
        for (const field of fields) {
            const own = words.filter(([name]) => name === field.name).map(([, text]) => text);
            if (field.type === 'checkbox') field.checked = own.length > 0;
            else field.value = own.join('; ');
        }
        one('details').open ||= [...one('details').querySelectorAll('input')].some(field => texts(field).length);
    };

    const mild = text => encodeURIComponent(text).replace(/%(2B|2C|2F|3A|3D|40|5E)/g, decodeURIComponent);
    const address = ([body, words]) => `#${[body, ...words.map(([name, text]) => text ? `${name}=${mild(text)}` : name)].join('&')}`;
    // A command too may stand in an address.
    const linked = hash => {
        if (hash.startsWith('#own?')) return typed(decodeURIComponent(hash.slice(5)))?.scene;
        const [body, ...words] = hash.slice(1).split('&');
        return ['block', 'ball'].includes(body) && [body, words.map(word => {
            const [name, ...text] = word.split('=');
            return [name, decodeURIComponent(text.join('='))];
        })];
    };

    const quoted = text => /^[\w.,:@/^=%+-]+$/.test(text) ? text : `'${text}'`;
    const command = ([body, words]) => ['slipbook scene', body, ...words.map(([name, text]) => text ? `--${name} ${quoted(text)}` : `--${name}`)].join(' ');
    // A scene from a command line, and what of it is no word of a scene.
    const typed = line => {
        const parts = [...line.replace(/\\\n/g, ' ').matchAll(/(?:'[^']*'|"[^"]*"|[^\s'"])+/g)].map(([part]) => part.replace(/['"]/g, ''));
        const at = parts.findIndex(part => ['block', 'ball'].includes(part));
        const words = [], over = [];
        for (let i = at + 1; i < parts.length; i++) {
            const [, name, , text] = parts[i].match(/^--([a-z-]+)(=(.*))?$/) || [];
            const field = fields.find(field => field.name === name);
            if (!field) over.push(parts[i]);
            else words.push([name, field.type === 'checkbox' ? '' : text ?? parts[++i] ?? '']);
        }
        return at < 0 ? null : { scene: [parts[at], words], over };
    };

    // What is told, by the names of its lines.
    const apart = told => {
        const found = { number: [], does: [] };
        for (const [name, ...cells] of told.split('\n').map(line => line.split('\t'))) {
            if (Array.isArray(found[name])) found[name].push(cells);
            else found[name] = ['path', 'x', 'y'].includes(name) ? cells.map(Number) : cells.join(' ');
        }
        return found;
    };
    const short = text => String(Number(Number(text).toPrecision(6))).replace('-', '−');
    const order = does => {
        const more = does.length - SHOWN, list = does.slice(0, SHOWN).map(([doing, t]) => `${doing} from ${short(t)} s`);
        return `It ${list.join(', ')}${more > 0 ? `, and ${more} changes more` : ''}.`;
    };
    const column = (list, k, many = 4) => list.filter((_, i) => i % many === k);
    const pairs = (us, vs) => us.flatMap((u, i) => [u, vs[i]]);
    const ends = values => {
        let [low, high] = [Infinity, -Infinity];
        for (const value of values) [low, high] = [Math.min(low, value), Math.max(high, value)];
        const room = 0.06 * (high - low) || 0.1 * Math.abs(high) || 1;
        return [low - room, high + room];
    };
    // Ends for the same scale on both axes, in a shape that fits the page.
    const alike = (x, y) => {
        const wider = ([from, to], size) => [(from + to - size) / 2, (from + to + size) / 2];
        const [wide, high] = [x, y].map(([from, to]) => to - from);
        return [wider(x, Math.max(wide, high / 0.8)), wider(y, Math.max(high, 0.4 * wide))];
    };
    const rests = (does, end) => does.map(([doing, t], i) => [doing, [Number(t), Number(does[i + 1]?.[1] ?? end)]])
        .filter(([doing]) => doing === 'rests').map(([, band]) => ({ band, fill: 0.13 }));
    // The plots of a motion.
    const motion = (box, id, { path, straight, does }) => {
        const [t, x, y, speed] = [0, 1, 2, 3].map(k => column(path, k)), grey = rests(does, t.at(-1));
        const plot = (name, options, marks) => new SlipbookPlot(box, `${id}-${name}`, { title: options.label, height: 210, ...options }).draw({ marks });
        const [wide, high] = straight === undefined ? alike(ends(x), ends(y)) : [ends(t), ends(x)];
        if (straight !== undefined) plot('place', { label: 'place against time', x: { label: 't (s)', range: wide }, y: { label: 'x (m)', range: high } }, [...grey, { points: pairs(t, x), series: 1 }]);
        else plot('place', { label: 'path on the floor', equal: true, x: { label: 'x (m)', range: wide }, y: { label: 'y (m)', range: high } },
            [{ points: pairs(x, y), series: 1 }, { points: [x.at(-1), y.at(-1)], dots: 5, series: 1 }]);
        plot('speed', { title: 'speed; grey: at rest', label: 'speed against time', x: { label: 't (s)', range: ends(t) }, y: { label: 'speed (m/s)', range: ends(speed) } },
            [...grey, { points: pairs(t, speed), series: 2 }]);
    };
    const list = (box, rows) => {
        box.replaceChildren(...rows.map(([name, value]) => {
            const row = document.createElement('div');
            row.append(document.createElement('dt'), document.createElement('dd'));
            row.firstChild.innerHTML = name.replace(/_(.)/, '<sub>$1</sub>');
            row.lastChild.textContent = value;
            return row;
        }));
    };
    const numbers = ({ number }) => number.map(([name, value, unit]) => [name, `${value.replace('-', '−') || 'unknown'} ${unit}`]);

    const parts = '<div class="plots"></div><p class="says" role="status"></p><dl></dl>';
    host.insertAdjacentHTML('afterbegin', `<p><span class="name">Your own scene.</span> <span class="hint">Fill in words, or put a command into the line. A number has a unit or is in SI.</span></p>
        <label>command <textarea name="command" rows="2" spellcheck="false"></textarea></label>`);
    host.insertAdjacentHTML('beforeend', `<p><button type="button" class="copy">Copy command</button> <button type="button" class="copy link">Copy link</button></p>${parts}`);
    host.hidden = false;
    const line = one('textarea');
    drop.insertAdjacentHTML('beforeend', `<p><span class="name">Drop a recording here.</span> <span class="hint">It stays on your computer.</span></p>
        <div class="inputs"><label>or choose a file <input type="file"></label><label>μ <input type="text" name="mu" value="0.2"></label><label>columns, if its heads do not say <input type="text" name="columns"></label></div>${parts}<p><a class="as-scene" hidden>As a scene</a></p>`);
    drop.hidden = false;

    const ask = await slipbookDoor();
    // The answer in parts, or nothing as long as it is not there.
    const told = (number, question) => {
        try {
            return apart(ask(number, question));
        } catch (pending) {
            if (typeof pending !== 'symbol') throw pending;
            return null;
        }
    };
    const question = ([body, words], file) => `${[body, ...words.map(([name, text]) => `${name}=${text}`)].join('\n')}\n\n${file || ''}`;

    let over = [];
    const draw = () => {
        const scene = read(), record = scene[1].find(([name]) => name === 'record');
        delete host.dataset.shown;
        if (document.activeElement !== line) line.value = command(scene);
        const found = told(SCENE, question(scene, record && files[record[1]]));
        if (!found) {
            one('.says').textContent = 'Computing…';
            return;
        }
        one('.plots').replaceChildren();
        if (found.path) motion(one('.plots'), 'own', found);
        one('.says').textContent = `${found.error ?? order(found.does)}${over.length ? ` Passed over: ${over.join(' ')}` : ''}`;
        list(one('dl'), numbers(found));
        host.dataset.shown = address(scene);
    };
    let noted;
    const changed = () => {
        draw();
        clearTimeout(noted);
        noted = setTimeout(() => history.replaceState(history.state, '', address(read())), 200);
    };
    host.addEventListener('input', ({ target }) => {
        over = [];
        if (target === line) {
            const given = typed(line.value);
            if (!given) return;
            write(given.scene);
            over = given.over;
        }
        changed();
    });
    for (const box of [host, drop]) box.addEventListener('keydown', event => event.stopPropagation());
    line.addEventListener('blur', draw);
    host.addEventListener('click', async ({ target }) => {
        if (!target.matches('.copy')) return;
        const name = target.textContent;
        const text = target.matches('.link') ? new URL(address(read()), location.href).href : command(read());
        try {
            await navigator.clipboard.writeText(text);
            target.textContent = 'Copied';
        } catch {
            target.textContent = 'Not allowed here';
        }
        setTimeout(() => { target.textContent = name; }, 1500);
    });

    let file;
    const dropped = () => {
        if (!file) return;
        const [mu, columns] = ['mu', 'columns'].map(name => drop.querySelector(`[name=${name}]`).value.trim());
        const chosen = columns ? [['columns', columns]] : [], found = told(RECORDING, question(['recording', chosen], files[file]));
        const says = drop.querySelector('.says'), plots = drop.querySelector('.plots');
        delete drop.dataset.shown;
        says.textContent = found?.error ? `${file}: ${found.error}` : 'Computing…';
        if (!found || found.error) return;
        const [rows, from, to] = found.rows.split(' ');
        const scene = ['block', [['mu', mu], ['record', file], ...chosen, ['until', `${to}s`]]];
        const moved = told(DROPPED, question(scene, files[file]));
        if (!moved) return;
        const lines = [found.x, found.y].filter(values => values.some((value, i) => i % 2 && value));
        const limit = Number(mu) * 9.80665, [x, y] = [[Number(from), Number(to)], ends(lines.flatMap(values => column(values, 1, 2)))];
        plots.replaceChildren();
        new SlipbookPlot(plots, 'recording-a', { title: 'the recording; dashed: ±μg', label: 'the acceleration that was recorded against time', height: 210, x: { label: 't (s)', range: x }, y: { label: 'A (m/s²)', range: y } })
            .draw({ marks: [...lines.map((points, i) => ({ points, series: i + 1 })), ...[-limit, limit].map(level => ({ points: [x[0], level, x[1], level], dash: true }))] });
        if (moved.path) motion(plots, 'recording', moved);
        says.textContent = `${rows} rows from ${short(from)} s to ${short(to)} s. ${moved.error ?? order(moved.does)}`;
        const many = doing => moved.does.filter(([does], i) => does === doing && i).length;
        list(drop.querySelector('dl'), [...numbers(moved), ['starts, stops', `${many('slides')}, ${many('rests')}`],
            ...[['μ, if the sensor slid', 'kinetic'], ['μ_s, if the sensor slid', 'holding'], ['Coulomb’s law', 'verdict'], ['taken for granted', 'assumed']].map(([name, key]) => [name, found[key]]).filter(([, value]) => value)]);
        const link = drop.querySelector('.as-scene');
        link.href = address(scene);
        link.hidden = false;
        drop.dataset.shown = `${file} ${mu}`;
    };
    const take = async given => {
        if (!given) return;
        file = given.name;
        // As Windows writes it, it may be no UTF-8.
        const bytes = await given.arrayBuffer(), [first, second] = new Uint8Array(bytes);
        const read = coding => new TextDecoder(coding, { fatal: true }).decode(bytes);
        try {
            files[file] = read(first === 0xff && second === 0xfe ? 'utf-16le' : 'utf-8');
        } catch {
            files[file] = read('windows-1252');
        }
        dropped();
        draw();
    };
    drop.addEventListener('input', ({ target }) => target.type === 'file' ? take(target.files[0]) : dropped());
    addEventListener('dragover', event => event.preventDefault());
    addEventListener('drop', event => {
        event.preventDefault();
        take(event.dataTransfer.files[0]);
    });

    // The commands of the page can be tried.
    for (const code of document.querySelectorAll('main pre code')) {
        const given = code.textContent.startsWith('$ slipbook scene ') && typed(code.textContent.split('\n')[0]);
        if (given && !given.over.length) code.parentElement.insertAdjacentHTML('afterend', `<p class="try"><a href="${address(given.scene).replace(/&/g, '&amp;').replace(/"/g, '&quot;')}">▶ try it</a></p>`);
    }
    const follow = () => {
        const given = linked(location.hash);
        if (!given) return false;
        over = given[1].map(([name]) => name).filter(name => !fields.some(field => field.name === name));
        write(given);
        draw();
        host.scrollIntoView();
        return true;
    };
    addEventListener('hashchange', follow);
    ask.heard.push(draw, dropped);
    if (!follow()) {
        write(FIRST);
        draw();
    }
})();
