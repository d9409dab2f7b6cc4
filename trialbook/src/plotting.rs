//! Figures: functions from plain data to a [`Figure`]: an SVG text, the same numbers as CSV, a caption and a
//! description in words. A figure never computes physics; the same data give the same bytes.
//!
//! A [`Plot`] is a grid of [`Panel`]s; a panel has two [`Axis`] and a list of marks: [`Curve`], [`Points`],
//! [`Area`], [`Raster`], [`Rule`], [`Note`]. Three habits hold everywhere:
//!
//! - *Ink follows the page.* Text and axes are drawn in `currentColor`, series in CSS variables `--fig-1` to
//!   `--fig-6`; a series also has its own dash pattern or marker, and a label beside it.
//! - *A gap is a gap.* A point that is not finite interrupts a curve; a value ≤ 0 on a logarithmic axis is an
//!   error ([`FigureError::NotPositive`]): there the caller has lost a sign.
//! - *Nothing is wider than a phone.* A panel is 480 units wide with type of 15 and 16 units; panels stand
//!   below each other unless asked otherwise.
//!
//! ```
//! use trialbook::plotting::{Axis, Curve, Panel, Plot, Table};
//!
//! let parabola: Vec<[f64; 2]> = (0..=100).map(|i| f64::from(i) / 50.0).map(|x| [x, x * x]).collect();
//! let mut table = Table::new(&["x (m)", "y (m)"]);
//! table.rows((), &parabola)?;
//! let figure = Plot::new("parabola", "A parabola")
//!     .caption("The path $y = x^2$.")
//!     .alt("A curve that rises ever more steeply.")
//!     .panel(
//!         Panel::new(Axis::linear("x (m)"), Axis::linear("y (m)"))
//!             .curve(Curve::new(parabola).label("y = x^2").arrows(&[0.6])),
//!     )
//!     .figure(table)?;
//! assert!(figure.svg.starts_with("<svg"));
//! # Ok::<(), trialbook::plotting::FigureError>(())
//! ```

mod axes;
mod csv;
mod labels;
pub mod map;
mod marks;
mod panel;
mod panels;
mod path;
mod plot;
mod raster;
mod sketch;
mod svg;
mod text;
mod ticks;

pub use axes::Axis;
pub use csv::{Cells, Table};
pub use marks::{Area, Curve, Marker, Note, Points, Rule};
pub use panel::Panel;
pub use panels::panels;
pub use plot::Plot;
pub use raster::{BLANK, Raster};

/// A finished figure.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Figure {
    /// Permanent id: `fig-1`. Prefix of every id inside the SVG.
    pub id: &'static str,
    /// What a reader should see in it; formulas in `$…$`.
    pub caption: String,
    /// What it shows, in plain words, for those who do not see it.
    pub alt: String,
    /// The drawing: one `<svg>` element without blank lines.
    pub svg: String,
    /// The data: a header with names and units, then rows, 12 significant digits.
    pub csv: String,
}

/// Why a figure cannot be drawn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FigureError {
    /// A value on a logarithmic axis that has no logarithm.
    #[error("axis \"{axis}\" is logarithmic: values must be > 0, got {value}")]
    NotPositive {
        /// Label of the axis.
        axis: String,
        /// The value.
        value: f64,
    },
    /// The ends of an axis do not span an interval that can be divided.
    #[error(
        "axis \"{axis}\": ends must be finite with from < to, apart by more than 1e-9 of \
         themselves, and their sizes within 1e-280 to 1e280, got {from} and {to}"
    )]
    Range {
        /// Label of the axis.
        axis: String,
        /// Lower end.
        from: f64,
        /// Upper end.
        to: f64,
    },
    /// An axis without fixed ends and without a finite value to take them from.
    #[error("axis \"{0}\": no finite value to draw, and no range given")]
    NoData(String),
    /// A row of a table with too few or too many cells.
    #[error("a row of the table must have {expected} cells, got {found}")]
    Row {
        /// Number of columns.
        expected: usize,
        /// Number of cells in the row.
        found: usize,
    },
    /// A raster whose cells do not fill its rows and columns.
    #[error(
        "a raster of {columns} × {rows} (each ≥ 1) must have {columns} × {rows} cells, got {cells}"
    )]
    RasterShape {
        /// Number of columns.
        columns: usize,
        /// Number of rows.
        rows: usize,
        /// Number of cells.
        cells: usize,
    },
    /// A raster cell of a class that is not described.
    #[error("a raster cell must be one of its {classes} classes or BLANK, got {class}")]
    RasterClass {
        /// Number of classes.
        classes: usize,
        /// The class found.
        class: u8,
    },
    /// Words of a caption that the figure does not say.
    #[error("figure {figure}: {{{{{words}}}}}: {why}")]
    Unsaid {
        /// The figure's id.
        figure: &'static str,
        /// The words.
        words: String,
        /// Why not.
        why: String,
    },
    /// A plot without panels, or with a size that leaves no room to draw.
    #[error("{parameter} must be {allowed}, got {value}")]
    Layout {
        /// The parameter.
        parameter: &'static str,
        /// What it may be.
        allowed: &'static str,
        /// What it is.
        value: f64,
    },
}
