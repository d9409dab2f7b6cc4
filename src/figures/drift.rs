//! The figure of the drift under anisotropic friction, and of what it costs. Dimensionless, as in [`super::anisotropic`].

use super::Drawn;
use super::anisotropic::{Heights, heights};
use crate::claims::anisotropic::drawn::{self, Budgets};
use trialbook::plotting::{Area, Axis, Curve, Figure, FigureError, Panel, Plot, Table};

pub(super) fn figures() -> Drawn<Vec<Figure>> {
    Ok(vec![drift(&drawn::budgets()?)?])
}

const DRIFTS: [f64; 6] = [0.05, 0.2, 0.35, 0.5, 0.65, 0.8];

const LOSSES: [f64; 6] = [0.05, 0.25, 0.5, 0.75, 1.0, 1.2];

pub(super) fn drift(budgets: &Budgets) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["q", "lambda_0", "mean velocity", "lost in a period"]);
    for (q, found) in budgets.q.iter().zip(&budgets.found) {
        table.rows(q, budgets.lambda0.iter().zip(found))?;
    }
    // q, λ₀, drift, loss.
    let rows = budgets.q.iter().zip(&budgets.found).flat_map(|(q, found)| {
        let along = budgets.lambda0.iter().zip(found);
        along.map(|(lambda0, [drift, loss])| [*q, *lambda0, *drift, *loss])
    });
    let rows: Vec<_> = rows.collect();
    let most = |of: usize| {
        rows.iter()
            .max_by(|a, b| a[of].total_cmp(&b[of]))
            .map_or([f64::NAN; 2], |row| [row[0], row[1]])
    };
    let ([q, lambda0], lost) = (most(2), most(3));
    Plot::new("anisotropic-drift", "How fast it creeps, and what that costs")
        .caption(
            "Lines of equal mean velocity, in units of $A_0/\\varpi$, and of equal loss by friction in a period, per mass and in units of \
             $A_0^2/\\varpi^2$, by simulation. The curves A to E are those of the corrected diagram.",
        )
        .alt(
            "Two maps with q from 1 to 7 along the horizontal axis and λ₀ from 0 to 1.2 along the vertical one. In the first the \
             lines of equal mean velocity are horizontal in region IV and bend at the curves; the fastest drift lies in the \
             corner of {{large|small}} q and {{small|large}} λ₀. In the second the lines surround a place at {{q = 1, λ₀ = 0.45}}.",
        )
        .says(["large|small"], [budgets.q.last(), budgets.q.first()].map(|end| end == Some(&q)))
        .says(["small|large"], [budgets.lambda0.first(), budgets.lambda0.last()].map(|end| end == Some(&lambda0)))
        .says(["q = 1, λ₀ = 0.45"], (lost[0] - 1.0).abs() <= 0.05 && (lost[1] - 0.45).abs() <= 0.015)
        .panel(map(budgets, "mean velocity", 0, &DRIFTS))
        .panel(map(budgets, "loss per period", 1, &LOSSES))
        .figure(table)
}

fn map(budgets: &Budgets, title: &str, which: usize, levels: &[f64]) -> Panel {
    let mut panel = Panel::new(
        Axis::linear("q").range(1.0, 7.0).without_grid(),
        Axis::linear("λ_0").range(0.0, 1.2).without_grid(),
    )
    .title(title)
    .height(300.0);
    for &level in levels {
        let [lower, upper] = above(budgets, which, level);
        let line = lower.iter().filter(|[_, lambda0]| *lambda0 > 0.0);
        // Where both end at the frame, no line joins them.
        let gap = [[f64::NAN; 2]];
        let line = Curve::new(line.chain(&gap).chain(upper.iter().rev()).copied());
        let line = line.series(which).solid().width(1.2);
        panel = panel
            .area(Area::between(lower, upper).series(which).opacity(0.1))
            .curve(line.label_at(level.to_string(), 0.3));
    }
    let curve = |of: fn(&Heights) -> Option<f64>| {
        let points = budgets.curves.iter().map(heights);
        Curve::new(points.filter_map(move |h| Some([h.q, of(&h)?])))
            .ink()
            .width(1.0)
    };
    panel
        .curve(curve(|h| Some(h.d)).label_at("'D'", 0.9))
        .curve(curve(|h| h.e.is_none().then_some(h.c)).label_at("'C'", 0.3))
        .curve(curve(|h| h.b).dotted().label_at("'B'", 0.1))
        .curve(curve(|h| h.e).label_at("'E'", 0.8))
        .curve(curve(|h| Some(h.a)).label_at("'A'", 0.3))
}

/// The lower and the upper edge, from left to right, of where a quantity is above a level; at each q that is a single range of λ₀,
/// which begins at 0 if the level is reached at the least λ₀.
fn above(budgets: &Budgets, which: usize, level: f64) -> [Vec<[f64; 2]>; 2] {
    // Where the straight line through two points, of places and heights, has the height of the level.
    let crossing = |[x, v]: [f64; 2], [y, w]: [f64; 2]| x + (y - x) * (level - v) / (w - v);
    let mut edges = [Vec::new(), Vec::new()];
    let mut before: Option<([f64; 2], Option<[f64; 2]>)> = None;
    for (&q, found) in budgets.q.iter().zip(&budgets.found) {
        let points = budgets.lambda0.iter().zip(found);
        let points: Vec<_> = points.map(|(x, one)| [*x, one[which]]).collect();
        let over = |point: &[f64; 2]| point[1] >= level;
        let (first, last) = (points.iter().position(over), points.iter().rposition(over));
        let range = first.zip(last).map(|(first, last)| {
            let low = first.checked_sub(1);
            let low = low.map_or(0.0, |low| crossing(points[low], points[first]));
            [low, crossing(points[last], points[last + 1])]
        });
        let top = [q, points.iter().map(|point| point[1]).fold(0.0, f64::max)];
        let mut ends = Vec::new();
        // Where only one of two neighbours reaches the level, the range closes between them.
        if let Some((other, range_there)) = before
            && range_there.is_some() != range.is_some()
            && let Some([low, high]) = range_there.or(range)
        {
            let middle = if low > 0.0 { 0.5 * (low + high) } else { 0.0 };
            ends.push((crossing(other, top), [middle; 2]));
        }
        ends.extend(range.map(|range| (q, range)));
        for (q, range) in ends {
            edges
                .iter_mut()
                .zip(range)
                .for_each(|(edge, end)| edge.push([q, end]));
        }
        before = Some((top, range));
    }
    edges
}
