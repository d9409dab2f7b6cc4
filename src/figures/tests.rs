//! Whole figures: well-formed, small, and refused for the right reasons.

use super::*;
use std::collections::BTreeSet;
use std::sync::LazyLock;
use trialbook::notation::{self, Tag};
use trialbook::plotting::*;

static GALLERY: LazyLock<Vec<Figure>> =
    LazyLock::new(|| crate::figures::all().expect("they can be drawn"));

/// All tags, after checking that the text is one balanced element with quoted attributes.
fn tags(svg: &str) -> Vec<Tag<'_>> {
    let (mut open, mut all) = (Vec::new(), Vec::new());
    for tag in notation::tags(svg.trim_end()) {
        assert!(
            tag.tag.ends_with('>') && tag.tag.matches('<').count() == 1,
            "an unfinished tag: {tag:?}"
        );
        assert!(
            all.is_empty() || !open.is_empty(),
            "behind the element: {tag:?}"
        );
        for entity in tag.text.split('&').skip(1) {
            let known = ["amp;", "lt;", "gt;", "quot;"];
            assert!(
                known.iter().any(|name| entity.starts_with(name)),
                "{entity}"
            );
        }
        assert!(!tag.text.contains('>'), "stray >: {}", tag.text);
        if tag.closes {
            assert_eq!(open.pop(), Some(tag.name));
            continue;
        }
        let keys: BTreeSet<_> = tag.attributes().map(|(key, _)| key).collect();
        assert_eq!(
            2 * keys.len(),
            tag.tag.matches('"').count(),
            "unquoted or twice: {tag:?}"
        );
        open.extend(Some(tag.name).filter(|_| !tag.alone));
        all.push(tag);
    }
    assert!(open.is_empty());
    all
}

#[test]
fn figures_are_well_formed_with_ids_of_their_own() {
    let mut ids = BTreeSet::new();
    for figure in GALLERY.iter() {
        let tags = tags(&figure.svg);
        assert_eq!((tags[0].name, tags[0].value("role")), ("svg", Some("img")));
        for id in tags.iter().filter_map(|tag| tag.value("id")) {
            assert!(id.starts_with(&format!("{}-", figure.id)));
            assert!(ids.insert(id), "{id} twice");
        }
        for bad in ["NaN", "inf", "\n\n", "\"-0\"", " -0 "] {
            assert!(!figure.svg.contains(bad), "{bad:?} in {}", figure.id);
        }
        let size = figure.svg.len();
        assert!(
            (2_000..60_000).contains(&size),
            "{}: {size} bytes",
            figure.id
        );
    }
}

#[test]
fn type_is_legible_on_a_phone() {
    for figure in GALLERY.iter() {
        for tag in tags(&figure.svg).iter().filter(|tag| tag.name == "g") {
            if let Some(size) = tag.value("font-size") {
                let pixels = size.parse::<f64>().unwrap() * 390.0 / 480.0;
                assert!(pixels >= 12.0, "{pixels}");
            }
        }
    }
}

/// Coordinates in the path data that starts with `M` and has `L` and blanks after.
fn coordinates(data: &str) -> Vec<f64> {
    data.split(['M', 'L', ' '])
        .filter(|part| !part.is_empty())
        .map(|n| n.parse().unwrap())
        .collect()
}

fn paths(svg: &str) -> Vec<String> {
    let paths = tags(svg).into_iter().filter(|tag| tag.name == "path");
    paths
        .filter_map(|tag| tag.value("d").map(str::to_owned))
        .collect()
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
        let name = tags(&svg)
            .into_iter()
            .find(|tag| tag.text == "name")
            .unwrap();
        name.value("y").unwrap().parse::<f64>().unwrap()
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
        tags(&svg).iter().filter(|tag| tag.name == "svg").count() - 1
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
    let empty = plot(Panel::new(Axis::linear("x"), Axis::linear("y"))).unwrap_err();
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
    assert!(fates::fates(&[], "").is_ok());
}

/// What the tables beside the figures call the columns is what stands there.
#[test]
fn tables_have_what_their_columns_say() {
    let census = census::Census {
        side: 2,
        ends: [(0.0, 0.5), (2.0, 4.0)],
        rests: vec![true, true, false, true],
    };
    let section = rest::Section {
        psi: "0",
        census,
        printed: vec![[0.0, 3.0], [0.5, 2.5]],
        corrected: vec![[0.0, 3.0], [0.5, 2.75]],
        found: vec![[0.25, 3.25]],
    };
    let rows = |figure: Figure| -> Vec<String> { figure.csv.lines().map(str::to_owned).collect() };
    assert_eq!(
        rows(rest::census(&[section]).unwrap()),
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
