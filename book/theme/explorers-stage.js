// A stage on which bodies move: a film of equal times, played, stepped and drawn along by hand.
'use strict';

window.SlipbookStage = (() => {
    // Below so many pixels a picture is narrow.
    const NARROW = 520;
    const PACES = [['0.25', '¼ ×'], ['0.5', '½ ×'], ['1', '1 ×'], ['2', '2 ×'], ['4', '4 ×']];

    // Noise as loud as the slip is fast, once the reader asks for it.
    class Sound {
        constructor() {
            this.context = new AudioContext();
            const noise = this.context.createBuffer(1, this.context.sampleRate, this.context.sampleRate);
            noise.getChannelData(0).forEach((_, i, data) => { data[i] = Math.random() * 2 - 1; });
            const source = new AudioBufferSourceNode(this.context, { buffer: noise, loop: true });
            const filter = new BiquadFilterNode(this.context, { type: 'bandpass', frequency: 900, Q: 0.7 });
            this.gain = new GainNode(this.context, { gain: 0 });
            source.connect(filter).connect(this.gain).connect(this.context.destination);
            source.start();
        }

        play(slip) {
            this.gain.gain.setTargetAtTime(Math.min(0.4, 0.25 * slip), this.context.currentTime, 0.02);
        }
    }

    return class Stage {
        // The point of a film's curve at a picture, between two as well.
        static at(points, i) {
            const last = points.length / 2 - 1;
            const k = Math.min(Math.floor(i), Math.max(0, last - 1)), part = Math.min(i, last) - k;
            const one = j => points[2 * k + j] + (last ? part * (points[2 * k + 2 + j] - points[2 * k + j]) : 0);
            return [one(0), one(1)];
        }

        // The picture goes into `host`, what one plays it with into `bar`; `told` hears which picture is shown, `fits` when there is
        // room for a wider or a narrower one.
        constructor(host, bar, told, fits) {
            this.told = told;
            this.fits = fits;
            this.pace = 1;
            host.insertAdjacentHTML('beforeend', '<div class="stage"><svg role="img"><g class="scene"></g><g class="hands"></g></svg></div>');
            bar.insertAdjacentHTML('beforeend', `<div class="film"><button type="button" class="play"></button>
                <button type="button" class="back" tabindex="-1" aria-label="A step back">‹</button><button type="button" class="on" tabindex="-1" aria-label="A step on">›</button>
                <input type="range" min="0" step="1" aria-label="time"><output></output>
                <label class="pace"><span>speed</span> <select aria-label="speed">${PACES.map(([value, name]) => `<option value="${value}"${value === '1' ? ' selected' : ''}>${name}</option>`).join('')}</select></label>
                <button type="button" class="sound" aria-pressed="false" aria-label="Sound of the slip" title="Sound of the slip">♪</button></div>`);
            const root = bar.lastElementChild, one = selector => root.querySelector(selector);
            this.svg = host.querySelector('.stage svg');
            [this.scene, this.hands] = this.svg.children;
            this.narrow = host.clientWidth < NARROW;
            new ResizeObserver(() => {
                if (!host.clientWidth || this.narrow === host.clientWidth < NARROW) return;
                this.narrow = !this.narrow;
                fits();
            }).observe(host);
            this.slider = one('input');
            this.clock = one('output');
            this.button = one('.play');
            this.button.addEventListener('click', () => this.playing ? this.pause() : this.play());
            one('.back').addEventListener('click', () => this.step(-1));
            one('.on').addEventListener('click', () => this.step(1));
            one('select').addEventListener('change', event => { this.pace = Number(event.target.value); });
            this.slider.addEventListener('input', event => {
                event.stopPropagation();
                this.pause();
                this.show(Number(this.slider.value));
            });
            one('.sound').addEventListener('click', event => {
                const on = event.target.getAttribute('aria-pressed') !== 'true';
                event.target.setAttribute('aria-pressed', on);
                this.sound ||= new Sound();
                this.loud = on;
                this.sound.play(0);
            });
            // What nobody sees any more need not move.
            new IntersectionObserver(entries => !entries.at(-1).isIntersecting && this.playing && this.pause()).observe(this.svg);
            this.pause();
        }

        // film: step (time between pictures), count, rate (time a second), time(i) in words, box, label, draw(i), slip(i), hands.
        // A film that is `kept` shows the same motion.
        load(film, kept) {
            this.film = film;
            this.svg.setAttribute('viewBox', film.box.join(' '));
            this.svg.setAttribute('aria-label', film.label);
            this.svg.setAttribute('role', film.hands?.length ? 'group' : 'img');
            this.slider.max = film.count - 1;
            this.giveHands(film.hands || []);
            this.show(kept ? this.i : 0);
        }

        // The hands are made once and keep the focus while the film changes.
        giveHands(hands) {
            hands.forEach((hand, k) => {
                let knob = this.hands.children[k];
                if (!knob) {
                    this.hands.insertAdjacentHTML('beforeend', '<g class="hand" tabindex="0" role="slider"><circle class="reach" r="24"/><circle r="9"/></g>');
                    knob = this.hands.lastElementChild;
                    const here = event => {
                        const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.svg.getScreenCTM().inverse());
                        this.film.hands[k].move(x, y);
                    };
                    knob.addEventListener('pointerdown', event => {
                        if (event.button !== 0) return;
                        knob.setPointerCapture(event.pointerId);
                        this.pause();
                        this.held = true;
                        here(event);
                        event.preventDefault();
                        knob.focus({ preventScroll: true });
                    });
                    knob.addEventListener('pointermove', event => this.held && here(event));
                    knob.addEventListener('pointerup', () => {
                        if (!this.held) return;
                        this.held = false;
                        // What was kept in its place for the hand need no longer be.
                        this.fits();
                        this.play();
                    });
                    knob.addEventListener('pointercancel', () => { this.held = false; });
                    // The keys move the start, so it is the start that one sees.
                    knob.addEventListener('focus', () => {
                        if (this.held || !this.i) return;
                        this.pause();
                        this.show(0);
                    });
                    knob.addEventListener('keydown', event => {
                        if (event.key === 'Enter' || event.key === ' ') {
                            event.preventDefault();
                            this.play();
                            return;
                        }
                        const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] }[event.key];
                        if (!way || event.altKey || event.ctrlKey || event.metaKey) return;
                        event.preventDefault();
                        this.pause();
                        this.film.hands[k].step(...way.map(d => d * (event.shiftKey ? 10 : 1)));
                    });
                }
                const [x, y] = hand.at;
                knob.setAttribute('transform', `translate(${x.toFixed(1)} ${y.toFixed(1)})`);
                knob.setAttribute('aria-label', hand.label);
                knob.setAttribute('aria-valuemin', hand.range[0]);
                knob.setAttribute('aria-valuemax', hand.range[1]);
                knob.setAttribute('aria-valuenow', hand.now);
                knob.setAttribute('aria-valuetext', hand.text);
            });
        }

        show(i) {
            this.i = Math.max(0, Math.min(this.film.count - 1, i));
            this.picture(this.film.draw(this.i));
            // A hand sets the start, and is faint while the bodies are elsewhere.
            this.hands.classList.toggle('gone', this.i > 0);
            this.slider.value = this.i;
            const time = this.film.time(SlipbookPlot.fixed(this.i * this.film.step, 1));
            if (this.clock.textContent !== time) {
                this.clock.textContent = time;
                this.slider.setAttribute('aria-valuetext', time);
            }
            if (this.loud) this.sound.play(this.playing ? this.film.slip(this.i) : 0);
            this.told(this.i);
        }

        // What the picture before has too is kept and moved: this costs a third of drawing it anew.
        picture(shapes) {
            shapes.forEach(([name, attributes, words = ''], k) => {
                let shape = this.scene.children[k];
                if (shape?.tagName !== name) {
                    const made = document.createElementNS(this.svg.namespaceURI, name);
                    if (shape) shape.replaceWith(made);
                    else this.scene.append(made);
                    shape = made;
                }
                const before = shape.attributed || {};
                for (const key in before) if (!(key in attributes)) shape.removeAttribute(key);
                for (const key in attributes) if (attributes[key] !== before[key]) shape.setAttribute(key, attributes[key]);
                shape.attributed = attributes;
                if (shape.textContent !== words) shape.textContent = words;
            });
            while (this.scene.children.length > shapes.length) this.scene.lastChild.remove();
        }

        step(way) {
            this.pause();
            this.show(Math.round(this.i) + way * Math.max(1, Math.round(this.film.count / 120)));
        }

        play() {
            clearTimeout(this.back);
            if (this.i >= this.film.count - 1) this.show(0);
            if (this.playing) return;
            this.playing = true;
            this.hands.classList.add('playing');
            this.button.textContent = '❚❚';
            this.button.setAttribute('aria-label', 'Pause');
            let before = performance.now();
            const next = now => {
                if (!this.playing) return;
                const pictures = Math.min(0.1, (now - before) / 1000) * this.film.rate * this.pace / this.film.step;
                before = now;
                this.show(this.i + pictures);
                if (this.i < this.film.count - 1) {
                    requestAnimationFrame(next);
                    return;
                }
                const rewind = this.rewind;
                this.pause();
                this.ended?.();
                if (rewind) this.back = setTimeout(() => this.show(0), 1500);
            };
            requestAnimationFrame(next);
        }

        pause() {
            clearTimeout(this.back);
            this.playing = this.rewind = false;
            this.hands.classList.remove('playing');
            this.button.textContent = '▶';
            this.button.setAttribute('aria-label', 'Play');
            if (this.loud) this.sound.play(0);
        }
    };
})();
