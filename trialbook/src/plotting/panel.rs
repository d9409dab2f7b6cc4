//! A panel: two axes, and what is drawn between them.

use super::{
    FigureError,
    axes::{Axis, Scale},
    marks::{Area, Curve, Note, Points, Rule},
    raster::Raster,
    sketch::{Sketch, inside, marker, sample, stroke},
};

#[derive(Debug, Clone, PartialEq)]
enum Mark {
    Curve(Curve),
    Points(Points),
    Area(Area),
    Rule(Rule),
    Note(Note),
    Raster(Raster),
}

/// Two axes and the marks between them: rasters and areas lowest, then grid and axes, then the rest in order.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    pub(super) title: String,
    x: Axis,
    y: Axis,
    marks: Vec<Mark>,
    height: f64,
    equal: bool,
}

impl Panel {
    /// An empty panel.
    pub fn new(x: Axis, y: Axis) -> Self {
        Panel {
            title: String::new(),
            x,
            y,
            marks: Vec::new(),
            height: 290.0,
            equal: false,
        }
    }

    /// A line above the panel: `"(a)  λ ≤ 1"`.
    pub fn title(mut self, title: impl Into<String>) -> Self {
        self.title = title.into();
        self
    }

    /// Height between the axes' ends, from 40 to 4000 units; 290 if not set. The page is 480 wide.
    pub fn height(mut self, height: f64) -> Self {
        self.height = height;
        self
    }

    /// Makes the units (on logarithmic axes the decades) of both axes equal.
    pub fn equal(mut self) -> Self {
        self.equal = true;
        self
    }

    /// Adds a curve.
    pub fn curve(mut self, curve: Curve) -> Self {
        self.marks.push(Mark::Curve(curve));
        self
    }

    /// Adds points.
    pub fn points(mut self, points: Points) -> Self {
        self.marks.push(Mark::Points(points));
        self
    }

    /// Adds a filled polygon.
    pub fn area(mut self, area: Area) -> Self {
        self.marks.push(Mark::Area(area));
        self
    }

    /// Adds a straight line across the panel.
    pub fn rule(mut self, rule: Rule) -> Self {
        self.marks.push(Mark::Rule(rule));
        self
    }

    /// Adds words at a place.
    pub fn note(mut self, note: Note) -> Self {
        self.marks.push(Mark::Note(note));
        self
    }

    /// Adds a raster.
    pub fn raster(mut self, raster: Raster) -> Self {
        self.marks.push(Mark::Raster(raster));
        self
    }

    pub(super) fn strokes(&self, named: &str) -> impl Iterator<Item = &'static str> {
        let lines = self.marks.iter().filter_map(|mark| match mark {
            Mark::Curve(curve) => Some(curve),
            Mark::Rule(rule) => Some(&rule.line),
            _ => None,
        });
        let is = move |line: &&Curve| {
            let label = line.label.as_ref().map(|label| &label.text);
            [line.key.as_ref(), label]
                .into_iter()
                .flatten()
                .any(|text| text.starts_with(named))
        };
        lines.filter(is).map(|line| line.stroke.name())
    }

    /// Along x (`0`) or y (`1`).
    fn values(&self, axis: usize) -> Vec<f64> {
        let mut values = Vec::new();
        for mark in &self.marks {
            match mark {
                Mark::Curve(Curve { points, .. })
                | Mark::Points(Points { points, .. })
                | Mark::Area(Area { points, .. }) => values.extend(points.iter().map(|p| p[axis])),
                Mark::Rule(rule) if rule.horizontal == (axis == 1) => values.push(rule.at),
                Mark::Rule(_) => {}
                Mark::Note(note) => values.push(note.at[axis]),
                Mark::Raster(raster) => {
                    let (from, to) = if axis == 0 { raster.x } else { raster.y };
                    values.extend([from, to]);
                }
            }
        }
        values
    }

    pub(super) fn settle(&self, width: f64) -> Result<(Scale, Scale), FigureError> {
        for mark in &self.marks {
            if let Mark::Raster(raster) = mark {
                raster.check()?;
            }
        }
        let x = self.x.settle(
            self.values(0).into_iter(),
            if width < 400.0 { 4 } else { 6 },
        )?;
        let about = if self.height < 150.0 { 2 } else { 5 };
        let y = self.y.settle(self.values(1).into_iter(), about)?;
        Ok((x, y))
    }

    pub(super) fn inner_height(
        &self,
        x: &Scale,
        y: &Scale,
        width: f64,
    ) -> Result<f64, FigureError> {
        let span = |scale: &Scale| {
            if scale.log {
                libm::log10(scale.to) - libm::log10(scale.from)
            } else {
                scale.to - scale.from
            }
        };
        let height = if self.equal {
            width * span(y) / span(x)
        } else {
            self.height
        };
        if (40.0..=4000.0).contains(&height) {
            Ok(height)
        } else {
            Err(FigureError::Layout {
                parameter: "height of a panel",
                allowed: "from 40 to 4000",
                value: height,
            })
        }
    }

    pub(super) fn key(&self, x: &Scale, y: &Scale) -> Vec<(String, String)> {
        let mut entries = Vec::new();
        let entry = |sample, words: &Option<String>| Some((sample, words.clone()?));
        for mark in &self.marks {
            match mark {
                Mark::Curve(curve) | Mark::Rule(Rule { line: curve, .. }) => {
                    entries.extend(entry(stroke(curve, "M1 -5H29"), &curve.key));
                }
                Mark::Points(points) => {
                    entries.extend(entry(marker(points, &[[15.0, -5.0]]), &points.key));
                }
                Mark::Area(area) => {
                    entries.extend(entry(sample(area.colour, area.opacity), &area.key));
                }
                Mark::Raster(raster) => {
                    for (n, class) in raster.classes.iter().enumerate() {
                        let hidden = inside(raster, n, x, y).is_some() || raster.counts()[n] == 0;
                        if !class.label.is_empty() && !hidden {
                            let sample = sample(class.colour, class.opacity);
                            entries.push((sample, class.label.clone()));
                        }
                    }
                }
                Mark::Note(_) => {}
            }
        }
        entries
    }

    pub(super) fn draw(&self, x: &Scale, y: &Scale) -> String {
        let mut sketch = Sketch::new(x, y);
        for (mark, owner) in self.marks.iter().zip((1..u16::MAX).cycle()) {
            match mark {
                Mark::Area(area) => sketch.area(area),
                Mark::Raster(raster) => sketch.raster(raster),
                Mark::Curve(curve) => sketch.curve(curve, &curve.points, owner),
                Mark::Rule(rule) => sketch.rule(rule, owner),
                Mark::Points(points) => sketch.points(points, owner),
                Mark::Note(note) => sketch.note(note),
            }
        }
        sketch.finish()
    }
}
