//! What a panel can show, besides a raster: curves, points, areas, rules and notes.

use super::svg::Colour;
use std::borrow::Borrow;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Stroke {
    Solid,
    Dashed,
    Dotted,
    DashDotted,
}

impl Stroke {
    fn of(series: usize) -> Self {
        [
            Stroke::Solid,
            Stroke::Dashed,
            Stroke::Dotted,
            Stroke::DashDotted,
        ][series % 4]
    }

    pub(super) fn name(self) -> &'static str {
        match self {
            Stroke::Solid => "solid",
            Stroke::Dashed => "dashed",
            Stroke::Dotted => "dotted",
            Stroke::DashDotted => "dash-dotted",
        }
    }

    /// For round ends.
    pub(super) fn pattern(self) -> Option<&'static str> {
        match self {
            Stroke::Solid => None,
            Stroke::Dashed => Some("7 5"),
            Stroke::Dotted => Some("0 4.5"),
            Stroke::DashDotted => Some("9 4.5 0 4.5"),
        }
    }
}

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Label {
    pub text: String,
    pub at: f64,
}

fn listed(points: impl IntoIterator<Item: Borrow<[f64; 2]>>) -> Vec<[f64; 2]> {
    points.into_iter().map(|point| *point.borrow()).collect()
}

macro_rules! alike {
    ($($mark:ident),*) => {$(
        impl $mark {
            /// The page's text colour.
            pub fn ink(mut self) -> Self {
                self.colour = Colour::Ink;
                self
            }

            /// An entry in the key, where there is no room for a label.
            pub fn key(mut self, text: impl Into<String>) -> Self {
                self.key = Some(text.into());
                self
            }
        }
    )*};
}

alike!(Curve, Points, Area);

/// A line through points.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    pub(super) points: Vec<[f64; 2]>,
    pub(super) colour: Colour,
    pub(super) stroke: Stroke,
    pub(super) width: f64,
    pub(super) arrows: Vec<f64>,
    pub(super) label: Option<Label>,
    pub(super) key: Option<String>,
}

impl Curve {
    /// A solid line in the first series' colour through `[x, y]` in order. A point that is not finite
    /// is a gap.
    pub fn new(points: impl IntoIterator<Item: Borrow<[f64; 2]>>) -> Self {
        Curve {
            points: listed(points),
            colour: Colour::Series(0),
            stroke: Stroke::Solid,
            width: 1.8,
            arrows: Vec::new(),
            label: None,
            key: None,
        }
    }

    /// Colour and dash pattern of series `n` (counted from 0; twelve differ).
    pub fn series(mut self, n: usize) -> Self {
        self.colour = Colour::Series(n);
        self.stroke = Stroke::of(n);
        self
    }

    /// Without a break, whatever the series.
    pub fn solid(mut self) -> Self {
        self.stroke = Stroke::Solid;
        self
    }

    /// In dashes.
    pub fn dashed(mut self) -> Self {
        self.stroke = Stroke::Dashed;
        self
    }

    /// In dots.
    pub fn dotted(mut self) -> Self {
        self.stroke = Stroke::Dotted;
        self
    }

    /// Another width, in units of 1/480 of the panel's width; 1.8 if not set.
    pub fn width(mut self, width: f64) -> Self {
        self.width = width;
        self
    }

    /// Arrowheads at these fractions of the visible length.
    pub fn arrows(mut self, fractions: &[f64]) -> Self {
        self.arrows = fractions.to_vec();
        self
    }

    /// Words beside the end of the curve, moved to where they cover nothing.
    pub fn label(self, text: impl Into<String>) -> Self {
        self.label_at(text, 1.0)
    }

    /// Words beside the curve, near this fraction of its visible length.
    pub fn label_at(mut self, text: impl Into<String>, fraction: f64) -> Self {
        self.label = Some(Label {
            text: text.into(),
            at: fraction,
        });
        self
    }
}

/// The shape of a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Marker {
    /// A filled disc.
    Disc,
    /// An open circle.
    Circle,
    /// A filled square.
    Square,
    /// An open triangle.
    Triangle,
    /// An oblique cross.
    Cross,
}

/// Single points.
#[derive(Debug, Clone, PartialEq)]
pub struct Points {
    pub(super) points: Vec<[f64; 2]>,
    pub(super) colour: Colour,
    pub(super) marker: Marker,
    pub(super) size: f64,
    pub(super) label: Option<Label>,
    pub(super) key: Option<String>,
}

impl Points {
    /// Discs in the first series' colour at `[x, y]`. A point that is not finite is left out.
    pub fn new(points: impl IntoIterator<Item: Borrow<[f64; 2]>>) -> Self {
        Points {
            points: listed(points),
            colour: Colour::Series(0),
            marker: Marker::Disc,
            size: 4.0,
            label: None,
            key: None,
        }
    }

    /// Colour and marker of series `n` (counted from 0).
    pub fn series(mut self, n: usize) -> Self {
        let markers = [
            Marker::Disc,
            Marker::Circle,
            Marker::Square,
            Marker::Triangle,
            Marker::Cross,
        ];
        self.colour = Colour::Series(n);
        self.marker = markers[n % markers.len()];
        self
    }

    /// Another shape.
    pub fn marker(mut self, marker: Marker) -> Self {
        self.marker = marker;
        self
    }

    /// Another radius, in units of 1/480 of the panel's width; 4 if not set.
    pub fn size(mut self, size: f64) -> Self {
        self.size = size;
        self
    }

    /// Words beside the last point, moved to where they cover nothing.
    pub fn label(mut self, text: impl Into<String>) -> Self {
        self.label = Some(Label {
            text: text.into(),
            at: 1.0,
        });
        self
    }
}

/// A filled polygon without an outline.
#[derive(Debug, Clone, PartialEq)]
pub struct Area {
    pub(super) points: Vec<[f64; 2]>,
    pub(super) colour: Colour,
    pub(super) opacity: f64,
    pub(super) key: Option<String>,
}

impl Area {
    /// The polygon with these corners `[x, y]`, tinted in the first series' colour. A corner that is
    /// not finite is left out.
    pub fn new(corners: impl IntoIterator<Item: Borrow<[f64; 2]>>) -> Self {
        Area {
            points: listed(corners),
            colour: Colour::Series(0),
            opacity: 0.18,
            key: None,
        }
    }

    /// What lies between two curves that run in the same direction.
    pub fn between(
        one: impl IntoIterator<Item = [f64; 2]>,
        other: impl IntoIterator<Item = [f64; 2]>,
    ) -> Self {
        let back: Vec<_> = other.into_iter().collect();
        Area::new(one.into_iter().chain(back.into_iter().rev()))
    }

    /// Colour of series `n` (counted from 0).
    pub fn series(mut self, n: usize) -> Self {
        self.colour = Colour::Series(n);
        self
    }

    /// Another opacity, from 0 to 1; 0.18 if not set.
    pub fn opacity(mut self, opacity: f64) -> Self {
        self.opacity = opacity;
        self
    }
}

/// A straight line across the panel, for a value to compare with. It does not widen an axis that is
/// parallel to it.
#[derive(Debug, Clone, PartialEq)]
pub struct Rule {
    pub(super) horizontal: bool,
    pub(super) at: f64,
    pub(super) line: Curve,
}

impl Rule {
    fn new(horizontal: bool, at: f64) -> Self {
        Rule {
            horizontal,
            at,
            line: Curve::new([[0.0; 2]; 0]).ink().dashed().width(1.2),
        }
    }

    /// The line of constant y.
    pub fn horizontal(y: f64) -> Self {
        Rule::new(true, y)
    }

    /// The line of constant x.
    pub fn vertical(x: f64) -> Self {
        Rule::new(false, x)
    }

    /// Without a break.
    pub fn solid(mut self) -> Self {
        self.line = self.line.solid();
        self
    }

    /// In dots.
    pub fn dotted(mut self) -> Self {
        self.line = self.line.dotted();
        self
    }

    /// Words beside the right or upper end.
    pub fn label(mut self, text: impl Into<String>) -> Self {
        self.line = self.line.label(text);
        self
    }

    /// An entry in the key below the panel.
    pub fn key(mut self, text: impl Into<String>) -> Self {
        self.line = self.line.key(text);
        self
    }
}

/// Words at a place. Labels keep clear of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Note {
    pub(super) at: [f64; 2],
    pub(super) text: String,
}

impl Note {
    /// Words centred at `[x, y]`. Nothing is drawn at a place that is not finite or off the panel.
    pub fn new(at: [f64; 2], text: impl Into<String>) -> Self {
        Note {
            at,
            text: text.into(),
        }
    }
}
