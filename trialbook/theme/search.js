// What one means comes first: a claim by its number, its id or its name, a symbol by the claim that introduces it, a number by as many
// digits as one has, the places that are to answer to certain words, a part of a formula; then what has the words. The search of the
// book and the field of the first page ask here. Without this script the search ranks by words alone.
(() => {
    'use strict';
    if (!window.elasticlunr) return;
    const GREEK = { alpha: 'α', beta: 'β', gamma: 'γ', delta: 'δ', zeta: 'ζ', eta: 'η', theta: 'θ', kappa: 'κ', lambda: 'λ', mu: 'μ', xi: 'ξ',
        pi: 'π', rho: 'ρ', sigma: 'σ', tau: 'τ', phi: 'φ', psi: 'ψ', omega: 'ω', varpi: 'ϖ', sqrt: '√' };
    const HIGH = '⁰¹²³⁴⁵⁶⁷⁸⁹', LOW = '₀₁₂₃₄₅₆₇₈₉';
    // What one says around the name of what one means, and what one asks about it.
    const AROUND = new Set(['eq', 'equation', 'the', 'a', 'an', 'this', 'in', 'of', 'with', 'paper']);
    const ASKED = new Set(['what', 'is', 'are', 'does', 'right', 'wrong', 'true', 'false', 'correct', 'hold', 'proof', 'prove', 'mean', 'means']);
    // However it is typed: `λ_c`, `lambda c` and `λc` are the same, `Y` and `y` are not.
    const letters = text => text.replace(/[A-Za-z]+/g, name => GREEK[name.toLowerCase()] || name);
    const flat = text => letters(text)
        .replace(/[⁰¹²³⁴⁵⁶⁷⁸⁹]/g, c => `^${HIGH.indexOf(c)}`)
        .replace(/[₀₁₂₃₄₅₆₇₈₉]/g, c => LOW.indexOf(c))
        .replace(/−/g, '-').replace(/[\s_()[\]{}*·]/g, '');
    const key = words => flat(words.join(''));
    const split = text => text.split(/[\s\-_]+/).map(word => word.replace(/^["'“]+|[.,;:!?"'”]+$/g, '')).filter(Boolean);

    let places;
    const named = asked => {
        if (!places) {
            places = new Map();
            const put = (name, place) => places.set(name, [...places.get(name) || [], String(place)]);
            // Whatever the case, but in the same case first.
            window.search.exact.forEach(([phrase, place]) => put(key(split(phrase)), place));
            window.search.exact.forEach(([phrase, place]) => put(`any ${key(split(phrase)).toLowerCase()}`, place));
        }
        const without = (words, some) => words.filter(word => !some.has(word.toLowerCase()));
        const words = split(asked), meant = without(words, AROUND);
        const names = [words, meant, without(meant, ASKED)].map(key).flatMap(name => [name, `any ${name.toLowerCase()}`]);
        const found = places.get(names.find(name => places.has(name)));
        if (found) return found;
        // Else the longest name of several words that stands in what is asked.
        const spaced = words => ` ${words.join(' ').toLowerCase()} `, all = spaced(words);
        const within = window.search.exact.filter(([phrase]) => /\S[ -]\S/.test(phrase) && all.includes(spaced(split(phrase))));
        return within.sort(([a], [b]) => b.length - a.length).slice(0, 1).map(([, place]) => String(place));
    };
    const valued = asked => {
        const decimal = asked.trim().replace('−', '-').match(/^-?\d*\.(\d+)$/);
        if (!decimal) return [];
        // As a reader rounds, or cuts off.
        const off = value => Math.abs(Number(value) - Number(decimal[0]));
        return window.search.values.filter(([value]) => off(value) < 10 ** -decimal[1].length)
            .sort(([a], [b]) => off(a) - off(b)).map(([, place]) => String(place));
    };
    const written = asked => {
        const part = flat(asked).toLowerCase();
        // Words are no formula.
        if (part.length < 2 || !/[^a-z'?!.,;-]/.test(part) || /^\d+$/.test(part) || !/[α-ωϖ=+~^√/\d]/.test(part)) return [];
        const formulas = window.search.formulas.map(([formula, place]) => [flat(formula).toLowerCase(), String(place)]);
        const begins = formulas.filter(([formula]) => formula.startsWith(part));
        const has = formulas.filter(([formula]) => !formula.startsWith(part) && formula.includes(part));
        return [...begins, ...has].map(([, place]) => place);
    };

    const { prototype } = elasticlunr.Index;
    const byWords = prototype.search;
    prototype.search = function (asked, options) {
        const all = byWords.call(this, asked, options);
        // Where no place has every word, those that have the most of them.
        const found = all.length ? all : byWords.call(this, asked, { ...options, bool: 'OR' });
        const first = [...new Set([named, valued, written].flatMap(look => look(asked)))];
        const result = ref => found.find(one => one.ref === ref) || { ref, score: 0, doc: this.documentStore.getDoc(ref) };
        return [...first.map(result), ...found.filter(one => !first.includes(one.ref))];
    };

    // The addresses and titles of what is found, and those of the pages; the index is loaded when one first asks.
    let index;
    const load = () => index ||= (window.search.index ? Promise.resolve() : new Promise((done, failed) => {
        const script = document.createElement('script');
        script.src = window.path_to_searchindex_js;
        script.onload = done;
        script.onerror = failed;
        document.head.append(script);
    })).then(() => elasticlunr.Index.load(window.search.index));
    window.trialbookSearch = async asked => (await load()).search(asked, window.search.search_options)
        .map(({ ref, doc }) => ({ at: window.search.doc_urls[ref], title: doc.title, page: doc.breadcrumbs.split(' » ')[0] }));
    Object.assign(window.trialbookSearch, { load, letters });
})();
