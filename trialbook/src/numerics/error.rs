//! What can go wrong in a numerical method, by name.

/// A number with all its digits, as short as it can be read back.
pub fn plain(x: f64) -> String {
    if x == 0.0 || (1e-5..1e15).contains(&x.abs()) {
        format!("{x}")
    } else {
        format!("{x:e}")
    }
}

/// Why a numerical method has no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NumericsError {
    /// An argument lies outside its range.
    #[error("{name} = {} must be {range}", plain(*value))]
    Argument {
        /// Name of the parameter.
        name: &'static str,
        /// What was given.
        value: f64,
        /// What is allowed.
        range: &'static str,
    },
    /// A value that has to be computed on the way is infinite or not a number.
    #[error("{what} is not finite at {at}")]
    NotFinite {
        /// Which value.
        what: &'static str,
        /// Value of the independent variable there.
        at: f64,
    },
    /// The work allowed was used up first.
    #[error("{what}: the limit of {limit} was reached at {at}")]
    Limit {
        /// What was counted.
        what: &'static str,
        /// How many were allowed.
        limit: usize,
        /// Value of the independent variable reached.
        at: f64,
    },
    /// A bracket whose ends have values of the same sign.
    #[error("no change of sign between {low} (value {at_low}) and {high} (value {at_high})")]
    NoSignChange {
        /// Lower end.
        low: f64,
        /// Upper end.
        high: f64,
        /// Value at the lower end.
        at_low: f64,
        /// Value at the upper end.
        at_high: f64,
    },
    /// A point outside what was integrated.
    #[error("{at} lies outside the integrated range from {from} to {to}")]
    Outside {
        /// The point asked for.
        at: f64,
        /// Where the range begins.
        from: f64,
        /// Where the range ends.
        to: f64,
    },
    /// An adapted library gave up.
    #[error("{method}: {message}")]
    Library {
        /// Which method.
        method: &'static str,
        /// What it said.
        message: String,
    },
    /// Basis functions that the data cannot tell apart, or fewer data than unknowns.
    #[error("the fit is not determined: {data} data, {unknowns} unknowns, rank {rank}")]
    Rank {
        /// Number of data.
        data: usize,
        /// Number of unknowns.
        unknowns: usize,
        /// Numerical rank of the design matrix.
        rank: usize,
    },
}

/// Requires a finite argument.
///
/// # Errors
/// [`NumericsError::Argument`] for any other.
pub fn finite(name: &'static str, value: f64) -> Result<f64, NumericsError> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err(NumericsError::Argument {
            name,
            value,
            range: "finite",
        })
    }
}
