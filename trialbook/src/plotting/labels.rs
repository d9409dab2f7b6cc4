//! Finds room for words: beside their own curve, off every other, inside the frame.

use super::{
    axes::TEXT_SIZE,
    path::{Frame, Place, along},
    text::width,
};

/// In units of the page.
const CELL: f64 = 2.0;

/// By 0 nobody, else a mark's number.
pub(super) struct Canvas {
    frame: Frame,
    columns: usize,
    rows: usize,
    owner: Vec<u16>,
}

impl Canvas {
    pub(super) fn new(frame: Frame) -> Self {
        let cells = |from: f64, to: f64| ((to - from) / CELL).max(0.0) as usize + 1;
        let (columns, rows) = (
            cells(frame.left, frame.right),
            cells(frame.top, frame.bottom),
        );
        Canvas {
            frame,
            columns,
            rows,
            owner: vec![0; columns * rows],
        }
    }

    pub(super) fn lines(&mut self, pieces: &[Vec<Place>], owner: u16) {
        for pair in pieces.iter().flat_map(|piece| piece.windows(2)) {
            let (dx, dy) = (pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]);
            let steps = (libm::hypot(dx, dy) / CELL) as usize + 1;
            for k in 0..=steps {
                let t = k as f64 / steps as f64;
                let (i, j) = self.cell([pair[0][0] + t * dx, pair[0][1] + t * dy]);
                self.owner[j * self.columns + i] = owner;
            }
        }
    }

    pub(super) fn take(&mut self, frame: Frame, owner: u16) {
        let (i0, j0) = self.cell([frame.left, frame.top]);
        let (i1, j1) = self.cell([frame.right, frame.bottom]);
        for j in j0..=j1 {
            self.owner[j * self.columns..][i0..=i1].fill(owner);
        }
    }

    fn cell(&self, p: Place) -> (usize, usize) {
        let index = |at: f64, from: f64, count: usize| {
            (((at - from) / CELL).max(0.0) as usize).min(count - 1)
        };
        (
            index(p[0], self.frame.left, self.columns),
            index(p[1], self.frame.top, self.rows),
        )
    }

    pub(super) fn is_free(&self, frame: Frame) -> bool {
        self.taken(frame, 0).0 == 0
    }

    fn taken(&self, frame: Frame, owner: u16) -> (usize, usize) {
        let (i0, j0) = self.cell([frame.left, frame.top]);
        let (i1, j1) = self.cell([frame.right, frame.bottom]);
        let mut counts = (0, 0);
        for j in j0..=j1 {
            for &cell in &self.owner[j * self.columns..][i0..=i1] {
                counts.0 += usize::from(cell != 0);
                counts.1 += usize::from(cell != 0 && cell != owner);
            }
        }
        counts
    }

    /// Each anchor has a cost; takes the label's box. None without anchors.
    pub(super) fn place(
        &mut self,
        label: &str,
        anchors: &[(Place, f64)],
        owner: u16,
    ) -> Option<Place> {
        let half = [width(label, TEXT_SIZE) / 2.0 + 1.0, TEXT_SIZE * 0.55];
        let mut best: Option<(f64, Place)> = None;
        for &(anchor, cost) in anchors {
            for direction in 0..24 {
                let angle = f64::from(direction) * std::f64::consts::TAU / 24.0;
                let (cos, sin) = (libm::cos(angle), libm::sin(angle));
                // So far from the anchor that the box just clears it.
                let clear = (half[0] / cos.abs().max(1e-9)).min(half[1] / sin.abs().max(1e-9));
                for gap in [6.0, 10.0, 15.0] {
                    let reach = clear + gap;
                    let centre =
                        self.inward([anchor[0] + reach * cos, anchor[1] - reach * sin], half);
                    let off = libm::hypot(centre[0] - anchor[0], centre[1] - anchor[1]);
                    let mut total = cost + 0.25 * off;
                    let good = |total: f64| best.is_none_or(|(least, _)| total < least);
                    // To count cells takes long: not where it can change nothing any more.
                    if !good(total) {
                        continue;
                    }
                    let frame = around(centre, half);
                    total += 12.0 * self.taken(frame.grown(1.0), owner).0 as f64;
                    if !good(total) {
                        continue;
                    }
                    total += self.taken(frame.grown(7.0), owner).1 as f64;
                    if good(total) {
                        best = Some((total, centre));
                    }
                }
            }
        }
        let centre = best?.1;
        self.take(around(centre, half), u16::MAX);
        Some(centre)
    }

    fn inward(&self, centre: Place, half: Place) -> Place {
        let clamp = |at: f64, from: f64, to: f64, half: f64| at.min(to - half).max(from + half);
        [
            clamp(centre[0], self.frame.left, self.frame.right, half[0] + 2.0),
            clamp(centre[1], self.frame.top, self.frame.bottom, half[1] + 1.0),
        ]
    }
}

pub(super) fn around(centre: Place, half: Place) -> Frame {
    Frame {
        left: centre[0] - half[0],
        right: centre[0] + half[0],
        top: centre[1] - half[1],
        bottom: centre[1] + half[1],
    }
}

pub(super) fn anchors(pieces: &[Vec<Place>], wanted: f64) -> Vec<(Place, f64)> {
    let near = |k: i32| {
        let fraction = f64::from(k) / 25.0;
        along(pieces, fraction).map(|(place, _)| (place, 60.0 * (fraction - wanted).abs()))
    };
    (0..=25).filter_map(near).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: Frame = Frame {
        left: 0.0,
        right: 400.0,
        top: 0.0,
        bottom: 300.0,
    };

    #[test]
    fn labels_of_crossing_curves_cover_nothing() {
        let lines = [
            vec![vec![[0.0, 0.0], [400.0, 300.0]]],
            vec![vec![[0.0, 300.0], [400.0, 0.0]]],
            vec![vec![[0.0, 150.0], [400.0, 150.0]]],
        ];
        let mut canvas = Canvas::new(FRAME);
        for (i, line) in lines.iter().enumerate() {
            canvas.lines(line, i as u16 + 1);
        }
        let mut placed: Vec<Frame> = Vec::new();
        for (i, line) in lines.iter().enumerate() {
            let half = [width("λ = 0.5", TEXT_SIZE) / 2.0, TEXT_SIZE * 0.5];
            let before = canvas.owner.clone();
            let at = canvas
                .place("λ = 0.5", &anchors(line, 1.0), i as u16 + 1)
                .unwrap();
            canvas.owner = before;
            let frame = around(at, half);
            assert_eq!(canvas.taken(frame, 0), (0, 0), "label {i} covers a curve");
            assert!(
                FRAME.contains([frame.left, frame.top])
                    && FRAME.contains([frame.right, frame.bottom])
            );
            canvas.take(frame, u16::MAX);
            let apart = |o: &Frame| {
                o.right < frame.left
                    || o.left > frame.right
                    || o.bottom < frame.top
                    || o.top > frame.bottom
            };
            assert!(placed.iter().all(apart));
            placed.push(frame);
        }
    }

    #[test]
    fn a_label_wider_than_the_panel_is_placed_all_the_same() {
        let mut canvas = Canvas::new(FRAME);
        let long = "a label that is much too long for this panel ".repeat(3);
        assert!(canvas.place(&long, &[([10.0, 10.0], 0.0)], 1).is_some());
        assert_eq!(canvas.place("x", &[], 1), None);
    }
}
