// A plot that the explorers draw in: axes, curves, areas, and a hand that the reader moves.
'use strict';

window.SlipbookPlot = (() => {
    const WIDTH = 380;
    const MARGIN = { left: 52, right: 18, top: 30, bottom: 46 };
    const number = x => (Math.abs(x) < 1e-12 ? 0 : Number(x.toPrecision(10))).toString().replace('-', '−');
    const escape = text => String(text).replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/"/g, '&quot;');
    const colour = series => series === undefined ? 'currentColor' : `var(--explore-${series})`;

    // A label in which `_x` is a subscript; few systems have a `𝔴`, the formulas' face has it in the place of the w. In one
    // pass: what has become markup is not read again.
    const letter = c => c === '𝔴' ? '<tspan font-family="KaTeX_Fraktur">w</tspan>' : escape(c);
    const label = text => String(text).replace(/_(.)|./gsu, (c, low) => low === undefined ? letter(c)
        : `<tspan dy="4" font-size="13.5">${letter(low)}</tspan><tspan dy="-4">​</tspan>`);

    // Round numbers between two ends, about five of them.
    function ticks([from, to]) {
        const rough = (to - from) / 5;
        const unit = 10 ** Math.floor(Math.log10(rough));
        const step = [1, 2, 5, 10].map(n => n * unit).find(s => s >= rough);
        const first = Math.ceil(from / step - 1e-9);
        const count = Math.floor(to / step + 1e-9) - first;
        return Array.from({ length: count + 1 }, (_, i) => [(first + i) * step, number((first + i) * step)]);
    }

    return class Plot {
        // A number with so many digits after the point, as a reader writes it.
        static fixed(x, digits = 4) {
            return x.toFixed(digits).replace(/^-(0\.?0*)$/, '$1').replace('-', '−');
        }

        // options: title, label (for those who do not see it), x and y (label, range, ticks), height or equal (the same
        // scale along both axes), hand (label, move(x, y), step(dx, dy)).
        constructor(host, id, options) {
            this.options = options;
            this.id = id;
            host.insertAdjacentHTML('beforeend', '<svg class="explore-plot"><g class="back"></g></svg>');
            this.svg = host.lastElementChild;
            this.svg.setAttribute('role', options.hand ? 'group' : 'img');
            this.svg.setAttribute('aria-label', options.label);
            this.back = this.svg.firstElementChild;
            if (options.hand) this.giveHand(options.hand);
        }

        giveHand(hand) {
            this.svg.insertAdjacentHTML('beforeend', `<g class="hand" tabindex="0" role="slider" aria-label="${escape(hand.label)}"
                aria-valuemin="${hand.range[0]}" aria-valuemax="${hand.range[1]}"><circle class="reach" r="26"/><circle r="8"/></g>`);
            this.hand = this.svg.lastElementChild;
            const move = event => {
                const [x, y] = this.place(event);
                hand.move(x, y);
            };
            // A finger that begins beside the hand scrolls the page; its tap moves the hand.
            this.svg.addEventListener('pointerdown', event => {
                if (event.button !== 0 || (event.pointerType !== 'mouse' && !this.hand.contains(event.target))) return;
                this.svg.setPointerCapture(event.pointerId);
                this.held = true;
                move(event);
                this.hand.focus({ preventScroll: true });
                event.preventDefault();
            });
            this.svg.addEventListener('pointermove', event => this.held && move(event));
            for (const end of ['pointerup', 'pointercancel']) this.svg.addEventListener(end, () => { this.held = false; });
            this.svg.addEventListener('click', move);
            this.hand.addEventListener('keydown', event => {
                const ways = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] };
                const way = ways[event.key];
                if (!way || event.altKey || event.ctrlKey || event.metaKey) return;
                event.preventDefault();
                hand.step(...way.map(d => d * (event.shiftKey ? 10 : 1)));
            });
        }

        // The place of a pointer, in the units of the axes.
        place(event) {
            const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.svg.getScreenCTM().inverse());
            const { x, y } = this.axes;
            return [
                x[0] + (at.x - MARGIN.left) / (WIDTH - MARGIN.left - MARGIN.right) * (x[1] - x[0]),
                y[1] - (at.y - MARGIN.top) / (this.height - MARGIN.top - MARGIN.bottom) * (y[1] - y[0]),
            ];
        }

        // Draws anew. marks: { points, series, fill, dash, faint, dots, text, band }; hand: where it is, and in words.
        draw({ x = this.options.x.range, y = this.options.y.range, marks, hand, words }) {
            const wide = WIDTH - MARGIN.left - MARGIN.right;
            const high = this.options.equal ? wide * (y[1] - y[0]) / (x[1] - x[0]) : this.options.height || 220;
            this.axes = { x, y };
            this.height = high + MARGIN.top + MARGIN.bottom;
            this.svg.setAttribute('viewBox', `0 0 ${WIDTH} ${this.height}`);
            const at = (u, v) => [
                (MARGIN.left + (u - x[0]) / (x[1] - x[0]) * wide).toFixed(2),
                (MARGIN.top + (y[1] - v) / (y[1] - y[0]) * high).toFixed(2),
            ];
            const frame = `x="${MARGIN.left}" y="${MARGIN.top}" width="${wide}" height="${high}"`;
            const clip = `${this.id}-clip`;
            const parts = [`<clipPath id="${clip}"><rect ${frame}/></clipPath>`];
            for (const [u, name] of this.options.x.ticks || ticks(x)) {
                const [px] = at(u, y[0]);
                parts.push(`<path class="grid" d="M${px} ${MARGIN.top}v${high}"/>
                    <text x="${px}" y="${MARGIN.top + high + 18}" text-anchor="middle">${label(name)}</text>`);
            }
            for (const [v, name] of this.options.y.ticks || ticks(y)) {
                const [, py] = at(x[0], v);
                parts.push(`<path class="grid" d="M${MARGIN.left} ${py}h${wide}"/>
                    <text x="${MARGIN.left - 6}" y="${py}" dy="5" text-anchor="end">${label(name)}</text>`);
            }
            parts.push(`<rect class="frame" ${frame}/>
                <text x="${MARGIN.left}" y="20" class="title">${label(this.options.title)}</text>
                <text x="${MARGIN.left + wide / 2}" y="${this.height - 8}" text-anchor="middle">${label(this.options.x.label)}</text>
                <text transform="translate(13 ${MARGIN.top + high / 2}) rotate(-90)" text-anchor="middle">${label(this.options.y.label)}</text>`);
            parts.push(`<g clip-path="url(#${clip})">`);
            for (const mark of marks) parts.push(this.mark(mark, at));
            parts.push('</g>');
            this.back.innerHTML = parts.join('');
            this.at = at;
            this.now(null);
            if (this.hand) {
                const [px, py] = at(...hand);
                this.hand.setAttribute('transform', `translate(${px} ${py})`);
                this.hand.setAttribute('aria-valuenow', words.now);
                this.hand.setAttribute('aria-valuetext', words.text);
            }
        }

        // Where the bodies on the stage are now.
        now(point) {
            if (!point) {
                this.spot?.remove();
                this.spot = null;
                return;
            }
            if (!this.spot) {
                this.back.insertAdjacentHTML('beforeend', '<circle class="now" r="6"/>');
                this.spot = this.back.lastElementChild;
            }
            this.spot.setAttribute('transform', `translate(${this.at(...point).join(' ')})`);
        }

        mark({ points = [], series, fill, dash, faint, dots, text, band }, at) {
            const pairs = [];
            for (let i = 0; i < points.length; i += 2) pairs.push(at(points[i], points[i + 1]));
            if (dots) return pairs.map(([u, v]) => `<circle cx="${u}" cy="${v}" r="${dots}" fill="${colour(series)}"/>`).join('');
            if (text) return pairs.map(([u, v]) => `<text class="note" x="${u}" y="${v}" text-anchor="middle">${label(text)}</text>`).join('');
            if (band) {
                const [[left], [right]] = band.map(u => at(u, 0));
                return `<rect x="${left}" y="0" width="${right - left}" height="${this.height}" fill="${colour(series)}" opacity="${fill}"/>`;
            }
            if (!pairs.length) return '';
            const path = `d="M${pairs.map(pair => pair.join(' ')).join('L')}"`;
            if (fill) return `<path ${path} fill="${colour(series)}" opacity="${fill}"/>`;
            return `<path ${path} class="curve" stroke="${colour(series)}" ${dash ? 'stroke-dasharray="7 5"' : ''} ${faint ? 'opacity="0.35"' : ''}/>`;
        }
    };
})();
