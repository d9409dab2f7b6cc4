// What the stages show: bodies on their floors, drawn from the films that the crate makes.
'use strict';

window.slipbookScenes = (() => {
    const at = SlipbookStage.at;
    const n = x => x.toFixed(1);
    const line = points => {
        const pairs = [];
        for (let i = 0; i < points.length; i += 2) pairs.push(`${n(points[i])} ${n(points[i + 1])}`);
        return `M${pairs.join('L')}`;
    };
    const arrow = (x, y, dx, dy, kind) => {
        const length = Math.hypot(dx, dy);
        if (length < 1) return '';
        const [u, v] = [dx / length, dy / length], head = Math.min(9, length);
        const [ex, ey] = [x + dx, y + dy];
        return `<path class="arrow ${kind}" d="${line([x, y, ex, ey])}M${n(ex - head * (u + 0.5 * v))} ${n(ey - head * (v - 0.5 * u))}L${n(ex)} ${n(ey)}L${n(ex - head * (u - 0.5 * v))} ${n(ey - head * (v + 0.5 * u))}"/>`;
    };
    // The points up to a picture, as a trail.
    const trail = (points, i, place) => {
        const shown = [];
        for (let k = 0; k <= i; k++) shown.push(...place(points[2 * k], points[2 * k + 1]));
        shown.push(...place(...at(points, i)));
        return `<path class="trail" d="${line(shown)}"/>`;
    };

    // A floor seen from the side, with a mark at each of its own units; `shift` is where it has gone to.
    const floor = (shift, y, width, unit, teeth) => {
        const marks = [];
        const first = ((shift * unit) % unit) - unit;
        for (let x = first; x < width + unit; x += unit / 2) {
            marks.push(teeth ? `M${n(x)} ${y}l${n(0.4 * unit)} -7l${n(0.02 * unit)} 7` : `M${n(x)} ${y}v9`);
        }
        return `<path class="ground" d="M0 ${y}H${width}V${y + 16}H0Z"/><path class="teeth" d="${marks.join('')}"/>`;
    };
    // Something that drifts comes back on the other side.
    const wrapped = (x, width) => ((x % width) + width) % width;

    // The record, seen from above; `angle` in radians, the radius in units of the circle within which friction can hold a coin.
    const RADIUS = 2.2;
    const record = (x, y, angle, scale) => {
        const radius = RADIUS * scale;
        const spokes = [0, 1, 2].map(k => {
            const turn = angle + k * Math.PI / 1.5;
            return `M${n(x)} ${n(y)}L${n(x + radius * Math.cos(turn))} ${n(y - radius * Math.sin(turn))}`;
        });
        return `<circle class="disc" cx="${x}" cy="${y}" r="${n(radius)}"/><path class="teeth" d="${spokes.join('')}"/>
            <circle class="limit" cx="${x}" cy="${y}" r="${scale}"/><circle cx="${x}" cy="${y}" r="3" fill="currentColor"/>`;
    };
    const coin = (x, y) => `<circle class="body" cx="${n(x)}" cy="${n(y)}" r="9"/>`;

    return {
        line,
        arrow,
        // The pulled table from above. The table stands still in the picture; the ground runs away below it.
        constant({ values: [step], curves: [places, velocities] }) {
            const xs = places.filter((_, i) => i % 2 === 0), ys = places.filter((_, i) => i % 2);
            const [left, right, low, high] = [Math.min(0, ...xs), Math.max(0, ...xs), Math.min(0, ...ys), Math.max(0, ...ys)];
            const scale = Math.min(110, 560 / (right - left + 0.4), 120 / (high - low + 0.2));
            const put = (x, y) => [380 + (x - (left + right) / 2) * scale, 96 - (y - (low + high) / 2) * scale];
            return {
                step, count: places.length / 2, rate: Math.max(0.4, step * places.length / 2 / 8), unit: 'v₀/A', box: [0, 0, 760, 230],
                label: 'The block on the table, from above; below, the ground from which the table is pulled away.',
                slip: i => Math.hypot(...at(velocities, i)),
                draw: i => {
                    const [x, y] = put(...at(places, i)), [u, v] = at(velocities, i), t = i * step;
                    return `<rect class="disc" x="30" y="6" width="700" height="180" rx="6"/>${floor(t * t / 2 * scale / 60, 200, 760, 60)}
                        ${arrow(120, 24, -64, 0, 'pull')}<text x="130" y="29">the table is pulled this way</text>
                        ${trail(places, i, put)}<rect class="body" x="${n(x - 11)}" y="${n(y - 8)}" width="22" height="16" rx="2"/>
                        ${arrow(x, y, 46 * u, -46 * v, 'velocity')}`;
                },
            };
        },
        // The shaken tray from the side, in the laboratory.
        tray({ values: [step], curves: [places, velocities] }, teeth) {
            const unit = 70, width = 760;
            return {
                step, count: places.length / 2, rate: 2.2, unit: 'φ', box: [0, 0, width, 150],
                label: 'The block on the shaken floor, from the side, in the laboratory.',
                slip: i => Math.abs(at(velocities, i)[1]),
                draw: i => {
                    const [tray, x] = at(places, i), w = at(velocities, i)[1], rests = Math.abs(w) < 1e-6;
                    const centre = wrapped(width / 2 + (tray + x) * unit, width);
                    return `${floor(tray, 104, width, unit, teeth)}
                        <rect class="body ${rests ? 'still' : ''}" x="${n(centre - 26)}" y="66" width="52" height="38" rx="3"/>
                        ${rests ? `<text x="${n(centre)}" y="52" text-anchor="middle">rests on the floor</text>` : arrow(centre, 50, 44 * w, 0, 'velocity')}
                        <text x="12" y="140">floor, shaken</text>`;
                },
            };
        },
        // The ball from the side; its spokes show how it turns.
        ball({ values: [step], curves: [places, turning] }) {
            const unit = 52, width = 760, radius = unit;
            return {
                step, count: places.length / 2, rate: 2.2, unit: 'φ', box: [0, 0, width, 170],
                label: 'The ball on the swinging floor, from the side, in the laboratory.',
                slip: i => Math.abs(at(turning, i)[1]),
                draw: i => {
                    const [tray, x] = at(places, i), [turned, slip] = at(turning, i), rolls = Math.abs(slip) < 1e-6;
                    const centre = wrapped(width / 2 + (tray + x) * unit, width), y = 126 - radius;
                    const spokes = [0, 1, 2, 3].map(k => {
                        const turn = turned + k * Math.PI / 2;
                        return `M${n(centre)} ${y}L${n(centre + radius * Math.cos(turn))} ${n(y + radius * Math.sin(turn))}`;
                    });
                    return `${floor(tray, 126, width, unit)}<circle class="body ${rolls ? 'still' : ''}" cx="${n(centre)}" cy="${y}" r="${radius}"/>
                        <path class="spokes" d="${spokes.join('')}"/><text x="${n(centre)}" y="14" text-anchor="middle">${rolls ? 'rolls' : 'slips'}</text>
                        ${arrow(centre, 160, 44 * slip, 0, 'velocity')}<text x="12" y="164">slip along the swing</text>`;
                },
            };
        },
        // The record from the laboratory, where it turns, and from the table, where it stands still; with `start`, which is drawn
        // over the coin before it moves, the first alone.
        record({ values, curves: [table, laboratory] }, start) {
            const step = values.at(-1), both = start === undefined, count = table.length / 2;
            const [left, right, y, scale] = both ? [180, 560, 150, 62] : [this.centre[0], 0, this.centre[1], this.scale];
            const put = x0 => (x, v) => [x0 + scale * x, y - scale * v];
            const slip = i => {
                const k = Math.min(i, count - 2);
                if (k < 0) return 0;
                const [a, b] = [at(table, k), at(table, k + 1)];
                return Math.hypot(a[0] - b[0], a[1] - b[1]) / step;
            };
            return {
                step, count, rate: 1.6, unit: '/Ω', box: both ? [0, 0, 740, 300] : [0, 0, 360, 340], slip,
                label: `The coin on the turning record, from above, in the laboratory${both ? ' and on the table' : ''}. Inside the dashed circle friction can hold it.`,
                draw: i => {
                    const view = (x0, points, angle) => `${record(x0, y, angle, scale)}${trail(points, i, put(x0))}${coin(...put(x0)(...at(points, i)))}`;
                    const shown = view(left, laboratory, i * step);
                    return both ? `${shown}${view(right, table, 0)}<text x="${left}" y="297" text-anchor="middle">in the laboratory</text>
                        <text x="${right}" y="297" text-anchor="middle">on the table</text>` : shown + (i > 0 ? '' : start);
                },
            };
        },
        // Of the record alone: pixels a unit, and where its axis is.
        scale: 76,
        centre: [180, 170],
    };
})();
