//! Figures: from data to SVG, each with its data as CSV.

/// A figure, ready to be shown.
pub struct Figure {
    /// Permanent id: `fig-1`.
    pub id: &'static str,
    /// What it shows, for all readers; formulas in `$…$`.
    pub caption: String,
    /// What is to be seen, for readers who do not see it.
    pub alt: String,
    /// The picture.
    pub svg: String,
    /// The plotted data.
    pub csv: String,
}
