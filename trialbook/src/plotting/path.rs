//! Curves on the page: cut to the frame, thinned, written as path data.

use super::svg::number;

pub(super) type Place = [f64; 2];

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Frame {
    pub left: f64,
    pub right: f64,
    pub top: f64,
    pub bottom: f64,
}

impl Frame {
    pub(super) fn grown(self, by: f64) -> Self {
        Frame {
            left: self.left - by,
            right: self.right + by,
            top: self.top - by,
            bottom: self.bottom + by,
        }
    }

    pub(super) fn contains(&self, p: Place) -> bool {
        p[0] >= self.left && p[0] <= self.right && p[1] >= self.top && p[1] <= self.bottom
    }

    fn sides(&self) -> [(usize, f64, f64); 4] {
        [
            (0, self.left, 1.0),
            (0, self.right, -1.0),
            (1, self.top, 1.0),
            (1, self.bottom, -1.0),
        ]
    }
}

fn between(a: Place, b: Place, t: f64) -> Place {
    [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]
}

fn distance(a: Place, b: Place) -> f64 {
    libm::hypot(b[0] - a[0], b[1] - a[1])
}

/// Liang and Barsky.
fn clip_segment(a: Place, b: Place, frame: &Frame) -> Option<(Place, Place)> {
    let (mut enter, mut leave) = (0.0f64, 1.0f64);
    for (axis, bound, sign) in frame.sides() {
        let (from, to) = (sign * (a[axis] - bound), sign * (b[axis] - bound));
        if from < 0.0 && to < 0.0 {
            return None;
        }
        if from < 0.0 {
            enter = enter.max(from / (from - to));
        } else if to < 0.0 {
            leave = leave.min(from / (from - to));
        }
    }
    (enter <= leave).then(|| (between(a, b, enter), between(a, b, leave)))
}

/// A place with a NaN is a gap.
pub(super) fn clip(points: &[Place], frame: &Frame) -> Vec<Vec<Place>> {
    let mut pieces: Vec<Vec<Place>> = Vec::new();
    for pair in points.windows(2) {
        if pair.iter().flatten().any(|c| c.is_nan()) {
            continue;
        }
        let Some((a, b)) = clip_segment(pair[0], pair[1], frame) else {
            continue;
        };
        match pieces.last_mut() {
            // The end of a piece is the very value that the next segment starts from.
            Some(piece) if piece.last() == Some(&a) => piece.push(b),
            _ => pieces.push(vec![a, b]),
        }
    }
    pieces.retain(|piece| piece.windows(2).any(|pair| pair[0] != pair[1]));
    pieces
}

/// Sutherland and Hodgman; places with a NaN are left out.
pub(super) fn clip_polygon(points: &[Place], frame: &Frame) -> Vec<Place> {
    let mut polygon: Vec<Place> = points
        .iter()
        .copied()
        .filter(|p| !p[0].is_nan() && !p[1].is_nan())
        .collect();
    for (axis, bound, sign) in frame.sides() {
        let mut kept = Vec::with_capacity(polygon.len() + 4);
        for (i, &b) in polygon.iter().enumerate() {
            let a = polygon[(i + polygon.len() - 1) % polygon.len()];
            let (from, to) = (sign * (a[axis] - bound), sign * (b[axis] - bound));
            if (from < 0.0) != (to < 0.0) {
                kept.push(between(a, b, from / (from - to)));
            }
            if to >= 0.0 {
                kept.push(b);
            }
        }
        polygon = kept;
    }
    polygon
}

fn deviation(p: Place, a: Place, b: Place) -> f64 {
    let length = distance(a, b);
    if length == 0.0 {
        return distance(p, a);
    }
    let along = ((p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1])) / (length * length);
    distance(p, between(a, b, along.clamp(0.0, 1.0)))
}

/// Nowhere farther than `tolerance` from those left out (Douglas and Peucker).
pub(super) fn simplify(points: &[Place], tolerance: f64) -> Vec<Place> {
    if points.len() < 3 {
        return points.to_vec();
    }
    let mut keep = vec![false; points.len()];
    keep[0] = true;
    keep[points.len() - 1] = true;
    let mut open = vec![(0, points.len() - 1)];
    while let Some((first, last)) = open.pop() {
        let mut worst = (tolerance, 0);
        for i in first + 1..last {
            let d = deviation(points[i], points[first], points[last]);
            if d > worst.0 {
                worst = (d, i);
            }
        }
        if worst.1 > 0 {
            keep[worst.1] = true;
            open.extend([(first, worst.1), (worst.1, last)]);
        }
    }
    points
        .iter()
        .zip(keep)
        .filter(|(_, keep)| *keep)
        .map(|(p, _)| *p)
        .collect()
}

/// To a tenth of a unit.
pub(super) fn data(pieces: &[Vec<Place>]) -> String {
    let mut out = String::new();
    for piece in pieces {
        for (i, p) in piece.iter().enumerate() {
            out += match i {
                0 => "M",
                1 => "L",
                _ => " ",
            };
            let tenths = |value: f64| number(libm::round(10.0 * value) / 10.0);
            out += &format!("{} {}", tenths(p[0]), tenths(p[1]));
        }
    }
    out
}

pub(super) fn length(pieces: &[Vec<Place>]) -> f64 {
    pieces
        .iter()
        .flat_map(|piece| piece.windows(2))
        .map(|pair| distance(pair[0], pair[1]))
        .sum()
}

pub(super) fn along(pieces: &[Vec<Place>], fraction: f64) -> Option<(Place, Place)> {
    let mut left = fraction.clamp(0.0, 1.0) * length(pieces);
    let mut found = None;
    for pair in pieces.iter().flat_map(|piece| piece.windows(2)) {
        let step = distance(pair[0], pair[1]);
        if step == 0.0 {
            continue;
        }
        let direction = [
            (pair[1][0] - pair[0][0]) / step,
            (pair[1][1] - pair[0][1]) / step,
        ];
        found = Some((between(pair[0], pair[1], (left / step).min(1.0)), direction));
        if left <= step {
            break;
        }
        left -= step;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const UNIT: Frame = Frame {
        left: 0.0,
        right: 1.0,
        top: 0.0,
        bottom: 1.0,
    };

    #[test]
    fn a_curve_is_cut_at_the_frame_and_at_gaps() {
        let crossing = [
            [-1.0, 0.5],
            [0.5, 0.5],
            [0.5, 2.0],
            [0.25, 2.0],
            [0.25, -1.0],
        ];
        let pieces = clip(&crossing, &UNIT);
        let expected = [
            vec![[0.0, 0.5], [0.5, 0.5], [0.5, 1.0]],
            vec![[0.25, 1.0], [0.25, 0.0]],
        ];
        assert_eq!(pieces, expected);
        let gap = [
            [0.1, 0.1],
            [0.2, 0.1],
            [f64::NAN, 0.1],
            [0.4, 0.1],
            [0.5, 0.1],
        ];
        assert_eq!(clip(&gap, &UNIT).len(), 2);
        assert!(clip(&[[-1.0, 0.5], [0.5, 3.0]], &UNIT).is_empty());
    }

    #[test]
    fn a_polygon_is_cut_to_the_frame() {
        let diamond = [[0.5, -0.5], [1.5, 0.5], [0.5, 1.5], [-0.5, 0.5]];
        let cut = clip_polygon(&diamond, &UNIT);
        let area: f64 = (0..cut.len())
            .map(|i| (cut[i], cut[(i + 1) % cut.len()]))
            .map(|(a, b)| 0.5 * (a[0] * b[1] - b[0] * a[1]))
            .sum();
        assert!((area.abs() - 1.0).abs() < 1e-12, "{area}");
        assert!(clip_polygon(&[[2.0, 2.0], [3.0, 2.0], [2.0, 3.0]], &UNIT).is_empty());
    }

    #[test]
    fn the_middle_of_a_bent_line_is_found_across_pieces() {
        let pieces = vec![vec![[0.0, 0.0], [3.0, 0.0]], vec![[10.0, 0.0], [10.0, 3.0]]];
        assert_eq!(along(&pieces, 0.75), Some(([10.0, 1.5], [0.0, 1.0])));
        assert_eq!(along(&pieces, 1.0), Some(([10.0, 3.0], [0.0, 1.0])));
        assert_eq!(along(&[], 0.5), None);
    }

    proptest! {
        #[test]
        fn thinning_keeps_close(ys in proptest::collection::vec(-50.0f64..50.0, 2..200)) {
            let points: Vec<Place> = ys.iter().enumerate().map(|(i, &y)| [i as f64, y]).collect();
            let thin = simplify(&points, 3.0);
            prop_assert_eq!(thin.first(), points.first());
            prop_assert_eq!(thin.last(), points.last());
            for &p in &points {
                let near = thin.windows(2).any(|pair| deviation(p, pair[0], pair[1]) <= 3.0);
                prop_assert!(near, "{:?}", p);
            }
        }

        #[test]
        fn what_is_drawn_lies_in_the_frame(
            points in proptest::collection::vec([-3.0f64..4.0, -3.0f64..4.0], 2..50),
        ) {
            for p in clip(&points, &UNIT).iter().flatten() {
                prop_assert!(UNIT.grown(1e-12).contains(*p));
            }
        }
    }
}
