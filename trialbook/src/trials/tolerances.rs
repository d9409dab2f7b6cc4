//! The tolerances that trials of any paper share, each with its reason; sorted by name.

/// Constants of type [`Tolerance`](crate::evidence::Tolerance), each with its own name.
#[macro_export]
macro_rules! tolerances {
    ($($(#[$about:meta])* $name:ident = $value:expr, $reason:literal;)*) => {
        $(
            $(#[$about])*
            pub const $name: $crate::evidence::Tolerance = $crate::evidence::Tolerance {
                name: stringify!($name),
                value: $value,
                reason: $reason,
            };
        )*
    };
}

pub use tolerances;

tolerances! {

/// A formula against the integrated motion.
MOTION = 2e-13,
    "the motion is good to about 1e-13 where the problem is well conditioned; the scale has what a rounding of the point makes of the value";

/// Nothing may differ.
NONE = 0.0,
    "a count or a normal form: nothing may differ";

/// A formula against a quadrature.
QUADRATURE = 5e-13,
    "the quadrature is asked for 1e-13";

}
