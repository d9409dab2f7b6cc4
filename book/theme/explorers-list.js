// What each explorer asks and shows. `QUESTIONS` in motion/src/explorers.rs says what the questions answer.
'use strict';

window.slipbookExplorers = (() => {
    const PHASES = [0, 2, 4, 6, 8].map(n => [n * Math.PI, n ? `${n}π` : '0']);
    const REGIONS = ['none of the five', 'I', 'II', 'III', 'IV', 'V'];
    const WAYS = { '1': 'forwards', '-1': 'backwards', '0': 'rest' };
    const fixed = SlipbookPlot.fixed;
    const pair = (x, y) => `(${fixed(x)}, ${fixed(y)})`;
    const column = (points, k) => points.filter((_, i) => i % 2 === k);
    const { at } = SlipbookStage;
    // The end of an axis that begins at 0.
    const nice = size => [0.5, 1, 1.5, 2, 3, 5, 7, 10, 20, 50, 100, 200].find(n => n >= size) || 500;
    const scenes = slipbookScenes;
    // The speed below which a particle at the distance ρ comes to rest, by the paper's border; 0 beyond it.
    const border = (printed, rho) => {
        for (let i = 0; i + 3 < printed.length; i += 2) {
            const [a, p, b, r] = printed.slice(i, i + 4);
            if ((a - rho) * (b - rho) <= 0 && a !== b) return p + (r - p) * (rho - a) / (b - a);
        }
        return 0;
    };
    // What the paper says of a start: of one with the speed p at the distance ρ, and the border at ρ.
    const byThePaper = (speed, rho, paper) => speed < rho ? `By the paper’s border, for slow coins, it ${speed < paper ? 'rests' : 'escapes'}.`
        : 'The paper’s border says nothing where p ≥ ρ.';
    // What lies between the paper's border C and the motion's, where C is the higher one.
    const wedge = (printed, found) => {
        const from = found.findIndex((_, i) => i % 2 === 0 && found[i] > 4.6);
        const back = i => [printed[i], printed[i + 1]];
        const upper = Array.from({ length: printed.length / 2 }, (_, i) => back(printed.length - 2 - 2 * i)).filter(([q]) => q > 4.6);
        return from < 0 ? [] : [...found.slice(from), ...upper.flat()];
    };
    const circle = radius => Array.from({ length: 122 }, (_, i) => radius * (i % 2 ? Math.sin : Math.cos)(Math.floor(i / 2) * Math.PI / 30));
    const FATES = {
        '1': (sigma, tau) => `it comes to rest at the distance σ = ${fixed(sigma)} after τ = ${fixed(tau)}`,
        '0': (_, tau) => `it goes away for ever, which is certain ${tau < 5e-5 ? 'at once' : `after τ = ${fixed(tau)}`}`,
        '-1': () => 'the start is so near the boundary that rounding decides',
    };
    // What an escape is watched by: the quantities, in the order of the answer and of what is printed, and their plots: title, label,
    // axis, and which quantities.
    const LATE = ['ρ/τ²', '(π/2 − ψ) τ', 'A²/τ³', 'cosh α cosh 2α/A', 'τ dα/dτ'];
    const GROWTH = [
        ['ρ/τ², (136)', 'The distance over the square of the time', 'ρ/τ²', [0.1, 0.3], [0]],
        ['(π/2 − ψ) τ, (134)', 'What ψ is short of a right angle, times the time', '(π/2 − ψ) τ', [0, 6], [1]],
        ['A²/τ³, (132)', 'The square of A over the cube of the time', 'A²/τ³', [0.1, 0.25], [2]],
        ['(128) and (129)', 'The time times the rate of α, and the quotient of the two sides of (129)', '', [-0.5, 1.5], [4, 3]],
    ];
    // What is shown at distances in powers of ten is seen from above: their circles, of which that of 1/10 is the axis.
    const RINGS = [[1, '1'], [4, '10³'], [7, '10⁶']];
    const fates = fate => fate === 1 ? 'rest' : fate ? 'undecided' : 'escape';

    // Ends of two axes that hold the points and the origin, in steps, so that they do not jump with every move.
    function around(points, shape) {
        const [xs, ys] = [column(points, 0), column(points, 1)];
        const [left, right] = [Math.min(0, ...xs), Math.max(0, ...xs)];
        const [low, high] = [Math.min(0, ...ys), Math.max(0, ...ys)];
        const sizes = [0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200];
        const centred = (size, from, to) => {
            const grid = size / 10;
            const start = Math.round(((from + to) / 2 - size / 2) / grid) * grid;
            return [start, start + size];
        };
        for (const size of sizes) {
            const x = centred(size, left, right);
            const y = centred(size * shape, low, high);
            if (x[0] <= left && x[1] >= right && y[0] <= low && y[1] >= high) return { x, y };
        }
        return { x: [-100, 100], y: [-100 * shape, 100 * shape] };
    }

    // The distance from the axis over the time, along a path on the table.
    const distance = ({ values, curves: [table] }) => column(table, 0).flatMap((x, i) => [i * values.at(-1), Math.hypot(x, table[2 * i + 1])]);

    // From when to when the ball rolls.
    const rolling = ({ values: [, , , , count, ...list] }) => Array.from({ length: count }, (_, i) => list.slice(2 * i, 2 * i + 2));

    // Words of a scene in the explorers' units: a velocity, and a floor that swings for four periods.
    const tidy = x => Number(x.toPrecision(12));
    const velocity = (u, v) => `${tidy(Math.hypot(u, v))}m/s@${tidy(Math.atan2(v, u))}rad`;
    const swung = { g: '1m/s^2', pull: 'sin(t)', until: '8*pi*1s' };

    // Each explorer: its inputs, its plots, and what to show at a state. `show` returns one drawing for each plot, the
    // values by name, and a sentence.
    const explorers = {
        constant: {
            name: 'Throw it yourself.',
            predict: {
                asks: 'First your guess: the table is pulled from under a block that is launched straight across the pull, with λ = 2. It stops',
                options: ['earlier than on a table at rest', 'at the same time', 'later'],
                right: 2,
                says: 'Friction turns with the velocity, and part of it works against the pull: a third later.',
                at: { lambda: 2, theta: 90 },
            },
            hint: 'Choose the friction; drag the tip of the velocity, on the table or in its plane, or focus a circle and use the arrow keys.',
            inputs: {
                lambda: { label: 'friction λ', range: [0, 3], step: 0.01 },
                theta: { label: 'launch angle θ₀', unit: '°', range: [-179, 180], step: 1 },
            },
            plots: set => [{
                title: 'velocity (hodograph)',
                label: 'The velocity in its plane: the motion from the chosen direction, and faintly those from other directions.',
                x: { label: 'v_x/v_0', range: [-1.5, 2.5] }, y: { label: 'v_y/v_0', range: [-1.5, 1.5] }, equal: true,
                hand: {
                    label: 'launch angle in degrees', range: [-179, 180],
                    move: (x, y) => set({ theta: Math.atan2(y, x) * 180 / Math.PI }),
                    step: (dx, dy) => set({ theta: [dx + dy] }),
                },
            }, {
                title: 'path, dots at equal times', label: 'The path of the particle on the plane.',
                x: { label: 'Ax/v_0²' }, y: { label: 'Ay/v_0²' }, equal: true,
            }, {
                title: 'stopping time', label: 'The time until rest against the launch angle.',
                x: { label: 'launch angle, either way', range: [0, 180], ticks: [0, 45, 90, 135, 180].map(t => [t, `${t}°`]) },
                y: { label: 'AT/v_0' }, height: 234,
            }],
            scene: ({ lambda, theta }, ask) => ({ mu: lambda, g: '1m/s^2', pull: '1m/s^2', throw: `1m/s@${theta}deg`, until: ask(0, lambda, theta).values[0] ? 'stop' : '10s' }),
            film: ({ lambda, theta }, ask, { narrow, set, held }) => scenes.constant(ask(7, lambda, theta), narrow, set, theta, held),
            now: ({ lambda, theta }, ask) => {
                const { curves: [places, velocities] } = ask(7, lambda, theta);
                return [i => at(velocities, i), i => at(places, i)];
            },
            show({ lambda, theta }, ask) {
                const { values: [rests, t, vx, vy, x, y], curves: [velocity, path, times] } = ask(0, lambda, theta);
                const [stops = [], ...others] = ask.later(1, lambda).curves;
                const rest = rests ? [{ points: [0, 0], dots: 6 }] : [];
                const top = [0.5, 1, 2, 5, 10, 20, 50, 100, 200].find(n => n >= Math.max(...column(stops, 1))) || 1;
                const ends = rests ? `It comes to rest after T = ${fixed(t)} v₀/A`
                    : `It is not at rest by ${fixed(t, 0)} v₀/A; then its velocity is ${pair(vx, vy)} v₀`;
                return {
                    draw: [{
                        marks: [...others.map(points => ({ points, faint: true })), { points: velocity, series: 1 }, ...rest],
                        hand: velocity.slice(0, 2),
                        words: { now: theta, text: `${theta}°` },
                    }, {
                        ...around(path.slice(0, rests ? undefined : 140), 0.75),
                        marks: [{ points: path, series: 1 }, { points: times, series: 1, dots: 3.5 }, ...(rests ? [{ points: [x, y], dots: 6 }] : [])],
                    }, {
                        y: [0, top],
                        marks: stops.length ? [{ points: stops, series: 1 }, { points: [Math.abs(theta), t], series: 2, dots: 6 }]
                            : [{ points: [90, top / 2], text: 'λ ≤ 1: it need not stop' }],
                    }],
                    values: rests ? { 'T (v₀/A)': fixed(t), 'x there (v₀²/A)': fixed(x), 'y there (v₀²/A)': fixed(y) }
                        : { 't (v₀/A)': fixed(t), 'v_x then (v₀)': fixed(vx), 'v_y then (v₀)': fixed(vy) },
                    says: `λ = ${fixed(lambda, 2)}, θ₀ = ${fixed(theta, 0)}°. ${ends}.`,
                };
            },
        },

        anisotropic: {
            name: 'Move through the map.',
            predict: {
                asks: 'First your guess: friction is twice as strong backwards as forwards. Shaken to and fro, the block in the end drifts fastest where friction is',
                options: ['weak', 'of medium strength', 'just weak enough to let it move'],
                right: 0,
                says: 'However weak, friction has to balance over a period, so the block moves forwards for two thirds of the time. It only takes longer to settle.',
                at: { q: 2, lambda: 0.02, w: -0.5 },
            },
            hint: 'Drag the circle on the map, or focus it and use the arrow keys; the start velocity shows how the periodic motion is approached.',
            inputs: {
                q: { label: 'ratio q', range: [1, 12], step: 0.02 },
                lambda: { label: 'friction λ₀', range: [0.01, 1.2], step: 0.002 },
                w: { label: 'velocity at start', range: [-2, 2], step: 0.05 },
            },
            plots: set => [{
                title: 'regions, by the motion itself', label: 'The map of the regions I to V, with the chosen point.',
                x: { label: 'q', range: [1, 12] }, y: { label: 'qλ_0', range: [0, 2] }, height: 210,
                hand: {
                    label: 'friction at the chosen point of the map', range: [0.01, 1.2],
                    move: (q, backwards) => set({ q, lambda: backwards / Math.min(12, Math.max(1, q)) }),
                    step: (dx, dy) => set({ q: [dx], lambda: [dy] }),
                },
            }, {
                title: '𝔴: from the start, and periodic (dashed)', label: 'Velocity against phase over four periods.',
                x: { label: 'φ', range: [0, 8 * Math.PI], ticks: PHASES }, y: { label: '𝔴' }, height: 210,
            }, {
                title: 'one period: + forth, − back, 0 rest', label: 'One period of the periodic motion, with its intervals.',
                x: { label: 'φ since the first start' }, y: { label: '𝔴' }, height: 210,
            }],
            scene: ({ q, lambda, w }) => ({ mu: lambda, 'mu-back': tidy(q * lambda), throw: `${w}m/s`, ...swung }),
            film: ({ q, lambda, w }, ask, { narrow, set }) => scenes.tray(ask(8, q, lambda, w), narrow, q > 1, w, set),
            now: ({ q, lambda, w }, ask) => {
                const { values: [step], curves: [, velocities] } = ask(8, q, lambda, w);
                return [null, i => [i * step, at(velocities, i)[1]]];
            },
            show({ q, lambda, w }, ask, { printed }) {
                const { values: [region, mean, largest, rest, count, ...list], curves: [shown, periodic] } = ask(2, q, lambda, w);
                // The friction backwards is what the wedge is seen by.
                const backwards = points => points.map((y, i) => i % 2 ? y * points[i - 1] : y);
                const borders = ask.later(3, 12).curves.map(backwards), paper = backwards(printed);
                const intervals = Array.from({ length: count }, (_, i) => list.slice(3 * i, 3 * i + 3));
                const order = intervals.map(([sign]) => ({ '1': '+', '-1': '−', '0': '0' })[sign]).join(' ');
                const edges = [[1, 0, 12, 0], ...borders, [1, 2, 12, 2]];
                const back = points => [...Array(points.length / 2).keys()].reverse().flatMap(i => points.slice(2 * i, 2 * i + 2));
                const areas = edges.slice(1).map((upper, i) => ({ points: [...edges[i], ...back(upper)], series: i + 1, fill: i === region - 1 ? 0.45 : 0.16 }));
                const from = intervals[0][1];
                const scale = size => [0.1, 0.2, 0.5, 1, 2, 3].find(n => n >= size) || 4;
                const [high, higher] = [scale(1.05 * largest), scale(Math.max(...column(shown, 1).map(Math.abs)))];
                const one = [];
                for (let i = 0; i < periodic.length; i += 2) {
                    if (periodic[i] >= from && periodic[i] <= from + 2 * Math.PI) one.push(periodic[i] - from, periodic[i + 1]);
                }
                return {
                    draw: [{
                        marks: [...areas, ...borders.map(points => ({ points })),
                            { points: wedge(paper, borders[1] || []), fill: 0.7 },
                            { points: paper, dash: true },
                            { points: [9.2, 1.07], text: 'II in the paper' }, { points: [11, 0.62], text: 'E' },
                            ...[[3, 0.2, 1], [4, 0.65, 2], [1.5, 0.83, 3], [5, 1.4, 4], [1.35, 1.75, 5]]
                                .map(([x, y, n]) => ({ points: [x, y], text: REGIONS[n] }))],
                        hand: [q, q * lambda],
                        words: { now: lambda, text: `q = ${fixed(q, 2)}, λ₀ = ${fixed(lambda, 3)}, region ${REGIONS[region]}` },
                    }, {
                        y: [-higher, higher],
                        marks: [{ points: shown, series: 1 }, { points: periodic, series: 2, dash: true }],
                    }, {
                        x: [0, 2 * Math.PI], y: [-high, high],
                        marks: [
                            ...intervals.map(([sign, a, b]) => ({ band: [a - from, b - from], series: { '1': 1, '-1': 2, '0': undefined }[sign], fill: 0.15 })),
                            { points: one, series: 2 },
                            ...intervals.map(([sign, a, b]) => ({ points: [(a + b) / 2 - from, 0.86 * high], text: { '1': '+', '-1': '−', '0': '0' }[sign] })),
                        ],
                    }],
                    values: { region: REGIONS[region], order, 'mean 𝔴': fixed(mean), 'largest |𝔴|': fixed(largest), 'share of rest': fixed(rest) },
                    says: `q = ${fixed(q, 2)}, λ₀ = ${fixed(lambda, 3)}: region ${REGIONS[region]}, in each period ${intervals.map(([sign]) => WAYS[sign]).join(', ')}.${region === 4 && q * lambda < border(paper, q) ? ' By the paper’s list region II.' : ''}`,
                };
            },
        },

        turntable: {
            name: 'Throw the coin.',
            predict: {
                asks: 'First your guess: a coin is thrown from the axis straight outwards. Seen from the laboratory its path is',
                options: ['straight', 'bent with the turning', 'bent against the turning'],
                right: 1,
                says: 'The record drags it along. On the record the same path bends the other way.',
                at: { rho: 0, u: 1.5, v: 0 },
            },
            hint: 'Drag the coin or the tip of its velocity on the table, and let go; or focus a circle and use the arrow keys. A dashed circle is the paper’s border for slow coins, (147).',
            inputs: {
                rho: { label: 'distance ρ', range: [0, 1.6], step: 0.01 },
                u: { label: 'velocity outwards', range: [-2, 2], step: 0.01 },
                v: { label: 'along the turning', range: [-2.5, 1.5], step: 0.01 },
            },
            plots: set => [{
                title: 'start velocity; inside it rests', equal: true,
                label: 'The velocities at the start, relative to the table. From those inside the marked area the particle comes to rest.',
                x: { label: 'outwards', range: [-2, 2] }, y: { label: 'along the turning', range: [-2.5, 1.5] },
                hand: {
                    label: 'velocity outwards, at the start', range: [-2, 2],
                    move: (u, v) => set({ u, v }),
                    step: (du, dv) => set({ u: [du], v: [dv] }),
                },
            }, {
                title: 'distance; friction can hold it below 1', label: 'The distance from the axis against the time, with that within which friction can hold the particle.',
                x: { label: 'τ' }, y: { label: 'ρ' }, height: 310,
            }],
            scene({ rho, u, v }, ask) {
                const { values, curves: [table] } = ask(4, rho, u, v);
                return { mu: 1, g: '1m/s^2', turn: '1rad/s', at: `${rho}m`, throw: velocity(u, v), until: values[0] === 1 ? 'rest' : `${tidy(values.at(-1) * (table.length / 2 - 1))}s` };
            },
            film: ({ rho, u, v }, ask, { printed, moving, told, set, narrow }) => scenes.record(ask(4, rho, u, v), narrow, false,
                { border: ask.later(5, rho, Number(moving)).curves[0], paper: border(printed, rho), velocity: [u, v], range: [0, 1.6], set, told }),
            now: ({ rho, u, v }, ask) => {
                const { values, curves: [table] } = ask(4, rho, u, v);
                return [null, i => [i * values.at(-1), Math.hypot(...at(table, i))]];
            },
            show({ rho, u, v }, ask, { printed, moving }, ...beside) {
                const { values: [fate, sigma, tau] } = ask(4, rho, u, v);
                const [boundary = []] = ask.later(5, rho, Number(moving)).curves;
                const paper = border(printed, rho);
                const words = FATES[fate](sigma, tau);
                const speed = { now: u, text: `outwards ${fixed(u, 2)}, along the turning ${fixed(v, 2)}: ${words}` };
                const paths = [ask(4, rho, u, v), ...beside].map(distance);
                const long = nice(Math.max(...paths.map(path => path.at(-2)))), far = nice(Math.max(1.2, ...paths.flatMap(path => column(path, 1))));
                return {
                    draw: [
                        { marks: [{ points: boundary, series: 1, fill: 0.2 }, { points: boundary, series: 1 },
                            ...(paper ? [{ points: circle(paper), dash: true }, { points: [0, paper + 0.06], text: '(147)' }] : [])], hand: [u, v], words: speed },
                        { x: [0, long], y: [0, far], marks: [{ points: [0, 1, long, 1], dash: true, faint: true }, ...paths.map((points, i) => ({ points, series: i ? 4 : fate === 1 ? 1 : 2 })),
                            ...(fate === 1 ? [{ points: [tau, sigma], series: 1, dots: 6 }] : [])] },
                    ],
                    values: fate === 1 ? { fate: 'rest', 'σ (μg/Ω²)': fixed(sigma), 'τ (1/Ω)': fixed(tau) }
                        : { fate: fates(fate), 'certain at τ (1/Ω)': fixed(tau) },
                    says: `From ρ = ${fixed(rho, 2)} with the velocity (${fixed(u, 2)}, ${fixed(v, 2)}): ${words}. ${byThePaper(Math.hypot(u, v), rho, paper)}`,
                };
            },
        },

        record: {
            name: 'Does it stay?',
            asksFirst: true,
            predict: {
                asks: 'A coin lies on a turning record, half as far out as friction can hold it. It is flicked hard, against the turning.',
                options: ['It flies off', 'It comes to rest', 'It slides for ever'],
                right: 1,
                says: 'Seen from the room it stands nearly still at first; the record takes it along before it has slid far.',
                at: { rho: 0.5, u: 0, v: -0.48 },
            },
            hint: 'Now drag the coin or the tip of its velocity. With the tip in the shaded area it comes to rest; by the paper’s formula for slow coins, within the dashed circle.',
            inputs: {
                rho: { label: 'distance ρ from the axis', range: [0, 1.4], step: 0.01 },
                u: { label: 'velocity outwards', range: [-2.5, 2.5], step: 0.01 },
                v: { label: 'velocity along the turning', range: [-2.5, 2.5], step: 0.01 },
            },
            bare: true,
            plots: () => [],
            film: ({ rho, u, v }, ask, { printed, moving, told, set }) => scenes.record(ask(4, rho, u, v), true, true,
                { border: ask.later(5, rho, Number(moving)).curves[0], paper: border(printed, rho), velocity: [u, v], range: [0, 1.4], set, told }),
            show({ rho, u, v }, ask, { printed }) {
                const { values: [fate, sigma, tau] } = ask(4, rho, u, v);
                return {
                    draw: [],
                    values: {},
                    says: `From ρ = ${fixed(rho, 2)} with the velocity (${fixed(u, 2)}, ${fixed(v, 2)}) relative to the record ${FATES[fate](sigma, tau)}. ${byThePaper(Math.hypot(u, v), rho, border(printed, rho))}`,
                };
            },
        },

        escape: {
            name: 'How fast does it go?',
            hint: 'Put the coin down at rest in the laboratory, at a distance that you choose with the mouse or the slider, and let the record drag it.',
            predict: {
                asks: 'First your guess: the coin slides off. Seen from the room, it circles the axis',
                options: ['a last time, then it goes straight', 'for ever, more and more slowly', 'as fast as the record'],
                right: 1,
                says: 'Once each time the time has grown 85-fold: far out its path is a logarithmic spiral, drawn below at distances in powers of ten.',
                at: {},
            },
            inputs: { rho: { label: 'distance ρ', range: [0.9, 2], step: 0.01, start: 1.1 } },
            // The first is seen from above; of the others each tends to a constant, if the power is right; dashed as printed.
            plots: () => [{
                title: 'from above, ρ in powers of ten', label: 'The path in the laboratory, at distances in powers of ten.', equal: true,
                x: { label: '', range: [-15, 15], ticks: [] }, y: { label: '', range: [-9, 9], ticks: [] },
            }, ...GROWTH.map(([title, label, quantity, range], i) => ({
                title: `${title}; dashed: printed`, label: `${label}, against the time in powers of ten.`,
                x: { label: 'τ', range: [0.5, 4], ticks: [[1, '10'], [2, '10²'], [3, '10³'], [4, '10⁴']] }, y: { label: quantity, range }, height: i ? 160 : 190,
            }))],
            film: ({ rho }, ask, { narrow, set }) => scenes.record(ask(4, rho, 0, -rho), narrow, false, { range: [0.9, 2], set }),
            show({ rho }, ask, { printed }) {
                const curves = [...ask(10, rho).curves], path = curves.pop(), many = printed.length / LATE.length;
                const dashed = LATE.map((_, i) => printed.slice(i * many, (i + 1) * many));
                const ends = curves.map((curve, i) => [fixed(curve.at(-1)), fixed(dashed[i].at(-1))]);
                return {
                    draw: [
                        { marks: [...RINGS.flatMap(([r, text]) => [{ points: circle(r), faint: true }, { points: [0, 0.25 - r], text }]),
                            { points: path, series: 1 }, { points: path.slice(-2), series: 1, dots: 5 }] },
                        ...GROWTH.map(([, , , , which]) => ({
                            marks: which.flatMap((k, n) => [{ points: curves[k], series: n + 1 }, { points: dashed[k], dash: true },
                                ...(which.length > 1 ? [{ points: [3.2, curves[k].at(-1) + 0.1], text: LATE[k] }] : [])]),
                        })),
                    ],
                    values: { 'at τ = 10⁴': 'found (printed)', ...Object.fromEntries(ends.map(([found, stated], i) => [LATE[i], `${found} (${stated})`])) },
                    says: `Put down at ρ = ${fixed(rho, 2)}: at τ = 10⁴ the distance is ${ends[0][0]} τ², and not ${ends[0][1]} τ².`,
                };
            },
        },

        sinusoidal: {
            name: 'Shake the tray.',
            predict: {
                asks: 'First your guess: the block slides across the stroke, too, with the friction λ₀ = 0.3. In the end its velocity across falls',
                options: ['in proportion to the time', 'exponentially', 'faster than any exponential'],
                right: 2,
                says: 'Each time the motion along the stroke turns round, all of the friction acts across.',
                at: { lambda: 0.3, w: 0.5, across: 1 },
            },
            hint: 'Choose the friction, and drag the tip of the velocity. Above λ<sub>c</sub> = 0.537 the block rests in each half period, above 1 for ever.',
            inputs: {
                lambda: { label: 'friction λ₀', range: [0.01, 1.2], step: 0.002 },
                w: { label: 'velocity along', range: [-2, 2], step: 0.05 },
                across: { label: 'velocity across', range: [0, 2], step: 0.05 },
            },
            plots: () => [{
                title: '𝔴 along; periodic motion dashed', label: 'Velocity along the drive against phase over four periods.',
                x: { label: 'φ', range: [0, 8 * Math.PI], ticks: PHASES }, y: { label: '𝔴' }, height: 210,
            }, {
                title: '−ln 𝔴_y across; exponential dashed', label: 'The negative logarithm of the velocity across against phase, and that of an exponential decay, as the paper has it.',
                x: { label: 'φ', range: [0, 8 * Math.PI], ticks: PHASES }, y: { label: '−ln 𝔴_y', range: [-1, 60] }, height: 210,
            }],
            scene: ({ lambda, w, across }) => ({ mu: lambda, throw: velocity(w, across), ...swung }),
            film: ({ lambda, w, across }, ask, { narrow, set }) => scenes.plane(ask(13, lambda, w, across), narrow, [w, across], set),
            now: ({ lambda, w, across }, ask) => {
                const { values: [step], curves: [, velocities, depths] } = ask(13, lambda, w, across);
                return [i => [i * step, at(velocities, i)[1]], i => at(depths, i)[1] < 60 ? [i * step, at(depths, i)[1]] : null];
            },
            show({ lambda, w, across }, ask) {
                const { values: [, , largest, rest, count, ...list], curves: [, periodic] } = ask(2, 1, lambda, w);
                const { values: [step, gone], curves: [, velocities, depths] } = ask(13, lambda, w, across);
                const ways = Array.from({ length: count }, (_, i) => WAYS[list[3 * i]]);
                const against = curve => column(curve, 1).flatMap((y, i) => [i * step, y]);
                const along = against(velocities), most = nice(Math.max(...column(along, 1).map(Math.abs)));
                const depth = across ? against(depths).filter((_, i, all) => all[i | 1] < 1000) : [];
                // An exponential that agrees with the motion while the velocity falls from e⁻¹ to e⁻⁴.
                const reached = y => depth.findIndex((v, i) => i % 2 && v >= y);
                const [one, four] = [reached(1), reached(4)];
                const line = four > one && one > 0 ? [depth[one - 1], depth[one], ...[8 * Math.PI].flatMap(phi =>
                    [phi, depth[one] + (phi - depth[one - 1]) * (depth[four] - depth[one]) / (depth[four - 1] - depth[one - 1])])] : [];
                const end = !across ? 'It does not slide across' : gone >= 0 ? `Its velocity across is exactly 0 from φ = ${fixed(gone, 2)} on`
                    : `After four periods its velocity across is ${depth.length && depths.at(-1) < 1000 ? `exp(−${fixed(depths.at(-1), 0)})` : 'below exp(−1000)'}`;
                return {
                    draw: [{ y: [-most, most], marks: [{ points: along, series: 1 }, { points: periodic, series: 2, dash: true }] },
                        { marks: [{ points: depth, series: 3 }, { points: line, dash: true }] }],
                    values: { 'largest |𝔴|, periodic': fixed(largest), 'share of rest': fixed(rest) },
                    says: `λ₀ = ${fixed(lambda, 3)}: in the end, in each period ${ways.join(', ')}. ${end}.`,
                };
            },
        },

        periodic: {
            name: 'Shake it in another rhythm.',
            predict: {
                asks: 'First your guess: to a sine its third harmonic is added, 1.5 times as strong. With λ₀ = 0.08 the block rests twice in each period. Twice as much friction makes these rests',
                options: ['longer', 'shorter', 'disappear'],
                right: 2,
                says: 'More friction lifts the shallow humps of the velocity away from zero. The rests come back where it is much larger.',
                at: { third: 1.5, lambda: 0.16 },
            },
            hint: 'Choose how much of the third harmonic is added to the sine, or pulses with gaps between them; choose the friction, and drag the tip of the velocity.',
            inputs: {
                third: { label: 'third harmonic', range: [0, 2], step: 0.05 },
                lambda: { label: 'friction λ₀', range: [0.01, 1.2], step: 0.002, start: 0.08 },
                w: { label: 'velocity at start', range: [-2, 2], step: 0.05, start: 0.2 },
                eta: { label: 'or pulses, of share η', range: [0, 0.95], step: 0.05, start: 0 },
            },
            plots: () => [{
                title: '𝔴: from the start, and periodic (dashed)', label: 'Velocity against phase over four periods.',
                x: { label: 'φ', range: [0, 8 * Math.PI], ticks: PHASES }, y: { label: '𝔴', range: [-2, 2] }, height: 210,
            }, {
                title: 'the drive h', label: 'The inertial force against phase over four periods, and the friction.',
                x: { label: 'φ', range: [0, 8 * Math.PI], ticks: PHASES }, y: { label: 'h', range: [-1.2, 1.2] }, height: 210,
            }],
            scene({ third, lambda, w, eta }) {
                // Of sin φ + a sin 3φ the largest value: at a quarter of the period, or where 12a sin²φ = 1 + 3a.
                const hump = Math.sqrt((1 + 3 * third) / (12 * third));
                const size = hump < 1 ? (1 + 3 * third) * hump * 2 / 3 : Math.abs(1 - third);
                const half = sign => `${sign}m/s^2:${eta}*pi*1s,0:${tidy(1 - eta)}*pi*1s`;
                const pull = eta ? Array(4).fill(`${half(1)},${half(-1)}`).join() : `(sin(t)+${third}*sin(3*t))/${tidy(size)}`;
                return { mu: lambda, throw: `${w}m/s`, ...swung, pull };
            },
            film: ({ third, lambda, w, eta }, ask, { narrow, set }) => scenes.tray(ask(12, third, lambda, w, eta), narrow, false, w, set),
            now: ({ third, lambda, w, eta }, ask) => {
                const { values: [step], curves: [, velocities] } = ask(12, third, lambda, w, eta);
                const { curves: [, , drive] } = ask(11, third, lambda, w, eta);
                return [i => [i * step, at(velocities, i)[1]], i => [i * step, at(drive, i * 400 / 480)[1]]];
            },
            show({ third, lambda, w, eta }, ask) {
                const { values: [, largest, rest, count, ...list], curves: [shown, periodic, drive] } = ask(11, third, lambda, w, eta);
                const signs = Array.from({ length: count }, (_, i) => list[3 * i]);
                const rests = signs.filter(sign => sign === 0).length;
                const most = Math.max(...column(shown, 1).map(Math.abs)), high = [0.5, 1, 2, 3].find(n => n >= most) || 5;
                const many = rests === 0 ? 'it never rests' : `${rests === 1 ? 'one rest' : `${rests} rests`} in each period`;
                return {
                    draw: [{ y: [-high, high], marks: [{ points: shown, series: 1 }, { points: periodic, series: 2, dash: true }] }, {
                        marks: [{ points: drive, series: 3 }, ...[-lambda, lambda].map(y => ({ points: [0, y, 8 * Math.PI, y], dash: true, faint: true }))],
                    }],
                    values: { 'rests per period': String(rests), 'largest |𝔴|': fixed(largest), 'share of rest': fixed(rest) },
                    says: `${eta ? `Pulses, η = ${fixed(eta, 2)}` : `Third harmonic ${fixed(third, 2)}`}, λ₀ = ${fixed(lambda, 3)}: ${many}.`,
                };
            },
        },

        sphere: {
            name: 'Shake the ball.',
            predict: {
                asks: 'First your guess: a solid ball rests in the laboratory when the floor under it begins to swing, and soon it rolls. Seen from the laboratory it then swings',
                options: ['as far as the floor', 'less far, with the floor', 'less far, against the floor'],
                right: 1,
                says: 'The friction that pushes the ball also turns it, so that it lags behind: seen from the room, 2/7 as far as the floor.',
                at: { lambda: 1.5, kappa: 0.4, u: -1, v: 0 },
            },
            hint: 'Choose the friction and the ball (κ is 0.4 if it is solid, 0.67 if hollow); drag the slip at the start, under the ball or in its plane, or focus a circle and use the arrow keys.',
            inputs: {
                lambda: { label: 'friction λ₀', range: [0.05, 1.5], step: 0.01 },
                kappa: { label: 'κ (solid 0.40)', range: [0.05, 0.67], step: 0.01 },
                u: { label: 'slip along', range: [-2, 2], step: 0.02 },
                v: { label: 'slip across', range: [-2, 2], step: 0.02 },
            },
            plots: set => [{
                title: 'slip w_x; dashed v_x on floor; grey: rolls',
                label: 'Slip and velocity of the centre along the swing against the phase; where the ball rolls the ground is grey.',
                x: { label: 'φ', range: [0, 8 * Math.PI], ticks: PHASES }, y: { label: 'velocity (A_0/ϖ)', range: [-2.5, 2.5] }, height: 210,
            }, {
                title: 'slip in the plane', label: 'The slip velocity in its plane.', equal: true,
                x: { label: 'w_x', range: [-2.5, 2.5] }, y: { label: 'w_y', range: [-2, 2] },
                hand: {
                    label: 'slip along the swing, at the start', range: [-2, 2],
                    move: (u, v) => set({ u, v }),
                    step: (du, dv) => set({ u: [du], v: [dv] }),
                },
            }, {
                title: 'path of the centre on the plane', label: 'The path of the centre, as seen from the plane.', equal: true,
                x: { label: 'x (A_0/ϖ²)' }, y: { label: 'y (A_0/ϖ²)' },
            }],
            body: 'ball',
            scene: ({ lambda, kappa, u, v }) => ({ mu: tidy(lambda / (1 + 1 / kappa)), radius: '1m', kappa, throw: velocity(u, v), ...swung }),
            film: ({ lambda, kappa, u, v }, ask, { narrow, set }) => scenes.ball(ask(9, lambda, kappa, u, v), narrow, u, set, rolling(ask(6, lambda, kappa, u, v))),
            now: ({ lambda, kappa, u, v }, ask) => {
                const { values: [step], curves: [, turning] } = ask(9, lambda, kappa, u, v);
                return [i => [i * step, at(turning, i)[1]]];
            },
            show({ lambda, kappa, u, v }, ask) {
                const { values: [b, first, share, slip], curves: [along, centre, plane, path] } = ask(6, lambda, kappa, u, v);
                const rolls = rolling(ask(6, lambda, kappa, u, v));
                const begins = first < 0 ? 'it does not roll within four periods' : `it first rolls at φ = ${fixed(first)}`;
                return {
                    draw: [
                        { marks: [...rolls.map(band => ({ band, fill: 0.13 })), { points: along, series: 1 }, { points: centre, series: 2, dash: true }] },
                        { marks: [{ points: plane, series: 1 }], hand: [u, v], words: { now: u, text: `along ${fixed(u, 2)}, across ${fixed(v, 2)}: ${begins}` } },
                        { ...around(path, 0.8), marks: [{ points: path, series: 2 }, { points: [0, 0], dots: 4 }] },
                    ],
                    values: { 'b = 1 + 1/κ': fixed(b), 'first rolls at φ': first < 0 ? 'not within 8π' : fixed(first), 'share of rolling, last period': fixed(share), '|slip| at 8π': fixed(slip) },
                    says: `λ₀ = ${fixed(lambda, 2)}, κ = ${fixed(kappa, 2)}: ${begins}; in the last of four periods it rolls for ${fixed(100 * share, 1)} % of the time.`,
                };
            },
        },
    };
    // The same record, with a second coin a hair farther out, as fast in the laboratory: the border runs between the two.
    const { turntable } = explorers;
    explorers.record.scene = turntable.scene;
    explorers.escape.scene = ({ rho }, ask) => turntable.scene({ rho, u: 0, v: -rho }, ask);
    const HAIR = 0.01;
    const second = ({ rho, u, v }, ask) => ask.beside(4, rho + HAIR, u, v - HAIR);
    explorers.rest = {
        ...turntable,
        name: 'On the border.',
        hint: `${turntable.hint} The second coin starts a hair farther out, by 0.01.`,
        predict: {
            asks: 'First your guess: two coins are put down side by side, at rest in the laboratory, one a hair farther out. In the end they are',
            options: ['still side by side', 'a little farther apart', 'one at rest, one gone for ever'],
            right: 2,
            says: 'The border runs between them.',
            at: { rho: 0.87, u: 0, v: -0.87 },
        },
        film: (state, ask, { printed, moving, told, set, narrow }) => {
            const { rho, u, v } = state;
            return scenes.record(ask(4, rho, u, v), narrow, false, { border: ask.later(5, rho, Number(moving)).curves[0], paper: border(printed, rho),
                velocity: [u, v], range: [0, 1.6], set, told, beside: second(state, ask) });
        },
        show(state, ask, more) {
            const other = second(state, ask), [fate, sigma, tau] = other.values;
            const shown = turntable.show(state, ask, more, other);
            return { ...shown, says: `${shown.says} A hair farther out ${FATES[fate](sigma, tau)}.` };
        },
    };
    return explorers;
})();
