// The first page's field and marks. Without this script the ledger and the indexes say the same.
(() => {
    'use strict';
    const all = (selector, within = document) => [...within.querySelectorAll(selector)];
    const escape = text => String(text).replace(/[&<>"]/g, c => `&#${c.charCodeAt(0)};`);

    // One mark is in the order of tabs; the arrow keys lead on from it.
    all('.skeleton').forEach(strip => {
        const marks = all('a', strip);
        const says = document.createElement('p');
        says.className = 'skeleton-says';
        says.textContent = strip.getAttribute('aria-label');
        strip.after(says);
        const go = i => {
            const mark = marks[Math.max(0, Math.min(marks.length - 1, i))];
            marks.forEach(other => { other.tabIndex = other === mark ? 0 : -1; });
            mark.focus();
        };
        marks.forEach((mark, i) => {
            const tell = () => { says.textContent = mark.getAttribute('aria-label'); };
            mark.addEventListener('mouseenter', tell);
            mark.addEventListener('focus', tell);
            mark.addEventListener('keydown', event => {
                const way = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1, End: marks.length, Home: -marks.length }[event.key];
                if (!way || event.altKey || event.ctrlKey || event.metaKey) return;
                event.preventDefault();
                // mdBook turns pages with the arrow keys.
                event.stopPropagation();
                go(i + way);
            });
        });
    });

    // The field: an equation's number, a symbol, a number to as many digits as one has, or words.
    const NAMES = { alpha: 'α', theta: 'θ', kappa: 'κ', lambda: 'λ', mu: 'μ', xi: 'ξ', pi: 'π', rho: 'ρ', sigma: 'σ', tau: 'τ', phi: 'φ', psi: 'ψ', omega: 'ω', varpi: 'ϖ' };
    const HIGH = { '⁰': 0, '¹': 1, '²': 2, '³': 3, '⁴': 4, '⁵': 5, '⁶': 6, '⁷': 7, '⁸': 8, '⁹': 9 };
    const LOW = { '₀': 0, '₁': 1, '₂': 2, '₃': 3, '₄': 4 };
    const flat = text => text.toLowerCase()
        .replace(/[a-z]{2,}/g, word => NAMES[word] || word)
        .replace(/[⁰¹²³⁴⁵⁶⁷⁸⁹]/g, c => `^${HIGH[c]}`).replace(/[₀-₄]/g, c => LOW[c])
        .replace(/[\s_()\[\]]+/g, '');

    function found({ claims, symbols, values }, asked) {
        const of = (id, why) => ({ claim: claims.find(claim => claim.id === id), why });
        const number = asked.match(/^\W*(?:eq(?:uation|n)?s?\W*)?(\d{1,3})\W*$/i) || asked.match(/(?:eq\w*\W*|\()(\d{1,3})\b/i);
        if (number) {
            const claim = claims.find(claim => claim.equation === Number(number[1]));
            if (claim) return [{ claim }];
        }
        const decimal = asked.trim().replace('−', '-').match(/^-?\d*\.(\d+)$/);
        if (decimal) {
            // As a reader rounds, or cuts off.
            const unit = 10 ** -decimal[1].length;
            return values.map(value => [Math.abs(Number(value.is) - Number(decimal[0])), value])
                .filter(([off]) => off < unit).sort(([a], [b]) => a - b)
                .map(([, value]) => of(value.id, `${value.is}: ${value.means}`));
        }
        const plain = flat(asked);
        if (!plain) return [];
        const bySymbol = symbols.filter(symbol => flat(symbol.is) === plain).map(symbol => of(symbol.id, `${symbol.is}: ${symbol.means}`));
        if (bySymbol.length) {
            const ids = new Set(bySymbol.map(({ claim }) => claim?.id));
            const defines = claims.filter(claim => !ids.has(claim.id) && flat(claim.plain).startsWith(`${plain}=`));
            return [...bySymbol.filter(({ claim }) => claim), ...defines.map(claim => ({ claim }))];
        }
        const words = asked.toLowerCase().split(/[\s-]+/).filter(word => word && !['is', 'the', 'of', 'right', 'wrong', 'true', 'in', 'paper', 'what'].includes(word));
        const score = claim => {
            const text = `${claim.name} ${claim.title} ${claim.id}`.toLowerCase();
            if (words.length && words.every(word => text.includes(word))) return 2;
            return plain.length > 1 && flat(claim.plain).includes(plain) ? 1 : 0;
        };
        const byWords = claims.map(claim => [score(claim), claim]).filter(([points]) => points)
            .sort(([a], [b]) => b - a).map(([, claim]) => ({ claim }));
        return byWords;
    }

    all('form.ask').forEach(form => {
        const field = form.querySelector('input'), answers = form.querySelector('.answers');
        let loading;
        const load = () => loading ||= new Promise((done, failed) => {
            const script = document.createElement('script');
            script.src = form.dataset.answers;
            script.onload = done;
            script.onerror = failed;
            document.head.append(script);
        });
        const answer = async () => {
            const asked = field.value;
            if (!asked.trim()) { answers.replaceChildren(); return; }
            await load();
            if (asked !== field.value) return;
            const hits = found(window.trialbookAnswers, asked);
            const item = ({ claim, why }) => `<li>${claim.verdict} <a href="${claim.at}">${escape(claim.name === claim.title ? claim.title : `${claim.name} ${claim.title}`)}</a>
                <span class="formula">${claim.formula}</span>${why ? `<small>${escape(why)}</small>` : ''}<small>${escape(claim.says)}</small></li>`;
            const more = hits.length > 4 ? `<p>${hits.length - 4} more: the search of the book has them.</p>` : '';
            answers.innerHTML = hits.length ? `<ul>${hits.slice(0, 4).map(item).join('')}</ul>${more}`
                : '<p>Nothing found: try an equation’s number, a symbol such as λc, a value such as 0.537, or a word.</p>';
        };
        field.addEventListener('focus', load, { once: true });
        field.addEventListener('input', answer);
        // mdBook has shortcuts on single letters.
        field.addEventListener('keydown', event => event.stopPropagation());
        form.addEventListener('submit', event => {
            event.preventDefault();
            answer().then(() => answers.querySelector('a')?.focus());
        });
        form.hidden = false;
    });
})();
