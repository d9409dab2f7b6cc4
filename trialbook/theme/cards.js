// A card beside a link to a claim or a symbol: what it is, while one points at it.
(() => {
    'use strict';
    const here = document.currentScript.src;
    const main = document.querySelector('main');
    const page = location.pathname.split('/').pop() || 'index.html';
    if (!main) return;

    let loading;
    const load = () => loading ||= window.trialbookAnswers ? Promise.resolve() : new Promise((done, failed) => {
        const script = document.createElement('script');
        script.src = new URL('../answers.js', here);
        script.onload = done;
        script.onerror = failed;
        document.head.append(script);
    });

    const escape = text => String(text).replace(/[&<>"]/g, c => `&#${c.charCodeAt(0)};`);
    // λ_c and λc, θ₀ and θ0 are one.
    const flat = text => text.normalize('NFKC').replace(/[_\s\u2061-\u2064\u200b]/g, '');
    const named = claim => `${claim.verdict} <a href="${claim.at}">${escape(claim.name === claim.title ? claim.title : `${claim.name} ${claim.title}`)}</a>`;

    function words(target) {
        const { claims, symbols } = window.trialbookAnswers;
        if (target.matches('.katex')) {
            const sought = flat(target.querySelector('math')?.textContent || '');
            const same = symbols.filter(symbol => sought && flat(symbol.is) === sought)
                .map(symbol => ({ ...symbol, claim: claims.find(claim => claim.id === symbol.id) })).filter(({ claim }) => claim);
            // A letter may mean something else in another chapter.
            const symbol = same.find(({ claim }) => claim.at.startsWith(page)) || same[0];
            return symbol && `<p><b>${escape(symbol.is)}</b> ${escape(symbol.means)}, ${named(symbol.claim)}</p>`;
        }
        const address = target.getAttribute('href');
        const claim = claims.find(claim => claim.at === address || address === `#${claim.id}`);
        return claim && `<p>${named(claim)}</p><p class="formula">${claim.formula}</p><p>${escape(claim.says).replace(/(\d)e-(\d+)/, '$1 × 10<sup>−$2</sup>')}</p>`;
    }

    const card = document.createElement('div');
    card.className = 'card';
    card.hidden = true;
    main.append(card);
    let shown, waiting, title = '';
    const hide = () => {
        clearTimeout(waiting);
        card.hidden = true;
        if (shown && title) shown.title = title;
        shown = null;
    };
    const show = async target => {
        await load();
        const html = words(target);
        if (!html || waiting !== target.waits) return;
        hide();
        shown = target;
        title = target.title;
        target.removeAttribute('title');
        card.innerHTML = html;
        card.hidden = false;
        const box = target.getBoundingClientRect();
        const { offsetWidth: wide, offsetHeight: high } = card;
        card.style.left = `${Math.max(8, Math.min(box.left, document.documentElement.clientWidth - wide - 8))}px`;
        card.style.top = `${box.bottom + high + 8 < innerHeight ? box.bottom + 4 : Math.max(8, box.top - high - 4)}px`;
    };
    const soon = (target, act, delay) => {
        clearTimeout(waiting);
        waiting = setTimeout(act, delay);
        if (target) target.waits = waiting;
    };
    const KINDS = 'a[href*="#"]:not(.header), p .katex, li .katex';
    main.addEventListener('pointerover', event => {
        if (event.target.closest('.card')) {
            clearTimeout(waiting);
            return;
        }
        const target = event.target.closest(KINDS);
        if (target === shown && shown) clearTimeout(waiting);
        else if (target && !target.closest('.katex-display, .explorer')) soon(target, () => show(target), 250);
        else if (shown) soon(null, hide, 300);
        else clearTimeout(waiting);
    });
    main.addEventListener('focusin', event => event.target.matches('p a[href*="#"], li a[href*="#"]') && soon(event.target, () => show(event.target), 400));
    main.addEventListener('focusout', event => event.target === shown && !card.contains(event.relatedTarget) && hide());
    addEventListener('keydown', event => event.key === 'Escape' && hide());
    // What is focused from the keyboard scrolls into view first.
    addEventListener('scroll', () => shown && hide(), { passive: true });
})();
