//! What a reader waits for and can read: times with a processor four times slower, sizes on a phone, pages of paper.

use crate::Book;
use crate::chrome::{Page, Seen};
use crate::explorers::{PAGES, page_of};
use crate::pages::{CHAPTERS, none};
use serde_json::{Value, json};

const SLOWER: f64 = 4.0;
/// In milliseconds, with the slower processor.
const ANSWER: f64 = 50.0;
/// Of the page's own thread for all pages in one, in seconds; half a second more is waited.
const READY: f64 = 7.0;
/// A picture of sixty in a second.
const PICTURE: f64 = 1000.0 / 60.0;
/// Other work on the machine makes things late, a mistake makes them last for ever. The benchmark allows none of it.
const LEEWAY: f64 = 10.0;

fn allowed(aim: f64) -> f64 {
    match crate::timed_alone() {
        true => aim,
        false => LEEWAY * aim,
    }
}

const GIVEN: [(u32, &[[f64; 4]]); 14] = [
    (0, &[[1.2, 120.0, 0.0, 0.0], [1.01, 1.0, 0.0, 0.0]]),
    (1, &[[1.01, 0.0, 0.0, 0.0], [1.2, 0.0, 0.0, 0.0]]),
    (2, &[[2.0, 0.45, 1.5, 0.0], [1.0, 0.01, -2.0, 0.0]]),
    (3, &[[7.0, 0.0, 0.0, 0.0]]),
    (4, &[[0.8, -0.6, 0.4, 0.0], [0.87, 0.0, -0.87, 0.0]]),
    (
        5,
        &[
            [0.0, 0.0, 0.0, 0.0],
            [0.8, 0.0, 0.0, 0.0],
            [0.8, 1.0, 0.0, 0.0],
            [1.3, 0.0, 0.0, 0.0],
        ],
    ),
    (6, &[[0.75, 0.4, 0.0, 1.0], [0.05, 0.67, -2.0, 0.02]]),
    (7, &[[1.2, 120.0, 0.0, 0.0]]),
    (8, &[[2.0, 0.45, 1.5, 0.0]]),
    (9, &[[0.75, 0.4, 0.0, 1.0], [0.05, 0.67, -2.0, 0.02]]),
    (10, &[[0.9, 0.0, 0.0, 0.0], [2.0, 0.0, 0.0, 0.0]]),
    (11, &[[1.5, 0.08, 0.2, 0.0], [2.0, 0.01, 2.0, 0.0]]),
    (12, &[[2.0, 0.01, 2.0, 0.0]]),
    (13, &[[0.3, 0.5, 1.0, 0.0], [0.2, 0.0, 0.3, 0.0]]),
];

fn slow(page: &mut Page, rate: f64) -> Seen {
    page.call("Emulation.setCPUThrottlingRate", json!({ "rate": rate }))
        .map(drop)
}

pub fn answers(page: &mut Page, book: &Book) -> Seen {
    page.open(&book.address("index.html"))?;
    slow(page, SLOWER)?;
    let given: Vec<Value> = GIVEN
        .iter()
        .flat_map(|(number, all)| all.iter().map(move |given| json!([number, given])))
        .collect();
    let limit = allowed(ANSWER);
    let found = page.texts(&format!(
        "(async () => {{
            if (!window.slipbookModule) await new Promise(done => {{
                const script = document.createElement('script');
                script.src = 'theme/explorers-module.js';
                script.onload = done;
                document.head.append(script);
            }});
            const bytes = Uint8Array.from(atob(slipbookModule), c => c.charCodeAt(0));
            const {{ ask }} = (await WebAssembly.instantiate(bytes)).instance.exports;
            return {given}.map(([number, given]) => {{
                let least = Infinity;
                // Once without other work in between is enough.
                for (let i = 0; i < 40 && !(least < {limit}); i++) {{
                    const before = performance.now();
                    ask(number, ...given);
                    least = Math.min(least, performance.now() - before);
                }}
                return [least, `${{number}} at ${{given}} takes ${{least.toFixed(0)}} ms`];
            }}).filter(([least]) => !(least < {limit})).map(([, words]) => words);
        }})()",
        given = json!(given)
    ));
    slow(page, 1.0)?;
    none(found?)
}

/// From the slider to the picture, by one thread that is slowed down.
pub fn sliders(page: &mut Page, book: &Book) -> Seen {
    // Workers would not be slowed down.
    let alone = json!({ "source": "window.Worker = undefined;" });
    page.call("Page.addScriptToEvaluateOnNewDocument", alone)?;
    let (mut late, limit) = (Vec::new(), allowed(ANSWER));
    for name in PAGES.map(crate::explorers::name_on) {
        page.open(&book.address(&format!("{}.html", page_of(name))))?;
        page.show_explorer()?;
        slow(page, SLOWER)?;
        let found = page.texts(&format!(
            "(async host => {{
                const found = [];
                for (const slider of host.querySelectorAll('.inputs input')) {{
                    let least = Infinity;
                    // Once without other work in between is enough.
                    for (let i = 0; i < 24 && !(least < {limit}); i++) {{
                        const [low, high, step] = ['min', 'max', 'step'].map(end => Number(slider[end]));
                        await new Promise(rest => setTimeout(rest, 20));
                        const before = performance.now();
                        slider.value = low + step * Math.round((high - low) * ((0.11 + 0.37 * i) % 1) / step);
                        slider.dispatchEvent(new Event('input', {{ bubbles: true }}));
                        while (!host.dataset.whole) await new Promise(requestAnimationFrame);
                        least = Math.min(least, performance.now() - before);
                    }}
                    if (!(least < {limit})) found.push(`{name}, ${{slider.name}}: ${{least.toFixed(0)}} ms`);
                }}
                return found;
            }})(document.querySelector('[data-explorer]'))"
        ));
        slow(page, 1.0)?;
        late.extend(found?);
    }
    none(late)
}

pub fn frames(page: &mut Page, book: &Book) -> Seen {
    let mut late = Vec::new();
    for name in PAGES.map(crate::explorers::name_on) {
        page.open(&book.address(&format!("{}.html", page_of(name))))?;
        page.show_explorer()?;
        slow(page, SLOWER)?;
        let half = page.value(
            "(bar => {
                const round = () => {
                    const times = Array.from({ length: 41 }, (_, i) => {
                        const before = performance.now();
                        bar.value = bar.max * (i + 1) / 42;
                        bar.dispatchEvent(new Event('input', { bubbles: true }));
                        document.querySelector('.stage svg').getBoundingClientRect();
                        return performance.now() - before;
                    });
                    return times.sort((a, b) => a - b)[20];
                };
                // Once without other work in between is enough.
                let least = Infinity;
                for (let i = 0; i < 6 && !(least < 16); i++) least = Math.min(least, round());
                return least;
            })(document.querySelector('.film input'))",
        );
        slow(page, 1.0)?;
        let half = half?.as_f64().unwrap_or(f64::INFINITY);
        if half > allowed(PICTURE) {
            late.push(format!("{name}: {half:.1} ms for a picture"));
        }
    }
    none(late)
}

/// Words can be read; what one plays with stays in view; an explorer is in the first third of its page.
pub fn phone(page: &mut Page, book: &Book) -> Seen {
    let mut wrong = Vec::new();
    for name in PAGES.map(crate::explorers::name_on) {
        page.resize(1400, 900)?;
        page.open(&book.address(&format!("{}.html", page_of(name))))?;
        page.show_explorer()?;
        let place = page.value(
            "document.querySelector('[data-explorer]').getBoundingClientRect().top / document.documentElement.scrollHeight",
        )?;
        if place.as_f64().is_none_or(|place| place > 1.0 / 3.0) {
            wrong.push(format!("{name} stands at {place} of its page"));
        }
        page.resize(390, 800)?;
        page.wait_for("document.querySelector('[data-explorer]').clientWidth < 390")?;
        wrong.extend(page.texts(
            "(() => {
                document.querySelectorAll('.explorer-static').forEach(still => { still.open = true; });
                return [...document.querySelectorAll('figure.plot > div:not(.map-window) svg text, .explorer svg text')]
                    .filter(words => words.textContent.trim() && words.checkVisibility() && words.getScreenCTM())
                    .map(words => [parseFloat(getComputedStyle(words).fontSize) * Math.hypot(words.getScreenCTM().a, words.getScreenCTM().b), words])
                    .filter(([size]) => size < 12)
                    .map(([size, words]) => `${words.closest('figure, .explorer').id}: ${words.textContent} is ${size.toFixed(1)} px`);
            })()",
        )?);
        // Nothing around a figure cuts its labels off.
        wrong.extend(page.texts(
            "[...document.querySelectorAll('figure.plot > div:not(.map-window) svg')].filter(svg => {
                const { left, right } = svg.getBoundingClientRect();
                for (let box = svg.parentElement; !box.matches('.page'); box = box.parentElement) {
                    const seen = box.getBoundingClientRect();
                    if (getComputedStyle(box).overflowX !== 'visible' && (seen.left > left + 1 || seen.right < right - 1)) return true;
                }
                return false;
            }).map(svg => `${svg.closest('figure').id} is cut off`)",
        )?);
        if name == "record" {
            continue;
        }
        let hidden = page.texts(
            "(async () => {
                const host = document.querySelector('[data-explorer]'), bar = host.querySelector('.controls'), found = [];
                for (const picture of host.querySelectorAll('.stage svg, .explore-plot')) {
                    scrollTo({ top: scrollY + picture.getBoundingClientRect().top - 60, behavior: 'instant' });
                    await new Promise(done => setTimeout(done, 50));
                    const [seen, held] = [picture, bar].map(part => part.getBoundingClientRect());
                    if (held.top < seen.bottom - 1 || held.bottom > innerHeight + 1) {
                        found.push(`${picture.getAttribute('aria-label')}: to ${seen.bottom.toFixed(0)}, the controls from ${held.top.toFixed(0)} to ${held.bottom.toFixed(0)}`);
                    }
                }
                return found;
            })()",
        )?;
        wrong.extend(hidden.into_iter().map(|words| format!("{name}: {words}")));
    }
    none(wrong)
}

pub fn paper(page: &mut Page, book: &Book) -> Seen {
    let mut wrong = Vec::new();
    // What else this machine does is not counted.
    page.call("Performance.enable", json!({ "timeDomain": "threadTicks" }))?;
    page.open(&book.address("print.html"))?;
    let metrics = page.call("Performance.getMetrics", json!({}))?;
    let metrics = metrics["metrics"].as_array().ok_or("no metrics")?;
    let spent = metrics
        .iter()
        .find(|metric| metric["name"] == "TaskDuration");
    let spent = spent.and_then(|metric| metric["value"].as_f64());
    let spent = SLOWER * spent.unwrap_or(f64::INFINITY);
    if !(spent > 0.1 && spent < allowed(READY)) {
        wrong.push(format!("all pages in one take {spent:.1} s"));
    }
    none(wrong)
}

pub fn cards(page: &mut Page, book: &Book) -> Seen {
    page.open(&book.address(&format!("{}.html", CHAPTERS[7])))?;
    let mut wrong = Vec::new();
    for (pointed, says) in [
        (
            "[...document.querySelectorAll('a.cite')].find(cite => cite.textContent === '(113)')",
            "(113)",
        ),
        (
            "[...document.querySelectorAll('p .katex')].find(formula => formula.querySelector('math').textContent === 'ψ')",
            "ψ",
        ),
    ] {
        page.value(&format!(
            "({pointed}).dispatchEvent(new PointerEvent('pointerover', {{ bubbles: true }}))"
        ))?;
        let card = "document.querySelector('.card:not([hidden])')";
        let expected = format!(
            "{card}?.textContent.includes('{says}') && {card}.querySelector('.verdict') !== null"
        );
        if page.wait_for(&expected).is_err() {
            wrong.push(format!("there is no card for {says}"));
        }
    }
    none(wrong)
}
