//! The figures of section 2.4, dimensionless: λ₀ is the friction of forward motion over the drive's amplitude, q the
//! ratio of backward to forward friction, φ the phase and 𝔴 the velocity.

use super::{Drawn, trend::sides};
use crate::claims::{
    anisotropic::simulated::{Changes, Curves},
    anisotropic::{census as counted, drawn, panels, rows},
};
use std::f64::consts::PI;
use trialbook::plotting::{
    Area, Axis, Curve, Figure, FigureError, Marker, Note, Panel, Plot, Points, Table,
};

pub(super) fn figures() -> Drawn<Vec<Figure>> {
    Ok(vec![
        region_diagram()?,
        region_waves()?,
        region_census()?,
        region_boundaries()?,
    ])
}

pub(super) fn heights(curves: &Curves) -> Heights {
    Heights {
        q: curves.q,
        a: curves.printed.a,
        b: curves.printed.b,
        c: curves.printed.c,
        d: curves.printed.d,
        e: drawn::on_e(&curves.corrected),
    }
}

fn region_map(columns: std::ops::Range<usize>, rows: usize, largest_q: f64) -> Drawn<Map> {
    let map = drawn::map(columns, rows)?;
    let count = counted::count(largest_q)?;
    let cell = |&(at, found, printed): &drawn::Cell| Cell {
        at,
        found: found as u8,
        printed: printed.unwrap_or(0) as u8,
    };
    Ok(Map {
        curves: map.curves.iter().map(heights).collect(),
        q: map.q,
        lambda0: map.lambda0,
        cells: map.cells.iter().map(cell).collect(),
        corners: drawn::corners()?,
        count: [count.points, count.printed_wrong, count.corrected_wrong],
    })
}

fn region_diagram() -> Drawn {
    Ok(fig5(&region_map(0..180, 180, 7.0)?)?)
}

fn region_census() -> Drawn {
    let map = region_map(90..330, 36, f64::INFINITY)?;
    Ok(census(&map)?)
}

fn region_waves() -> Drawn {
    let waves: Vec<_> = drawn::waves()?.into_iter().zip(panels::PANELS).collect();
    Ok(fig6(&waves)?)
}

/// λ₀ on the curves at one q; none where a curve has no point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Heights {
    pub q: f64,
    pub a: f64,
    pub b: Option<f64>,
    pub c: f64,
    pub d: f64,
    pub e: Option<f64>,
}

/// One simulated point of the plane: the region that its motion fits, and that of the printed list; 1 to 5, 0 for
/// none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cell {
    /// q and λ₀.
    pub at: [f64; 2],
    pub found: u8,
    pub printed: u8,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Map {
    /// In the order of q.
    pub curves: Vec<Heights>,
    pub q: (f64, f64),
    pub lambda0: (f64, f64),
    pub cells: Vec<Cell>,
    /// The points X and Y, as (q, λ₀).
    pub corners: [[f64; 2]; 2],
    /// How many points were simulated, and at how many of them the printed and the corrected list are wrong.
    pub count: [usize; 3],
}

impl Map {
    fn height(&self, of: impl Fn(&Heights) -> Option<f64>) -> Vec<[f64; 2]> {
        let point = |h: &Heights| Some([h.q, of(h)?]);
        self.curves.iter().filter_map(point).collect()
    }

    fn wrong(&self) -> impl Iterator<Item = [f64; 2]> {
        let wrong = self.cells.iter().filter(|cell| cell.found != cell.printed);
        wrong.map(|cell| cell.at)
    }

    fn region(
        &self,
        low: impl Fn(&Heights) -> Option<f64>,
        high: impl Fn(&Heights) -> Option<f64>,
        series: usize,
    ) -> Area {
        Area::between(self.height(low), self.height(high)).series(series)
    }

    /// Between E and C, beyond Y: where the printed list has II and the motion is of IV.
    fn wedge(&self) -> Area {
        let y = self.corners[1][0];
        let beyond = self.region(|h| h.e, |h| h.e.filter(|_| h.q >= y).map(|_| h.c), 0);
        beyond.ink().opacity(0.55)
    }

    fn table(&self) -> Result<Table, FigureError> {
        let mut table = Table::new(&["what", "q", "lambda_0"]);
        type Of = fn(&Heights) -> Option<f64>;
        let curves: [(&str, Of); 5] = [
            ("curve A", |h| Some(h.a)),
            ("curve B", |h| h.b),
            ("curve C", |h| Some(h.c)),
            ("curve D", |h| Some(h.d)),
            ("curve E", |h| h.e),
        ];
        for (name, of) in curves {
            table.rows(name, self.height(of))?;
        }
        table.rows((), ["point X", "point Y"].iter().zip(self.corners))?;
        table.rows("point where the printed list is wrong", self.wrong())?;
        Ok(table)
    }
}

/// fig-5: the regions as printed, with the census's verdict on them, and as corrected.
pub(super) fn fig5(map: &Map) -> Result<Figure, FigureError> {
    let [points, printed_wrong, corrected_wrong] = map.count;
    let y = map.corners[1][0];
    let wrong: Vec<_> = map.wrong().collect();
    let before = |h: &Heights, at: f64| (h.q <= y).then_some(at);
    // B, and beyond Y the border of region II that comes after it.
    let upper = |beyond: fn(&Heights) -> Option<f64>| {
        move |h: &Heights| if h.q <= y { h.b } else { beyond(h) }
    };
    let base = |title: &str, beyond: fn(&Heights) -> Option<f64>| {
        let regions = [
            ([1.35, 0.17], "'I'"),
            ([2.1, 0.335], "'II'"),
            ([1.24, 0.6], "'III'"),
            ([4.0, 0.6], "'IV'"),
            ([4.0, 1.2], "'V'"),
        ];
        let panel = Panel::new(
            Axis::linear("q").range(1.0, 7.0),
            Axis::linear("λ_0").range(0.0, 1.4),
        )
        .title(title)
        .height(340.0)
        .area(map.region(|_| Some(0.0), |h| Some(h.a), 0))
        .area(map.region(|h| Some(h.a), upper(beyond), 1))
        .area(map.region(upper(beyond), |h| Some(h.d), 3))
        .area(map.region(|h| h.b, |h| h.b.map(|_| h.c), 2))
        .area(map.region(|h| Some(h.d), |_| Some(1.4), 4))
        .curve(Curve::new(map.height(|h| Some(h.d))).label_at("'D'", 0.9))
        .curve(Curve::new(map.height(|h| Some(h.a))).label_at("'A'", 0.55));
        regions
            .into_iter()
            .fold(panel, |panel, (at, name)| panel.note(Note::new(at, name)))
    };
    let corners = |panel: Panel| {
        let [x, y] = map.corners;
        panel
            .points(Points::new([x]).ink().label("X"))
            .points(Points::new([y]).ink().label("Y"))
    };
    let b = || {
        Curve::new(map.height(|h| h.b))
            .series(1)
            .dotted()
            .label_at("'B'", 0.2)
    };
    let printed = base("as printed", |h| Some(h.c))
        .area(map.wedge().key("'IV', where the list has 'II'"))
        .curve(
            Curve::new(map.height(|h| Some(h.c)))
                .series(2)
                .solid()
                .label_at("'C'", 0.33),
        )
        .curve(b());
    let corrected = base("as corrected", |h| h.e)
        .curve(
            Curve::new(map.height(|h| before(h, h.c)))
                .series(2)
                .solid()
                .label_at("'C'", 0.4),
        )
        .curve(b())
        .curve(
            Curve::new(map.height(|h| h.e))
                .series(4)
                .solid()
                .label_at("'E'", 0.8),
        );
    Plot::new("fig-5", "The regions of the anisotropic friction")
        .caption(format!(
            "Which motion the friction $\\lambda_0$ and the ratio $q$ lead to. As printed, the list is wrong at {printed_wrong} of \
             {points} simulated points; all lie {{{{below|above}}}} C and {{{{before|beyond}}}} Y, in the dark wedge. \
             As corrected, with E for the missing boundary and C ending at Y, it is wrong at {corrected_wrong}. The last panel has the \
             wedge enlarged. {}",
            super::after("fig-5")
        ))
        // C is λ₀ = 1/q.
        .says(["below|above"], sides(wrong.iter().map(|[q, lambda0]| q * lambda0), 1.0))
        .says(["before|beyond"], sides(wrong.iter().map(|at| at[0]), y))
        .alt(
            "Three diagrams. The first two have q from 1 to 7 to the right and λ₀ from 0 to 1.4 upwards. The curves \
             A, B and C fall from the left, D is the horizontal line λ₀ = 1. In the first, a thin wedge below C, right \
             of the point Y, is dark. In the second, curve E runs along the lower edge of that wedge, and C \
             ends at Y. The third shows the wedge alone, with C above it and E below.",
        )
        .panel(corners(printed))
        .panel(corners(corrected))
        .panel(wedge(map)?)
        .figure(map.table()?)
}

/// The place where the two diagrams differ, enlarged.
fn wedge(map: &Map) -> Result<Panel, FigureError> {
    let plain = |of: fn(&Heights) -> Option<f64>| Curve::new(map.height(of));
    Ok(Panel::new(
        Axis::linear("q").range(4.0, 7.0),
        Axis::linear("λ_0").range(0.12, 0.26),
    )
    .title("where they differ")
    .height(260.0)
    .area(map.wedge().key("'IV', where the list has 'II'"))
    .curve(plain(|h| Some(h.c)).series(2).solid().label_at("'C'", 0.75))
    .curve(plain(|h| h.b).series(1).dotted().label_at("'B'", 0.3))
    .curve(plain(|h| h.e).series(4).solid().label_at("'E'", 0.7))
    .points(Points::new([map.corners[1]]).ink().label("Y"))
    .note(Note::new([4.4, 0.16], "'II'"))
    .note(Note::new([6.0, 0.22], "'IV'")))
}

pub(super) fn census(map: &Map) -> Result<Figure, FigureError> {
    let [points, printed_wrong, corrected_wrong] = map.count;
    let y = map.corners[1][0];
    let upper = |h: &Heights| if h.q <= y { h.b } else { h.e };
    let panel = Panel::new(
        Axis::linear("q").range(map.q.0, map.q.1).without_grid(),
        Axis::linear("λ_0")
            .range(map.lambda0.0, map.lambda0.1)
            .without_grid(),
    )
    .height(380.0)
    .area(map.region(|_| Some(0.0), |h| Some(h.a), 0).opacity(0.3))
    .area(map.region(|h| Some(h.a), upper, 1).opacity(0.3))
    .area(map.region(upper, |_| Some(1.0), 3).opacity(0.2))
    .note(Note::new([5.0, 0.03], "'I'"))
    .note(Note::new([6.0, 0.11], "'II'"))
    .note(Note::new([9.5, 0.2], "'IV'"))
    .curve(
        Curve::new(map.height(|h| Some(h.a)))
            .ink()
            .width(1.2)
            .label_at("'A'", 0.25),
    )
    .curve(
        Curve::new(map.height(|h| h.b))
            .ink()
            .width(1.2)
            .dotted()
            .label_at("'B'", 0.1),
    )
    .curve(
        Curve::new(map.height(|h| Some(h.c)))
            .ink()
            .width(1.2)
            .label_at("'C'", 0.7),
    )
    .curve(
        Curve::new(map.height(|h| h.e))
            .ink()
            .width(1.2)
            .label_at("'E'", 0.6),
    )
    .points(
        Points::new(map.wrong())
            .ink()
            .size(1.4)
            .key("wrong in the printed list"),
    )
    .points(Points::new([map.corners[1]]).ink().label("Y"));
    Plot::new("anisotropic-census", "Where the printed list of regions fails")
        .caption(format!(
            "The motion at points of the plane, by simulation alone. Of {points} points with $1\\le q\\le12$ and \
             $0<\\lambda_0\\le1.4$ the printed list is wrong at {printed_wrong}, which are drawn where they lie: all between \
             E and C. With E for the missing border it is wrong at {corrected_wrong}: at all other points the motion is that of \
             the region drawn.",
        ))
        .alt(
            "A map with q from 4 to 12 to the right and λ₀ from 0 to 0.28 upwards. From below: region I, region II, \
             and above them region IV. A wedge full of dots that opens to the right of the point Y separates II from IV: \
             there the motion is that of IV although the printed list has II.",
        )
        .panel(panel)
        .figure(map.table()?)
}

fn region_boundaries() -> Drawn {
    let laws = rows::far_laws()?;
    let seen = |row: &rows::Row| Ok((heights(&Curves::at(row.q)?), row.changes));
    let seen: Drawn<Vec<_>> = drawn::boundaries()?.iter().map(seen).collect();
    let seen = seen?;
    let mut table = Table::new(&[
        "q",
        "lambda_0 on A",
        "lambda_0 on B or E",
        "lambda_0 on C",
        "rest appears",
        "direct reversals end",
        "backward motion ends",
        "motion ends",
    ]);
    for (h, changes) in &seen {
        let b_or_e = h.b.or(h.e).unwrap_or(f64::NAN);
        let Changes {
            rest,
            reversal,
            backward,
            motion,
            ..
        } = *changes;
        table.row([h.q, h.a, b_or_e, h.c, rest, reversal, backward, motion])?;
    }
    let formula = |of: fn(&Heights) -> Option<f64>| {
        Curve::new(seen.iter().filter_map(|(h, _)| Some([h.q, of(h)?])))
    };
    let found = |of: fn(&Changes) -> f64| Points::new(seen.iter().map(|(h, at)| [h.q, of(at)]));
    let panel = Panel::new(
        Axis::log("q").range(1.0, 3e4),
        Axis::log("λ_0").range(1e-9, 10.0),
    )
    .height(380.0)
    .curve(formula(|h| Some(h.d)).ink().width(1.2).label_at("'D'", 0.9))
    .curve(
        formula(|h| Some(h.c))
            .series(2)
            .dotted()
            .label_at("'C'", 0.75),
    )
    .curve(
        formula(|h| h.b.or(h.e))
            .series(1)
            .solid()
            .label_at("'B, E'", 0.8),
    )
    .curve(formula(|h| Some(h.a)).series(0).label_at("'A'", 0.6))
    .points(found(|s| s.motion).ink().size(2.2).key("motion ends"))
    .points(
        found(|s| s.backward)
            .series(3)
            .marker(Marker::Circle)
            .size(4.6)
            .key("backward motion ends"),
    )
    .points(
        found(|s| s.reversal)
            .series(1)
            .size(2.4)
            .key("direct reversals end"),
    )
    .points(found(|s| s.rest).series(0).size(2.4).key("rest appears"));
    let number = |(value, error): (f64, f64)| format!("{value:.7} \\pm {error:.0e}");
    let law = |law: rows::PowerLaw| {
        format!(
            "$\\lambda_0\\propto(q+1)^n$ with $n={}$ and the prefactor ${}$",
            scientific(&number(law.exponent)),
            scientific(&number(law.prefactor))
        )
    };
    Ok(Plot::new("anisotropic-far", "The boundaries for large ratios of the frictions")
        .caption(format!(
            "Where the motion changes, by bisection on the simulation (marks), with the curves. Far out a rest appears \
             at {}, which is $\\pi$; direct reversals, and with them all backward motion, end at {}, which is \
             $4\\pi$. C is $1/q$; far out it is not a border.",
            law(laws[0]),
            law(laws[1])
        ))
        .alt(
            "Both axes are logarithmic. D is horizontal. C falls as 1/q; the marks for the end of backward motion \
             leave it near q = 4.6 and follow E, which falls as the square of q, in parallel with A below it.",
        )
        .panel(panel)
        .figure(table)?)
}

/// Turns the exponent of a number such as 3e-9 into LaTeX.
fn scientific(number: &str) -> String {
    match number.split_once('e') {
        Some((mantissa, exponent)) => format!("{mantissa}\\cdot10^{{{exponent}}}"),
        None => number.to_owned(),
    }
}

/// The velocity over the phase, and the friction: q and λ₀.
pub(super) type Wave = (Vec<[f64; 2]>, (f64, f64));

fn manner(points: &[[f64; 2]]) -> &'static str {
    let sign = |point: &[f64; 2]| match point[1] {
        w if w > 1e-9 => '+',
        w if w < -1e-9 => '-',
        _ => '0',
    };
    let signs: Vec<char> = points.iter().map(sign).collect();
    // A passage is no rest.
    let mut lasting: Vec<char> = signs
        .windows(2)
        .filter(|two| two[0] == two[1])
        .map(|two| two[0])
        .collect();
    lasting.dedup();
    let kind: String = lasting.into_iter().collect();
    let has = |part: &str| kind.contains(part);
    match ["-", "0", "+-", "-+", "+0"].map(has) {
        [true, false, ..] => "forwards and backwards in turn",
        [true, true, true, false, false] => "forwards, at once backwards, rest",
        [true, true, false, false, true] => "a rest after either",
        [false, true, _, _, true] => "forwards and rest",
        _ if kind == "0" => "rest",
        _ => "in another way",
    }
}

/// fig-6: the motion over two periods, one panel for each region.
pub(super) fn fig6(waves: &[Wave]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["region", "q", "lambda_0", "phi (rad)", "w"]);
    let ticks = [
        (0.0, "0"),
        (PI, "π"),
        (2.0 * PI, "2π"),
        (3.0 * PI, "3π"),
        (4.0 * PI, "4π"),
    ];
    let named = || ["I", "II", "III", "IV", "V"].into_iter().zip(waves);
    let manners: String = named()
        .map(|(name, (points, _))| format!("{name}: {}. ", manner(points)))
        .collect();
    let mut plot = Plot::new("fig-6", "The motion in each region")
        .caption(format!(
            "The periodic velocity $\\mathfrak{{w}}$ against the phase $\\phi$ over two periods, at one point of each \
             region. {manners}{}",
            super::after("fig-6")
        ))
        .alt(
            "Five panels with φ from 0 to 4π to the right and 𝔴 from −1 to 1 upwards. The wave of panel I never \
             rests; in II it rests once a period, in III twice, in IV it is never negative, in V it is zero.",
        );
    for (name, wave) in named() {
        let (points, (q, lambda0)) = wave;
        table.rows((name, q, lambda0), points)?;
        let title = format!("'{name}'\u{2003}q = {q}, λ_0 = {lambda0}");
        plot = plot.panel(
            Panel::new(
                Axis::linear("φ").range(0.0, 4.0 * PI).ticks(ticks),
                Axis::linear("𝔴").range(-1.0, 1.0),
            )
            .title(title)
            .height(120.0)
            .curve(Curve::new(points)),
        );
    }
    plot.figure(table)
}
