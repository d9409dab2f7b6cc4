//! Counts that are computed: from the library, its data, or what the page itself shows.
//!
//! What is found by a few words around the number has to be right; where the words are no longer there, nothing is asked.

use super::numbers::{literals, number, quotients, slots};
use super::printed_part::Library;
use super::text::{Page, Section, pages, sections_of};
use slipbook::claims::PAPER;
use slipbook::claims::anisotropic::census;
use slipbook::claims::anisotropic::simulated::{attractor, curve_a, curve_e, order};
use slipbook::claims::corners::CORNERS;
use slipbook::claims::periodic::drawn;
use slipbook::claims::periodic::drives::{Phase, motion, third_harmonic};
use slipbook::claims::tolerances::{ESCAPE_CORRECTION, ESCAPE_LIMIT};
use slipbook::evidence::{Compared, Evidence, Kind, Route, Subject, Tolerance};
use slipbook::ledger::{Verdict, judge};
use slipbook::motion::drive::{Drive, DriveState, Friction, Interval, Sign};
use slipbook::motion::sphere::{Ball, Sphere};
use slipbook::motion::turntable::{Start, State as Turning, intrinsic};
use slipbook::motion::{Launch, Plane};
use slipbook::numerics::fit::fit;
use slipbook::paper::{sinusoidal, sphere};
use slipbook::seeded::Corner;
use slipbook::solve::sinusoidal::SinusoidalProblem;
use slipbook::solve::{Double, VERSION};
use std::collections::BTreeSet;
use std::f64::consts::{FRAC_PI_2, PI, SQRT_2, TAU};
use std::sync::LazyLock;

/// What a number has to be.
enum Count {
    Is(fn() -> f64),
    /// One of these; of a page or a file that says nothing of it there are none, and nothing is asked.
    Among(fn(&Page) -> Vec<f64>),
    /// In the code of the same section.
    Code,
    /// This placeholder and no other.
    Filled(&'static str),
}

use Count::{Among, Code, Filled, Is};

/// A page, words with `{}` for the number, and what it has to be.
type Row = (&'static str, &'static str, Count);

macro_rules! counts {
    ($($page:literal, $words:literal => $count:expr;)*) => {
        const COUNTS: &[Row] = &[$(($page, $words, $count)),*];
    };
}

counts! {
    "methods", "asked {} times" => Among(|_| digits().asked);
    "methods", "has all its {} digits" => Among(|_| digits().most);
    "json", "number of up to {} digits" => Among(|_| digits().most);
    "json", "relative to that {} if" => Among(|_| digits().most);
    "methods", "with numbers of {} digits" => Is(digits_of_two);
    "methods", "computed in numbers of {} digits" => Is(digits_of_two);
    "json", "in numbers of {} digits" => Is(digits_of_two);
    "methods", "sums of {} floating-point" => Is(parts_of_two);
    "adding", "{} independent routes" => Is(routes_needed);
    "methods", "{} independent routes or by a proof" => Is(routes_needed);
    "own", "{} independent routes" => Is(routes_needed);
    "methods", "part in {} too strong" => Among(slips);
    "methods", "part in {} too early" => Among(slips);
    "methods", "a {} of 0 or of 1" => Is(|| edges("λ₀").map(|c| c.high - c.low).fold(0.0, f64::max));
    "methods", "coefficient of friction above {}" => Is(|| edges("μ").next().unwrap().low);
    "methods", "or § above {}" => Is(|| edges("α").find(|c| c.high.is_infinite()).unwrap().low);
    "methods", "or § above {} or" => Is(|| edges("β").find(|c| c.high.is_infinite()).unwrap().low);
    "methods", "or below a {}" => Is(|| edges("α").find(|c| c.low == 0.0).unwrap().high);
    "methods", "below a {} and" => Is(|| edges("β").find(|c| c.low == 0.0).unwrap().high);
    "general", "draws {} conclusions" => Is(|| without_number("general"));
    "general", "{} statements about every" => Is(|| without_number("general"));
    "exam", "second prints {} of them" => Among(|page| {
        let command = behind(&page.text, "slipbook exam --json > exam.json\nslipbook exam ").lines().next();
        command.iter().map(|line| line.split(' ').count() as f64).collect()
    });
    "new", "and measured to {}" => Is(critical);
    "new", "measured to {} digits" => Is(|| decimals(ESCAPE_LIMIT.value));
    "new", "of the logarithm to {}" => Is(|| decimals(ESCAPE_CORRECTION.value));
    "escape", "fit gives {}" => Is(|| decimals(ESCAPE_LIMIT.value));
    "escape", "stalls at {} digits" => Is(by_powers);
    "escape", "differ by {} per cent" => Is(|| {
        let pairs = [("a-printed", "a"), ("p-printed", "p"), ("s-printed", "s")];
        let apart = pairs.map(|(printed, right)| (value(printed) / value(right) - 1.0).abs());
        (100.0 * apart.into_iter().fold(0.0, f64::max)).ceil()
    });
    "escape", "turns {} times meanwhile" => Is(|| ((1e8 - 1e4) / TAU / 1e6).round() * 1e6);
    "escape", "than {} around" => Is(|| (SQRT_2 * 1e4_f64.ln() / TAU).floor());
    "escape", "is within {} of" => Code;
    "rest", "the code does to {} digits" => Is(critical);
    // Of an interval as long above as below.
    "rest", "{} of their digits are" => Among(|_| certain().map(|off| decimals(2.0 * off)).into_iter().collect());
    "rest", "above it to {} all escape" => Code;
    "rest", "turns {} times a minute" => Code;
    "rest", "less than a {} of each" => Code;
    "rest", "0.4 to {} below" => Code;
    "rest", "from 0.9 to {}" => Code;
    "json", "takes some {} steps" => Is(|| 10.0 * (steps() / 10.0).round());
    "json", "same for a {} starts" => Among(|_| timed().into_iter().take(1).collect());
    "json", "as for a {}" => Among(|_| timed().into_iter().skip(1).collect());
    "turntable", "next {} chapters" => Is(|| {
        let stems = PAPER.topics.iter().map(|topic| topic.stem);
        stems.skip_while(|stem| *stem != "turntable").skip(1).count() as f64
    });
    "turntable", "so {} numbers suffice" => Is(|| arguments(&["eq107_p_rate", "eq108_rho_rate", "eq109_psi_rate"]));
    "turntable", "suffice instead of {}" => Is(|| {
        let start = Turning { t: 0.0, x: [0.0; 2], v: [0.0; 2] };
        (start.x.len() + start.v.len()) as f64
    });
    "turntable", "grows at the rate {}" => Code;
    "turntable", "at {} turns a minute" => Code;
    "own", "{} equations are printed" => Among(|_| {
        let example = file("trialbook/examples/fall.rs");
        equations(behind(&example, "mod paper {").split("\n}").next().unwrap_or_default())
    });
    "own", "whole paper {} equations" => Among(|_| equations(&file("trialbook/examples/drag/main.rs")));
    "own", "it takes {} commands" => Among(|page| {
        let (steps, _) = page.text.split_once("## Break it").unwrap_or_default();
        let blocks = steps.split("```text").skip(1).filter_map(|block| block.split("```").next());
        let is_command = |line: &&str| line.starts_with("cargo ") || line.starts_with("cd ");
        some(blocks.flat_map(str::lines).filter(is_command).count())
    });
    "certificates", "became of {} spoiled files" => Among(|_| {
        let text = file("certificates/corrupted.txt");
        behind(&text, ": of ").split(' ').take(1).filter_map(|n| n.replace(',', "").parse().ok()).collect()
    });
    "methods", "mpmath to a {} decimals" => Among(|_| {
        let text = file("tests/data/digits/certified.csv");
        let long = text.lines().skip(1).filter_map(|row| row.split(',').nth(2)?.split_once('.'));
        let least = long.map(|(_, decimals)| decimals.len()).min();
        least.iter().map(|least| (least / 1000 * 1000) as f64).collect()
    });
    "json", "for {} numbers from the first" => Among(|page| {
        let range = behind(&page.text, "in the place of a number, `").split(':').nth(2);
        range.into_iter().map(leading).collect()
    });
    "json", "of {} parts" => Among(|page| {
        let shard = behind(&page.text, "`--shard ").split_once('/');
        shard.into_iter().map(|(_, of)| leading(of)).collect()
    });
    "json", "describes version {}" => Is(|| f64::from(VERSION));
    "json", "the {} of them add up" => Among(|page| {
        let section = behind(&page.text, "{#solve-anisotropic}").split("\n## ").next();
        some(section.unwrap_or_default().matches("| number | length of ").count())
    });
    "constant", "falls from {} to" => Is(|| half_tangent(0.0));
    "constant", "to {} as the velocity turns" => Is(|| half_tangent(1e4));
    "constant", "ends up with {} its initial speed" => Is(|| (1e9 * kept(90.0)).round() * 1e-9);
    "constant", "at {} to the inertial force" => Is(|| {
        let (mut near, mut far) = (1.0, 179.0);
        while far - near > 1e-6 {
            let middle = 0.5 * (near + far);
            *(if kept(middle) > 0.75 { &mut near } else { &mut far }) = middle;
        }
        near.round()
    });
    "constant", "takes a {} longer" => Is(|| {
        let launch = Launch::new(2.0, 1.0, 1.0, FRAC_PI_2).unwrap();
        launch.motion_to_rest().unwrap().end().t / (1.0 / 2.0) - 1.0
    });
    "constant", "with a {} of the time left" => Code;
    "constant", "about a {} of its initial value" => Code;
    "constant", "ends up with {} of its speed" => Code;
    "sinusoidal", "{} phases of a period special" => Is(|| PAPER.values().filter(|v| v.id.starts_with("phi-")).count() as f64);
    "sinusoidal", "the {} merge into" => Is(|| SPECIAL.len() as f64);
    "sinusoidal", "merge into {}" => Is(|| different_phases(TAU));
    "sinusoidal", "or {} if both ends" => Is(|| different_phases(9.0));
    "sinusoidal", "so only {} of the" => Is(ends_of_rests);
    "sinusoidal", "of the {} can end" => Is(|| SPECIAL.len() as f64);
    "sinusoidal", "about its {} borders" => Is(|| regimes() - 1.0);
    "sphere", "the {} kinds of motion" => Is(regimes);
    "sinusoidal", "passes through zero {} in a period" => Is(|| zeros(0.3));
    "sinusoidal", "{} zeros in a period" => Is(|| zeros(0.3));
    "sinusoidal", "{} passages per period" => Is(|| zeros(0.3));
    "sinusoidal", "vanishes at {} instants" => Code;
    "sphere", "the {} instants of each period" => Is(|| zeros(0.3));
    "sphere", "printed formulas give {} that" => Is(|| {
        let start = Ball { t: 0.0, x: [0.0; 2], v: [0.0, 1.0], omega: [0.0; 3] };
        let plane = Plane::constant([-2.0, 0.0]);
        let motion = Sphere::with_kappa(0.4).run(&plane, &start, 1.0).unwrap();
        let printed = sphere::eq82_time(3.5 / 2.0, 1.0, FRAC_PI_2, 1e-9);
        (printed / motion.transitions()[0].t * 1e6).round() / 1e6
    });
    "sphere", "with {} components" => Is(|| {
        let ball = Ball { t: 0.0, x: [0.0; 2], v: [0.0; 2], omega: [0.0; 3] };
        ball.omega.len() as f64
    });
    "periodic", "at {} that distance after the maximum" => Is(|| {
        // A sine is 1 − x²/2 at its maximum.
        let swing = Drive::new(libm::sin, &[]).unwrap();
        let friction = Friction::new(1.0 - 1e-6, 1.0 - 1e-6).unwrap();
        let path = swing.advance(friction, DriveState { phi: 0.0, w: 0.0 }, PI).unwrap();
        let slip = path.intervals.iter().find(|i| i.sign == Sign::Positive).unwrap();
        (slip.end - FRAC_PI_2).div_euclid(0.99 * (FRAC_PI_2 - slip.start))
    });
    "periodic", "through zero {} times in a period" => Is(|| loops(0.04).len() as f64);
    "periodic", "{} large loops" => Is(|| (loops(0.04).len() - shallow(0.04).len()) as f64);
    "periodic", "{} shallow ones" => Is(|| shallow(0.04).len() as f64);
    "periodic", "deepens {} of the shallow loops" => Is(|| deepened(true));
    "periodic", "flattens the other {}" => Is(|| deepened(false));
    "periodic", "from none to {}" => Is(|| RESTS[1]);
    "periodic", "one {} and one again" => Is(|| RESTS[2]);
    "periodic", "and {} again" => Is(|| RESTS[3]);
    "periodic", "{} times as strong" => Code;
    "periodic", "pull {} times as long" => Code;
    "periodic", "rests for a {} of each" => Code;
    "periodic", "fill {} of the time" => Code;
    "anisotropic", "nearly {} points" => Is(|| (census::COLUMNS * census::ROWS).next_multiple_of(10_000) as f64);
    "anisotropic", "each of {} ×" => Code;
    "anisotropic", "× {} cells" => Code;
    "anisotropic", "the one {} between them" => Code;
    "anisotropic", "here are {}" => Code;
    "anisotropic", "{} kinds of motion" => Is(|| PAPER.claims().filter(|(_, claim)| claim.id.starts_with("s24-region-")).count() as f64);
    "anisotropic", "each period or {}" => Is(|| {
        let kinds = [0.2, 0.38, 0.45, 0.55, 1.1].map(|x| order(attractor(2.0, x).unwrap().intervals()));
        kinds.iter().map(|kind| kind.matches('0').count()).max().unwrap() as f64
    });
    "anisotropic", "(53) gives a {} of that" => Is(|| {
        let q = 1e4;
        (1e3 * curve_a(q).unwrap() / curve_e(q).unwrap().unwrap()).round() / 1e3
    });
    // Beside the phase.
    "anisotropic", "{} numbers decide which" => Is(|| arguments(&["eq51_rate", "eq52_rate"]) - 1.0);
    "anisotropic", "map of these {} numbers" => Is(|| arguments(&["eq51_rate", "eq52_rate"]) - 1.0);
    "anisotropic", "{} questions four borders" => Among(curves);
    "anisotropic", "questions {} borders" => Among(curves);
    "anisotropic", "{} questions decide what comes next" => Among(curves);
    "errata", "{} claims are false" => Filled("count wrong");
    "errata", "{} of them by an error of their own" => Filled("count roots");
    "errata", "{} because what they rest on" => Filled("count heirs");
    "errata", "{} by a slip in print" => Filled("count misprint");
    "errata", "{} need" => Filled("count conditional");
    "new", "up to the distance {}" => Filled("value critical-radius");
    "new", "up to the speed {}" => Filled("value critical-speed");
    "rest", "the critical radius {}" => Filled("value critical-radius");
    "methods", "of the {} claims" => Filled("count claims");
    "methods", "proved {} of the" => Filled("count proved");
    "methods", "argued {}" => Filled("count argued");
    "methods", "measured {}" => Filled("count measured");
    "methods", "of {} wrong variants" => Filled("count variants");
    "methods", "variants {} are rejected" => Filled("count rejected");
    "methods", "each of these {} mistakes" => Filled("count corners");
    "methods", "{} times in all" => Filled("count put");
    "index", "in {} comparisons" => Filled("count points");
    "index", "in {} topics" => Filled("count results");
    "index", "{} formulas have lost" => Filled("count factors");
    "index", "{} slips of the pen" => Filled("count misprint");
    "ledger", "all {} claims" => Filled("count claims");
}

/// Whether a page has the number right that a row is about. Where the same words stand with several, one of them has to be; but each
/// placeholder.
fn holds((_, pattern, count): &Row, page: &Page) -> Option<bool> {
    let found = slots(&page.words, pattern);
    let right = |(start, at, length): &(usize, usize, usize)| {
        let slot = &page.words[*at..at + length];
        let start = page.words[*start].at;
        let among = |all: Vec<f64>| {
            let close = |n: f64| all.iter().any(|right| (right - n).abs() <= 1e-9 * n.abs());
            all.is_empty() || number(slot).is_some_and(close)
        };
        match count {
            Is(right) => among(vec![right()]),
            Among(all) => among(all(page)),
            Code => {
                let sections = sections_of(&page.name, &page.text);
                let here = sections.iter().rfind(|section| section.from <= start);
                let code = here.into_iter().flat_map(Section::code);
                among(
                    code.flat_map(|code| [literals(code), quotients(code)].concat())
                        .chain([f64::NAN])
                        .collect(),
                )
            }
            Filled(placeholder) => slot
                .iter()
                .all(|word| word.text == format!("{{{placeholder}}}")),
        }
    };
    let all = matches!(count, Filled(_));
    let enough = || {
        if all {
            found.iter().all(right)
        } else {
            found.iter().any(right)
        }
    };
    (!found.is_empty()).then(enough)
}

#[test]
fn every_count_that_is_found_is_right_and_no_other_would_be() {
    let mut pages = pages();
    let (mut failures, mut tried) = (Vec::new(), 0);
    for row in COUNTS {
        let (name, pattern, _) = row;
        let page = pages
            .iter_mut()
            .find(|page| page.name == *name)
            .expect("a page");
        let Some(right) = holds(row, page) else {
            println!("{name}: it no longer says {pattern:?}");
            continue;
        };
        tried += 1;
        if !right {
            failures.push(format!("{name}: wrong in {pattern:?}"));
        }
        let words = page.words.clone();
        for (_, at, _) in slots(&words, pattern) {
            page.words[at].text = "77,777".to_owned();
        }
        let unknown = matches!(row.2, Among(all) if all(page).is_empty());
        if holds(row, page) != Some(false) && !unknown {
            failures.push(format!("{name}: anything would do in {pattern:?}"));
        }
        page.words = words;
    }
    println!("{tried} of {} counts are still there", COUNTS.len());
    assert!(
        failures.is_empty() && 2 * tried > COUNTS.len(),
        "{}",
        failures.join("\n")
    );
}

/// A file of the crate, empty if there is none.
fn file(path: &str) -> String {
    std::fs::read_to_string(path).unwrap_or_default()
}

/// What stands behind these words, nothing if they are not there.
fn behind<'a>(text: &'a str, words: &str) -> &'a str {
    text.split_once(words).unwrap_or_default().1
}

/// The number at the beginning of a text.
fn leading(text: &str) -> f64 {
    let end = text
        .find(|c: char| !c.is_ascii_digit() && c != '.')
        .unwrap_or(text.len());
    text[..end]
        .trim_end_matches('.')
        .parse()
        .unwrap_or(f64::NAN)
}

/// A number of things, none if none were found.
fn some(n: usize) -> Vec<f64> {
    (n > 0).then_some(n as f64).into_iter().collect()
}

/// What the record says of the calculators: how many cases each was asked, how many digits they claimed at most.
#[derive(Default)]
struct Digits {
    asked: Vec<f64>,
    most: Vec<f64>,
}

fn digits() -> Digits {
    let text = file("snapshots/digits.csv");
    let mut asked = std::collections::BTreeMap::<&str, f64>::new();
    let mut most = None;
    for row in text.lines().skip(1) {
        let cells: Vec<&str> = row.split(',').collect();
        let [calculator, claimed, _, cases] = cells[..] else {
            return Digits::default();
        };
        *asked.entry(calculator).or_default() += leading(cases);
        most = most.max(claimed.parse::<usize>().ok());
    }
    let mut asked: Vec<f64> = asked.into_values().collect();
    asked.dedup();
    // Each as often, or nothing can be said of all.
    asked.truncate(usize::from(asked.len() == 1));
    Digits {
        asked,
        most: most.map_or_else(Vec::new, some),
    }
}

/// How many parts each of the mistakes in a drive is one of.
fn slips(_: &Page) -> Vec<f64> {
    literals(&file("mutants/physics/2-drive.txt"))
        .into_iter()
        .map(|size| (1.0 / size).round())
        .collect()
}

/// The least and the largest number of starts that were timed, as powers of ten.
fn timed() -> Vec<f64> {
    let results: serde_json::Value =
        serde_json::from_str(&file("benches/results.json")).unwrap_or_default();
    let rows = results["growth"].as_array().cloned().unwrap_or_default();
    let starts = [rows.first(), rows.last()].into_iter().flatten();
    starts
        .filter_map(|row| Some(10_f64.powf(row["starts"].as_f64()?.log10().round())))
        .collect()
}

/// How many equations an example prints.
fn equations(example: &str) -> Vec<f64> {
    some(
        (1..100)
            .filter(|n| example.contains(&format!("pub fn eq{n}_")))
            .count(),
    )
}

/// How many curves a page has headings for.
fn curves(page: &Page) -> Vec<f64> {
    some(page.text.matches("{#curve-").count())
}

fn value(id: &str) -> f64 {
    PAPER.value(id).unwrap().number().unwrap()
}

/// To how many digits the critical radius and speed are given.
fn critical() -> f64 {
    let decimals = |id| PAPER.value(id).unwrap().decimals;
    decimals("critical-radius").min(decimals("critical-speed")) as f64
}

/// How near to them the code on the page on rest comes with its proofs.
fn certain() -> Option<f64> {
    literals(behind(&file("book/src/rest.md"), ".abs() > "))
        .first()
        .copied()
}

/// How many decimals are right of what is right to so much.
fn decimals(off: f64) -> f64 {
    (-off.log10() + 1e-9).floor()
}

/// To how many digits p/τ² is found by a fit that knows only powers of 1/τ.
fn by_powers() -> f64 {
    let start = Start::hyperbolic(1.5, 0.3, 1.0).unwrap();
    let data: Vec<_> = (0..40)
        .map(|i| {
            let tau = 10_f64.powf(6.0 + f64::from(i) / 20.0);
            let end = intrinsic::Run::new(&start, tau).unwrap().end();
            (tau, end.p() / (tau * tau))
        })
        .collect();
    let powers = fit(&data, &[&|_| 1.0, &|t| 1.0 / t, &|t| 1.0 / (t * t)]).unwrap();
    let limit = 1.0 / (3.0 * SQRT_2);
    decimals((powers.coefficients[0] / limit - 1.0).abs())
}

/// How many steps a motion on the turntable takes to rest, or to a time of 100, at a middle.
fn steps() -> f64 {
    let starts = [0.3, 0.6, 0.9, 1.2, 1.5].map(|a| Start::hyperbolic(a, 0.3, 1.0).unwrap());
    let runs = starts.map(|start| intrinsic::Run::new(&start, 100.0).unwrap());
    let mut steps = runs.map(|run| run.nodes().count());
    steps.sort_unstable();
    steps[2] as f64
}

/// How many floating-point numbers the calculators' numbers are made of.
fn parts_of_two() -> f64 {
    (size_of::<Double>() / size_of::<f64>()) as f64
}

/// How many decimal digits such a number has.
fn digits_of_two() -> f64 {
    (parts_of_two() * f64::from(f64::MANTISSA_DIGITS) * 2_f64.log10()).floor()
}

/// How many routes that measure the judge wants, each with motions of its own.
fn routes_needed() -> f64 {
    const ANY: Tolerance = Tolerance {
        name: "ANY",
        value: 1e-10,
        reason: "whichever",
    };
    let routes = [
        Route::Integration,
        Route::Quadrature,
        Route::Root,
        Route::Limit,
    ];
    let by = |route: &Route| {
        let compared = Compared::one("a formula", "the motion");
        Evidence {
            points: 1000,
            worst: 1e-12,
            ..Evidence::new(*route, Subject::Printed, compared, ANY)
        }
    };
    let confirmed = |n: &usize| {
        let evidence: Vec<Evidence> = routes[..*n].iter().map(by).collect();
        judge(Kind::Equation, None, &[], &evidence).verdict == Verdict::Confirmed
    };
    (0..=routes.len()).find(confirmed).unwrap() as f64
}

/// The corners of a symbol.
fn edges(letter: &'static str) -> impl Iterator<Item = &'static Corner> {
    CORNERS.iter().filter(move |corner| corner.letter == letter)
}

/// How many claims of a topic have no number.
fn without_number(topic: &str) -> f64 {
    let of_topic = PAPER
        .claims()
        .filter(|(of, claim)| of.stem == topic && claim.equation.is_none());
    of_topic.count() as f64
}

/// tan(θ/2) at a time, over what it was at the start.
fn half_tangent(t: f64) -> f64 {
    let motion = Launch::new(0.5, 1.0, 1.0, 2.0)
        .unwrap()
        .motion(1e4)
        .unwrap();
    ((motion.at(t).unwrap().direction() / 2.0).tan() / 1_f64.tan()).round()
}

/// The share of its speed that a particle keeps at λ = 1, launched at so many degrees to the inertial force.
fn kept(degrees: f64) -> f64 {
    let launch = Launch::new(1.0, 1.0, 1.0, degrees.to_radians()).unwrap();
    launch.motion(400.0).unwrap().end().speed()
}

/// The special phases of a period, by λ₀.
const SPECIAL: [fn(f64) -> f64; 4] = [
    sinusoidal::eq27_phi1,
    sinusoidal::eq28_phi2,
    sinusoidal::eq29_phi3,
    sinusoidal::eq30_phi4,
];

/// How many of them differ without friction, if those are the same that are so far apart.
fn different_phases(turn: f64) -> f64 {
    let mut at: Vec<f64> = SPECIAL.iter().map(|phase| phase(0.0) % turn).collect();
    at.sort_by(f64::total_cmp);
    at.dedup();
    at.len() as f64
}

/// At how many of them a rest ends.
fn ends_of_rests() -> f64 {
    let swing = Drive::new(libm::sin, &[]).unwrap();
    let friction = Friction::new(0.5, 0.5).unwrap();
    let ends = |phase: &&fn(f64) -> f64| {
        let start = DriveState {
            phi: phase(0.5) - 1e-3,
            w: 0.0,
        };
        let after = |time| {
            swing
                .advance(friction, start, start.phi + time)
                .unwrap()
                .end
                .w
        };
        after(5e-4) == 0.0 && after(0.1) != 0.0
    };
    SPECIAL.iter().filter(ends).count() as f64
}

/// How many regimes sinusoidal shaking has, from little friction to much.
fn regimes() -> f64 {
    let of = |i: u32| {
        SinusoidalProblem {
            lambda0: f64::from(i) / 20.0,
        }
        .solve()
        .unwrap()
        .best
        .regime
    };
    let mut all: Vec<_> = (1..30).map(of).collect();
    all.dedup();
    all.len() as f64
}

/// How often the large-time velocity is zero in a period of a sine without resting.
fn zeros(lambda: f64) -> f64 {
    let swing = Drive::new(libm::sin, &[]).unwrap();
    let friction = Friction::new(lambda, lambda).unwrap();
    let outcome = swing.attractor(friction, DriveState { phi: 0.0, w: 0.0 }, 99);
    let motion = outcome.unwrap().settled().unwrap();
    assert!(motion.intervals().iter().all(|i| i.sign != Sign::Rest));
    motion.intervals().len() as f64
}

/// The largest speed in each loop under the drive of which the page on any drive speaks.
fn loops(lambda: f64) -> Vec<f64> {
    let shape = third_harmonic(drawn::THIRD).unwrap();
    let motion = motion(&shape, lambda).unwrap().unwrap();
    let loops = motion.intervals().iter().filter(|i| i.sign != Sign::Rest);
    let largest = |i: &Interval| {
        let phases = (0..=200).map(|k| i.start + i.length() * f64::from(k) / 200.0);
        phases.map(|phi| motion.w(phi).abs()).fold(0.0, f64::max)
    };
    loops.map(largest).collect()
}

/// The loops with less than half of the largest speed, by their numbers.
fn shallow(lambda: f64) -> Vec<usize> {
    let sizes = loops(lambda);
    let most = sizes.iter().copied().fold(0.0, f64::max);
    (0..sizes.len())
        .filter(|i| sizes[*i] <= 0.5 * most)
        .collect()
}

/// How many of the shallow loops more friction deepens, or flattens.
fn deepened(deeper: bool) -> f64 {
    // The same loops one after the other, as none has gone.
    let (weak, strong) = (loops(0.02), loops(0.05));
    assert_eq!(weak.len(), strong.len());
    shallow(0.02)
        .iter()
        .filter(|i| (strong[**i] > weak[**i]) == deeper)
        .count() as f64
}

/// How many rests there are in a period, one number after the other, under growing friction.
static RESTS: LazyLock<Vec<f64>> = LazyLock::new(|| {
    let rests = |phase: &Phase| match phase {
        Phase::Rests(n) => *n as f64,
        other => panic!("{other:?}"),
    };
    let mut rests: Vec<f64> = drawn::census(100).unwrap()[1]
        .phases
        .iter()
        .map(rests)
        .collect();
    rests.dedup();
    rests
});

/// How many arguments these formulas have.
fn arguments(formulas: &[&str]) -> f64 {
    let library = Library::new();
    let all = formulas
        .iter()
        .flat_map(|name| library.formula(name).arguments);
    all.collect::<BTreeSet<_>>().len() as f64
}
