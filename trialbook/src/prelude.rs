//! What a paper on trial needs, in one import: `use trialbook::prelude::*;`.

pub use crate::claims::attempt::{Attempt, trials};
pub use crate::claims::compare::{Compared, Failure, Pair, Trial, is, where_defined};
pub use crate::claims::excepted::{no_inside, no_value};
pub use crate::claims::formulas::{Formulas, formulas_of};
pub use crate::claims::points::Points;
pub use crate::claims::read::{File, claims};
pub use crate::claims::runs::{Runs, every, only, parts, with_each};
pub use crate::claims::statement::{Statement, given};
pub use crate::claims::{Claim, Condition, Correction, Paper, Topic};
#[cfg(feature = "book")]
pub use crate::edition::{Edition, Page, Sources, sources};
pub use crate::evidence::Subject::{Corrected, Excepted, Outside, Printed, Remark, Step, Within};
pub use crate::evidence::{Change, Evidence, Kind, Route, Subject, Tolerance};
pub use crate::exact::{ExactError, Expr, Obstacle, Proof, Prover, Rational, Ring};
#[cfg(feature = "book")]
pub use crate::figures::{Axis, Curve, Figure, FigureError, Panel, Plot, Table};
pub use crate::ledger::{Ledger, Record, Verdict};
pub use crate::numerics::dop853;
pub use crate::numerics::quadrature::integral;
pub use crate::numerics::roots::root;
pub use crate::scalar::Scalar;
pub use crate::seeded::{Formula, formulas};
pub use std::process::ExitCode;
