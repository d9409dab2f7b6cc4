// What the pages do beyond standing there. Without this script nothing is lost but comfort.
(() => {
    'use strict';
    const all = (selector, within = document) => [...within.querySelectorAll(selector)];

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

    // A formula or table wider than its place scrolls: then it can be reached by keyboard.
    const reachable = box => {
        const scrolls = box.scrollWidth > box.clientWidth + 1;
        if (scrolls && !box.hasAttribute('tabindex')) {
            box.tabIndex = 0;
            box.setAttribute('role', 'group');
            box.setAttribute('aria-label', box.matches('.katex-display') ? 'formula, scrolls' : 'scrolls');
        } else if (!scrolls && box.getAttribute('aria-label')?.endsWith('scrolls')) {
            ['tabindex', 'role', 'aria-label'].forEach(name => box.removeAttribute(name));
        }
    };
    const widths = new ResizeObserver(entries => entries.forEach(entry => reachable(entry.target)));
    all('.katex-display, .claim-words, .table-wrapper, .says, .map-window').forEach(box => widths.observe(box));

    // On paper answers and lists are not folded away, for browsers whose styles cannot say so.
    let closed = [];
    addEventListener('beforeprint', () => {
        closed = all('details:not([class]):not([open])');
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

    // The map of claims: zoom, drag, and what rests on the claim under the pointer.
    all('#plot-map').forEach(figure => {
        const view = figure.querySelector('.map-window'), map = view?.querySelector('svg');
        if (!map) return;
        const width = map.viewBox.baseVal.width;
        let scale = 1;
        const zoom = (to, x = view.clientWidth / 2, y = view.clientHeight / 2) => {
            to = Math.min(2.5, Math.max(Math.min(1, view.clientWidth / width), to));
            const [left, top] = [(view.scrollLeft + x) / scale, (view.scrollTop + y) / scale];
            scale = to;
            map.style.width = `${width * scale}px`;
            map.style.height = 'auto';
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
        view.before(bar);
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

        const steps = all('.step', map), nodes = all('.node', map);
        const light = start => {
            const lit = new Set([start]);
            for (let before = -1; before !== lit.size;) {
                before = lit.size;
                steps.forEach(step => lit.has(step.dataset.from) && lit.add(step.dataset.to));
            }
            map.classList.add('chosen');
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
