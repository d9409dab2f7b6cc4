use super::EDITION;
use crate::claims::PAPER;
use crate::evidence::{Compared, Evidence, Route, Sample, Subject, Tolerance};
use crate::ledger::{Entry, Ledger};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use tempfile::TempDir;
use trialbook::book::{self, BookError};
use trialbook::data::Text;
use trialbook::notation::{tags, without_tags};
use trialbook::plotting::Figure;
use trialbook::publishing::{Edition, Page, Part};
use trialbook::trials::{Claim, Paper, Topic, read::File};

/// Everything that a box can show, some of it hostile.
static FULL: Topic = Topic::new(
    "full",
    "Full",
    File::here(
        r#"
            [eq-13]
            section = "2.1"
            title = 'time as a function of $\theta_0$'
            latex = 't=\frac{a_1*b_2}{c_3*d_4}\left|\sqrt{x}\right|, {{y}}'
            plain = "t"
            conditions = [{ stated = '$\lambda<1$ & <b>' }, { substance = "v > 0" }]
            from = ["eq-11", "s21-large-friction-stops"]
            corrected = 't=-\frac{a_1*b_2}{c_3*d_4}\left|\sqrt{x}\right|, {{y}}'
            corrected-plain = "-t"
        "#,
    ),
    &[],
);

fn evidence(route: Route, subject: Subject, worst: f64) -> Evidence {
    const TEN_DIGITS: Tolerance = Tolerance {
        name: "TEN_DIGITS",
        value: 1e-10,
        reason: "ten digits of <both>",
    };
    let compared = Compared::one("<script>alert(1)</script>", "the *motion*");
    Evidence {
        points: 1234,
        failed: if worst > TEN_DIGITS.value { 7 } else { 0 },
        worst,
        at: "λ = 0.5, θ₀ < 1 & v|0 = 2".into(),
        samples: vec![Sample {
            at: "a_1 < 2".into(),
            stated: 0.25,
            found: f64::NAN,
        }],
        steps: if route.is_proof() {
            vec!["the difference <is>: 0".into()]
        } else {
            Vec::new()
        },
        ..Evidence::new(route, subject, compared, TEN_DIGITS)
    }
}

static DEEP: Paper = Paper {
    deep: Text::Built(
        "commit 0, 2026-01-01\t2\t2468\neq-11 integration printed 1\t2468\t0\t4e-13\tλ = 2\n",
    ),
    ..PAPER
};

/// Of all claims, of which two were tried; no trial is run for it.
fn ledger() -> Ledger {
    let entry = |topic: &'static Topic, claim: &'static Claim| {
        let evidence = match claim.id {
            "eq-11" => vec![
                evidence(Route::Exact, Subject::Printed, 0.0),
                evidence(Route::Integration, Subject::Printed, 3.2e-13),
            ],
            "eq-13" => vec![
                evidence(Route::Quadrature, Subject::Printed, f64::INFINITY),
                evidence(Route::Exact, Subject::Corrected, 0.0),
            ],
            _ => Vec::new(),
        };
        let claim = match claim.id {
            "eq-13" => Box::leak(Box::new(Claim {
                argument: "As $x$ <grows>.",
                ..FULL.claims()[0]
            })),
            "eq-11" => Box::leak(Box::new(Claim {
                conditions: &[],
                ..*claim
            })),
            _ => claim,
        };
        let judgement = claim.judged(&evidence);
        Entry {
            paper: &DEEP,
            claim,
            topic,
            evidence,
            judgement,
        }
    };
    let entries = PAPER.claims().map(|(topic, claim)| entry(topic, claim));
    Ledger {
        paper: &DEEP,
        entries: entries.collect(),
        beside: Vec::new(),
    }
}

fn figures() -> Vec<Figure> {
    let figure = |id| {
        Figure {
        id,
        caption: r"Hodographs for $\lambda\leq 1$".into(),
        alt: "curves that \"bend\"".into(),
        svg: "<?xml version=\"1.0\"?>\n<svg viewBox=\"0 0 4 2\">\n\n  <path d=\"M0 0 L4 2\"/>\n</svg>\n".into(),
        csv: "x,y\n0,0\n4,2\n".into(),
    }
    };
    let named = |text: &'static str| text.split("{{figure ").skip(1);
    let ids = EDITION.pages.iter().flat_map(|page| named(&page.text));
    ids.filter_map(|rest| rest.split("}}").next())
        .filter(|id| *id != "map")
        .map(figure)
        .collect()
}

fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let files = book::files_below(folder).unwrap().into_iter();
    files
        .map(|(name, path)| (name, fs::read(path).unwrap()))
        .collect()
}

fn values<'a>(html: &'a str, attribute: &str) -> Vec<&'a str> {
    let start = format!(" {attribute}=\"");
    let parts = html.split(start.as_str()).skip(1);
    parts.map(|part| part.split('"').next().unwrap()).collect()
}

/// What stands behind the first of these words, up to the second.
fn between<'a>(text: &'a str, start: &str, end: &str) -> &'a str {
    let behind = text.split(start).nth(1).expect(start);
    behind.split(end).next().unwrap_or_default()
}

/// Without tags and without code.
fn prose(html: &str) -> String {
    let main = between(html, "<main>", "</main>");
    let mut code = false;
    let text = tags(main).filter(|tag| {
        if tag.name == "code" {
            code = !tag.closes;
        }
        !code
    });
    text.map(|tag| tag.text).collect()
}

fn write(out: &Path) -> Result<PathBuf, BookError> {
    book::write(&EDITION, &ledger(), &figures(), out)
}

fn written(folder: &TempDir) -> BTreeMap<String, Vec<u8>> {
    let out = folder.path().join("deep/book");
    let first = write(&out).unwrap();
    assert_eq!(first, out.canonicalize().unwrap().join("index.html"));
    assert_eq!(book::dead_links(&out).unwrap(), [""; 0]);
    files(&out)
}

/// Written once for all who only read them.
fn whole() -> &'static BTreeMap<String, Vec<u8>> {
    static FILES: LazyLock<BTreeMap<String, Vec<u8>>> =
        LazyLock::new(|| written(&TempDir::new().unwrap()));
    &FILES
}

fn text(name: &str) -> &'static str {
    std::str::from_utf8(&whole()[name]).unwrap()
}

#[test]
fn the_book_is_whole() {
    let files = whole();
    let pages: Vec<_> = files
        .keys()
        .filter(|name| name.ends_with(".html"))
        .collect();
    // Those of the edition, those that lead on, the print page and the table of contents.
    let of_code = pages.iter().filter(|name| name.starts_with("code/"));
    let moved = EDITION.moved.iter().filter(|(from, _)| !from.contains('#'));
    assert_eq!(
        pages.len() - of_code.count(),
        EDITION.pages.len() + moved.count() + 2
    );

    for page in &pages {
        let html = text(page);
        for math in html.split("<math").skip(1) {
            let mut open = Vec::new();
            for tag in tags(math.split("</math>").next().unwrap()).skip(1) {
                match tag.closes {
                    true => assert_eq!(open.pop(), Some(tag.name), "{page}: {math:.200}"),
                    false => open.extend(Some(tag.name).filter(|_| !tag.alone)),
                }
            }
        }
        let ids = values(html, "id");
        assert_eq!(
            ids.iter().collect::<BTreeSet<_>>().len(),
            ids.len(),
            "{page}: an id twice"
        );
        if **page != "toc.html" && !page.starts_with("code/") {
            let prose = prose(html);
            let mut links = values(html, "href").into_iter();
            let out = links.find(|link| {
                link.starts_with("http")
                    && !link.starts_with("https://arxiv.org/abs/")
                    && !text("theme/questions.toml").contains(link)
            });
            assert_eq!(out, None, "{page} leads out of the book");
            for left in ["$", "{{", "}}", "\\frac", "**"] {
                assert!(!prose.contains(left), "{page}: a leftover {left}");
            }
        }
    }
    for name in files.keys() {
        if name.ends_with(".css") {
            for url in text(name).split("url(").skip(1) {
                let url = url.split(')').next().unwrap().trim_matches(['"', '\'']);
                if url.starts_with("data:") {
                    continue;
                }
                let mut place: Vec<_> = name.split('/').collect();
                place.pop();
                for step in url.split('/') {
                    match step {
                        ".." => drop(place.pop()),
                        step => place.push(step),
                    }
                }
                let path = place.join("/");
                assert!(files.contains_key(&path), "{name} loads {url}");
            }
        }
    }
    assert!(text("theme/katex/katex.min.css").contains("KaTeX_Main-Regular.woff2"));
    assert_eq!(text("figures/fig-1.csv"), "x,y\n0,0\n4,2\n");
}

/// Figures are numbered through a page, whichever of them a script folds away.
#[test]
fn figures_have_the_numbers_of_their_places() {
    for page in EDITION.pages {
        let html = text(&format!("{}.html", page.stem));
        let captions = html.split("<figcaption>").skip(1);
        for (i, caption) in captions.enumerate() {
            let number = format!("<strong>Fig. {}.</strong>", i + 1);
            assert!(caption.starts_with(&number), "{}: {}", page.stem, i + 1);
        }
    }
}

/// Numbers in the text lead to their equations, but where another paper's are meant; there are no cards there either.
#[test]
fn numbers_are_links_where_the_paper_is_spoken_of() {
    for page in EDITION.pages {
        let html = text(&format!("{}.html", page.stem));
        let about = page.part != Part::Use;
        assert_eq!(html.contains("theme/cards.js"), about, "{}", page.stem);
        assert!(about || !html.contains("class=\"cite\""), "{}", page.stem);
    }
    assert!(
        text("escape.html").contains("<a class=\"cite\" href=\"turntable.html#eq-113\">(113)</a>")
    );
}

#[test]
fn the_page_for_printing_leads_to_places_within_itself() {
    let main = text("print.html").split("<main>").nth(1).unwrap();
    for link in values(main, "href") {
        let chapter = link.split_once(".html").map(|(stem, _)| stem);
        assert!(
            EDITION.pages.iter().all(|page| Some(page.stem) != chapter),
            "{link} leads to another page"
        );
    }
    assert!(main.contains("href=\"#eq-11\"") && main.contains("id=\"eq-11\""));
}

/// Whatever was an address leads to its place, on a page that has moved elsewhere; the book itself knows the new ones alone.
#[test]
fn addresses_stay() {
    let files = whole();
    let moved = |address: &str| {
        let (page, _) = address.split_once('#')?;
        let own = EDITION.moved.iter().find(|(from, _)| *from == address);
        let begins = || {
            EDITION
                .moved
                .iter()
                .find(|(from, _)| from.ends_with('-') && address.starts_with(from))
        };
        let (from, to) = own
            .or_else(begins)
            .or_else(|| EDITION.moved.iter().find(|(from, _)| *from == page))?;
        Some(match from.contains('#') {
            true => address.replacen(from, to, 1),
            false => address.replacen(page, to.split('#').next()?, 1),
        })
    };
    let addresses = include_str!("../../tests/data/addresses.txt").lines();
    for (line, address) in (1..).zip(addresses) {
        let now = moved(address).unwrap_or_else(|| address.to_owned());
        let (page, id) = now.split_once('#').unwrap();
        assert!(
            text(page).contains(&format!(" id=\"{id}\"")),
            "tests/data/addresses.txt, line {line}: {address} leads nowhere: the claim that says it now has `was = [\"{id}\"]`, and `MOVED` in src/edition/pages.rs where what else has moved is"
        );
    }
    let old = EDITION.moved.iter().filter(|(from, _)| !from.contains('#'));
    for (old, _) in old {
        let link = format!("href=\"{old}");
        for (name, text) in files.iter().filter(|(name, _)| name.ends_with(".html")) {
            assert!(
                !String::from_utf8_lossy(text).contains(&link),
                "{name} leads to {old}"
            );
        }
    }
}

#[test]
fn the_search_finds_numbers_and_symbols() {
    let index = text("searchindex.js");
    for title in [
        r#""title":"(37) "#,
        "sinusoidal.html#eq-37",
        "λ_c = 2/√(4+π²)",
        "refuted",
    ] {
        assert!(index.contains(title), "no {title}");
    }
    // A formula is there once, and neither as MathML nor as LaTeX.
    assert!(!index.contains("mathrm") && !index.contains("\u{200b}"));
}

#[test]
fn every_claim_has_its_address_and_its_verdict() {
    for entry in &ledger().entries {
        let html = text(&format!("{}.html", entry.topic.stem));
        let start = format!("aria-labelledby=\"{}\"", entry.claim.id);
        let claim = between(html, &start, "</article>");
        let verdict = entry.judgement.verdict;
        let mark = format!("<span class=\"verdict {}\">", verdict.slug());
        let words = without_tags(between(claim, &mark, "</div>"));
        assert_eq!(words, verdict.words());
        assert!(claim.contains(&format!("id=\"{}\"", entry.claim.id)));
    }
}

#[test]
fn a_box_shows_all_and_data_stays_data() {
    let html = text("constant.html");
    let full = between(html, "id=\"eq-13\"", "</article>");
    for part in [
        "misprint",
        "As printed",
        "As corrected (changed: a sign)",
        "not stated in the paper",
        "&lt;grows&gt;",
        "&amp; &lt;b&gt;",
        "no value where the motion has one",
        "1,234 points",
        "7 of 1,234 disagree by more than 10<sup>−10</sup>; there is no",
        "Tolerance: ten digits of &lt;both&gt;.",
        "<td class=\"number\">0.25</td><td class=\"number\">no value</td>",
        "</span>|0 = 2",
        "Depends on <a href=\"constant.html#eq-11\" title=",
        "a_1*b_2",
        "<math",
        "<a class=\"permalink\" href=\"#eq-13\">",
        "constant.html#eq13_time\"><code>eq13_time</code>",
    ] {
        assert!(full.contains(part), "no {part} in {full}");
    }
    assert!(!html.contains("<script>alert"));
    let proof = between(full, "<strong>exact</strong>", "<strong>");
    assert!(
        proof.contains("<span class=\"outcome\">shown</span>"),
        "{proof}"
    );
    for part in [
        "The proof, 1 step",
        "the difference &lt;is&gt;: 0",
        "</details>",
    ] {
        assert!(proof.contains(part), "no {part} in {proof}");
    }
    assert!(!proof.contains("tolerance"), "{proof}");
    assert!(full.find("<strong>exact</strong>") < full.find("<strong>quadrature</strong>"));
    let used = between(html, "id=\"eq-11\"", "</article>");
    let users = between(used, "Used by ", "</p>");
    assert!(users.contains("<a href=\"constant.html#eq-13\" title="));
}

/// Where the book has an address and its sources are kept somewhere, each page says where it stands, and the first
/// one links to the sources.
#[test]
fn a_published_book_says_where_it_is() {
    const ADDRESS: &str = "https://slip.example/book/";
    let folder = TempDir::new().unwrap();
    let out = folder.path().join("book");
    let edition = Edition {
        address: Some(ADDRESS),
        repository: Some("https://code.example/slip"),
        ..EDITION
    };
    book::write(&edition, &ledger(), &figures(), &out).unwrap();
    let read = |stem: &str| fs::read_to_string(out.join(stem).with_extension("html")).unwrap();
    for page in EDITION.pages {
        let (stem, html) = (page.stem, read(page.stem));
        for part in [
            format!("<link rel=\"canonical\" href=\"{ADDRESS}{stem}.html\">"),
            format!("<meta property=\"og:url\" content=\"{ADDRESS}{stem}.html\">"),
            format!("<meta property=\"og:image\" content=\"{ADDRESS}share.png\">"),
        ] {
            assert_eq!(html.matches(&part).count(), 1, "{stem}: {part}");
        }
        let description = html.split_once("\"og:description\" content=\"").unwrap().1;
        assert!(!description.starts_with('"'), "{stem}");
    }
    assert!(out.join("share.png").is_file());
    assert!(
        read("index").contains("<a href=\"https://code.example/slip\">the program’s sources</a>")
    );
}

fn with_page(
    stem: &str,
    change: impl Fn(&str) -> String,
    out: &Path,
) -> Result<PathBuf, BookError> {
    let mut pages = EDITION.pages.to_vec();
    let page: &mut Page = pages.iter_mut().find(|page| page.stem == stem).unwrap();
    page.text = Text::Built(change(&page.text).leak());
    let edition = Edition {
        pages: pages.leak(),
        ..EDITION
    };
    book::write(&edition, &ledger(), &figures(), out)
}

#[test]
fn values_formulas_and_code_stand_where_they_should() {
    let folder = TempDir::new().unwrap();
    let out = folder.path().join("book");
    let added = "\nIt is {{verdict eq-11}}, *worst* {{worst eq-11}} at {{points eq-11}} points, see {{ref eq-11}}; \
                 $a_1*b_1*c_1$ and `$x {{y}}`.\n\n```text\n{{counts}} $\n```\n\n| $u$ | b |\n|---|---|\n| $\\lvert v\\rvert$ | 2 |\n";
    with_page("methods", |text| format!("{text}{added}"), &out).unwrap();
    let html = fs::read_to_string(out.join("methods.html")).unwrap();
    for part in [
        "It is <span class=\"verdict confirmed\">confirmed</span>, <em>worst</em> 3.2\u{a0}×\u{a0}10<sup>−13</sup> at 2,468 points",
        "<a href=\"constant.html#eq-11\" title=",
        "<code>$x {{y}}</code>",
        "{{counts}} $",
    ] {
        assert!(html.contains(part), "no {part}");
    }
    assert_eq!(
        html.split("It is <span")
            .nth(1)
            .unwrap()
            .matches("<em>")
            .count(),
        1
    );
}

#[test]
fn every_claim_leads_to_its_code() {
    let folder = TempDir::new().unwrap();
    let out = folder.path().join("book");
    let mut tried = ledger();
    for entry in &mut tried.entries {
        let blank = || evidence(Route::Integration, Subject::Printed, 0.0);
        entry.evidence = entry.claim.trials.iter().map(|_| blank()).collect();
    }
    book::write(&EDITION, &tried, &figures(), &out).unwrap();
    for entry in &tried.entries {
        let claim = entry.claim;
        let page = fs::read_to_string(out.join(format!("{}.html", entry.topic.stem))).unwrap();
        let start = format!("aria-labelledby=\"{}\"", claim.id);
        let html = between(&page, &start, "</article>");
        let leads =
            |word: &str, module: &str| html.contains(&format!("{word} <a href=\"code/{module}/"));
        assert!(
            leads("motion", "motion") && leads("claim", "claims"),
            "{}",
            claim.id
        );
        assert_eq!(
            leads("printed", "paper"),
            claim.equation.is_some(),
            "{}",
            claim.id
        );
        for (trial, link) in claim
            .trials
            .iter()
            .zip(html.split("class=\"code\" href=\"").skip(1))
        {
            let (file, name) = link.split('"').next().unwrap().split_once('#').unwrap();
            assert!(trial.name().ends_with(name), "{trial:?}: {name}");
            let code = fs::read_to_string(out.join(file)).unwrap();
            assert!(
                code.contains(&format!("<a id=\"{name}\"></a>")),
                "{trial:?}"
            );
        }
        assert_eq!(
            html.matches("class=\"code\"").count(),
            claim.trials.len(),
            "{}",
            claim.id
        );
    }
}

#[test]
fn every_symbol_stands_in_the_code() {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let sources = (EDITION.sources.files)();
    for symbol in EDITION.symbols {
        let word = symbol.argument;
        let found = sources.iter().any(|(_, text)| {
            text.match_indices(word).any(|(at, _)| {
                !text[..at].ends_with(is_word) && !text[at + word.len()..].starts_with(is_word)
            })
        });
        assert!(found, "no `{word}`");
    }
}
