//! What a paper on trial needs, in one import: `use trialbook::prelude::*;`.

pub use crate::data::{Text, text};
pub use crate::evidence::Subject::{Corrected, Excepted, Outside, Printed, Remark, Step, Within};
pub use crate::evidence::{Change, Evidence, Kind, Route, Subject, Tolerance};
pub use crate::exact::{ExactError, Expr, Obstacle, Proof, Prover, Rational, Ring};
pub use crate::ledger::{Ledger, Record, Verdict};
pub use crate::numerics::dop853;
pub use crate::numerics::quadrature::integral;
pub use crate::numerics::roots::root;
#[cfg(feature = "book")]
pub use crate::plotting::{Axis, Curve, Figure, FigureError, Panel, Plot, Table};
#[cfg(feature = "book")]
pub use crate::publishing::{Edition, Page, Sources, sources};
pub use crate::scalar::Scalar;
pub use crate::seeded::{Formula, formulas};
pub use crate::trials::attempt::{Attempt, trials};
pub use crate::trials::compare::{Compared, Failure, Pair, Trial, is, where_defined};
pub use crate::trials::excepted::{no_inside, no_value};
pub use crate::trials::formulas::{Formulas, formulas_of};
pub use crate::trials::points::{Points, others};
pub use crate::trials::read::{File, claims};
pub use crate::trials::runs::{Runs, Setting, every, only, parts, with_each};
pub use crate::trials::statement::{Statement, rest_on};
pub use crate::trials::{Claim, Condition, Correction, Paper, Topic};
pub use std::process::ExitCode;
