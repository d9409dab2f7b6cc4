//! Whole figures: well-formed, the same every time, small, and refused for the right reasons.

use super::constant::{Ending, History, Hodograph, Hodographs, StoppingTimes};
use super::*;
use std::collections::BTreeSet;
use std::f64::consts::{PI, TAU};

type State = [f64; 2];

/// Newton's law with friction, acceleration along x, in units of A.
fn slope(v: State, lambda: f64) -> State {
    let speed = libm::hypot(v[0], v[1]);
    [1.0 - lambda * v[0] / speed, -lambda * v[1] / speed]
}

/// Runge and Kutta's fourth-order steps until the speed is gone or the time is over.
fn run(lambda: f64, theta0: f64, until: f64) -> Vec<[f64; 3]> {
    let step = 0.005;
    let mut v = [libm::cos(theta0), libm::sin(theta0)];
    let mut out = vec![[0.0, v[0], v[1]]];
    let mut t = 0.0;
    while t < until && libm::hypot(v[0], v[1]) > 2.0 * step * lambda {
        let shifted = |k: State, h: f64| [v[0] + h * k[0], v[1] + h * k[1]];
        let k1 = slope(v, lambda);
        let k2 = slope(shifted(k1, step / 2.0), lambda);
        let k3 = slope(shifted(k2, step / 2.0), lambda);
        let k4 = slope(shifted(k3, step), lambda);
        for i in 0..2 {
            v[i] += step / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
        }
        t += step;
        out.push([t, v[0], v[1]]);
    }
    if lambda > 1.0 && t < until {
        out.push([t + libm::hypot(v[0], v[1]) / (lambda - 1.0), 0.0, 0.0]);
    }
    out
}

fn hodographs() -> Hodographs {
    let fan = |lambdas: &[f64]| -> Vec<Hodograph> {
        let angles = [22.5, 67.5, 112.5, 157.5, -22.5, -67.5, -112.5, -157.5];
        let curves = lambdas
            .iter()
            .flat_map(|&lambda| angles.map(|angle| (lambda, angle * PI / 180.0)));
        curves
            .map(|(lambda, theta0)| Hodograph {
                lambda,
                theta0,
                points: run(lambda, theta0, if lambda == 1.0 { 12.0 } else { 3.0 })
                    .into_iter()
                    .filter(|p| p[1] <= 1.5)
                    .collect(),
                ending: match lambda {
                    1.0 => Ending::Terminal([(1.0 + libm::cos(theta0)) / 2.0, 0.0]),
                    l if l > 1.0 => Ending::Rest,
                    _ => Ending::Onward,
                },
            })
            .collect()
    };
    Hodographs {
        weak: fan(&[0.0, 0.5, 1.0]),
        strong: fan(&[1.5, 2.0, 4.0]),
    }
}

fn histories() -> Vec<History> {
    let one = |lambda: f64| History {
        lambda,
        points: run(lambda, 2.0 * PI / 3.0, 3.0)
            .into_iter()
            .map(|[t, x, y]| [t, libm::hypot(x, y), libm::atan2(y, x)])
            .collect(),
        rests: lambda > 1.0,
    };
    [0.0, 0.5, 1.0, 1.5, 2.0].map(one).to_vec()
}

fn stopping_times() -> Vec<StoppingTimes> {
    let one = |lambda: f64| StoppingTimes {
        lambda,
        points: (0..=60)
            .map(|i| f64::from(i) * PI / 60.0)
            .filter_map(|theta0| run(lambda, theta0, 40.0).last().map(|p| [theta0, p[0]]))
            .collect(),
    };
    [1.25, 1.5, 2.0, 4.0].map(one).to_vec()
}

/// A region diagram like that of section 2.4: a raster, curves over it, a mismatch in ink.
fn regions() -> Result<Figure, FigureError> {
    let (columns, rows) = (480, 320);
    let cells = (0..columns * rows)
        .map(|k| {
            let q = 1.0 + 6.0 * ((k % columns) as f64 + 0.5) / columns as f64;
            let l = 1.4 * ((k / columns) as f64 + 0.5) / rows as f64;
            match (
                l > 1.0 / libm::sqrt(q),
                l > 1.0,
                l * q > 1.0,
                q > 5.0 && (l - 0.7).abs() < 0.02,
            ) {
                (.., true) => 4,
                (_, true, ..) => 0,
                (true, ..) => 1,
                (_, _, true, _) => 2,
                _ => 3,
            }
        })
        .collect();
    let raster = Raster::new(columns, rows, (1.0, 7.0), (0.0, 1.4), cells)?
        .class("'I'", 0, 0.3)
        .class("'II'", 1, 0.3)
        .class("'III'", 2, 0.3)
        .class("'IV'", 3, 0.3)
        .ink_class("the printed list differs", 0.8);
    let mut table = Table::new(&["q", "lambda_0 of A"]);
    let curve: Vec<[f64; 2]> = (0..=200)
        .map(|i| 1.0 + 0.03 * f64::from(i))
        .map(|q| [q, 1.0 / libm::sqrt(q)])
        .collect();
    for [q, l] in &curve {
        table.row([q.into(), l.into()])?;
    }
    Plot::new("regions", "Regions of the plane")
        .panel(
            Panel::new(
                Axis::linear("q").without_grid(),
                Axis::linear("λ_0").without_grid().ticks([
                    (0.0, "0"),
                    (1.0 / PI, "1/π"),
                    (0.7, "0.7"),
                    (1.0, "1"),
                ]),
            )
            .height(320.0)
            .raster(raster)
            .curve(Curve::new(curve).ink().label_at("A", 0.9))
            .rule(Rule::horizontal(1.0).label("C"))
            .points(Points::new([[3.0, 0.8]]).ink().label("X")),
        )
        .figure(table)
}

/// A compensated plot on logarithmic axes with two values to compare with.
fn compensated() -> Result<Figure, FigureError> {
    let data: Vec<[f64; 2]> = (0..=300)
        .map(|i| libm::pow(10.0, f64::from(i) / 50.0))
        .map(|t| [t, 0.5 + 1.5 / (libm::sqrt(t) + 0.3)])
        .collect();
    let mut table = Table::new(&["tau", "p/tau^2"]);
    for [t, c] in &data {
        table.row([t.into(), c.into()])?;
    }
    Plot::new("escape", "The prefactor of the escape")
        .caption("Measured, printed and corrected.")
        .alt("A curve that settles on the lower of two lines.")
        .panel(
            Panel::new(Axis::log("τ"), Axis::log("p/τ^2").range(0.3, 3.0))
                .curve(Curve::new(data).label_at("measured", 0.1))
                .rule(Rule::horizontal(0.75).series(1).label("printed"))
                .rule(Rule::horizontal(0.5).series(2).label("corrected")),
        )
        .figure(table)
}

/// Small panels side by side, and everything with a key.
fn small() -> Result<Figure, FigureError> {
    let ticks = [(0.0, "0"), (TAU, "2π"), (2.0 * TAU, "4π")];
    let wave = |k: f64| -> Vec<[f64; 2]> {
        (0..=400)
            .map(|i| f64::from(i) * TAU / 200.0)
            .map(|x| [x, libm::sin(k * x) / k])
            .collect()
    };
    let panel = |k: f64| {
        Panel::new(
            Axis::linear("φ").ticks(ticks),
            Axis::linear("w").range(-1.0, 1.0),
        )
        .title(format!("'{}'\u{2003}q = {k}", "I".repeat(k as usize)))
        .height(130.0)
        .area(Area::between(wave(k), [[0.0, 0.0], [2.0 * TAU, 0.0]]).key("swept"))
        .curve(Curve::new(wave(k)).key("w"))
    };
    let marks = (0..5).fold(
        Panel::new(Axis::linear("x"), Axis::linear("y")),
        |panel, n| {
            let y = n as f64;
            panel
                .points(
                    Points::new((0..6).map(|i| [f64::from(i), y]))
                        .series(n)
                        .key(format!("set {n}")),
                )
                .curve(
                    Curve::new([[0.0, y + 0.4], [5.0, y + 0.5]])
                        .series(n)
                        .key(format!("run {n}")),
                )
        },
    );
    Plot::new("small", "Small panels")
        .columns(2)
        .panel(panel(1.0))
        .panel(panel(2.0))
        .panel(panel(3.0))
        .panel(marks.note(Note::new([2.5, 4.8], "a note")))
        .figure(Table::new(&[]))
}

fn gallery() -> Vec<Figure> {
    [
        constant::fig1(&hodographs()),
        constant::speed_and_angle(&histories()),
        constant::stopping_time(&stopping_times()),
        regions(),
        compensated(),
        small(),
    ]
    .map(|figure| figure.expect("the gallery's data are fine"))
    .into()
}

/// Names and attributes of all tags, after checking that the text is one balanced element with
/// quoted attributes.
fn tags(svg: &str) -> Vec<(String, Vec<(String, String)>)> {
    let (mut open, mut all) = (Vec::new(), Vec::new());
    let mut rest = svg.trim_end();
    while let Some(at) = rest.find('<') {
        assert!(all.is_empty() || !open.is_empty(), "text after the element");
        let text = &rest[..at];
        assert!(!text.contains('>'), "stray >: {text}");
        for entity in text.split('&').skip(1) {
            let known = ["amp;", "lt;", "gt;", "quot;"];
            assert!(
                known.iter().any(|name| entity.starts_with(name)),
                "{entity}"
            );
        }
        let end = at + rest[at..].find('>').expect("an unfinished tag");
        let tag = &rest[at + 1..end];
        rest = &rest[end + 1..];
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop().as_deref(), Some(name));
            continue;
        }
        let (body, empty) = tag
            .strip_suffix('/')
            .map_or((tag, false), |body| (body, true));
        let (name, mut left) = body.split_once(' ').unwrap_or((body, ""));
        let mut attributes: Vec<(String, String)> = Vec::new();
        while !left.trim().is_empty() {
            let (key, after) = left
                .trim_start()
                .split_once("=\"")
                .expect("a quoted attribute");
            let (value, after) = after.split_once('"').expect("a closed attribute");
            assert!(!value.contains('<') && !key.contains(' '));
            assert!(
                attributes.iter().all(|(other, _)| other != key),
                "{key} twice in {tag}"
            );
            attributes.push((key.into(), value.into()));
            left = after;
        }
        all.push((name.to_string(), attributes));
        if !empty {
            open.push(name.to_string());
        }
    }
    assert!(open.is_empty() && rest.is_empty());
    all
}

#[test]
fn figures_are_well_formed_with_ids_of_their_own() {
    let mut ids = BTreeSet::new();
    for figure in gallery() {
        let tags = tags(&figure.svg);
        assert_eq!(tags[0].0, "svg");
        assert!(tags[0].1.contains(&("role".into(), "img".into())));
        for (key, value) in tags.iter().flat_map(|tag| &tag.1) {
            if key == "id" {
                assert!(value.starts_with(&format!("{}-", figure.id)));
                assert!(ids.insert(value.clone()), "{value} twice");
            }
        }
        for bad in ["NaN", "inf", "\n\n", "\"-0\"", " -0 "] {
            assert!(!figure.svg.contains(bad), "{bad:?} in {}", figure.id);
        }
        let size = figure.svg.len();
        assert!(
            (2_000..35_000).contains(&size),
            "{}: {size} bytes",
            figure.id
        );
    }
}

#[test]
fn the_same_data_give_the_same_bytes() {
    assert_eq!(gallery(), gallery());
}

#[test]
fn type_is_legible_on_a_phone() {
    for figure in gallery() {
        for (name, attributes) in tags(&figure.svg) {
            for (key, value) in attributes {
                if key == "font-size" && name == "g" {
                    let pixels = value.parse::<f64>().unwrap() * 390.0 / 480.0;
                    assert!(pixels >= 12.0, "{pixels}");
                }
            }
        }
    }
}

#[test]
fn the_table_holds_every_point_that_is_drawn() {
    let data = hodographs();
    let figure = constant::fig1(&data).unwrap();
    let points: usize = data
        .weak
        .iter()
        .chain(&data.strong)
        .map(|c| c.points.len())
        .sum();
    assert_eq!(figure.csv.lines().count(), points + 1);
    let last = data.strong.last().unwrap();
    let [t, ..] = last.points.last().unwrap();
    let line = figure.csv.lines().last().unwrap();
    let cells: Vec<&str> = line.split(',').collect();
    assert_eq!((cells[0], cells[1]), ("b", "4"));
    assert!((cells[3].parse::<f64>().unwrap() - t).abs() < 1e-11);
}

/// Coordinates in the path data that starts with `M` and has `L` and blanks after.
fn coordinates(data: &str) -> Vec<f64> {
    data.split(['M', 'L', ' '])
        .filter(|part| !part.is_empty())
        .map(|n| n.parse().unwrap())
        .collect()
}

fn paths(svg: &str) -> Vec<String> {
    let data = |tag: (String, Vec<(String, String)>)| {
        tag.1
            .into_iter()
            .find(|(key, _)| tag.0 == "path" && key == "d")
            .map(|(_, data)| data)
    };
    tags(svg).into_iter().filter_map(data).collect()
}

#[test]
fn a_diagonal_runs_from_the_lower_left_to_the_upper_right() {
    let axis = |label: &str| Axis::linear(label).range(0.0, 10.0);
    let diagonal = Curve::new([[0.0, 0.0], [10.0, 10.0]]);
    let raster = Raster::new(2, 1, (0.0, 10.0), (0.0, 10.0), vec![0, BLANK])
        .unwrap()
        .class("", 0, 0.5);
    let panel = Panel::new(axis("x"), axis("y"))
        .height(200.0)
        .curve(diagonal)
        .raster(raster);
    let svg = Plot::new("d", "D")
        .panel(panel)
        .figure(Table::new(&[]))
        .unwrap()
        .svg;
    let ends = coordinates(paths(&svg).last().unwrap());
    let [x0, y0, x1, y1] = ends[..] else {
        panic!("{ends:?}")
    };
    assert!(x1 - x0 > 380.0 && x1 < 480.0 && x0 > 0.0);
    assert!((y0 - y1 - 200.0).abs() < 0.11);
    // The raster's corner is the diagonal's lower end, its two cells are as wide as the panel.
    let matrix = svg
        .split("matrix(")
        .nth(1)
        .unwrap()
        .split(')')
        .next()
        .unwrap();
    let m: Vec<f64> = matrix.split(' ').map(|n| n.parse().unwrap()).collect();
    assert!((m[4] - x0).abs() < 0.06 && (m[5] - y0).abs() < 0.06);
    assert!((2.0 * m[0] - (x1 - x0)).abs() < 0.11 && (m[3] + 200.0).abs() < 1e-6);
}

/// The words of a class stood in the middle of its largest square, whatever ran through it.
#[test]
fn the_name_of_a_class_stands_off_the_curves() {
    let height_of_name = |curve: Option<[[f64; 2]; 2]>| {
        let raster = Raster::new(2, 2, (0.0, 1.0), (0.0, 1.0), vec![0; 4])
            .unwrap()
            .class("name", 0, 0.3);
        let axis = |label: &str| Axis::linear(label).range(0.0, 1.0);
        let mut panel = Panel::new(axis("x"), axis("y")).raster(raster);
        if let Some(points) = curve {
            panel = panel.curve(Curve::new(points));
        }
        let figure = Plot::new("named", "Named").panel(panel);
        let svg = figure.figure(Table::new(&["x"])).unwrap().svg;
        let line = svg.lines().find(|line| line.contains(">name<")).unwrap();
        let (_, y) = line.split_once(" y=\"").unwrap();
        y.split_once('"').unwrap().0.parse::<f64>().unwrap()
    };
    let alone = height_of_name(None);
    assert_eq!(height_of_name(Some([[0.0, 0.9], [1.0, 0.9]])), alone);
    let beside = height_of_name(Some([[0.0, 0.5], [1.0, 0.5]]));
    assert!(
        (12.0..40.0).contains(&(beside - alone).abs()),
        "{alone}, {beside}"
    );
}

#[test]
fn a_raster_beyond_the_axes_is_cut_off() {
    let inner_drawings = |to: f64| {
        let raster = Raster::new(2, 2, (0.0, to), (0.0, 1.0), vec![0; 4])
            .unwrap()
            .class("a", 0, 0.5);
        let axis = |label: &str| Axis::linear(label).range(0.0, 1.0);
        let plot = Plot::new("r", "R").panel(Panel::new(axis("x"), axis("y")).raster(raster));
        let svg = plot.figure(Table::new(&[])).unwrap().svg;
        tags(&svg).iter().filter(|tag| tag.0 == "svg").count() - 1
    };
    assert_eq!([1.0, 2.0].map(inner_drawings), [0, 1]);
}

#[test]
fn a_gap_in_the_data_is_a_gap_in_the_curve() {
    let with_gap = |y: f64| {
        let points = [[0.0, 0.0], [1.0, 1.0], [2.0, y], [3.0, 1.0], [4.0, 0.0]];
        let panel = Panel::new(Axis::linear("x"), Axis::linear("y")).curve(Curve::new(points));
        let svg = Plot::new("g", "G")
            .panel(panel)
            .figure(Table::new(&[]))
            .unwrap()
            .svg;
        paths(&svg).last().unwrap().matches('M').count()
    };
    assert_eq!([0.5, f64::NAN, f64::INFINITY].map(with_gap), [1, 2, 2]);
}

#[test]
fn what_cannot_be_drawn_is_refused_by_name() {
    let panel =
        |x: Axis| Panel::new(x, Axis::linear("y")).curve(Curve::new([[0.0, 1.0], [1.0, 2.0]]));
    let plot = |panel: Panel| {
        Plot::new("p", "P")
            .panel(panel)
            .figure(Table::new(&[]))
            .map(|_| ())
    };
    let not_positive = FigureError::NotPositive {
        axis: "τ".into(),
        value: 0.0,
    };
    assert_eq!(plot(panel(Axis::log("τ"))), Err(not_positive.clone()));
    let fixed = Axis::log("τ").range(0.5, 2.0);
    assert_eq!(
        plot(panel(fixed)),
        Err(not_positive),
        "also when the axis has its ends"
    );
    let empty = constant::stopping_time(&[]).unwrap_err();
    assert!(matches!(empty, FigureError::NoData { .. }), "{empty}");
    let flat = plot(panel(Axis::linear("x")).height(f64::NAN)).unwrap_err();
    assert!(matches!(flat, FigureError::Layout { .. }));
    let none = Plot::new("p", "P").figure(Table::new(&[])).unwrap_err();
    assert!(matches!(none, FigureError::Layout { .. }));
    let crowded = Plot::new("p", "P")
        .columns(5)
        .panel(panel(Axis::linear("x")));
    assert!(matches!(
        crowded.figure(Table::new(&[])),
        Err(FigureError::Layout { .. })
    ));
}

proptest::proptest! {
    #[test]
    fn no_data_break_a_figure(
        points in proptest::collection::vec([proptest::num::f64::ANY, proptest::num::f64::ANY], 0..8),
        log: bool,
        fixed: bool,
    ) {
        let axis = |label: &str| {
            let axis = if log { Axis::log(label) } else { Axis::linear(label) };
            if fixed { axis.range(0.5, 20.0) } else { axis }
        };
        let panel = Panel::new(axis("x"), axis("y"))
            .curve(Curve::new(points.clone()).label("c").arrows(&[0.5, f64::NAN]))
            .area(Area::new(points.clone()).opacity(f64::NAN))
            .points(Points::new(points.clone()).label("p"))
            .note(Note::new([1.0, 1.0], "n"));
        if let Ok(figure) = Plot::new("any", "Any").panel(panel).figure(Table::new(&[])) {
            tags(&figure.svg);
            proptest::prop_assert!(!figure.svg.contains("NaN") && !figure.svg.contains("inf"));
        }
    }
}

/// What a record no longer tells is missing in its figure, and breaks nothing.
#[test]
fn figures_of_records_are_drawn_without_them() {
    assert!(digits::digits(&[], "").is_ok());
    assert!(rest::fates(&[], "").is_ok());
}

/// What the tables beside the figures call the columns is what stands there.
#[test]
fn tables_have_what_their_columns_say() {
    let [alpha, a] = [(0.0, 0.5), (2.0, 4.0)];
    let census = rest::Census {
        psi: "0",
        side: 2,
        rests: vec![true, true, false, true],
        alpha,
        a,
        printed: vec![[0.0, 3.0], [0.5, 2.5]],
        corrected: vec![[0.0, 3.0], [0.5, 2.75]],
        found: vec![[0.25, 3.25]],
    };
    let rows = |figure: Figure| -> Vec<String> { figure.csv.lines().map(str::to_owned).collect() };
    assert_eq!(
        rows(rest::census(&[census]).unwrap()),
        [
            "psi,alpha,A,rests",
            "0,0.125,2.5,1",
            "0,0.375,2.5,1",
            "0,0.125,3.5,0",
            "0,0.375,3.5,1",
            "0,0.25,3.25,border",
        ]
    );
    let quantity = escape::Compensated {
        name: "p/tau^2",
        axis: "p",
        range: (0.0, 1.0),
        printed: Some(0.25),
        corrected: 0.5,
        escapes: vec![
            vec![[10.0, 0.25], [20.0, 0.5]],
            vec![[30.0, 0.75], [40.0, 0.5]],
        ],
    };
    assert_eq!(
        rows(escape::compensated(&[quantity]).unwrap()),
        [
            "quantity,escape,tau,value",
            "p/tau^2,1,10,0.25",
            "p/tau^2,1,20,0.5",
            "p/tau^2,2,30,0.75",
            "p/tau^2,2,40,0.5",
        ]
    );
}
