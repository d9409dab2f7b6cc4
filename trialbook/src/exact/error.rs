//! What can keep a formula from being read or a proof from being carried out.

/// Why an exact computation has no result.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ExactError {
    /// A symbol that the ring does not know.
    #[error("the symbol {name} is not declared in the ring")]
    UnknownSymbol {
        /// The symbol.
        name: String,
    },
    /// A name that is declared already.
    #[error("the symbol {name} is declared twice")]
    DeclaredTwice {
        /// The symbol.
        name: String,
    },
    /// A symbol that is not free to vary, because it stands for something else.
    #[error("{name} is not a free symbol of the ring, its rate cannot be chosen")]
    NotFree {
        /// The symbol.
        name: String,
    },
    /// A divisor that is zero in the ring.
    #[error("division by {divisor}, which is zero")]
    DivisionByZero {
        /// The divisor.
        divisor: String,
    },
    /// A circular function of something that is not made of declared angles.
    #[error(
        "{argument} is not a sum of half multiples of declared angles and of π/2, up to 32 of each"
    )]
    NoAngle {
        /// The argument.
        argument: String,
    },
    /// A hyperbolic function or an exponential of something that is not made of declared arguments.
    #[error(
        "{argument} is not a sum of half multiples of declared hyperbolic arguments, up to 32 of each"
    )]
    NoArgument {
        /// The argument.
        argument: String,
    },
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
    #[error("ln({of}) is not a sum of declared logarithms")]
    NoLogarithm {
        /// What the logarithm is taken of.
        of: String,
    },
    /// An inverse function for which no angle is declared.
    #[error("{function}({of}) is not a declared angle")]
    NoInverse {
        /// The function.
        function: &'static str,
        /// Its argument.
        of: String,
    },
    /// A power or logarithm of a number, or a value that is not what it is declared to be.
    #[error("{what} cannot be declared")]
    BadDeclaration {
        /// What was to be declared.
        what: String,
    },
    /// A function that has no power series there.
    #[error("there is no series in whole powers {what}")]
    NoSeries {
        /// Of what.
        what: String,
    },
    /// Equations for coefficients that contradict each other.
    #[error("the equations for the coefficients have no solution: {left} is left over")]
    Unsolvable {
        /// What would have to be zero.
        left: String,
    },
    /// A power whose exponent varies, while the logarithm of its base is not declared.
    #[error("the exponent of {power} varies, and the logarithm of its base is not declared")]
    VaryingExponent {
        /// The power.
        power: String,
    },
}
