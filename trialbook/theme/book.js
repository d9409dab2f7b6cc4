// What the pages do beyond standing there. Without this script nothing is lost but comfort.
(() => {
    'use strict';
    const all = (selector, within = document) => [...within.querySelectorAll(selector)];

    // Past the contents, for the keyboard.
    const main = document.querySelector('main');
    if (main) {
        main.id ||= 'main';
        main.tabIndex = -1;
        document.body.insertAdjacentHTML('afterbegin', `<a class="skip" href="#${main.id}">Skip to the page</a>`);
    }

    // mdBook's bar is a landmark, and what opens the contents a button: a label is none to the keyboard.
    document.getElementById('mdbook-menu-bar')?.setAttribute('role', 'banner');
    all('label#mdbook-sidebar-toggle').forEach(label => {
        const box = document.getElementById(label.htmlFor);
        const button = document.createElement('button');
        button.type = 'button';
        button.className = label.className;
        button.innerHTML = label.innerHTML;
        ['title', 'aria-label', 'aria-controls'].forEach(name => button.setAttribute(name, label.getAttribute(name)));
        const tell = () => button.setAttribute('aria-expanded', box.checked);
        button.addEventListener('click', () => label.click());
        box.addEventListener('change', tell);
        tell();
        label.style.display = 'none';
        label.after(button);
    });

    // A heading's link to itself is for the mouse; every box has its address in its evidence.
    all('main a.header').forEach(link => { link.tabIndex = -1; });

    // A path or the name of a field is broken between its parts.
    all('td code').forEach(code => {
        if (code.childElementCount || code.textContent.length < 12) return;
        code.replaceChildren(...code.textContent.split(/(?<=[./_\]])(?![.\]])/).flatMap((part, i) => i ? [document.createElement('wbr'), part] : [part]));
    });

    // A formula or table wider than its place scrolls: then it can be reached by keyboard.
    const fades = box => box.classList.toggle('more', box.scrollLeft + box.clientWidth < box.scrollWidth - 2);
    const reachable = box => {
        const scrolls = box.scrollWidth > box.clientWidth + 1;
        // The rows of a table cover what is behind them: its edge fades where there is more.
        if (box.matches('.table-wrapper') && (scrolls || box.matches('.more'))) fades(box);
        if (scrolls && !box.hasAttribute('tabindex')) {
            box.tabIndex = 0;
            box.setAttribute('role', 'group');
            box.setAttribute('aria-label', box.matches('.katex-display') ? 'formula, scrolls' : 'scrolls');
        } else if (!scrolls && box.getAttribute('aria-label')?.endsWith('scrolls')) {
            ['tabindex', 'role', 'aria-label'].forEach(name => box.removeAttribute(name));
        }
    };
    const widths = new ResizeObserver(entries => entries.forEach(entry => reachable(entry.target)));
    all('.katex-display, .steps, .claim-words, .table-wrapper, .says, .map-window').forEach(box => widths.observe(box));
    addEventListener('scroll', ({ target }) => target.matches?.('.table-wrapper') && fades(target), { capture: true, passive: true });

    // On paper answers are not folded away, for browsers whose styles cannot say so; all else is as it is seen.
    let closed = [];
    addEventListener('beforeprint', () => {
        closed = all('.exercise details:not([open])');
        closed.forEach(box => { box.open = true; });
    });
    addEventListener('afterprint', () => closed.forEach(box => { box.open = false; }));

    // A link to something folded away opens it.
    const unfold = () => {
        const target = location.hash && document.getElementById(decodeURIComponent(location.hash.slice(1)));
        for (let box = target; box; box = box.parentElement) {
            if (box.tagName === 'DETAILS') box.open = true;
        }
    };
    addEventListener('hashchange', unfold);
    unfold();

    // What stands above a link's target is laid out when one comes there: the target is looked for until it stays where it is.
    const land = (pictures = 6) => {
        const target = location.hash && document.getElementById(decodeURIComponent(location.hash.slice(1)));
        if (!target || !pictures) return;
        target.scrollIntoView({ behavior: 'instant' });
        requestAnimationFrame(() => land(pictures - 1));
    };
    addEventListener('hashchange', () => land());
    addEventListener('load', () => land());

    // Who reads sees the boxes folded, who audits unfolded: a switch, remembered.
    const folds = all('.evidence, .proof, .samples, .listing').filter(fold => fold.matches('.listing') || fold.closest('.claim'));
    const place = document.querySelector('#mdbook-menu-bar .right-buttons');
    if (folds.length && place) {
        const key = 'trialbook-evidence';
        const remember = on => { try { localStorage.setItem(key, on); } catch { /* Then it lasts for this page. */ } };
        const remembered = () => { try { return localStorage.getItem(key) === 'true'; } catch { return false; } };
        const button = document.createElement('button');
        button.type = 'button';
        button.className = 'audit';
        button.textContent = 'Evidence';
        button.title = 'Unfold all evidence and all code';
        const put = on => {
            button.setAttribute('aria-pressed', on);
            folds.forEach(fold => { fold.open = on || fold.matches('.disagrees .samples'); });
        };
        button.addEventListener('click', () => {
            const on = button.getAttribute('aria-pressed') !== 'true';
            const seen = all('.claim').find(box => box.getBoundingClientRect().bottom > 60);
            const top = seen?.getBoundingClientRect().top;
            put(on);
            remember(on);
            // What one was looking at stays where it is.
            if (seen) scrollBy(0, seen.getBoundingClientRect().top - top);
        });
        put(remembered());
        place.prepend(button);
        unfold();
    }

    // The last group of pages is for those who use it in a work of their own: closed, but for who reads one of them.
    const contents = document.getElementById('mdbook-sidebar'), group = contents && all('.part-title', contents).at(-1);
    const grouped = group ? all('li', group.parentElement).slice(all('li', group.parentElement).indexOf(group) + 1) : [];
    if (grouped.length && !grouped.some(item => item.querySelector('.active'))) {
        const button = document.createElement('button');
        button.type = 'button';
        button.className = 'group';
        button.textContent = group.textContent;
        const put = open => {
            button.setAttribute('aria-expanded', open);
            grouped.forEach(item => { item.hidden = !open; });
        };
        button.addEventListener('click', () => put(button.getAttribute('aria-expanded') === 'false'));
        put(false);
        group.replaceChildren(button);
    }

    // The verdict of a claim, in the list of the page's headings and among what the search finds.
    const marked = new Map(all('.claim').map(box => [box.getAttribute('aria-labelledby'), box.className.split(' ')[1]]));
    const parts = () => all('a[href*="#"]:not(.marked)', contents);
    const markContents = () => {
        all('a[href*="#"]', contents).forEach(link => {
            const slug = marked.get(decodeURIComponent(link.hash.slice(1)));
            if (!slug) return;
            link.classList.add('marked', slug);
            // Who goes from link to link meets each claim once, on the page.
            link.tabIndex = -1;
        });
        // One of the page's parts is in the order of tabs; the arrow keys lead on from it.
        if (!parts().some(link => link === document.activeElement)) parts().forEach((link, i) => { link.tabIndex = i ? -1 : 0; });
    };
    if (marked.size && contents) {
        new MutationObserver(markContents).observe(contents, { childList: true, subtree: true });
        contents.addEventListener('keydown', event => {
            const way = { ArrowDown: 1, ArrowUp: -1 }[event.key], links = parts(), at = links.indexOf(event.target), next = links[at + way];
            if (at < 0 || !next || event.altKey || event.ctrlKey || event.metaKey) return;
            event.preventDefault();
            links.forEach(link => { link.tabIndex = link === next ? 0 : -1; });
            next.focus();
        });
        markContents();
    }
    const results = document.getElementById('mdbook-searchresults');
    const markResults = () => all('a:not(.marked)', results).forEach(link => {
        const [slug, words] = window.search?.verdicts?.[`${link.pathname.split('/').pop()}${link.hash}`] || [];
        if (!slug) return;
        link.classList.add('marked', slug);
        link.title = words;
    });
    if (results) new MutationObserver(markResults).observe(results, { childList: true });

    // The LaTeX of a claim, copied by a button.
    const copy = async text => {
        try {
            await navigator.clipboard.writeText(text);
        } catch {
            const field = document.body.appendChild(document.createElement('textarea'));
            field.value = text;
            field.select();
            document.execCommand('copy');
            field.remove();
        }
    };
    all('details.latex').forEach(box => {
        const button = document.createElement('button');
        button.type = 'button';
        button.className = 'copy-latex';
        button.textContent = 'Copy LaTeX';
        button.addEventListener('click', async () => {
            await copy(all('code', box).map(code => code.textContent).join('\n'));
            button.textContent = 'Copied';
            setTimeout(() => { button.textContent = 'Copy LaTeX'; }, 1500);
        });
        box.before(button);
    });

    // Long tables: a field that keeps the rows with all its words, and headings that sort. In the ledger the table of counts keeps
    // the rows of a verdict, and a switch the numbered claims.
    const bars = new Set(['ledger', 'values', 'symbols', 'accuracy']);
    const tables = all('.table-wrapper').filter(box => [...box.classList].some(name => bars.has(name)));
    const long = tables.some(box => all('tbody tr', box).length > 12);
    if (long && !document.querySelector('.claim')) {
        const bar = document.createElement('div');
        bar.className = 'filter';
        const ledger = tables[0].matches('.ledger');
        bar.innerHTML = `<label>Only rows with <input type="search" autocomplete="off" placeholder="${ledger ? 'inherits, τ' : '0.537, τ'}"></label>
            ${ledger ? '<label><input type="checkbox"> numbered only</label>' : ''} <span role="status"></span>`;
        const [field, numbered] = all('input', bar), said = bar.querySelector('span');
        const kinds = (ledger ? all('.counts .verdict') : []).map(mark => {
            const button = document.createElement('button');
            button.type = 'button';
            button.className = mark.className;
            button.innerHTML = mark.innerHTML;
            button.setAttribute('aria-pressed', false);
            mark.replaceWith(button);
            return button;
        });
        // Where no script of the page's own reads the formula, its source would be read twice: as MathML and as HTML.
        const text = row => {
            const copy = row.cloneNode(true);
            all('.katex-html, annotation', copy).forEach(part => part.remove());
            const fails = copy.querySelector('.verdict:is(.misprint, .misderived, .inherited, .refuted)');
            return `${copy.textContent} ${fails ? 'wrong false' : ''}`.toLowerCase();
        };
        let rows;
        const filter = () => {
            rows ||= tables.flatMap(box => all('tbody tr', box)).map(row => [row, text(row)]);
            // `tau` is τ.
            const letters = window.trialbookSearch?.letters || (word => word);
            const words = field.value.toLowerCase().split(/\s+/).filter(Boolean);
            const kind = kinds.find(button => button.getAttribute('aria-pressed') === 'true')?.classList[1];
            let shown = 0;
            rows.forEach(([row, has]) => {
                row.hidden = !words.every(word => has.includes(word) || has.includes(letters(word)))
                    || Boolean(kind && !row.querySelector(`.verdict.${kind}`)) || Boolean(numbered?.checked && !/^\(\d/.test(has));
                shown += !row.hidden;
            });
            said.textContent = shown < rows.length ? `${shown} of ${rows.length}` : '';
            // A table of which no row is left goes, with what stands between it and the one before, the field aside.
            tables.forEach((box, k) => {
                box.hidden = all('tbody tr', box).every(row => row.hidden);
                for (let above = box.previousElementSibling; tables.length > 1 && above && above !== bar && above !== tables[k - 1]; above = above.previousElementSibling) {
                    above.hidden = box.hidden;
                }
            });
        };
        field.addEventListener('input', filter);
        field.addEventListener('keydown', event => event.stopPropagation());
        numbered?.addEventListener('change', filter);
        kinds.forEach(button => button.addEventListener('click', () => {
            const on = button.getAttribute('aria-pressed') === 'true';
            kinds.forEach(other => other.setAttribute('aria-pressed', other === button && !on));
            filter();
        }));
        // Above the heading of the first of several tables, beside the only one.
        let first = tables[0];
        while (tables.length > 1 && first && !first.matches('h2')) first = first.previousElementSibling;
        (first || tables[0]).before(bar);
        const number = text => Number(text.replace(/[,\s]/g, '').replace('−', '-').match(/^\(?(-?[\d.]+)/)?.[1] ?? NaN);
        tables.forEach(box => all('th', box).forEach((head, k) => {
            const button = document.createElement('button');
            button.type = 'button';
            button.className = 'sort';
            button.innerHTML = head.innerHTML;
            head.replaceChildren(button);
            button.addEventListener('click', () => {
                const down = head.getAttribute('aria-sort') === 'ascending';
                all('th', box).forEach(other => other.removeAttribute('aria-sort'));
                head.setAttribute('aria-sort', down ? 'descending' : 'ascending');
                const cell = row => row.cells[k].textContent.trim();
                const sorted = all('tbody tr', box).sort((a, b) => {
                    const [x, y] = [number(cell(a)), number(cell(b))];
                    const order = Number.isNaN(x) || Number.isNaN(y) ? cell(a).localeCompare(cell(b)) : x - y;
                    return down ? -order : order;
                });
                box.querySelector('tbody').append(...sorted);
            });
        }));
    }

    // The map of claims: zoom, drag, and what rests on the claim under the pointer.
    all('#plot-map').forEach(figure => {
        const view = figure.querySelector('.map-window'), map = view?.querySelector('svg');
        if (!map) return;
        const width = map.viewBox.baseVal.width;
        let scale = 1;
        const sized = () => {
            figure.classList.toggle('whole', width * scale <= view.clientWidth + 1);
            // What is too small to read gives its place to signs.
            figure.classList.toggle('small', scale < 0.75);
        };
        const zoom = (to, x = view.clientWidth / 2, y = view.clientHeight / 2) => {
            to = Math.min(2.5, Math.max(Math.min(1, view.clientWidth / width), to));
            const [left, top] = [(view.scrollLeft + x) / scale, (view.scrollTop + y) / scale];
            scale = to;
            map.style.width = `${width * scale}px`;
            map.style.height = 'auto';
            sized();
            view.scrollTo(left * scale - x, top * scale - y);
        };
        const bar = document.createElement('div');
        bar.className = 'map-bar';
        const button = (label, name, act) => {
            const made = bar.appendChild(document.createElement('button'));
            made.type = 'button';
            made.textContent = label;
            made.setAttribute('aria-label', name);
            made.addEventListener('click', act);
        };
        button('+', 'Zoom in', () => zoom(scale * 1.3));
        button('−', 'Zoom out', () => zoom(scale / 1.3));
        button('Whole map', 'Show the whole map', () => zoom(0));
        button('Only errors', 'Only errors, and what they rest on', event => {
            const on = map.classList.toggle('errors');
            event.target.setAttribute('aria-pressed', on);
        });
        view.before(bar);
        // Where the boxes are small, the whole name of the one that is pointed at.
        const says = document.createElement('p');
        says.className = 'map-says';
        view.before(says);
        view.addEventListener('wheel', event => {
            if (!event.ctrlKey && !event.metaKey) return;
            event.preventDefault();
            const box = view.getBoundingClientRect();
            zoom(scale * Math.exp(-event.deltaY / 300), event.clientX - box.left, event.clientY - box.top);
        }, { passive: false });
        let held = null;
        view.addEventListener('pointerdown', event => {
            if (event.pointerType === 'mouse') held = [event.clientX + view.scrollLeft, event.clientY + view.scrollTop];
        });
        addEventListener('pointermove', event => held && view.scrollTo(held[0] - event.clientX, held[1] - event.clientY));
        addEventListener('pointerup', () => { held = null; });
        map.addEventListener('dragstart', event => event.preventDefault());
        // As it is drawn, that is all of it on a desk. The page has its layout by then.
        new ResizeObserver(sized).observe(view);

        const steps = all('.step', map), nodes = all('.node', map);
        // What is wrong, and all that it rests on.
        const wrong = new Set(nodes.filter(node => node.matches('.misprint, .misderived, .inherited, .refuted')).map(node => node.dataset.node));
        for (let before = -1; before !== wrong.size;) {
            before = wrong.size;
            steps.forEach(step => wrong.has(step.dataset.to) && wrong.add(step.dataset.from));
        }
        nodes.forEach(node => node.classList.toggle('aside', !wrong.has(node.dataset.node)));
        steps.forEach(step => step.classList.toggle('aside', !(wrong.has(step.dataset.from) && wrong.has(step.dataset.to))));
        const light = start => {
            const lit = new Set([start]);
            for (let before = -1; before !== lit.size;) {
                before = lit.size;
                steps.forEach(step => lit.has(step.dataset.from) && lit.add(step.dataset.to));
            }
            map.classList.add('chosen');
            says.textContent = nodes.find(node => node.dataset.node === start).querySelector('title').textContent;
            nodes.forEach(node => node.classList.toggle('lit', lit.has(node.dataset.node)));
            steps.forEach(step => step.classList.toggle('lit', lit.has(step.dataset.from)));
        };
        const dark = () => map.classList.remove('chosen');
        nodes.forEach(node => {
            ['mouseenter', 'focus'].forEach(name => node.addEventListener(name, () => light(node.dataset.node)));
            ['mouseleave', 'blur'].forEach(name => node.addEventListener(name, dark));
        });
    });
})();
