// What one means comes first: a claim by its number, its id or its name, a symbol by the claim that introduces it, a number by as many
// digits as one has or by what it is calculated from, a part of a formula, the places that are to answer to certain words; then what has
// most of the words. The search of the book and the field of the first page ask here. Without this script the search ranks by words alone.
(() => {
    'use strict';
    if (!window.elasticlunr) return;
    const GREEK = { alpha: 'α', beta: 'β', gamma: 'γ', delta: 'δ', zeta: 'ζ', eta: 'η', theta: 'θ', kappa: 'κ', lambda: 'λ', mu: 'μ', xi: 'ξ',
        pi: 'π', rho: 'ρ', sigma: 'σ', tau: 'τ', phi: 'φ', psi: 'ψ', omega: 'ω', varpi: 'ϖ', sqrt: '√', infinity: '∞' };
    const HIGH = '⁰¹²³⁴⁵⁶⁷⁸⁹', ACCENTS = { tilde: '\u0303', dot: '\u0307', hat: '\u0302', bar: '\u0304' };
    // What one says around the name of what one means, what one asks about it, and what says nothing of it.
    const set = words => new Set(words.split(' '));
    const AROUND = set('eq eqn equation equations formula formulas the a an this in of with for paper');
    const ASKED = set('right wrong true false correct hold proof prove error mistake unit units symbol value');
    const SAYS_NOTHING = set('what is are does mean means happen happens there much many show tell explain please want know think people very really');
    // However it is typed: `λ_c`, `lambda c` and `λc` are the same, `Y` and `y` are not.
    const GREEK_NAME = new RegExp(`^(${Object.keys(GREEK).join('|')})([a-z]?)$`, 'i');
    const letters = text => text.replace(/[A-Za-z]+/g, name => name.replace(GREEK_NAME, (_, greek, index) => GREEK[greek.toLowerCase()] + index))
        .replace(/(\p{L}_?\d?) ?(tilde|dot|hat|bar)\b(?: ?(\d))?/gu, (all, [letter, ...more], accent, index = '') => letter > 'z' ? letter + ACCENTS[accent] + more.join('') + index : all);
    const flat = text => letters(text.replace(/⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]+/g, high => `^${[...high].map(c => c === '⁻' ? '-' : HIGH.indexOf(c)).join('')}`)
        .normalize('NFKC').replace(/⁄/g, '/').replace(/∼/g, '~').replace(/arc(sin|cos|tan)/g, '$1^-1'))
        .normalize('NFKC').replace(/[−–]/g, '-').replace(/[\s_()[\]{}*·]/g, '');
    const key = words => flat(words.join(' '));
    const split = text => text.split(/[\s\-_]+/).map(word => word.replace(/^["'“]+|[.,;:!?"'”]+$/g, '')).filter(Boolean);

    let places;
    const named = typed => {
        const asked = typed.replace(/(?:§|\b(?:sect?\.|sec|chapter)) ?(?=\d)/gi, 'section ');
        if (!places) {
            places = new Map();
            const put = (name, place) => places.set(name, [...places.get(name) || [], String(place)]);
            // Whatever the case, but in the same case first.
            window.search.exact.forEach(([phrase, place]) => put(key(split(phrase)), place));
            window.search.exact.forEach(([phrase, place]) => put(`any ${key(split(phrase)).toLowerCase()}`, place));
        }
        // A capital alone is a symbol, unless it begins a sentence.
        const without = (words, some) => words.filter((word, i) => !some.has(i && word.length === 1 ? word : word.toLowerCase()));
        const words = split(asked), meant = without(without(words, AROUND), SAYS_NOTHING), bare = without(meant, ASKED);
        const [number = ''] = asked.match(/(?<=\beq(?:n|uation)?\.? ?\(?|(?:^| )\()\d+(?=\)?(?:[\s?.,]|$))/i) || [];
        const names = [words, meant, bare, [number]].map(key).filter(Boolean).flatMap(name => [name, `any ${name.toLowerCase()}`]);
        const found = places.get(names.find(name => places.has(name)));
        if (found) return found;
        // Else the longest name of several words that stands in what is asked.
        const spaced = words => ` ${words.join(' ').toLowerCase()} `, all = spaced(words);
        const within = window.search.exact.filter(([phrase]) => /\S[ -]\S/.test(phrase) && all.includes(spaced(split(phrase))));
        return within.sort(([a], [b]) => b.length - a.length).slice(0, 1).map(([, place]) => String(place));
    };
    // What is calculated, or NaN: numbers, π, roots, powers and the four operations.
    const calculated = text => {
        const typed = letters(text).toLowerCase().replace(/[−–]/g, '-').replace(/[·×]/g, '*').replace(/[²³]/g, c => c === '²' ? '^2' : '^3');
        let rest = typed.match(/\d*\.?\d+|[π√()*/^+-]|\S/g) || [];
        const next = (...signs) => signs.includes(rest[0]) && rest.shift();
        const one = () => {
            if (next('-')) return -power();
            if (next('√')) return Math.sqrt(one());
            if (next('π')) return Math.PI;
            if (!next('(')) return /^[\d.]+$/.test(rest[0]) ? Number(rest.shift()) : NaN;
            const inside = sum();
            return next(')') ? inside : NaN;
        };
        const power = () => {
            const base = one();
            return next('^') ? base ** power() : base;
        };
        const product = () => {
            let all = power();
            for (let sign; (sign = next('*', '/') || (/^[\d.π√(]/.test(rest[0] || '') && '*'));) all = sign === '/' ? all / power() : all * power();
            return all;
        };
        const sum = () => {
            let all = product();
            for (let sign; (sign = next('+', '-'));) all += sign === '+' ? product() : -product();
            return all;
        };
        const value = sum();
        return rest.length ? NaN : value;
    };
    const valued = asked => {
        const [, decimals] = asked.trim().match(/^[-−]?\d*\.(\d+)$/) || [];
        const value = calculated(asked);
        if (!decimals && (Number.isNaN(value) || /^\s*\d+\s*$/.test(asked))) return [];
        // As a reader rounds, or cuts off; what is calculated has to be what is shown.
        const off = shown => Math.abs(Number(shown) - value), digits = shown => shown.split('.')[1]?.length || 0;
        return window.search.values.filter(([shown]) => decimals ? off(shown) < 10 ** -decimals.length : digits(shown) > 3 && off(shown) < 0.6 * 10 ** -digits(shown))
            .sort(([a], [b]) => off(a) - off(b)).map(([, place]) => String(place));
    };
    const written = asked => {
        const part = flat(asked).toLowerCase();
        // Words are no formula, but a few letters that begin no word of a heading.
        const few = /^[a-z]{2,4}$/.test(part) && !asked.includes(' ') && !['title', 'aliases'].some(field => index.index[field].expandToken(part).length);
        if (part.length < 2 || !few && (!/[^a-z'?!.,;-]/.test(part) || /^\d+$/.test(part) || !/[α-ωϖ=+~^√/\d]/.test(part))) return [];
        const formulas = window.search.formulas.map(([formula, place]) => [flat(formula).toLowerCase(), String(place)])
            .filter(([, place]) => !few || window.search.doc_urls[place].includes('#eq-'));
        const begins = formulas.filter(([formula]) => formula.startsWith(part));
        const has = formulas.filter(([formula]) => !formula.startsWith(part) && formula.includes(part));
        return [...begins, ...has].map(([, place]) => place);
    };

    // All words of the book, with how often they stand there.
    let index, known;
    const vocabulary = () => {
        if (known) return known;
        known = new Map(Object.keys(GREEK).map(name => [name, 1]));
        const { docs } = index.documentStore;
        const texts = [...Object.values(docs).flatMap(({ title, body, aliases }) => [title, body, aliases]), ...window.search.exact.map(([phrase]) => phrase)];
        texts.forEach(text => (text.toLowerCase().match(/\p{L}+/gu) || []).forEach(word => known.set(word, (known.get(word) || 0) + 1)));
        return known;
    };
    // Whether one slip lies between two words: a letter too many, too few, another one, or two in the wrong order.
    const near = (a, b) => {
        if (a.length > b.length) [a, b] = [b, a];
        if (b.length - a.length > 1) return false;
        let i = 0;
        while (i < a.length && a[i] === b[i]) i++;
        return b.length > a.length ? a.slice(i) === b.slice(i + 1)
            : a.slice(i + 1) === b.slice(i + 1) || a[i] === b[i + 1] && a[i + 1] === b[i] && a.slice(i + 2) === b.slice(i + 2);
    };
    // Words of five letters or more that the book has not, and that begin none of its own, as the nearest that it has.
    const fields = () => Object.values(index.index);
    const mended = asked => asked.replace(/\p{L}{5,}/gu, word => {
        const typed = word.toLowerCase();
        if (stemmed([typed]).every(token => fields().some(field => field.expandToken(token).length)) || vocabulary().has(typed)) return word;
        const [[best] = [word]] = [...vocabulary()].filter(([other]) => near(typed, other)).sort(([, a], [, b]) => b - a);
        return best;
    });
    const stemmed = words => index.pipeline.run(words);

    // How much a place has of what is asked: rare words count for more, those of its heading and those that it is to answer to for most,
    // those of a long text for less; what it lacks counts against it. A chapter comes before its parts, and these in their order.
    const FIELDS = { title: 4, aliases: 6, breadcrumbs: 0.5, body: 1 };
    const ranked = asked => {
        const { docInfo, length } = index.documentStore, total = new Map(), has = new Map();
        const all = split(asked.toLowerCase()).map(word => word.replace(/^[([]+|[)\]]+$|['’]s$/g, '')).filter(Boolean);
        const some = all.filter(word => !SAYS_NOTHING.has(word) && !AROUND.has(word)), words = some.length ? some : all;
        let whole = 0;
        stemmed([...new Set(words)]).forEach(word => {
            const found = new Map();
            Object.entries(FIELDS).forEach(([field, weight]) => index.index[field].expandToken(word).forEach(token => {
                const docs = index.index[field].getDocs(token), part = word.length / token.length;
                Object.keys(docs).forEach(ref => {
                    const count = docs[ref].tf ** 2, long = field === 'body' ? 0.4 + docInfo[ref].body / 250 : field === 'title' ? 0.5 + docInfo[ref].title / 8 : 1;
                    found.set(ref, Math.max(found.get(ref) || 0, part * part * weight * count / (count + long)));
                });
            }));
            const rare = Math.log(1 + length / (1 + found.size));
            whole += rare;
            found.forEach((much, ref) => {
                total.set(ref, (total.get(ref) || 0) + rare * much);
                has.set(ref, (has.get(ref) || 0) + rare);
            });
        });
        const pairs = words.slice(1).map((word, i) => `${words[i]} ${word}`);
        return [...total].map(([ref, much]) => {
            const doc = index.documentStore.getDoc(ref), title = split(doc.title.toLowerCase()).join(' ');
            const together = pairs.some(pair => title.startsWith(pair)) ? 2 : pairs.some(pair => title.includes(pair)) ? 1.5 : 1, chapter = doc.breadcrumbs === doc.title ? 1.5 : 1;
            return { ref, doc, score: much * (has.get(ref) / whole) ** 2 * together * chapter * (1 - 0.3 * ref / length) };
        }).sort((a, b) => b.score - a.score);
    };

    elasticlunr.Index.prototype.search = function (asked) {
        index = this;
        const meant = mended(asked), found = ranked(meant);
        const first = [...new Set([named, valued, written].flatMap(look => look(meant)))];
        const result = ref => found.find(one => one.ref === ref) || { ref, score: 0, doc: this.documentStore.getDoc(ref) };
        return [...first.map(result), ...found.filter(one => !first.includes(one.ref))];
    };

    // The addresses and titles of what is found, and those of the pages; the index is loaded when one first asks.
    let loading;
    const load = () => loading ||= (window.search.index ? Promise.resolve() : new Promise((done, failed) => {
        const script = document.createElement('script');
        script.src = window.path_to_searchindex_js;
        script.onload = done;
        script.onerror = failed;
        document.head.append(script);
    })).then(() => elasticlunr.Index.load(window.search.index));
    window.trialbookSearch = async asked => (await load()).search(asked)
        .map(({ ref, doc }) => ({ at: window.search.doc_urls[ref], title: doc.title, page: doc.breadcrumbs.split(' » ')[0] }));
    Object.assign(window.trialbookSearch, { load, letters });
})();
