// What one means comes first: a claim by its number, its id or its name, a symbol by the claim that introduces it, and the places
// that are to answer to certain words. Without this script the search ranks by words alone.
(() => {
    'use strict';
    if (!window.elasticlunr) return;
    const GREEK = { alpha: 'α', beta: 'β', gamma: 'γ', delta: 'δ', zeta: 'ζ', eta: 'η', theta: 'θ', kappa: 'κ', lambda: 'λ', mu: 'μ', xi: 'ξ',
        pi: 'π', rho: 'ρ', sigma: 'σ', tau: 'τ', phi: 'φ', psi: 'ψ', omega: 'ω', varpi: 'ϖ' };
    const HIGH = '⁰¹²³⁴⁵⁶⁷⁸⁹', LOW = '₀₁₂₃₄₅₆₇₈₉';
    // What one asks around the name of what one means.
    const AROUND = new Set(['eq', 'equation', 'is', 'are', 'the', 'a', 'in', 'of', 'paper', 'right', 'wrong', 'true', 'false', 'correct']);
    // However it is typed: `λ_c`, `lambda c` and `λc` are the same, `Y` and `y` are not.
    const key = words => words.map(word => word.replace(/[A-Za-z]+/g, name => GREEK[name.toLowerCase()] || name)).join('')
        .replace(/[⁰¹²³⁴⁵⁶⁷⁸⁹]/g, c => `^${HIGH.indexOf(c)}`)
        .replace(/[₀₁₂₃₄₅₆₇₈₉]/g, c => LOW.indexOf(c))
        .replace(/[_()[\]]/g, '');
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
        const words = split(asked), meant = words.filter(word => !AROUND.has(word.toLowerCase()));
        const names = [words, meant].map(key).flatMap(name => [name, `any ${name.toLowerCase()}`]);
        return places.get(names.find(name => places.has(name))) || [];
    };

    const { prototype } = elasticlunr.Index;
    const byWords = prototype.search;
    prototype.search = function (asked, options) {
        const found = byWords.call(this, asked, options);
        const first = named(asked);
        const result = ref => found.find(one => one.ref === ref) || { ref, score: 0, doc: this.documentStore.getDoc(ref) };
        return [...first.map(result), ...found.filter(one => !first.includes(one.ref))];
    };
})();
