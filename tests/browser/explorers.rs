//! The explorers under a reader's hands; whatever they show is held against the crate.

use crate::Book;
use crate::chrome::{Failure, Page};
use crate::pages::{is_marked, none};
use serde_json::{Value, json};
use slipbook::explorers::answer;

/// The pages with an explorer, which has the same name.
pub const PAGES: [&str; 4] = ["constant", "anisotropic", "sphere", "turntable"];

/// States to show, as they stand in the address; between them all that the explorer can say.
const STATES: [(&str, &[&str]); 4] = [
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
        "sphere",
        &[
            "lambda=0.75&kappa=0.4&u=0&v=1",
            "lambda=0.3&kappa=0.67&u=0.5&v=1",
            "lambda=1.5&kappa=0.05&u=0&v=0",
        ],
    ),
];

/// What an explorer must show at a state: the values, in order, from the crate.
fn expected(name: &str, state: &[f64]) -> Result<Vec<String>, Failure> {
    let mut given = [0.0; 4];
    given[..state.len()].copy_from_slice(state);
    let number = match name {
        "constant" => 0,
        "anisotropic" => 2,
        "turntable" => 4,
        _ => 6,
    };
    let values = answer(number, given)
        .map_err(|error| error.to_string())?
        .values;
    let fixed = |x: f64| {
        let text = format!("{x:.4}");
        if text == "-0.0000" {
            "0.0000".into()
        } else {
            text.replace('-', "−")
        }
    };
    Ok(match (name, values.as_slice()) {
        ("constant", [rests, t, vx, vy, x, y]) => {
            let end = if *rests == 1.0 {
                [t, x, y]
            } else {
                [t, vx, vy]
            };
            end.map(|value| fixed(*value)).into()
        }
        ("anisotropic", [region, mean, largest, rest, _, intervals @ ..]) => {
            let sign = |i: &[f64]| ["−", "0", "+"][(i[0] + 1.0) as usize];
            let order: Vec<_> = intervals.chunks(3).map(sign).collect();
            let region = ["none of the five", "I", "II", "III", "IV", "V"][*region as usize];
            let numbers = [mean, largest, rest].map(|value| fixed(*value));
            [region.into(), order.join(" ")]
                .into_iter()
                .chain(numbers)
                .collect()
        }
        ("turntable", [fate, sigma, tau]) => match fate {
            1.0 => vec!["rest".into(), fixed(*sigma), fixed(*tau)],
            0.0 => vec!["escape".into(), fixed(*tau)],
            _ => vec!["undecided".into(), fixed(*tau)],
        },
        ("sphere", [b, first, share, slip, ..]) => {
            let first = if *first < 0.0 {
                "not within 8π".into()
            } else {
                fixed(*first)
            };
            vec![fixed(*b), first, fixed(*share), fixed(*slip)]
        }
        _ => return Err(format!("{name} shows {values:?}")),
    })
}

/// An explorer as a reader has it before them.
struct Explorer<'p, 'b> {
    page: &'p mut Page<'b>,
    name: &'static str,
}

impl<'p, 'b> Explorer<'p, 'b> {
    fn open(
        page: &'p mut Page<'b>,
        book: &Book,
        name: &'static str,
        state: &str,
    ) -> Result<Self, Failure> {
        let query = if state.is_empty() {
            String::new()
        } else {
            format!("#explore-{name}?{state}")
        };
        page.open(&format!("{}{query}", book.address(&format!("{name}.html"))))?;
        Ok(Explorer { page, name })
    }

    /// Follows an address on the same page.
    fn go(&mut self, state: &str) -> Result<(), Failure> {
        let hash = format!("#explore-{}?{state}", self.name);
        let name = self.name;
        self.page.value(&format!("location.hash = '{hash}'"))?;
        self.page.wait_for(&format!(
            "document.getElementById('explore-{name}').dataset.shown === '{hash}'"
        ))
    }

    /// A value of an expression in which `host` is the explorer.
    fn value(&mut self, expression: &str) -> Result<Value, Failure> {
        let name = self.name;
        self.page.value(&format!(
            "(host => {expression})(document.getElementById('explore-{name}'))"
        ))
    }

    /// The strings in an array, as [`value`](Self::value).
    fn texts(&mut self, expression: &str) -> Result<Vec<String>, Failure> {
        let name = self.name;
        self.page.texts(&format!(
            "(host => {expression})(document.getElementById('explore-{name}'))"
        ))
    }

    /// The inputs, once the picture has caught up with them.
    fn state(&mut self) -> Result<Vec<f64>, Failure> {
        let name = self.name;
        self.page.wait_for(&format!(
            "document.getElementById('explore-{name}').dataset.shown !== undefined"
        ))?;
        let state = self.value("[...host.querySelectorAll('input')].map(i => Number(i.value))")?;
        let numbers = state
            .as_array()
            .map(|list| list.iter().filter_map(Value::as_f64).collect());
        numbers.ok_or_else(|| format!("{name} has no inputs"))
    }

    /// Requires that all that is shown is what the crate says, and returns the state.
    fn right(&mut self) -> Result<Vec<f64>, Failure> {
        let (name, state) = (self.name, self.state()?);
        let shown = self.page.texts(&format!(
            "[...document.querySelectorAll('#explore-{name} dd')].map(e => e.textContent)"
        ))?;
        let expected = expected(name, &state)?;
        if shown == expected {
            Ok(state)
        } else {
            Err(format!(
                "{name} at {state:?} shows {shown:?}, but the crate says {expected:?}"
            ))
        }
    }

    /// The curves of all plots, as drawn.
    fn drawn(&mut self) -> Result<Value, Failure> {
        self.value("[...host.querySelectorAll('.curve')].map(e => e.getAttribute('d'))")
    }

    /// The numbers of the plots that have a hand.
    fn hands(&self) -> &'static [usize] {
        match self.name {
            "sphere" => &[1],
            "turntable" => &[0, 1],
            _ => &[0],
        }
    }

    /// Brings a plot into view; the place of its hand and the corners of its frame on the screen.
    fn places(&mut self, plot: usize) -> Result<[[f64; 2]; 3], Failure> {
        let list = self.value(&format!(
            "(plot => {{ plot.scrollIntoView({{ block: 'center', behavior: 'instant' }});
                const [hand, frame] = [plot.querySelector('.hand circle'), plot.querySelector('.frame')].map(e => e.getBoundingClientRect());
                return [[hand.x + hand.width / 2, hand.y + hand.height / 2], [frame.left, frame.bottom], [frame.right, frame.top]]; }})
             (host.querySelectorAll('.explore-plot')[{plot}])"
        ))?;
        serde_json::from_value(list).map_err(|error| error.to_string())
    }

    /// Requires that the reader is still on the page and that it has not complained.
    fn unharmed(&mut self) -> Result<(), Failure> {
        let (name, complaints) = (self.name, self.page.complaints());
        let here = self.page.value("location.pathname")?;
        if !complaints.is_empty()
            || !here
                .as_str()
                .is_some_and(|path| path.ends_with(&format!("{name}.html")))
        {
            return Err(format!("{name}: at {here} with complaints {complaints:?}"));
        }
        Ok(())
    }
}

/// Whatever a reader at a desk does with it, each explorer shows what the crate says.
pub fn desk(page: &mut Page, book: &Book) -> Result<(), Failure> {
    for name in PAGES {
        let mut explorer = Explorer::open(page, book, name, "")?;
        let first = explorer.right()?;
        keyboard(&mut explorer)?;
        mouse(&mut explorer)?;
        explorer.value("host.querySelector('button').click()")?;
        let again = explorer.right()?;
        if first != again {
            return Err(format!(
                "{name} starts at {first:?} but goes back to {again:?}"
            ));
        }
        sliders(&mut explorer)?;
        states(&mut explorer)?;
        explorer.unharmed()?;
    }
    Ok(())
}

/// Led to a state by its address, it shows that state.
fn states(explorer: &mut Explorer<'_, '_>) -> Result<(), Failure> {
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

/// The arrow keys move every hand, and no key turns the page.
fn keyboard(explorer: &mut Explorer<'_, '_>) -> Result<(), Failure> {
    let name = explorer.name;
    for plot in 0..explorer.hands().len() {
        explorer.value(&format!("host.querySelectorAll('.hand')[{plot}].focus()"))?;
        for key in [
            "ArrowRight",
            "ArrowUp",
            "ArrowLeft",
            "ArrowLeft",
            "ArrowDown",
            "ArrowDown",
        ] {
            let (before, drawn) = (explorer.right()?, explorer.drawn()?);
            explorer.page.press(key)?;
            let after = explorer.right()?;
            let moved = before.iter().zip(&after).filter(|(a, b)| a != b).count();
            if moved != 1 || explorer.drawn()? == drawn {
                return Err(format!(
                    "{name}, hand {plot}: {key} led from {before:?} to {after:?}"
                ));
            }
        }
    }
    Ok(())
}

/// The arrow keys move every slider, and no other.
fn sliders(explorer: &mut Explorer<'_, '_>) -> Result<(), Failure> {
    let name = explorer.name;
    let count = explorer.state()?.len();
    for i in 0..count {
        let before = explorer.right()?;
        explorer.value(&format!("host.querySelectorAll('input')[{i}].focus()"))?;
        for key in ["ArrowLeft", "ArrowDown", "ArrowLeft"] {
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
    // The address follows, a little later; until then a link to the address that still stands leads nowhere.
    explorer.page.wait_for(&format!(
        "document.getElementById('explore-{name}').dataset.shown === location.hash"
    ))
}

/// The mouse takes every hand along, on its way too.
fn mouse(explorer: &mut Explorer<'_, '_>) -> Result<(), Failure> {
    let name = explorer.name;
    for &plot in explorer.hands() {
        let (before, drawn) = (explorer.right()?, explorer.drawn()?);
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
        if after == before || explorer.drawn()? == drawn {
            return Err(format!(
                "{name}: dragging the hand of plot {plot} does nothing at {before:?}"
            ));
        }
        // The hand is where the mouse left it, but for the steps of the inputs and the axis to which it is bound.
        let [hand, ..] = explorer.places(plot)?;
        let off = [0, 1].map(|i| (hand[i] - share(0.6, 0.6)[i]).abs());
        let free = match (name, plot) {
            ("constant", _) => true,
            ("turntable", 1) => off[0] < 3.0,
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

/// On a phone, a tap moves the hand.
pub fn touch(page: &mut Page, book: &Book) -> Result<(), Failure> {
    page.resize(390, 800)?;
    for name in PAGES {
        let mut explorer = Explorer::open(page, book, name, "")?;
        for &plot in explorer.hands() {
            let before = explorer.right()?;
            let [_, low, high] = explorer.places(plot)?;
            explorer
                .page
                .tap([0.3 * low[0] + 0.7 * high[0], 0.7 * low[1] + 0.3 * high[1]])?;
            explorer.page.wait_for(&format!(
                "[...document.querySelectorAll('#explore-{name} input')].some((input, i) => Number(input.value) !== {}[i])",
                json!(before)
            ))?;
            explorer.right()?;
        }
        explorer.unharmed()?;
    }
    Ok(())
}

/// Labels that a careless way to markup would break.
const ODD: [&str; 7] = [
    "𝔴_𝔴: w_x, 𝔴",
    "_<b_>x</b> & _&amp;",
    "\"𝔴\" = '1'",
    "<tspan>𝔴</tspan>",
    "$1_$&",
    "κ_",
    "",
];

/// All that is written, at every state, is words and nothing of their markup; so are labels that nobody has thought of.
pub fn labels(page: &mut Page, book: &Book) -> Result<(), Failure> {
    let mut wrong = Vec::new();
    for (name, states) in STATES {
        let mut explorer = Explorer::open(page, book, name, "")?;
        for state in [""].iter().chain(states) {
            if !state.is_empty() {
                explorer.go(state)?;
            }
            let written = explorer.texts(
                "[...host.querySelectorAll('*')].flatMap(e => ['aria-label', 'aria-valuetext', 'title'].map(a => e.getAttribute(a) || '')
                    .concat([...e.childNodes].filter(n => n.nodeType === Node.TEXT_NODE).map(n => n.data)))",
            )?;
            let marked = written.into_iter().filter(|text| is_marked(text));
            wrong.extend(marked.map(|text| format!("{name} at {state}: {text}")));
        }
        wrong.extend(explorer.texts(&format!(
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

/// A text as it is seen, and what is seen of a label.
const PLAIN: &str = "text => text.textContent.replaceAll('\u{200b}', '')";
const SEEN: &str = "label => label.replace(/_(.)/gsu, '$1').replaceAll('𝔴', 'w')";

/// The address follows the hand and leads back to the same view; the page's own fragments still lead to their places.
pub fn addresses(page: &mut Page, book: &Book) -> Result<(), Failure> {
    for name in PAGES {
        let mut explorer = Explorer::open(page, book, name, "")?;
        if explorer.page.value("location.hash")? != "" {
            return Err(format!(
                "{name}: the address changes before the reader does anything"
            ));
        }
        explorer.value("host.querySelector('.hand').focus()")?;
        explorer.page.press("ArrowLeft")?;
        let state = explorer.right()?;
        explorer.page.wait_for("location.hash !== ''")?;
        let hash = explorer.page.value("location.hash")?;
        let hash = hash.as_str().unwrap_or_default().to_owned();
        page.open(&format!("{}{hash}", book.address(&format!("{name}.html"))))?;
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
        // A link that is followed before the last state is noted keeps its address; timers of the same length run in order.
        let kept = page.value(&format!(
            "document.querySelector('#explore-{name} button').click(), location.hash = 'elsewhere',
             new Promise(later => setTimeout(() => later(location.hash), 200))"
        ))?;
        if kept != "#elsewhere" {
            return Err(format!("{name}: {kept} has taken the place of an address"));
        }
        // An ordinary fragment.
        let target = page.value("[...document.querySelectorAll('main h2[id]')].pop().id")?;
        let target = target.as_str().unwrap_or_default().to_owned();
        page.value(&format!(
            "document.querySelector('a.header[href=\"#{target}\"]').click()"
        ))?;
        page.wait_for(&format!(
            "location.hash === '#{target}' && (box => box.top > -5 && box.top < innerHeight)(document.getElementById('{target}').getBoundingClientRect())"
        ))?;
        // Nonsense in the address is not believed.
        let mut explorer =
            Explorer::open(page, book, name, "lambda=1e99&rho=&theta=x&q=-7&nonsense=1")?;
        explorer.right()?;
        explorer.unharmed()?;
    }
    Ok(())
}
