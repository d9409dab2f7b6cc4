// What the stages show: bodies on their floors, drawn from the films that the crate makes. A picture is a list of shapes: name,
// attributes, words.
'use strict';

window.slipbookScenes = (() => {
    const at = SlipbookStage.at;
    const n = x => x.toFixed(1);
    const line = points => {
        const pairs = [];
        for (let i = 0; i < points.length; i += 2) pairs.push(`${n(points[i])} ${n(points[i + 1])}`);
        return `M${pairs.join('L')}`;
    };
    const path = (kind, d) => ['path', { class: kind, d }];
    const disc = (kind, x, y, r) => ['circle', { class: kind, cx: n(x), cy: n(y), r: n(r) }];
    const box = (kind, x, y, width, height, rx) => ['rect', { class: kind, x: n(x), y: n(y), width, height, rx }];
    const text = (x, y, words, more) => ['text', { x: n(x), y: n(y), ...more }, words];
    const MIDDLE = { 'text-anchor': 'middle' }, END = { 'text-anchor': 'end' };
    const arrow = (x, y, dx, dy, kind) => {
        const length = Math.hypot(dx, dy);
        if (length < 1) return [];
        const [u, v] = [dx / length, dy / length], head = Math.min(9, length);
        const [ex, ey] = [x + dx, y + dy];
        return [path(`arrow ${kind}`, `${line([x, y, ex, ey])}M${n(ex - head * (u + 0.5 * v))} ${n(ey - head * (v - 0.5 * u))}L${n(ex)} ${n(ey)}L${n(ex - head * (u - 0.5 * v))} ${n(ey - head * (v + 0.5 * u))}`)];
    };
    // The points up to a picture, as a trail.
    // `within` is how far to each side of where it may go on the stage; what has left it is not drawn any more.
    const trail = (points, i, place, kind = '', within = Infinity) => {
        const shown = [], [middle] = place(0, 0);
        const put = ([x, y]) => Math.abs(x - middle) < within && shown.push(x, y);
        for (let k = 0; k <= Math.min(i, points.length / 2 - 1); k++) put(place(points[2 * k], points[2 * k + 1]));
        put(place(...at(points, i)));
        return path(`trail ${kind}`, line(shown));
    };

    // A floor seen from the side, with a mark at each of its own units; `shift` is where it has gone to.
    const floor = (shift, y, width, unit, teeth) => {
        const marks = [];
        const first = ((shift * unit) % unit) - unit;
        for (let x = first; x < width + unit; x += unit / 2) {
            marks.push(teeth ? `M${n(x)} ${y}l${n(0.4 * unit)} -7l${n(0.02 * unit)} 7` : `M${n(x)} ${y}v9`);
        }
        return [path('ground', `M0 ${y}H${width}V${y + 16}H0Z`), path('teeth', marks.join(''))];
    };
    // Something that drifts comes back on the other side.
    const wrapped = (x, width) => ((x % width) + width) % width;
    // Near a side, what is drawn at a place stands at the other side too.
    const around = (x, width, drawn) => [...drawn(x), ...(x < 80 ? drawn(x + width) : x > width - 80 ? drawn(x - width) : [])];

    // The record, seen from above; `angle` in radians, the radius in units of the circle within which friction can hold a coin.
    const RADIUS = 2.2;
    const record = (x, y, angle, scale) => {
        const radius = RADIUS * scale;
        const spokes = [0, 1, 2].map(k => {
            const turn = angle + k * Math.PI / 1.5;
            return `M${n(x)} ${n(y)}L${n(x + radius * Math.cos(turn))} ${n(y - radius * Math.sin(turn))}`;
        });
        return [disc('disc', x, y, radius), path('teeth', spokes.join('')), disc('limit', x, y, scale), disc('axis', x, y, 3),
            text(x, y - scale - 5, 'can be held', { class: 'small', ...MIDDLE })];
    };
    const ghost = (x, y) => box('body ghost', x - 11, y - 8, 22, 16, 2);
    const coin = (x, y, kind = '') => disc(`body ${kind}`, x, y, 9);
    const note = (x, y, words) => text(x, y, words, { class: 'note', ...MIDDLE });
    // The tip of an arrow, or the last place of it that is on the stage.
    const reached = (x, y, dx, dy, [left, top, width, height]) => {
        const room = (from, way, low, size) => way > 0 ? (low + size - 12 - from) / way : way < 0 ? (low + 12 - from) / way : 1;
        const part = Math.min(1, room(x, dx, left, width), room(y, dy, top, height));
        return [x + part * dx, y + part * dy];
    };
    // The stage's width in its own units: text is as large on a phone as on a desk.
    const width = narrow => narrow ? 380 : 760;
    // The length of a velocity of 1, where it is drawn as an arrow; the tip of the one at the start is taken by hand.
    const ARROW = 44;
    // What the pulled table shows, for as long as the hand is on it.
    let kept;

    return {
        line,
        // The pulled table from above. The table stands still in the picture; the ground runs away below it. Another block shows what
        // would be without the pull.
        constant({ values: [step], curves: [places, velocities, alike] }, narrow, set, theta, held) {
            const wide = width(narrow);
            const both = [...places, ...alike], xs = both.filter((_, i) => i % 2 === 0), ys = both.filter((_, i) => i % 2);
            if (!held || !kept) kept = [Math.min(0, ...xs), Math.max(0, ...xs), Math.min(0, ...ys), Math.max(0, ...ys)];
            const [left, right, low, high] = kept;
            const scale = Math.min(560, (wide - 200) / (right - left), 130 / (high - low));
            const put = (x, y) => [wide / 2 + (x - (left + right) / 2) * scale, 108 - (y - (low + high) / 2) * scale];
            const [x0, y0] = put(0, 0), [u0, v0] = velocities;
            return {
                hands: [{
                    at: [x0 + ARROW * u0, y0 - ARROW * v0], label: 'launch angle in degrees', range: [-179, 180], now: theta, text: `${theta}°`,
                    move: (x, y) => set({ theta: Math.atan2(y0 - y, x - x0) * 180 / Math.PI }),
                    step: (dx, dy) => set({ theta: [dx + dy] }),
                }],
                step, count: places.length / 2, rate: Math.max(0.4, step * places.length / 2 / 8), time: t => `t = ${t} v₀/A`, box: [0, 0, wide, 222],
                label: 'The block on the table, from above; below, the ground from which the table is pulled away.',
                slip: i => Math.hypot(...at(velocities, i)),
                draw: i => {
                    const [x, y] = put(...at(places, i)), [u, v] = at(velocities, i), t = i * step;
                    return [box('disc', 10, 6, wide - 20, 184, 6), ...floor(t * t / 2 * scale / 60, 202, wide, 60),
                        ...arrow(80, 24, -52, 0, 'pull'), text(90, 29, 'the table is pulled this way'),
                        text(wide - 20, 182, 'dashed: on a table at rest', END), ghost(...put(...at(alike, i))),
                        trail(places, i, put), box('body', x - 11, y - 8, 22, 16, 2), ...arrow(x, y, ARROW * u, -ARROW * v, 'velocity')];
                },
            };
        },
        // The shaken tray from the side, in the laboratory.
        tray({ values: [step], curves: [places, velocities] }, narrow, teeth, w0, set) {
            const unit = narrow ? 50 : 70, wide = width(narrow), begin = wide / 2 + places[0] * unit;
            return {
                hands: [{
                    at: [begin + ARROW * w0, 50], label: 'the velocity at the start', range: [-2, 2], now: w0, text: SlipbookPlot.fixed(w0, 2),
                    move: x => set({ w: (x - begin) / ARROW }),
                    step: (dx, dy) => set({ w: [dx + dy] }),
                }],
                step, count: places.length / 2, rate: 2.2, time: t => `φ = ${t}`, box: [0, 0, wide, 146],
                label: 'The block on the shaken floor, from the side, in the laboratory.',
                slip: i => Math.abs(at(velocities, i)[1]),
                draw: i => {
                    const [tray, x] = at(places, i), w = at(velocities, i)[1], rests = Math.abs(w) < 1e-6;
                    const centre = wrapped(wide / 2 + (tray + x) * unit, wide);
                    return [...floor(tray, 104, wide, unit, teeth), text(4, 140, 'floor, shaken'),
                        ...around(centre, wide, x => [box(`body ${rests ? 'still' : ''}`, x - 26, 66, 52, 38, 3), ...(rests ? [] : arrow(x, 50, ARROW * w, 0, 'velocity'))]),
                        ...(rests ? [text(Math.min(wide - 70, Math.max(70, centre)), 52, 'rests on the floor', MIDDLE)] : [])];
                },
            };
        },
        // The shaken tray from above, with a block that slides across too.
        plane({ values: [step, gone], curves: [places, velocities, across] }, narrow, [w0, v0], set) {
            const unit = narrow ? 44 : 62, wide = width(narrow), high = 200;
            const ys = across.filter((_, i) => i % 2 === 0), spread = Math.max(...ys) - Math.min(...ys);
            const rise = Math.min(unit, 120 / (spread || 1));
            const put = (x, y) => [wrapped(wide / 2 + x * unit, wide), high - 44 - (y - Math.min(...ys)) * rise];
            const [bx, by] = put(places[0] + places[1], ys[0]);
            return {
                hands: [{
                    at: [bx + ARROW * w0, by - ARROW * v0], label: 'the velocity at the start', range: [-2, 2], now: w0,
                    text: `along ${SlipbookPlot.fixed(w0, 2)}, across ${SlipbookPlot.fixed(v0, 2)}`,
                    move: (x, y) => set({ w: (x - bx) / ARROW, across: (by - y) / ARROW }),
                    step: (dx, dy) => set({ w: [dx], across: [dy] }),
                }],
                step, count: places.length / 2, rate: 2.2, time: t => `φ = ${t}`, box: [0, 0, wide, high + 14],
                label: 'The block on the shaken tray, from above, in the laboratory.',
                slip: i => Math.hypot(at(velocities, i)[1], Math.exp(-at(across, i)[1])),
                draw: i => {
                    const [tray, x] = at(places, i), w = at(velocities, i)[1], [y, depth] = at(across, i), v = Math.exp(-depth);
                    const [px, py] = put(tray + x, y), rests = Math.abs(w) < 1e-6 && v < 1e-6;
                    const lines = [], first = ((tray * unit) % unit) - unit;
                    for (let k = first; k < wide + unit; k += unit) lines.push(`M${n(k)} 6V${high - 8}`);
                    const over = gone >= 0 && i * step >= gone;
                    return [box('ground', 0, 6, wide, high - 14, 0), path('teeth', lines.join('')), text(4, high + 9, 'tray, shaken ↔'),
                        text(wide - 4, high + 9, over ? 'velocity across: exactly 0' : v < 1e-6 ? 'velocity across: hardly a trace' : '', END),
                        ...around(px, wide, x => [box(`body ${rests ? 'still' : ''}`, x - 17, py - 17, 34, 34, 3),
                            ...arrow(x, py, ARROW * w, 0, 'velocity'), ...arrow(x, py, 0, -ARROW * v, 'velocity')])];
                },
            };
        },
        // The ball from the side; its spokes show how it turns.
        ball({ values: [step], curves: [places, turning] }, narrow, u0, set, rolling) {
            const unit = narrow ? 42 : 52, wide = width(narrow), radius = unit, ground = 2 * radius + 22;
            const begin = wide / 2 + (places[0] + places[1]) * unit;
            return {
                hands: [{
                    at: [begin + ARROW * u0, ground + 30], label: 'slip along the swing, at the start', range: [-2, 2], now: u0, text: SlipbookPlot.fixed(u0, 2),
                    move: x => set({ u: (x - begin) / ARROW }),
                    step: (dx, dy) => set({ u: [dx + dy] }),
                }],
                step, count: places.length / 2, rate: 2.2, time: t => `φ = ${t}`, box: [0, 0, wide, ground + 44],
                label: 'The ball on the swinging floor, from the side, in the laboratory.',
                slip: i => Math.abs(at(turning, i)[1]),
                draw: i => {
                    const [tray, x] = at(places, i), [turned, slip] = at(turning, i);
                    const rolls = rolling.some(([from, to]) => from <= i * step && i * step <= to);
                    const centre = wrapped(wide / 2 + (tray + x) * unit, wide), y = ground - radius;
                    const spokes = x => [0, 1, 2, 3].map(k => {
                        const turn = turned + k * Math.PI / 2;
                        return `M${n(x)} ${y}L${n(x + radius * Math.cos(turn))} ${n(y + radius * Math.sin(turn))}`;
                    });
                    return [...floor(tray, ground, wide, unit), text(Math.min(wide - 24, Math.max(24, centre)), 14, rolls ? 'rolls' : 'slips', MIDDLE),
                        text(4, ground + 38, 'slip along the swing'),
                        ...around(centre, wide, x => [disc(`body ${rolls ? 'still' : ''}`, x, y, radius), path('spokes', spokes(x).join('')),
                            ...arrow(x, ground + 30, ARROW * slip, 0, 'velocity')])];
                },
            };
        },
        // The record from the laboratory, where it turns, and from the table, where it stands still; or the first alone. Before
        // the coin moves, its velocity is drawn, and the border of those from which it comes to rest: the motion's, and the paper's,
        // once they are told. Beside it there may be another coin.
        record({ values, curves: [table, laboratory] }, narrow, alone, { border = [], paper, velocity, range, set, told = true, beside } = {}) {
            const step = values.at(-1), count = Math.max(table.length, beside?.curves[0].length || 0) / 2;
            const later = beside ? step / beside.values.at(-1) : 1;
            const [size, left, right, y, scale] = alone ? [[0, 0, 360, 340], 180, 180, 170, 76]
                : narrow ? [[0, 0, 380, 224], 94, 286, 98, 42] : [[0, 0, 740, 284], 180, 560, 130, 57];
            const put = x0 => (x, v) => [x0 + scale * x, y - scale * v];
            const slip = i => {
                const k = Math.min(i, table.length / 2 - 2);
                if (k < 0) return 0;
                const [a, b] = [at(table, k), at(table, k + 1)];
                return Math.hypot(a[0] - b[0], a[1] - b[1]) / step;
            };
            const [rho] = at(table, 0), from = right + scale * rho;
            const start = [];
            const tip = velocity && reached(from, y, scale * velocity[0], -scale * velocity[1], size);
            if (velocity) {
                const around = border.map((c, i) => i % 2 ? y - scale * c : from + scale * c);
                const low = Math.max(...around.filter((_, i) => i % 2));
                const middle = around.filter((_, i) => i % 2 === 0).reduce((sum, x, _, all) => sum + x / all.length, 0);
                if (told && around.length) start.push(path('border', `${line(around)}Z`));
                if (told && paper) start.push(disc('printed', from, y, scale * paper));
                start.push(...arrow(from, y, tip[0] - from, tip[1] - y, 'velocity'));
                if (alone && told && around.length) start.push(note(middle, Math.min(low - 14, 326), 'rests'));
                if (alone && told && paper) start.push(note(from, y - scale * paper - 8, 'the paper’s'));
                if (alone && told) start.push(note(right, y - RADIUS * scale + 22, 'flies off'));
            }
            const hands = set && [{
                at: [from, y], label: 'the coin: its distance from the axis', range, now: rho, text: SlipbookPlot.fixed(rho, 2),
                move: px => set({ rho: (px - right) / scale }),
                step: (dx, dy) => set({ rho: [dx + dy] }),
            }, ...(velocity ? [{
                at: tip, label: 'the velocity at the start', range: [-2.5, 2.5], now: velocity[1],
                text: `outwards ${SlipbookPlot.fixed(velocity[0], 2)}, along the turning ${SlipbookPlot.fixed(velocity[1], 2)}`,
                move: (px, py) => set({ u: (px - from) / scale, v: (y - py) / scale }),
                step: (du, dv) => set({ u: [du], v: [dv] }),
            }] : [])];
            return {
                step, count, rate: 1.6, time: t => `τ = ${t}`, box: size, slip, hands,
                label: `The coin on the turning record, from above, in the laboratory${alone ? '' : ' and on the table'}. Inside the dotted circle friction can hold it.`,
                draw: i => {
                    // Each view keeps to its half.
                    const half = alone ? Infinity : size[2] / 4 - 8;
                    const run = (x0, points, i, kind) => {
                        const [x, height] = put(x0)(...at(points, i));
                        return [trail(points, i, put(x0), kind, half), ...(Math.abs(x - x0) < half - 9 ? [coin(x, height, kind)] : [])];
                    };
                    const view = (x0, k, angle) => [...record(x0, y, angle, scale),
                        ...(beside ? run(x0, beside.curves[k], i * later, 'other') : []), ...run(x0, [table, laboratory][k], i)];
                    const first = i > 0 ? [] : start, foot = size[3] - 6;
                    return [...view(left, 1, i * step), ...(alone ? [] : [...view(right, 0, 0),
                        text(left, foot, 'in the laboratory', MIDDLE), text(right, foot, 'on the table', MIDDLE)]), ...first];
                },
            };
        },
    };
})();
