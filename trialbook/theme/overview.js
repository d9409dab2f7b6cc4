// The marks of claims, and the first page's field. Without this script the ledger and the indexes say the same.
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
        // A chapter has no room for it, and the claims themselves below.
        if (strip.closest('.front')) strip.after(says);
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

    // The field answers with the first that the search of the book finds.
    all('form.ask').forEach(form => {
        const field = form.querySelector('input'), answers = form.querySelector('.answers');
        let loading;
        const load = () => loading ||= Promise.all([window.trialbookSearch.load(), new Promise((done, failed) => {
            const script = document.createElement('script');
            script.src = form.dataset.answers;
            script.onload = done;
            script.onerror = failed;
            document.head.append(script);
        })]);
        const answer = async () => {
            const asked = field.value;
            delete answers.dataset.asked;
            if (!asked.trim()) { answers.replaceChildren(); return; }
            if (!window.trialbookAnswers) answers.textContent = '…';
            await load();
            const hits = await window.trialbookSearch(asked);
            if (asked !== field.value) return;
            const { claims } = window.trialbookAnswers;
            const item = ({ at, title, page }) => {
                const claim = claims.find(claim => claim.at === at);
                return claim ? `<li>${claim.verdict} <a href="${at}">${escape(claim.name === claim.title ? claim.title : `${claim.name} ${claim.title}`)}</a>
                    <span class="formula">${claim.formula}</span><small>${escape(claim.says).replace(/(\d)e-(\d+)/, '$1 × 10<sup>−$2</sup>')}</small></li>`
                    : `<li><a href="${at}">${escape(title)}</a>${page === title ? '' : ` <small>${escape(page)}</small>`}</li>`;
            };
            const more = hits.length > 4 ? `<p><a href="?search=${encodeURIComponent(asked)}">${hits.length - 4} more</a></p>` : '';
            answers.innerHTML = hits.length ? `<ul>${hits.slice(0, 4).map(item).join('')}</ul>${more}`
                : '<p>Nothing found: try an equation’s number, a symbol such as λc, a value such as 0.537, or a word.</p>';
            answers.dataset.asked = asked;
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
