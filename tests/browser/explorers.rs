//! The explorers under a reader's hands; whatever they show is held against the crate.

use crate::Book;
use crate::chrome::{Page, Seen};
use crate::pages::{is_marked, none};
use serde::de::DeserializeOwned;
use serde_json::{Value, json};
use slipbook::breaks::{answer as answer_to, breaks, claims};
use slipbook::corrections::escape as corrections;
use slipbook::explorers::answer;
use slipbook::paper::escape::{eq128_alpha_rate, eq132_a, eq134_lag, eq136_rho};

pub const PAGES: [&str; 9] = [
    "index",
    "constant",
    "sinusoidal",
    "periodic",
    "anisotropic",
    "sphere",
    "turntable",
    "escape",
    "rest",
];

pub fn name_on(page: &'static str) -> &'static str {
    if page == "index" { "record" } else { page }
}

pub fn page_of(name: &str) -> &str {
    if name == "record" { "index" } else { name }
}

/// As they stand in the address; between them all that the explorer can say.
const STATES: [(&str, &[&str]); 9] = [
    (
        "constant",
        &[
            "lambda=1.2&theta=120",
            "lambda=1.01&theta=0",
            "lambda=1&theta=90",
            "lambda=1&theta=180",
            "lambda=0&theta=-179",
            "lambda=3&theta=-35",
        ],
    ),
    (
        "anisotropic",
        &[
            "q=2&lambda=0.45&w=1.5",
            "q=1.2&lambda=0.1&w=0",
            "q=2&lambda=0.38&w=-2",
            "q=6.5&lambda=0.15&w=0.3",
            "q=7&lambda=1.2&w=2",
        ],
    ),
    (
        "turntable",
        &[
            "rho=0.8&u=-0.6&v=0.4",
            "rho=0.9&u=0.3&v=0.9",
            "rho=0&u=0&v=0",
            "rho=1.6&u=-1.1&v=-1.6",
        ],
    ),
    (
        "record",
        &["rho=0.5&u=0&v=-1", "rho=1.4&u=2.5&v=-2.5", "rho=0&u=0&v=0"],
    ),
    ("rest", &["rho=0.8&u=-0.6&v=0.4", "rho=1.6&u=2&v=1.5"]),
    ("escape", &["rho=0.9", "rho=2"]),
    (
        "sinusoidal",
        &[
            "lambda=0.01&w=-2&across=0",
            "lambda=1.2&w=2&across=2",
            "lambda=0.3&w=0.5&across=1",
        ],
    ),
    (
        "periodic",
        &[
            "third=1.5&lambda=0.15&w=1&eta=0",
            "third=0&lambda=0.6&w=-2&eta=0",
            "third=2&lambda=1.2&w=2&eta=0",
            "third=0&lambda=0.25&w=0.5&eta=0.5",
        ],
    ),
    (
        "sphere",
        &[
            "lambda=0.75&kappa=0.4&u=0&v=1",
            "lambda=0.3&kappa=0.67&u=0.5&v=1",
            "lambda=1.5&kappa=0.05&u=0&v=0",
        ],
    ),
];

/// Values with names and units, in order; and what it says, or a part of it.
fn expected(name: &str, state: &[f64]) -> Seen<(Vec<String>, String)> {
    let mut given = [0.0; 4];
    given[..state.len()].copy_from_slice(state);
    if name == "sinusoidal" {
        // What goes across does not matter in the end.
        given = [1.0, given[0], given[1], 0.0];
    }
    let number = match name {
        "constant" => 0,
        "anisotropic" | "sinusoidal" => 2,
        "turntable" | "rest" | "record" => 4,
        "escape" => 10,
        "periodic" => 11,
        _ => 6,
    };
    let found = answer(number, given).map_err(|error| error.to_string())?;
    let values = found.values;
    let rounded = |x: f64, decimals: usize| {
        let text = format!("{x:.decimals$}");
        match text.trim_start_matches(['-', '0', '.']) {
            "" => text.replace('-', ""),
            _ => text.replace('-', "−"),
        }
    };
    let fixed = |x: f64| rounded(x, 4);
    let named = |names: &[&str], values: &[String]| -> Vec<String> {
        let pairs = names.iter().zip(values);
        pairs
            .map(|(name, value)| format!("{name}: {value}"))
            .collect()
    };
    let manners = |intervals: &[f64], names: [&str; 3], between: &str| {
        let signs = intervals.chunks(3).map(|i| i[0] as i32 + 1);
        let words: Vec<_> = signs.map(|sign| names[sign as usize]).collect();
        words.join(between)
    };
    let ways = |intervals: &[f64]| manners(intervals, ["backwards", "rest", "forwards"], ", ");
    let fate = |fate: f64, sigma: f64, tau: f64| match fate {
        1.0 => format!(
            "it comes to rest at the distance σ = {} after τ = {}",
            fixed(sigma),
            fixed(tau)
        ),
        0.0 if tau < 5e-5 => "it goes away for ever, which is certain at once".to_owned(),
        0.0 => format!(
            "it goes away for ever, which is certain after τ = {}",
            fixed(tau)
        ),
        _ => "the start is so near the boundary that rounding decides".to_owned(),
    };
    Ok(match (name, values.as_slice()) {
        ("constant", [1.0, t, _, _, x, y]) => (
            named(
                &["T (v₀/A)", "x there (v₀²/A)", "y there (v₀²/A)"],
                &[t, x, y].map(|x| fixed(*x)),
            ),
            format!("It comes to rest after T = {} v₀/A.", fixed(*t)),
        ),
        ("constant", [_, t, vx, vy, ..]) => (
            named(
                &["t (v₀/A)", "vx then (v₀)", "vy then (v₀)"],
                &[t, vx, vy].map(|x| fixed(*x)),
            ),
            format!(
                "It is not at rest by {} v₀/A; then its velocity is ({}, {}) v₀.",
                rounded(*t, 0),
                fixed(*vx),
                fixed(*vy)
            ),
        ),
        ("anisotropic", [region, mean, largest, rest, _, intervals @ ..]) => {
            let region = ["none of the five", "I", "II", "III", "IV", "V"][*region as usize];
            let [mean, largest, rest] = [mean, largest, rest].map(|value| fixed(*value));
            (
                named(
                    &["region", "order", "mean 𝔴", "largest |𝔴|", "share of rest"],
                    &[
                        region.to_owned(),
                        manners(intervals, ["−", "0", "+"], " "),
                        mean,
                        largest,
                        rest,
                    ],
                ),
                format!("region {region}, in each period {}.", ways(intervals)),
            )
        }
        ("sinusoidal", [_, _, largest, rest, _, intervals @ ..]) => (
            named(
                &["largest |𝔴|, periodic", "share of rest"],
                &[fixed(*largest), fixed(*rest)],
            ),
            format!("in the end, in each period {}.", ways(intervals)),
        ),
        ("periodic", [_, largest, rest, _, intervals @ ..]) => {
            let rests = intervals.chunks(3).filter(|i| i[0] == 0.0).count();
            let words = match rests {
                0 => "it never rests".to_owned(),
                1 => "one rest in each period".to_owned(),
                _ => format!("{rests} rests in each period"),
            };
            (
                named(
                    &["rests per period", "largest |𝔴|", "share of rest"],
                    &[rests.to_string(), fixed(*largest), fixed(*rest)],
                ),
                format!(": {words}."),
            )
        }
        ("escape", []) => {
            let end =
                |curve: &Vec<[f64; 2]>| fixed(curve.last().map_or(f64::NAN, |point| point[1]));
            let ends: Vec<_> = found.curves.iter().map(end).collect();
            let late = 1e4_f64;
            let a = eq132_a(1.0);
            let rate = late * eq128_alpha_rate(corrections::alpha(late), corrections::a(late));
            let printed = [eq136_rho(1.0), eq134_lag(late) * late, a * a, 1.0, rate].map(fixed);
            let names = [
                "ρ/τ²",
                "(π/2 − ψ) τ",
                "A²/τ³",
                "cosh α cosh 2α/A",
                "τ dα/dτ",
            ];
            let values = names.iter().zip(ends.iter().zip(&printed));
            let values =
                values.map(|(name, (found, printed))| format!("{name}: {found} ({printed})"));
            let head = "at τ = 10⁴: found (printed)".to_owned();
            (
                [head].into_iter().chain(values).collect(),
                format!(
                    "at τ = 10⁴ the distance is {} τ², and not {} τ².",
                    ends[0], printed[0]
                ),
            )
        }
        ("record", [of, sigma, tau, _]) => (
            Vec::new(),
            format!("relative to the record {}.", fate(*of, *sigma, *tau)),
        ),
        ("turntable" | "rest", [of, sigma, tau, _]) => {
            let [sigma_of, tau_of] = [*sigma, *tau].map(fixed);
            let certain = ["fate", "certain at τ (1/Ω)"];
            let values = match of {
                1.0 => named(
                    &["fate", "σ (μg/Ω²)", "τ (1/Ω)"],
                    &["rest".into(), sigma_of, tau_of],
                ),
                0.0 => named(&certain, &["escape".into(), tau_of]),
                _ => named(&certain, &["undecided".into(), tau_of]),
            };
            (values, format!("): {}.", fate(*of, *sigma, *tau)))
        }
        ("sphere", [b, first, share, slip, ..]) => {
            let (value, words) = match *first < 0.0 {
                true => (
                    "not within 8π".to_owned(),
                    "it does not roll within four periods".to_owned(),
                ),
                false => (
                    fixed(*first),
                    format!("it first rolls at φ = {}", fixed(*first)),
                ),
            };
            (
                named(
                    &[
                        "b = 1 + 1/κ",
                        "first rolls at φ",
                        "share of rolling, last period",
                        "|slip| at 8π",
                    ],
                    &[fixed(*b), value, fixed(*share), fixed(*slip)],
                ),
                format!(
                    ": {words}; in the last of four periods it rolls for {} % of the time.",
                    rounded(100.0 * share, 1)
                ),
            )
        }
        _ => return Err(format!("{name} shows {values:?}")),
    })
}

const TIME: &str = "Number(host.querySelector('.film input').value)";

struct Explorer<'p, 'b> {
    page: &'p mut Page<'b>,
    name: &'static str,
}

impl<'p, 'b> Explorer<'p, 'b> {
    fn open(page: &'p mut Page<'b>, book: &Book, name: &'static str, state: &str) -> Seen<Self> {
        let query = if state.is_empty() {
            String::new()
        } else {
            format!("#explore-{name}?{state}")
        };
        let file = format!("{}.html", page_of(name));
        page.open(&format!("{}{query}", book.address(&file)))?;
        // It is made when it comes near.
        page.wait_for(&format!(
            "(host => (host.nextElementSibling.scrollIntoView({{ behavior: 'instant' }}), host.dataset.shown !== undefined))(document.getElementById('explore-{name}'))"
        ))?;
        Ok(Explorer { page, name })
    }

    fn go(&mut self, state: &str) -> Seen {
        let hash = format!("#explore-{}?{state}", self.name);
        self.page.value(&format!("location.hash = '{hash}'"))?;
        self.wait_for(&format!("host.dataset.shown === '{hash}'"))
    }

    /// An expression in which `host` is the explorer.
    fn of_host(&self, expression: &str) -> String {
        let name = self.name;
        format!("(host => {expression})(document.getElementById('explore-{name}'))")
    }

    fn value(&mut self, expression: &str) -> Seen<Value> {
        self.page.value(&self.of_host(expression))
    }

    fn read<T: DeserializeOwned>(&mut self, expression: &str) -> Seen<T> {
        let value = self.value(expression)?;
        serde_json::from_value(value).map_err(|error| format!("{}: {error}", self.name))
    }

    fn wait_for(&mut self, condition: &str) -> Seen {
        self.page.wait_for(&self.of_host(condition))
    }

    /// `host` is the explorer in it.
    fn state(&mut self) -> Seen<Vec<f64>> {
        self.wait_for("host.dataset.shown !== undefined")?;
        self.read("[...host.querySelectorAll('.inputs input')].map(i => Number(i.value))")
    }

    fn plays(&mut self) -> Seen {
        self.wait_for(&format!("{TIME} > 1"))
    }

    fn wait_until_moved(&mut self, before: &[f64]) -> Seen {
        let inputs = "[...host.querySelectorAll('.inputs input')]";
        self.wait_for(&format!(
            "{inputs}.some((input, i) => Number(input.value) !== {before:?}[i])"
        ))
    }

    /// It has to move one input.
    fn steps(&mut self, part: &str, key: &str) -> Seen {
        let before = self.right()?;
        self.page.press(key)?;
        let after = self.right()?;
        match before.iter().zip(&after).filter(|(a, b)| a != b).count() {
            1 => Ok(()),
            _ => Err(format!(
                "{}, {part}: {key} led from {before:?} to {after:?}",
                self.name
            )),
        }
    }

    fn right(&mut self) -> Seen<Vec<f64>> {
        let (name, state) = (self.name, self.state()?);
        let shown: Vec<String> = self.read(
            "[...host.querySelectorAll('dd')].map(e => `${e.previousElementSibling.textContent}: ${e.textContent}`)",
        )?;
        let says: String = self.read("host.querySelector('.says').textContent")?;
        let (values, words) = expected(name, &state)?;
        if shown == values && says.contains(&words) {
            Ok(state)
        } else {
            Err(format!(
                "{name} at {state:?} shows {shown:?} and says {says}, but the crate says {values:?}: {words}"
            ))
        }
    }

    fn drawing(&mut self) -> Seen<Value> {
        self.value(
            "[...host.querySelectorAll('.curve, .stage path')].map(e => e.getAttribute('d'))",
        )
    }

    fn hands(&self) -> &'static [usize] {
        match self.name {
            "sphere" => &[1],
            "turntable" | "rest" | "constant" | "anisotropic" => &[0],
            _ => &[],
        }
    }

    /// The place of its hand and the corners of its frame on the screen, once in view.
    fn places(&mut self, plot: usize) -> Seen<[[f64; 2]; 3]> {
        self.read(&format!(
            "(plot => {{ plot.scrollIntoView({{ block: 'center', behavior: 'instant' }});
                const [hand, frame] = [plot.querySelector('.hand circle'), plot.querySelector('.frame')].map(e => e.getBoundingClientRect());
                return [[hand.x + hand.width / 2, hand.y + hand.height / 2], [frame.left, frame.bottom], [frame.right, frame.top]]; }})
             (host.querySelectorAll('.explore-plot')[{plot}])"
        ))
    }

    fn body(&mut self, k: u64) -> Seen<[f64; 2]> {
        self.read(&format!(
            "(hand => {{ hand.scrollIntoView({{ block: 'center', behavior: 'instant' }}); const box = hand.lastElementChild.getBoundingClientRect();
                return [box.x + box.width / 2, box.y + box.height / 2]; }})(host.querySelectorAll('.stage .hand')[{k}])"
        ))
    }

    fn check_unharmed(&mut self) -> Seen {
        let (name, complaints) = (self.name, self.page.complaints());
        let here: String = self.read("location.pathname")?;
        if !complaints.is_empty() || !here.ends_with(&format!("{}.html", page_of(name))) {
            return Err(format!("{name}: at {here} with complaints {complaints:?}"));
        }
        Ok(())
    }
}

pub fn desk(page: &mut Page, book: &Book) -> Seen {
    for name in PAGES.map(name_on) {
        let mut explorer = Explorer::open(page, book, name, "")?;
        let first = explorer.right()?;
        keyboard(&mut explorer)?;
        mouse(&mut explorer)?;
        bodies(&mut explorer)?;
        explorer.value("host.querySelector('.inputs button').click()")?;
        let again = explorer.right()?;
        if first != again {
            return Err(format!(
                "{name} starts at {first:?} but goes back to {again:?}"
            ));
        }
        sliders(&mut explorer)?;
        states(&mut explorer)?;
        explorer.check_unharmed()?;
    }
    Ok(())
}

fn states(explorer: &mut Explorer<'_, '_>) -> Seen {
    let name = explorer.name;
    let states = STATES.iter().find(|(of, _)| *of == name);
    for state in states.ok_or("no states")?.1 {
        explorer.go(state)?;
        let found = explorer.right()?;
        let asked: Vec<f64> = state
            .split('&')
            .filter_map(|part| part.split('=').nth(1)?.parse().ok())
            .collect();
        if found != asked {
            return Err(format!(
                "{name} was asked for {asked:?} and shows {found:?}"
            ));
        }
    }
    Ok(())
}

/// No key turns the page.
fn keyboard(explorer: &mut Explorer<'_, '_>) -> Seen {
    let name = explorer.name;
    for plot in 0..explorer.hands().len() {
        explorer.value(&format!(
            "host.querySelectorAll('.explore-plot .hand')[{plot}].focus()"
        ))?;
        for key in [
            "ArrowRight",
            "ArrowUp",
            "ArrowLeft",
            "ArrowLeft",
            "ArrowDown",
            "ArrowDown",
        ] {
            let drawn = explorer.drawing()?;
            explorer.steps(&format!("hand {plot}"), key)?;
            if explorer.drawing()? == drawn {
                return Err(format!("{name}, hand {plot}: {key} draws nothing anew"));
            }
        }
    }
    Ok(())
}

fn sliders(explorer: &mut Explorer<'_, '_>) -> Seen {
    let name = explorer.name;
    let count = match name {
        "record" => 0,
        _ => explorer.state()?.len(),
    };
    for i in 0..count {
        let before = explorer.right()?;
        explorer.value(&format!(
            "host.querySelectorAll('.inputs input')[{i}].focus()"
        ))?;
        let keys = match explorer.read(&format!(
            "(slider => slider.value === slider.min)(host.querySelectorAll('.inputs input')[{i}])"
        ))? {
            true => ["ArrowRight", "ArrowUp", "ArrowRight"],
            false => ["ArrowLeft", "ArrowDown", "ArrowLeft"],
        };
        for key in keys {
            explorer.page.press(key)?;
        }
        let after = explorer.right()?;
        let moved = (0..count).all(|k| (before[k] != after[k]) == (k == i));
        if !moved {
            return Err(format!(
                "{name}: slider {i} led from {before:?} to {after:?}"
            ));
        }
    }
    if count == 0 {
        return Ok(());
    }
    // A little later; until then a link to the address that still stands leads nowhere.
    explorer.wait_for("host.dataset.shown === location.hash")
}

fn mouse(explorer: &mut Explorer<'_, '_>) -> Seen {
    let name = explorer.name;
    for &plot in explorer.hands() {
        let (before, drawn) = (explorer.right()?, explorer.drawing()?);
        let [hand, low, high] = explorer.places(plot)?;
        let share = |s: f64, t: f64| {
            [
                low[0] + s * (high[0] - low[0]),
                low[1] + t * (high[1] - low[1]),
            ]
        };
        explorer
            .page
            .drag(&[hand, share(0.4, 0.4), share(0.6, 0.6)])?;
        let after = explorer.right()?;
        if after == before || explorer.drawing()? == drawn {
            return Err(format!(
                "{name}: dragging the hand of plot {plot} does nothing at {before:?}"
            ));
        }
        // Up to the steps of the inputs and the axis to which the hand is bound.
        let [hand, ..] = explorer.places(plot)?;
        let off = [0, 1].map(|i| (hand[i] - share(0.6, 0.6)[i]).abs());
        let free = match (name, plot) {
            ("constant", _) => true,
            _ => off[0] < 3.0 && off[1] < 3.0,
        };
        if !free {
            return Err(format!(
                "{name}: the hand of plot {plot} is {off:?} pixels from the mouse"
            ));
        }
    }
    Ok(())
}

fn bodies(explorer: &mut Explorer<'_, '_>) -> Seen {
    let name = explorer.name;
    let count: u64 = explorer.read("host.querySelectorAll('.stage .hand').length")?;
    if count == 0 {
        return Err(format!("{name}: nothing on the stage can be taken"));
    }
    for k in 0..count {
        explorer.value(&format!(
            "host.querySelectorAll('.stage .hand')[{k}].focus()"
        ))?;
        for key in ["ArrowRight", "ArrowUp", "ArrowLeft", "ArrowDown"] {
            explorer.steps(&format!("body {k}"), key)?;
        }
        let ([x, y], before) = (explorer.body(k)?, explorer.right()?);
        explorer
            .page
            .drag(&[[x, y], [x + 9.0, y - 7.0], [x + 21.0, y - 15.0]])?;
        let after = explorer.right()?;
        explorer.value("host.querySelector('.play[aria-label=Pause]')?.click()")?;
        if after == before {
            return Err(format!("{name}, body {k} does not follow the mouse"));
        }
    }
    Ok(())
}

pub fn touch(page: &mut Page, book: &Book) -> Seen {
    page.resize(390, 800)?;
    for name in PAGES.map(name_on) {
        let mut explorer = Explorer::open(page, book, name, "")?;
        for &plot in explorer.hands() {
            let before = explorer.right()?;
            let [_, low, high] = explorer.places(plot)?;
            explorer
                .page
                .tap([0.3 * low[0] + 0.7 * high[0], 0.7 * low[1] + 0.3 * high[1]])?;
            explorer.wait_until_moved(&before)?;
            explorer.right()?;
        }
        let before = explorer.right()?;
        let [x, y] = explorer.body(0)?;
        explorer.page.tap([x + 12.0, y - 9.0])?;
        explorer.wait_until_moved(&before)?;
        explorer.right()?;
        explorer.check_unharmed()?;
    }
    Ok(())
}

/// Played, stepped and drawn along, they end where the crate says; the first page's coin is taken by hand and let go.
pub fn stages(page: &mut Page, book: &Book) -> Seen {
    for name in PAGES.map(name_on) {
        let mut explorer = Explorer::open(page, book, name, "")?;
        let picture = "host.querySelector('.scene').innerHTML";
        explorer.value(
            "host.querySelector('.stage').scrollIntoView({ block: 'center', behavior: 'instant' })",
        )?;
        explorer.value(
            "new Promise(seen => requestAnimationFrame(() => requestAnimationFrame(seen)))",
        )?;
        let first = explorer.value(picture)?;
        explorer.value("host.querySelector('.play').click()")?;
        explorer.plays()?;
        explorer.value("host.querySelector('.play').click()")?;
        let (at, moved) = (explorer.value(TIME)?, explorer.value(picture)?);
        explorer.value("host.querySelector('.on').click()")?;
        if moved == first || explorer.value(TIME)? == at {
            return Err(format!("{name}: nothing moves"));
        }
        let draw_along = |to: &str| {
            format!(
                "(bar => {{ bar.value = {to}; bar.dispatchEvent(new Event('input', {{ bubbles: true }})); }})(host.querySelector('.film input'))"
            )
        };
        explorer.value(&draw_along("bar.max"))?;
        let last = explorer.value(picture)?;
        if last == moved {
            return Err(format!("{name}: the time cannot be drawn along"));
        }
        if name == "turntable" {
            const PICTURE: usize = 20;
            explorer.value(&draw_along(&PICTURE.to_string()))?;
            let place: [f64; 2] = explorer.read(
                "(coin => [Number(coin.getAttribute('cx')), Number(coin.getAttribute('cy'))])(host.querySelector('.scene .body'))",
            )?;
            let found = answer(4, [0.0, 1.5, 0.0, 0.0]).map_err(|error| error.to_string())?;
            let [x, y] = found.curves[1][PICTURE];
            let (there, scale) = ([180.0 + 57.0 * x, 130.0 - 57.0 * y], 0.06);
            if (0..2).any(|i| (place[i] - there[i]).abs() > scale) {
                return Err(format!(
                    "{name}: the coin is at {place:?}, not at {there:?}"
                ));
            }
        }
        guess(&mut explorer)?;
        explorer.check_unharmed()?;
    }
    let mut explorer = Explorer::open(page, book, "record", "")?;
    let before = explorer.right()?;
    let [x, y] = explorer.body(1)?;
    explorer
        .page
        .drag(&[[x, y], [x - 20.0, y - 10.0], [x - 40.0, y - 30.0]])?;
    if explorer.right()? == before {
        return Err("the coin's velocity does not follow the mouse".into());
    }
    explorer.plays()?;
    untold(page, book)?;
    // Nothing is told before the guess, also to who has nothing against motion.
    page.still(false)?;
    let mut wrong = Vec::new();
    for name in PAGES.map(name_on) {
        let mut explorer = Explorer::open(page, book, name, "")?;
        let said: Vec<String> = explorer.read(&format!(
            "(async ({{ predict: {{ asks, at }} }}) => {{
                host.querySelector('.stage').scrollIntoView({{ block: 'center', behavior: 'instant' }});
                await new Promise(done => setTimeout(done, 400));
                const shown = key => Number(host.querySelector(`.inputs [name=${{key}}]`).value);
                const named = [...asks.matchAll(/λ₀? = (\\d+(?:\\.\\d+)?)/g)].map(([, number]) => Number(number));
                return [
                    ...named.filter(number => number !== shown('lambda')).map(number => `λ is ${{shown('lambda')}}, not ${{number}}`),
                    ...Object.keys(at).filter(key => shown(key) !== at[key] && !(key === 'lambda' && named.length)).map(key => `${{key}} is ${{shown(key)}}`),
                    ...[...host.querySelectorAll('.says, .explore-plot [clip-path] *, .border, .printed')]
                        .filter(part => part.checkVisibility({{ visibilityProperty: true }})).map(part => `${{part.outerHTML}} is told`),
                    ...Number(host.querySelector('.film input').value) || host.querySelector('.play').ariaLabel === 'Pause' ? ['it moves'] : [],
                ];
            }})(slipbookExplorers.{name})"
        ))?;
        wrong.extend(said.into_iter().map(|words| format!("{name}: {words}")));
    }
    page.still(true)?;
    none(wrong)
}

/// Neither border is drawn before the film has been seen.
fn untold(page: &mut Page, book: &Book) -> Seen {
    let mut explorer = Explorer::open(page, book, "record", "")?;
    let told = "[...host.querySelectorAll('.scene :is(.border, .printed)')].map(e => e.getAttribute('class')).join()
        + ['.hint', '.says'].map(part => host.querySelector(part).checkVisibility()).join()";
    let before = explorer.value(told)?;
    if before != "false,false" {
        return Err(format!("before the question {before} is told"));
    }
    explorer.value("host.querySelector('.predict button').click()")?;
    explorer.plays()?;
    let during = explorer.value(told)?;
    if during != before {
        return Err(format!("while the bodies move {during} is told"));
    }
    explorer
        .wait_for("host.querySelector('.border') && host.querySelector('.printed') !== null")?;
    let after = explorer.value(told)?;
    if after != "border,printedtrue,true" {
        return Err(format!("in the end {after} is told"));
    }
    Ok(())
}

fn guess(explorer: &mut Explorer<'_, '_>) -> Seen {
    let name = explorer.name;
    let count: u64 = explorer.read("host.querySelectorAll('.predict button').length")?;
    for i in 0..count {
        explorer.value(&format!(
            "host.querySelectorAll('.predict button')[{i}].click()"
        ))?;
        let told: String =
            explorer.read("host.querySelector('.predict [role=status]').textContent")?;
        let (right, answer): (u64, String) = explorer.read(&format!(
            "(({{ right, options }}) => [right, options[right]])(slipbookExplorers.{name}.predict)"
        ))?;
        let begins = match right == i {
            true => "Yes.".to_owned(),
            false => format!("No: {}.", answer.replacen("It ", "it ", 1)),
        };
        if !told.starts_with(&begins) {
            return Err(format!("{name}: the guess {i} is answered with {told}"));
        }
        explorer.wait_for(&format!(
            "{TIME} > 0 && host.querySelector('.play').ariaLabel === 'Pause'
                && Object.entries(slipbookExplorers.{name}.predict.at).every(([key, value]) =>
                    Number(host.querySelector(`.inputs [name=${{key}}]`).value) === value)"
        ))?;
        explorer.right()?;
    }
    let seen = explorer.value("host.querySelector('.says').checkVisibility({ visibilityProperty: true }) || slipbookExplorers.record === slipbookExplorers[host.dataset.explorer]")?;
    if seen != true {
        return Err(format!("{name}: after the guess nothing is said"));
    }
    explorer.value("host.querySelector('.play[aria-label=Pause]')?.click()")?;
    Ok(())
}

const ODD: [&str; 7] = [
    "𝔴_𝔴: w_x, 𝔴",
    "_<b_>x</b> & _&amp;",
    "\"𝔴\" = '1'",
    "<tspan>𝔴</tspan>",
    "$1_$&",
    "κ_",
    "",
];

pub fn labels(page: &mut Page, book: &Book) -> Seen {
    let mut wrong = Vec::new();
    for (name, states) in STATES {
        let mut explorer = Explorer::open(page, book, name, "")?;
        for state in [""].iter().chain(states) {
            if !state.is_empty() {
                explorer.go(state)?;
            }
            let written: Vec<String> = explorer.read(
                "[...host.querySelectorAll('*')].flatMap(e => ['aria-label', 'aria-valuetext', 'title'].map(a => e.getAttribute(a) || '')
                    .concat([...e.childNodes].filter(n => n.nodeType === Node.TEXT_NODE).map(n => n.data)))",
            )?;
            let marked = written.into_iter().filter(|text| is_marked(text));
            wrong.extend(marked.map(|text| format!("{name} at {state}: {text}")));
        }
        wrong.extend(explorer.read::<Vec<String>>(&format!(
            "(seen => slipbookExplorers[host.dataset.explorer].plots(() => {{}}).flatMap(plot => [plot.title, plot.x.label, plot.y.label])
                .map({SEEN}).filter(words => !seen.includes(words)).map(words => `not seen: ${{words}}`))
             ([...host.querySelectorAll('svg text')].map({PLAIN}))"
        ))?);
    }
    let odd = json!(ODD);
    wrong.extend(page.texts(&format!(
        "{odd}.flatMap(text => {{
            const [host, axis] = [document.createElement('div'), {{ label: text, range: [0, 1], ticks: [[0, text]] }}];
            const hand = {{ label: text, range: [0, 1] }};
            new SlipbookPlot(host, 'odd', {{ title: text, label: text, x: axis, y: axis, hand }})
                .draw({{ marks: [{{ points: [0, 0], text: text || ' ' }}], hand: [0, 0], words: {{ now: 0, text }} }});
            const seen = [...host.querySelectorAll('text')].map({PLAIN});
            const told = [...host.querySelectorAll('[aria-label]')].map(e => e.getAttribute('aria-label'));
            return [...seen.filter(words => words !== ({SEEN})(text) && words !== ' '), ...told.filter(words => words !== text),
                ...(seen.length === 6 && told.length === 2 ? [] : ['some are missing'])].map(words => `${{text}}: ${{words}}`);
        }})"
    ))?);
    none(wrong)
}

const PLAIN: &str = "text => text.textContent.replaceAll('\u{200b}', '')";
const SEEN: &str = "label => label.replace(/_(.)/gsu, '$1').replaceAll('𝔴', 'w')";

/// They lead back to the same view; the page's own fragments still lead to their places.
pub fn addresses(page: &mut Page, book: &Book) -> Seen {
    for name in PAGES.map(name_on) {
        let mut explorer = Explorer::open(page, book, name, "")?;
        if explorer.page.value("location.hash")? != "" {
            return Err(format!(
                "{name}: the address changes before the reader does anything"
            ));
        }
        let first = match (name, explorer.hands()) {
            ("record", _) => ".stage .hand",
            (_, []) => ".inputs input",
            _ => ".explore-plot .hand",
        };
        explorer.value(&format!("host.querySelector('{first}').focus()"))?;
        explorer.page.press("ArrowLeft")?;
        let state = explorer.right()?;
        explorer.page.wait_for("location.hash !== ''")?;
        let hash = explorer.page.value("location.hash")?;
        let hash = hash.as_str().unwrap_or_default().to_owned();
        let file = format!("{}.html", page_of(name));
        page.open(&format!("{}{hash}", book.address(&file)))?;
        page.wait_for(&format!("(box => box.top < innerHeight && box.bottom > 0)(document.getElementById('explore-{name}').getBoundingClientRect())"))?;
        let again = Explorer { page, name }.right()?;
        if again != state {
            return Err(format!(
                "{name}: {hash} shows {again:?} instead of {state:?}"
            ));
        }
        // The still figure is behind a fold, which its own address opens.
        page.value("location.hash = document.querySelector('.explorer-static figure').id")?;
        page.wait_for("document.querySelector('.explorer-static svg').checkVisibility()")?;
        // A link followed before the last state is noted keeps its address.
        let kept = page.value(&format!(
            "document.querySelector('#explore-{name} .inputs button').click(), location.hash = 'elsewhere',
             new Promise(later => setTimeout(() => later(location.hash), 200))"
        ))?;
        if kept != "#elsewhere" {
            return Err(format!("{name}: {kept} has taken the place of an address"));
        }
        let target = page.value("[...document.querySelectorAll('main h2[id]')].pop().id")?;
        let target = target.as_str().unwrap_or_default().to_owned();
        page.value(&format!(
            "document.querySelector('a.header[href=\"#{target}\"]').click()"
        ))?;
        page.wait_for(&format!(
            "location.hash === '#{target}' && (box => box.top > -5 && box.top < innerHeight)(document.getElementById('{target}').getBoundingClientRect())"
        ))?;
        let mut explorer =
            Explorer::open(page, book, name, "lambda=1e99&rho=&theta=x&q=-7&nonsense=1")?;
        explorer.right()?;
        explorer.check_unharmed()?;
    }
    page.open(&book.address("escape.html#explore-escape?rho=1.1&plot=5"))?;
    page.wait_for("(box => box && box.top >= 0 && box.bottom <= innerHeight)(document.querySelectorAll('.explore-plot')[4]?.matches('.aimed') && document.querySelector('.aimed').getBoundingClientRect())")?;
    Ok(())
}

pub fn broken(page: &mut Page, book: &Book) -> Seen {
    page.open(&book.address("breaking.html"))?;
    page.wait_for("document.querySelector('#broken button') !== null")?;
    page.value("document.querySelector('#broken button').click()")?;
    page.wait_for("document.querySelector('#broken').dataset.shown === '0'")?;
    let all = claims();
    let time = all.iter().find(|claim| claim.id == "eq-13");
    let time = time.ok_or("(13) cannot be broken")?;
    let ways = breaks(time.id);
    let mut wrong = Vec::new();
    for (way, shown) in ways.iter().zip(["0", "1", "2"]) {
        page.wait_for(&format!(
            "document.querySelector('#broken').dataset.shown === '{shown}'"
        ))?;
        let trials = answer_to(time, way.seed).trials;
        let red = trials.iter().filter(|said| said.agrees == [true, false]);
        let red = red.count();
        let shown = "[...document.querySelectorAll('#broken .red code')].map(c => c.textContent)";
        let seen = page.texts(shown)?;
        if red == 0 || seen.len() != red {
            wrong.push(format!("{}: {seen:?} turn red, not {red}", way.wrong));
        }
        // Those who do not see the formula are told its text, whose letters are seen.
        let told =
            page.value("document.querySelector('#broken .broken math').getAttribute('alttext')")?;
        let seen = page.value(
            "[...document.querySelectorAll('#broken .broken :is(mi, mn, mo)')].map(part => part.textContent).join('')",
        )?;
        let seen: String = seen
            .as_str()
            .unwrap_or_default()
            .chars()
            .filter(|c| !"()\u{2061}\u{2062}".contains(*c))
            .collect();
        let letters: String = way
            .wrong
            .chars()
            .filter(|c| !"() /^".contains(*c))
            .map(|c| if c == '₀' { '0' } else { c })
            .collect();
        if told != way.wrong.as_str() || seen != letters {
            wrong.push(format!("{told} and {seen} are shown for {}", way.wrong));
        }
        let marks =
            page.value("document.querySelectorAll('#broken .broken :is(.wrong, .cut)').length")?;
        if marks.as_u64().is_none_or(|marks| marks == 0) {
            wrong.push(format!("nothing is marked in {}", way.wrong));
        }
        page.value("document.querySelector('#broken input').focus()")?;
        page.press("ArrowRight")?;
    }
    page.open(&book.address("breaking.html#broken?claim=eq-135"))?;
    let shown = "document.querySelector('#broken').dataset.shown";
    page.wait_for(&format!("{shown} === '0'"))?;
    let ways = breaks("eq-135");
    let signs = page
        .texts("[...document.querySelectorAll('#broken .sign')].map(sign => sign.dataset.ways)")?;
    if signs.is_empty() {
        wrong.push("there is no sign to click on".to_owned());
    }
    for (i, own) in signs.iter().enumerate() {
        page.value(&format!(
            "document.querySelectorAll('#broken .sign')[{i}].dispatchEvent(new MouseEvent('click', {{ bubbles: true }}))"
        ))?;
        page.wait_for(&format!("{shown} !== undefined"))?;
        let seen = page.value(&format!("Number({shown})"))?.as_f64();
        let way = ways.get(seen.unwrap_or(f64::MAX) as usize);
        let is_own = own.split(' ').any(|own| own.parse().ok() == seen);
        if !is_own || way.is_none_or(|way| way.formula != ways[0].formula) {
            wrong.push(format!("the sign {i} shows {seen:?}, not {own}"));
        }
    }
    wrong.extend(page.complaints());
    none(wrong)
}
