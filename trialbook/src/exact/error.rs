//! What can keep a formula from being read or a proof from being carried out.

/// Why an exact computation has no result.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ExactError {
    /// A symbol that the ring does not know.
    #[error("the symbol {0} is not declared in the ring")]
    UnknownSymbol(String),
    /// A name that is declared already.
    #[error("the symbol {0} is declared twice")]
    DeclaredTwice(String),
    /// A symbol that is not free to vary.
    #[error("{0} is not a free symbol of the ring, its rate cannot be chosen")]
    NotFree(String),
    /// A divisor that is zero in the ring.
    #[error("division by {0}, which is zero")]
    DivisionByZero(String),
    /// A circular function of what is not made of declared angles.
    #[error("{0} is not a sum of half multiples of declared angles and of π/2, up to 32 of each")]
    NoAngle(String),
    /// A hyperbolic function or an exponential of what is not made of declared arguments.
    #[error(
        "{0} is not a sum of half multiples of declared hyperbolic arguments, up to 32 of each"
    )]
    NoArgument(String),
    /// A power for which there is no generator.
    #[error(
        "({base})^({exponent}) is not a product of declared powers; whole exponents go from −64 to 64"
    )]
    NoPower {
        /// The base.
        base: String,
        /// The exponent.
        exponent: String,
    },
    /// A logarithm for which there is no generator.
    #[error("ln({0}) is not a sum of declared logarithms")]
    NoLogarithm(String),
    /// An inverse function for which no angle is declared.
    #[error("{function}({of}) is not a declared angle")]
    NoInverse {
        /// The function.
        function: &'static str,
        /// Its argument.
        of: String,
    },
    /// A power or logarithm of a number, or a value that is not as declared.
    #[error("{0} cannot be declared")]
    BadDeclaration(String),
    /// A value for a generator that its rule does not give it.
    #[error("{0} has another value there, or none, by what it is made of")]
    AgainstRule(String),
    /// A function that has no power series there: of what.
    #[error("there is no series in whole powers {0}")]
    NoSeries(String),
    /// Equations for coefficients that contradict each other.
    #[error("the equations for the coefficients have no solution: {0} is left over")]
    Unsolvable(String),
    /// A power whose exponent varies, without the logarithm of its base.
    #[error("the exponent of {0} varies, and the logarithm of its base is not declared")]
    VaryingExponent(String),
}
