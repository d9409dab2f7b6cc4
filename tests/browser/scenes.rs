//! What the stages draw: bodies where the crate says, turned as it says, with arrows along their velocities.

use crate::Book;
use crate::chrome::{Page, Seen};
use crate::explorers::page_of;
use crate::pages::none;
use serde_json::Value;
use slipbook::explorers::{Answer, answer};

const PICTURES: [usize; 7] = [0, 7, 40, 111, 205, 333, 477];
const OFF: f64 = 0.11;
/// For a velocity of 1.
const ARROW: f64 = 44.0;

#[derive(Debug, serde::Deserialize)]
struct Drawn {
    bodies: Vec<[f64; 2]>,
    arrows: Vec<[f64; 2]>,
    spoke: Option<[f64; 2]>,
    words: String,
}

fn drawn(page: &mut Page, name: &str, picture: usize) -> Seen<Drawn> {
    let found: Value = page.value(&format!(
        "(host => {{
            const bar = host.querySelector('.film input');
            bar.value = {picture};
            bar.dispatchEvent(new Event('input', {{ bubbles: true }}));
            const numbers = path => path.getAttribute('d').match(/-?[\\d.]+/g).map(Number);
            const vector = path => (([x, y, u, v]) => [u - x, v - y])(numbers(path));
            const scene = host.querySelector('.scene'), spokes = scene.querySelector('.spokes');
            return {{
                bodies: [...scene.querySelectorAll('.body')].map(body => body.tagName === 'circle' ? ['cx', 'cy'].map(at => Number(body.getAttribute(at)))
                    : [['x', 'width'], ['y', 'height']].map(([at, size]) => Number(body.getAttribute(at)) + Number(body.getAttribute(size)) / 2)),
                arrows: [...scene.querySelectorAll('.arrow.velocity')].map(vector),
                spoke: spokes && vector(spokes),
                words: [...scene.querySelectorAll('text')].map(text => text.textContent).join(', '),
            }};
        }})(document.getElementById('explore-{name}'))"
    ))?;
    serde_json::from_value(found).map_err(|error| error.to_string())
}

/// Places of bodies and arrows at a picture; arrows shorter than 1 are not drawn.
type Expected = fn(&Answer, usize) -> (Vec<[f64; 2]>, Vec<[f64; 2]>);

/// It comes back at the other side.
fn across(film: &Answer, i: usize, unit: f64) -> f64 {
    let [floor, body] = film.curves[0][i];
    (380.0 + unit * (floor + body)).rem_euclid(760.0)
}

fn tray(film: &Answer, i: usize) -> (Vec<[f64; 2]>, Vec<[f64; 2]>) {
    let arrow = [ARROW * film.curves[1][i][1], 0.0];
    (vec![[across(film, i, 70.0), 85.0]], vec![arrow])
}

const SCENES: [(&str, &str, usize, [f64; 4], Expected); 7] = [
    (
        "constant",
        "lambda=0.7&theta=120",
        7,
        [0.7, 120.0, 0.0, 0.0],
        |film, i| {
            let [u, v] = film.curves[1][i];
            let both = [&film.curves[0], &film.curves[2]];
            let ends = |k: usize| {
                let all = both.into_iter().flatten().map(|place| place[k]);
                let low = all.clone().fold(0.0, f64::min);
                [low, all.fold(0.0, f64::max)]
            };
            let [[left, right], [low, high]] = [ends(0), ends(1)];
            let scale = 560.0_f64
                .min(560.0 / (right - left))
                .min(130.0 / (high - low));
            let places = both.map(|places| {
                let [x, y] = places[i];
                [
                    380.0 + scale * (x - 0.5 * (left + right)),
                    108.0 - scale * (y - 0.5 * (low + high)),
                ]
            });
            (places.into(), vec![[ARROW * u, -ARROW * v]])
        },
    ),
    (
        "anisotropic",
        "q=2&lambda=0.3&w=1.5",
        8,
        [2.0, 0.3, 1.5, 0.0],
        tray,
    ),
    (
        "periodic",
        "third=1.5&lambda=0.16&w=0.2&eta=0",
        12,
        [1.5, 0.16, 0.2, 0.0],
        tray,
    ),
    (
        "sinusoidal",
        "lambda=0.3&w=0.5&across=1",
        13,
        [0.3, 0.5, 1.0, 0.0],
        |film, i| {
            let ways: Vec<f64> = film.curves[2].iter().map(|point| point[0]).collect();
            let [low, high] = [ways[0], *ways.last().unwrap_or(&0.0)];
            let rise = 62.0_f64.min(120.0 / (high - low));
            let place = [across(film, i, 62.0), 156.0 - rise * (ways[i] - low)];
            let along = [ARROW * film.curves[1][i][1], 0.0];
            (
                vec![place],
                vec![along, [0.0, -ARROW * (-film.curves[2][i][1]).exp()]],
            )
        },
    ),
    (
        "sphere",
        "lambda=0.75&kappa=0.4&u=0&v=1",
        9,
        [0.75, 0.4, 0.0, 1.0],
        |film, i| {
            let arrow = [ARROW * film.curves[1][i][1], 0.0];
            (vec![[across(film, i, 52.0), 74.0]], vec![arrow])
        },
    ),
    (
        "turntable",
        "rho=0.8&u=-0.6&v=0.4",
        4,
        [0.8, -0.6, 0.4, 0.0],
        |film, i| {
            let at = |x: f64, [u, v]: [f64; 2]| [x + 57.0 * u, 130.0 - 57.0 * v];
            let places = vec![at(180.0, film.curves[1][i]), at(560.0, film.curves[0][i])];
            // The velocity at the start, while it has not begun to move.
            let start = [57.0 * -0.6, -57.0 * 0.4];
            (places, if i == 0 { vec![start] } else { Vec::new() })
        },
    ),
    (
        "rest",
        "rho=0.87&u=0&v=-0.87",
        4,
        [0.87, 0.0, -0.87, 0.0],
        |film, i| {
            let at = |x: f64, [u, v]: [f64; 2]| [x + 57.0 * u, 130.0 - 57.0 * v];
            let mut places = vec![at(180.0, film.curves[1][i]), at(560.0, film.curves[0][i])];
            // At the same time; its film has steps of its own.
            if let Ok(other) = answer(4, [0.88, 0.0, -0.88, 0.0]) {
                let k = i as f64 * film.values[3] / other.values[3];
                for (x, curve) in [(180.0, &other.curves[1]), (560.0, &other.curves[0])] {
                    let last = curve.len() - 1;
                    let (j, part) = ((k as usize).min(last - 1), k.min(last as f64));
                    let part = part - j as f64;
                    let [a, b] = [curve[j], curve[j + 1]];
                    places.push(at(x, [0, 1].map(|n| a[n] + part * (b[n] - a[n]))));
                }
            }
            (
                places,
                if i == 0 {
                    vec![[0.0, 57.0 * 0.87]]
                } else {
                    Vec::new()
                },
            )
        },
    ),
];

pub fn pictures(page: &mut Page, book: &Book) -> Seen {
    page.resize(1400, 1000)?;
    let mut wrong = Vec::new();
    for (name, state, number, given, expected) in SCENES {
        let hash = format!("#explore-{name}?{state}");
        page.open(&format!(
            "{}{hash}",
            book.address(&format!("{}.html", page_of(name)))
        ))?;
        page.wait_for(&format!(
            "document.getElementById('explore-{name}')?.dataset.whole === '{hash}'"
        ))?;
        let film = answer(number, given).map_err(|error| error.to_string())?;
        for picture in PICTURES.map(|i| i.min(film.curves[0].len() - 1)) {
            let seen = drawn(page, name, picture)?;
            let (places, arrows) = expected(&film, picture);
            let long = |[u, v]: &[f64; 2]| u.hypot(*v) >= 1.0;
            let near = |a: &[f64; 2], b: &[f64; 2]| (0..2).all(|k| (a[k] - b[k]).abs() < OFF);
            let missing = places
                .iter()
                .any(|place| !seen.bodies.iter().any(|b| near(b, place)));
            let more = seen.bodies.iter().any(|body| {
                let beside = |by: f64| near(&[body[0] + by, body[1]], &places[0]);
                !places.iter().any(|place| near(body, place)) && !beside(760.0) && !beside(-760.0)
            });
            let lost = arrows
                .iter()
                .filter(|arrow| long(arrow))
                .any(|arrow| !seen.arrows.iter().any(|a| near(a, arrow)));
            let idle = seen
                .arrows
                .iter()
                .any(|a| !arrows.iter().any(|arrow| near(a, arrow)));
            // A spoke is as long as the ball is high.
            let turned = name != "sphere" || {
                let angle: f64 = film.curves[1][picture][0];
                let rolling = answer(6, given).map_err(|error| error.to_string())?;
                let time = film.values[0] * picture as f64;
                let rolls = rolling.values[5..].chunks_exact(2);
                let mut rolls = rolls.filter(|at| at[0] <= time && time <= at[1]);
                let says = if rolls.next().is_some() {
                    "rolls"
                } else {
                    "slips"
                };
                seen.words.starts_with(says)
                    && seen.spoke.is_some_and(|spoke| {
                        near(&spoke, &[52.0 * angle.cos(), 52.0 * angle.sin()])
                    })
            };
            if missing || more || lost || idle || !turned {
                wrong.push(format!(
                    "{name}, picture {picture}: {seen:?} are drawn, not {places:?} with {arrows:?}"
                ));
            }
        }
    }
    none(wrong)
}
