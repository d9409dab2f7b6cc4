//! The curves of a figure against its numbers: read back from the drawing by the ticks and the words at the axes.

use slipbook::figures::all;
use std::f64::consts::PI;
use std::sync::LazyLock;
use trialbook::notation::{Tag, tags};
use trialbook::plotting::Figure;

pub static FIGURES: LazyLock<Vec<Figure>> = LazyLock::new(|| all().unwrap());

const AXES: &str = "
cost: cost
error: error
digits claimed: claimed
digits true: true
ϕ: phi (rad)
w: w
q: q
λ0: lambda_0 | lambda_0 on A | lambda_0 on B or E | lambda_0 on C
λ: lambda
wy: w_y at phi = 0
A t/v0: t (v_0/A)
v/v0: v (v_0)
θ: theta (rad)
θ0: theta_0 (rad)
A T/v0: T (v_0/A)
vx/v0: v_x (v_0)
vy/v0: v_y (v_0)
x: x
y: y
τ: tau
p/τ2: value
A/τ3/2: value
(π/2 − ψ) τ: value
(3√2 p/τ2 − 1) τ: (3 sqrt(2) p/tau^2 - 1) tau
η: eta
ρ0: value
u0: value
σ: sigma
p: p
ψ: psi (rad)
(1 − A)/α: 
α cos ψ: 
α sin ψ: 
α: alpha
A: A
ρ: distance
outward: size
along: size
across: size
share of rest: share of rest
periods: periods
−ln wy: -ln w_y
γ: gamma
τ/(82): tau of the motion over (82)
velocity (A0/ϖ): slip (A_0/omega) | centre less mean (A_0/omega)
Ω2x/(μg): x on the table (mu g/Omega^2)
Ω2y/(μg): y on the table (mu g/Omega^2)
Ω2X/(μg): X in the laboratory (mu g/Omega^2)
Ω2Y/(μg): Y in the laboratory (mu g/Omega^2)
energy in m(μg)2/Ω2: p^2/2 | -rho^2/2 | s | sum
ψ, ψ1: psi (rad) | psi_1 (rad)
(π/2 − ψ)/(π/2 − ψ1): (pi/2-psi)/(pi/2-psi_1)
";

/// Lanes, borders, laws to compare with, the drive behind a motion, and paths turned around the axis.
const BESIDE: &[(&str, usize)] = &[
    ("sinusoidal-decay", 1),
    ("periodic-census", 9),
    ("periodic-come-and-go", 4),
    ("anisotropic-far", 1),
    ("anisotropic-drift", 20),
    ("sphere-times", 1),
    ("escape-fan", 133),
    ("rest-basin", 1),
    ("rest-census", 6),
    ("rest-boundary", 3),
    ("rest-space", 12),
];

/// Its place, how it is set, and what it says; a power of ten with `^`.
type Text = (f64, f64, String, String);

fn texts(tags: &[Tag<'_>]) -> Vec<Text> {
    let (mut texts, mut open) = (Vec::new(), None::<Text>);
    for tag in tags {
        match (&mut open, tag.name, tag.closes) {
            (_, "text", false) => {
                let place = |key| tag.value(key).and_then(|x| x.parse().ok());
                open = place("x")
                    .zip(place("y"))
                    .map(|(x, y)| (x, y, tag.tag.to_owned(), tag.text.to_owned()));
            }
            (_, "text", true) => texts.extend(open.take()),
            (Some((.., words)), _, closes) => {
                let power = !closes && words.ends_with("10");
                *words += if power { "^" } else { "" };
                *words += tag.text;
            }
            _ => {}
        }
    }
    texts
}

fn tick(words: &str) -> Option<f64> {
    let plain = words.replace('−', "-");
    if let Some(power) = plain.strip_prefix("10^") {
        return Some(libm::exp10(power.parse().ok()?));
    }
    let Some((times, over)) = plain.split_once('π') else {
        return plain.parse().ok();
    };
    let times = match times {
        "" => 1.0,
        "-" => -1.0,
        times => times.parse().ok()?,
    };
    let over = over
        .strip_prefix('/')
        .map_or(Some(1.0), |n| n.parse().ok())?;
    Some(times * PI / over)
}

/// On an even scale or on one of powers, if the other ticks fit.
fn scale(mut ticks: Vec<[f64; 2]>) -> Option<impl Fn(f64) -> f64> {
    ticks.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let (first, last) = (*ticks.first()?, *ticks.last()?);
    let on = move |logarithmic: bool, x: f64| {
        let f = |x: f64| if logarithmic { libm::log(x) } else { x };
        let part = (f(x) - f(first[1])) / (f(last[1]) - f(first[1]));
        first[0] + part * (last[0] - first[0])
    };
    let fits = |logarithmic| {
        ticks
            .iter()
            .all(|t| (on(logarithmic, t[1]) - t[0]).abs() < 0.1)
    };
    let kind = [false, true].into_iter().find(|kind| fits(*kind))?;
    (ticks.len() > 1).then_some(move |x| on(kind, x))
}

/// Left, top, bottom, right; with what is drawn from there on.
fn panels<'a, 'b>(svg: &'b [Tag<'a>]) -> Vec<([f64; 4], &'b [Tag<'a>])> {
    let frame = |tag: &Tag<'_>| {
        let (x, rest) = tag.value("d")?.strip_prefix('M')?.split_once(' ')?;
        let (top, rest) = rest.split_once('V')?;
        let (bottom, rest) = rest.split_once('H')?;
        let (right, _) = rest.split_once('M')?;
        let of = |text: &str| text.parse::<f64>().ok();
        let frame = [of(x)?, of(top)?, of(bottom)?, of(right)?];
        (frame[1] < frame[2]).then_some(frame)
    };
    let starts = svg
        .iter()
        .enumerate()
        .filter_map(|(i, tag)| Some((i, frame(tag)?)));
    let starts: Vec<_> = starts.collect();
    let ends = starts.iter().skip(1).map(|(at, _)| *at).chain([svg.len()]);
    starts
        .iter()
        .zip(ends)
        .map(|((at, frame), end)| (*frame, &svg[*at..end]))
        .collect()
}

type Drawn<'a> = (&'a str, Vec<[f64; 2]>);

fn colour<'a>(style: &'a str, what: &str) -> Option<&'a str> {
    style.split_once(what)?.1.split(['"', ',']).next()
}

fn curves<'a>(panel: &[Tag<'a>]) -> Vec<Drawn<'a>> {
    let drawn = panel
        .iter()
        .filter(|tag| tag.name == "path")
        .filter_map(|tag| {
            let data = tag.value("d")?;
            let line = tag.value("fill") == Some("none") && data.contains('L');
            let mut numbers = data.split(['M', 'L', ' ']).filter(|part| !part.is_empty());
            let mut corners = Vec::new();
            while let Some(x) = numbers.next().filter(|_| line) {
                corners.push([x.parse().ok()?, numbers.next()?.parse().ok()?]);
            }
            line.then_some((colour(tag.value("style")?, "stroke:")?, corners))
        });
    drawn.collect()
}

/// What words beside curves, or in the keys below, say of all of a colour: `λ0 = 0.3`.
fn labels(svg: &[Tag<'_>], panel: &[Tag<'_>]) -> Vec<(String, String, f64)> {
    let said = |colour: &str, words: &str| {
        let (name, value) = words.split_once(" = ")?;
        let value = value.split([':', ' ', ',']).next()?.parse().ok()?;
        Some((colour.to_owned(), name.to_owned(), value))
    };
    let beside = texts(panel).into_iter();
    let beside = beside.filter_map(|t| said(colour(&t.2, "style=\"fill:")?, &t.3));
    let keys = svg.iter().enumerate().filter_map(|(i, tag)| {
        tag.value("d").filter(|d| *d == "M1 -5H29")?;
        let (_, _, _, words) = texts(&svg[i..]).into_iter().next()?;
        said(colour(tag.tag, "style=\"stroke:")?, &words)
    });
    beside.chain(keys).collect()
}

fn beside(
    figure: &Figure,
    svg: &[Tag<'_>],
    (frame, panel): ([f64; 4], &[Tag<'_>]),
) -> Result<usize, String> {
    let [left, top, bottom, _] = frame;
    let texts = texts(panel);
    let near = |a: f64, b: f64| (a - b).abs() < 1.0;
    let words = |at: &dyn Fn(&Text) -> bool| texts.iter().find(|t| at(t)).map(|t| t.3.as_str());
    let across = words(&|t| near(t.1, bottom + 43.0)).ok_or("no words below")?;
    let up = words(&|t| near(t.1, top - 12.0) && t.0 < left + 1.0);
    let ticks = |at: &dyn Fn(&Text) -> Option<f64>| {
        let ticks = texts.iter().filter_map(|t| Some([at(t)?, tick(&t.3)?]));
        scale(ticks.collect())
    };
    let below = ticks(&|t| (near(t.1, bottom + 20.0)).then_some(t.0)).ok_or("no scale below")?;
    let beside = ticks(&|t| (t.2.contains("end") && t.0 < left).then_some(t.1 - 5.0));
    // Lanes with names have no scale.
    let (Some(up), Some(beside)) = (up, beside) else {
        return Ok(curves(panel).len());
    };
    let mut rows = figure.csv.lines().map(crate::cells);
    let head = rows.next().ok_or("no numbers")?;
    let rows: Vec<_> = rows.collect();
    let columns = |label: &str| {
        let mut known = AXES.lines().filter_map(|line| line.split_once(":"));
        let (_, names) = known
            .find(|(name, _)| *name == label)
            .ok_or_else(|| format!("`{label}` is unknown"))?;
        let names: Vec<&str> = names
            .split('|')
            .map(str::trim)
            .filter(|name| !name.is_empty())
            .collect();
        let found: Vec<_> = (0..head.len())
            .filter(|i| names.contains(&head[*i].as_str()))
            .collect();
        (names.is_empty() || !found.is_empty())
            .then_some(found)
            .ok_or_else(|| format!("no column for `{label}`"))
    };
    let (across, up) = (columns(across)?, columns(up)?);
    let mut points = Vec::new();
    for row in &rows {
        let number = |i: &usize| row[*i].parse::<f64>().ok();
        for x in across.iter().filter_map(number) {
            let there = |y| ([below(x), beside(y)], row);
            points.extend(up.iter().filter_map(number).map(there));
        }
    }
    let labels = labels(svg, panel);
    let told = |colour: &str, c: &[f64; 2]| {
        let of_label = |row: &[String]| {
            let own = labels.iter().filter(|(of, ..)| of == colour);
            let mut asked = own.filter_map(|(_, name, value)| Some((columns(name).ok()?, value)));
            asked.all(|(columns, value)| columns.iter().all(|i| row[*i].parse() == Ok(*value)))
        };
        points.iter().any(|(p, row)| {
            libm::hypot(p[0] - c[0], p[1] - c[1]) < 0.15 && of_label(row.as_slice())
        })
    };
    // At the frame a curve is cut off.
    let edge = |c: &[f64; 2]| {
        near(c[0], frame[0]) || near(c[0], frame[3]) || near(c[1], top) || near(c[1], bottom)
    };
    let strange =
        |(colour, corners): &&Drawn<'_>| !corners.iter().all(|c| told(colour, c) || edge(c));
    Ok(curves(panel).iter().filter(strange).count())
}

#[test]
fn every_curve_is_drawn_where_the_numbers_have_it() {
    let mut failures = Vec::new();
    for figure in FIGURES.iter() {
        let svg: Vec<_> = tags(&figure.svg).collect();
        let strange = panels(&svg)
            .into_iter()
            .map(|panel| beside(figure, &svg, panel));
        let strange: Result<usize, String> = strange.sum();
        let listed = BESIDE.iter().find(|row| row.0 == figure.id);
        let listed = listed.map_or(0, |row| row.1);
        match strange {
            Ok(strange) if strange == listed => {}
            Ok(strange) => failures.push(format!(
                "{}: {strange} curves are not where its numbers have them, and {listed} need not be: `BESIDE`",
                figure.id
            )),
            Err(why) => failures.push(format!("{}: {why}: `AXES` knows the words", figure.id)),
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
