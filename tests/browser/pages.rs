//! Pages, links, search, print.

use crate::Book;
use crate::chrome::{Page, Seen};
use crate::visit::visits;
use serde_json::json;
use slipbook::claims::PAPER;
use std::collections::BTreeSet;

pub fn load(page: &mut Page, book: &Book) -> Seen {
    let visits = visits(page, book)?.iter();
    let found = visits.flat_map(|(name, visit)| {
        visit
            .complaints
            .iter()
            .map(move |complaint| format!("{name}: {complaint}"))
    });
    none(found.collect())
}

pub fn links(page: &mut Page, book: &Book) -> Seen {
    let (root, visits) = (book.address(""), visits(page, book)?);
    let leads = |address: &str| {
        let Some(path) = address.strip_prefix(&root) else {
            // They are named, and not asked for.
            let asked = include_str!("../../book/questions.toml").contains(address);
            return asked
                || address.starts_with("data:")
                || address.starts_with("https://arxiv.org/");
        };
        let (file, fragment) = path.split_once('#').unwrap_or((path, ""));
        let fragment = match fragment.split_once('&') {
            Some(("block" | "ball", _)) => "own",
            _ => fragment.split('?').next().unwrap_or(""),
        };
        let file = if file.is_empty() { "index.html" } else { file };
        let place = fragment.is_empty()
            || visits
                .get(file)
                .is_some_and(|visit| visit.places.contains(fragment));
        place && book.folder().join(file).is_file()
    };
    let used = visits
        .iter()
        .flat_map(|(name, visit)| visit.addresses.iter().map(move |address| (name, address)));
    let dead: BTreeSet<_> = used.filter(|(_, address)| !leads(address)).collect();
    none(
        dead.into_iter()
            .map(|(name, address)| format!("{name}: {address}"))
            .collect(),
    )
}

/// It shows what should have become markup, or has and is read as text. Between two quantities `<` is a sign.
pub fn is_marked(label: &str) -> bool {
    let label = label.replace(" < ", "").replace(" > ", "");
    label.contains(['"', '<', '>', '&', '_', '^'])
        || ["tspan", "font-", "KaTeX"]
            .iter()
            .any(|part| label.contains(part))
}

pub fn labels(page: &mut Page, book: &Book) -> Seen {
    let visits = visits(page, book)?;
    let all = || {
        visits
            .iter()
            .flat_map(|(name, visit)| visit.labels.iter().map(move |label| (name, label)))
    };
    if all().count() < 1000 {
        return Err(format!("only {} labels", all().count()));
    }
    let wrong = all().filter(|(_, label)| is_marked(label));
    none(
        wrong
            .map(|(name, label)| format!("{name}: {label}"))
            .collect(),
    )
}

fn questions() -> impl Iterator<Item = (&'static str, &'static str)> {
    let lines = include_str!("questions.tsv").lines();
    lines.filter_map(|line| line.split_once('\t'))
}

pub fn search(page: &mut Page, book: &Book) -> Seen {
    let mut missing = Vec::new();
    page.open(&book.address("index.html"))?;
    page.value("document.getElementById('mdbook-search-toggle').click()")?;
    let bar = "document.getElementById('mdbook-searchbar')";
    page.wait_for(&format!("document.activeElement === {bar}"))?;
    for (asked, address) in questions() {
        page.value(&format!("{bar}.value = ''"))?;
        page.write(asked)?;
        // For a key that the field waits for.
        page.press("ArrowRight")?;
        page.wait_for(&format!(
            "document.getElementById('mdbook-searchresults-header').textContent.includes({})",
            json!(format!(" for '{asked}'"))
        ))?;
        let results = "[...document.querySelectorAll('#mdbook-searchresults a')]";
        let found = page.texts(&format!("{results}.map(a => a.href)"))?;
        page.wait_for(&format!(
            "{results}.every(a => a.matches('.marked') || !/#(eq|fig|s[234])/.test(a.hash.replace(/-evidence$/, '')))"
        ))?;
        // mdBook adds the words to be marked to the address.
        let plain = |found: &String| {
            let (file, rest) = found.split_once('?').unwrap_or((found, ""));
            format!("{file}{}", rest.find('#').map_or("", |i| &rest[i..]))
        };
        if !found
            .first()
            .is_some_and(|found| plain(found).ends_with(address))
        {
            missing.push(format!("\"{asked}\" does not find {address} but {found:?}"));
        }
    }
    none(missing)
}

pub const CHAPTERS: [&str; 9] = [
    "general",
    "constant",
    "sinusoidal",
    "periodic",
    "anisotropic",
    "sphere",
    "turntable",
    "escape",
    "rest",
];

/// Folded, chapters and boxes are short; the switch unfolds all and is remembered.
pub fn folds(page: &mut Page, book: &Book) -> Seen {
    page.resize(1400, 900)?;
    let (mut lengths, mut wrong) = (Vec::new(), Vec::new());
    for name in CHAPTERS {
        page.open(&book.address(&format!("{name}.html")))?;
        page.show_explorer()?;
        let height = page.value("document.documentElement.scrollHeight")?;
        lengths.push((name, height.as_f64().unwrap_or(f64::INFINITY) / 900.0));
        wrong.extend(page.texts(
            "[...document.querySelectorAll('.claim:is(.confirmed, .degenerate, .definition)')].map(box => [box, [...box.children]
                .filter(part => part.matches('.claim-formula, .claim-words')).reduce((rest, part) => rest - part.offsetHeight, box.offsetHeight)])
                .filter(([, height]) => height > 120).map(([box, height]) => `${box.getAttribute('aria-labelledby')} is ${height} high`)",
        )?);
        // Nothing has to be scrolled aside on a desk; a table of samples may be wider.
        let unfolded = "document.querySelectorAll('main details').forEach(fold => { fold.dataset.was = fold.open; fold.open = true; })";
        let folded = "document.querySelectorAll('main details').forEach(fold => { fold.open = fold.dataset.was === 'true'; })";
        page.value(unfolded)?;
        wrong.extend(page.texts(
            "[...document.querySelectorAll('.katex-display, .steps, .claim-words, .says, .table-wrapper, pre')]
                .filter(box => box.scrollWidth > box.clientWidth + 1 && !box.closest('.samples') && box.checkVisibility())
                .map(box => `${box.closest('[id]').id}: ${box.textContent.slice(0, 60)} is ${box.scrollWidth} wide`)",
        )?);
        page.value(folded)?;
        let stops = page.value(
            "[...document.querySelectorAll('a[href], button, input, select, summary, [tabindex]')]
                .filter(part => part.tabIndex >= 0 && part.checkVisibility({ visibilityProperty: true })).length",
        )?;
        if stops.as_f64().is_none_or(|stops| stops > 116.0) {
            wrong.push(format!("{name} has {stops} stops for the tabulator"));
        }
        // The parts of the page are one of them.
        let parts = "[...document.querySelectorAll('#mdbook-sidebar a[href*=\"#\"]:not(.marked)')]";
        page.value(&format!("{parts}[0].focus()"))?;
        page.press("ArrowDown")?;
        if page.value(&format!("{parts}.indexOf(document.activeElement)"))? != 1 {
            wrong.push(format!(
                "{name}: the arrow keys do not lead to the next part"
            ));
        }
    }
    let screens: f64 = lengths.iter().map(|(_, screens)| screens).sum();
    if screens > 112.0 {
        wrong.push(format!(
            "the chapters are {screens:.1} screens long: {lengths:.1?}"
        ));
    }
    let open = "[...document.querySelectorAll('.evidence')].every(fold => fold.open)";
    page.value("document.querySelector('.audit').click()")?;
    for expected in [true, true] {
        if page.value(open)? != expected {
            wrong.push("the switch does not unfold, or is forgotten".to_owned());
        }
        page.open(&book.address("general.html"))?;
    }
    page.value("document.querySelector('.audit').click()")?;
    page.open(&book.address("constant.html"))?;
    page.open(&book.address("general.html#eq-1-evidence"))?;
    if page.value("document.getElementById('eq-1-evidence').open")? != true {
        wrong.push("a link to the evidence does not open it".to_owned());
    }
    none(wrong)
}

/// Half a second after it is there; and the place of an address its own.
pub fn lengths(page: &mut Page, book: &Book) -> Seen {
    let mut wrong = Vec::new();
    for width in [1400, 390] {
        page.resize(width, 900)?;
        for name in CHAPTERS.into_iter().chain(["errata", "lemmas"]) {
            let address = book.address(&format!("{name}.html"));
            page.open(&address)?;
            let places = page.texts("[...document.querySelectorAll('main [id]:is(h2, h3, .erratum, .lemma > p)')].map(place => place.id)")?;
            page.open(&book.address("lookup.html"))?;
            page.open(&format!("{address}#{}", places[2 * places.len() / 3]))?;
            page.wait_until_shown()?;
            let found = page.texts(
                "(async () => {
                    const wait = time => new Promise(done => setTimeout(done, time));
                    const high = () => document.documentElement.scrollHeight;
                    const top = () => document.getElementById(location.hash.slice(1)).getBoundingClientRect().top;
                    await wait(500);
                    const before = [top(), high()];
                    await wait(1000);
                    const moved = Math.abs(top() - before[0]);
                    for (let y = 0; y < high(); y += 600) {
                        scrollTo({ top: y, behavior: 'instant' });
                        await wait(20);
                    }
                    const grown = Math.abs(high() / before[1] - 1);
                    return [...before[0] < -1 || before[0] > 120 ? [`lands at ${before[0]}`] : [], ...moved > 3 ? [`moves by ${moved}`] : [], ...grown > 0.02 ? [`grows by ${grown}`] : []];
                })()",
            )?;
            wrong.extend(
                found
                    .into_iter()
                    .map(|words| format!("{name}, {width} wide, {words}")),
            );
        }
    }
    none(wrong)
}

pub fn front(page: &mut Page, book: &Book) -> Seen {
    page.open(&book.address("index.html"))?;
    let mut wrong = Vec::new();
    for (asked, address) in questions() {
        page.value(&format!(
            "(field => {{ field.value = {}; field.dispatchEvent(new Event('input')); }})(document.querySelector('.ask input'))",
            json!(asked)
        ))?;
        let answers = "document.querySelector('.ask .answers')";
        page.wait_for(&format!("{answers}.dataset.asked === {}", json!(asked)))?;
        let first = page.value(&format!("{answers}.querySelector('a')?.href ?? ''"))?;
        if !first.as_str().is_some_and(|first| first.ends_with(address)) {
            wrong.push(format!(
                "\"{asked}\" is answered with {first}, not {address}"
            ));
        }
        let bare = page.texts(&format!(
            "[...{answers}.querySelectorAll('li')].filter(li => /#(eq|fig|s[234])/.test(li.querySelector('a').hash)
                && !(li.querySelector('.verdict') && li.querySelector('.formula').textContent)).map(li => li.textContent)"
        ))?;
        wrong.extend(
            bare.into_iter()
                .map(|words| format!("\"{asked}\": without a verdict or a formula, {words}")),
        );
    }
    let more = "document.querySelector('.ask .answers p a')?.href";
    page.value("(field => { field.value = 'sphere'; field.dispatchEvent(new Event('input')); })(document.querySelector('.ask input'))")?;
    page.wait_for(&format!("{more}?.endsWith('?search=sphere')"))?;
    let more = page.value(more)?;
    page.open(more.as_str().unwrap_or_default())?;
    page.wait_for("document.querySelectorAll('#mdbook-searchresults a').length > 4")?;
    page.open(&book.address("index.html"))?;
    let hint = page.value("document.querySelector('.ask input').placeholder")?;
    for example in hint.as_str().unwrap_or_default().split(", ") {
        if !questions().any(|(asked, _)| asked == example) {
            wrong.push(format!("whether {example} is found is not known"));
        }
    }
    // Nothing has to be scrolled to, and no two parts of the strip are called the same.
    page.resize(1400, 900)?;
    page.open(&book.address("index.html"))?;
    page.show_explorer()?;
    let below =
        page.value("scrollY + document.querySelector('.front').getBoundingClientRect().bottom")?;
    if below.as_f64().is_none_or(|below| below > 900.0) {
        wrong.push(format!("the first page ends at {below}"));
    }
    let twice = page.texts(
        "[...document.querySelectorAll('.skeleton abbr')].map(part => part.textContent).filter((name, i, all) => all.indexOf(name) !== i)",
    )?;
    wrong.extend(
        twice
            .into_iter()
            .map(|name| format!("two parts of the strip are called {name}")),
    );
    let marks = page.value("document.querySelectorAll('.skeleton a').length")?;
    let numbered = PAPER.claims().filter(|(_, claim)| claim.equation.is_some());
    let numbered = numbered.count();
    if marks != numbered {
        wrong.push(format!(
            "the strip has {marks} marks for {numbered} equations"
        ));
    }
    page.value("document.querySelector('.skeleton a').focus()")?;
    page.press("ArrowRight")?;
    page.wait_for("document.querySelector('.skeleton-says').textContent.startsWith('(2)')")?;
    none(wrong)
}

pub fn filters(page: &mut Page, book: &Book) -> Seen {
    page.open(&book.address("ledger.html"))?;
    let mut wrong = Vec::new();
    let shown =
        "[...document.querySelectorAll('.ledger tbody tr')].filter(row => row.checkVisibility())";
    let type_in = |words: &str| {
        format!(
            "(field => {{ field.value = '{words}'; field.dispatchEvent(new Event('input')); }})(document.querySelector('.filter input'))"
        )
    };
    let press = |name: &str| format!("document.querySelector('.counts button.{name}').click()");
    let numbered = "document.querySelector('.filter [type=checkbox]').click()".to_owned();
    let fails = ".misprint, .misderived, .inherited, .refuted";
    for (act, undo, expected) in [
        (
            type_in("misprint"),
            type_in(""),
            "row.querySelector('.misprint')".to_owned(),
        ),
        (
            type_in("wrong"),
            type_in(""),
            format!("row.querySelector('{fails}')"),
        ),
        (
            type_in("tau"),
            type_in(""),
            "row.textContent.includes('τ')".to_owned(),
        ),
        (
            press("inherited"),
            press("inherited"),
            "row.querySelector('.inherited')".to_owned(),
        ),
        (
            numbered.clone(),
            numbered,
            "row.cells[0].textContent.startsWith('(')".to_owned(),
        ),
    ] {
        page.value(&act)?;
        let [right, all, there] = [
            format!("{shown}.filter(row => {expected}).length"),
            format!("{shown}.length"),
            format!("[...document.querySelectorAll('.ledger tbody tr')].filter(row => {expected}).length"),
        ]
        .map(|count| page.value(&count));
        let [right, all, there] = [right?, all?, there?];
        if right != all || right == 0 || all != there {
            wrong.push(format!(
                "{act}: {right} of {all} rows shown are right, and there are {there}"
            ));
        }
        page.value(&undo)?;
    }
    page.value("document.querySelectorAll('.ledger .sort')[1].click()")?;
    let first = page.value("document.querySelector('.ledger tbody tr .verdict').textContent")?;
    if first != "confirmed" {
        wrong.push("the table is not sorted by verdict".to_owned());
    }
    none(wrong)
}

pub fn moved(page: &mut Page, book: &Book) -> Seen {
    let mut wrong = Vec::new();
    for scripts in [true, false] {
        page.call(
            "Emulation.setScriptExecutionDisabled",
            json!({ "value": !scripts }),
        )?;
        for (old, new, place) in [
            (
                "findings.html#findings-eq-82",
                "errata.html",
                "erratum-eq-82",
            ),
            ("accuracy.html#digits", "methods.html", "digits"),
            ("values.html", "lookup.html", "values"),
            ("trust.html#break-it", "breaking.html", "break-it"),
        ] {
            page.call("Page.navigate", json!({ "url": book.address(old) }))?;
            let there = match scripts {
                true => format!(
                    "location.href === {} && document.getElementById('{place}') !== null",
                    json!(book.address(&format!("{new}#{place}")))
                ),
                false => "document.querySelector('main h1') !== null".to_owned(),
            };
            if page.wait_for(&there).is_err() {
                wrong.push(format!("{old} does not lead to {place}, scripts {scripts}"));
            }
        }
    }
    none(wrong)
}

pub fn contents(page: &mut Page, book: &Book) -> Seen {
    page.open(&book.address("index.html"))?;
    page.value("document.querySelector('button[aria-controls=mdbook-sidebar]').focus()")?;
    for open in [false, true] {
        page.press("Enter")?;
        page.wait_for(&format!(
            "document.documentElement.classList.contains('sidebar-visible') === {open}
             && document.activeElement.getAttribute('aria-expanded') === '{open}'"
        ))?;
    }
    Ok(())
}

pub fn narrow(page: &mut Page, book: &Book) -> Seen {
    let visits = visits(page, book)?
        .iter()
        .filter(|(name, _)| book.is_chapter(name));
    let wide = visits.filter(|(_, visit)| visit.width.as_f64().is_none_or(|width| width > 390.0));
    none(
        wide.map(|(name, visit)| format!("{name} is {} wide", visit.width))
            .collect(),
    )
}

pub fn without_scripts(page: &mut Page, book: &Book) -> Seen {
    page.call(
        "Emulation.setScriptExecutionDisabled",
        json!({ "value": true }),
    )?;
    let mut wrong = Vec::new();
    for name in crate::explorers::PAGES {
        page.call(
            "Page.navigate",
            json!({ "url": book.address(&format!("{name}.html")) }),
        )?;
        // The browser's own eyes are open.
        page.wait_for(&format!(
            "location.pathname.endsWith('/{name}.html') && document.readyState === 'complete'"
        ))?;
        let seen = page.value(
            "(() => { const host = document.querySelector('[data-explorer]');
               return [host.checkVisibility(), host.nextElementSibling.querySelector('svg').checkVisibility()]; })()",
        )?;
        if seen != json!([false, true]) {
            wrong.push(format!("{name}: explorer and figure are seen: {seen}"));
        }
    }
    none(wrong)
}

pub fn printing(page: &mut Page, book: &Book) -> Seen {
    let visit = visits(page, book)?.get("print.html");
    let seen = &visit.ok_or("no page for printing")?.explorers;
    let expected = json!(crate::explorers::PAGES.map(|_| [false, true]));
    if *seen == expected {
        Ok(())
    } else {
        Err(format!("explorers and figures are seen: {seen}"))
    }
}

pub fn none(found: Vec<String>) -> Seen {
    if found.is_empty() {
        Ok(())
    } else {
        Err(format!("{} found:\n{}", found.len(), found.join("\n")))
    }
}
