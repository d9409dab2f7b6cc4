//! What is asked of a calculator at one point of a grid.

use crate::numerics::error::plain as number;
use crate::solve::{
    Curve, Double, Field, Report, SolveError, Value, anisotropic, constant, periodic, rest,
    sinusoidal, sphere, turntable,
};

impl Asked {
    /// The answer.
    pub(super) fn report(&self) -> Result<Report, SolveError> {
        let report = self.found()?;
        if report.digits == Some(0) {
            return Err(SolveError::Unknown);
        }
        Ok(report)
    }

    /// The heads of the columns of what it asks for; they do not depend on the parameters.
    pub(super) fn heads(&self) -> Result<Vec<String>, SolveError> {
        let fields = self.easy().found()?.fields;
        Ok(fields.iter().map(Field::head).collect())
    }
}

/// The calculators with one answer: the parameters, the name on the command line, and parameters that are in range.
macro_rules! asked {
    ($($kind:ident: $problem:ty = $name:literal, $easy:expr;)*) => {
        /// A calculator with its parameters, in the paper's units.
        pub(super) enum Asked {
            $($kind($problem),)*
            /// What becomes of a start.
            Fate(turntable::TurntableProblem<Double>),
            /// Its state at a time.
            Moment(turntable::TurntableProblem<Double>, Double),
        }

        impl Asked {
            /// Its name on the command line.
            pub(super) fn name(&self) -> &'static str {
                match self {
                    $(Self::$kind(_) => $name,)*
                    Self::Fate(_) | Self::Moment(..) => "turntable",
                }
            }

            fn found(&self) -> Result<Report, SolveError> {
                let name = self.name();
                Ok(match self {
                    $(Self::$kind(given) => given.solve()?.report(name),)*
                    Self::Fate(given) => given.fate()?.report(name),
                    Self::Moment(given, time) => given.at(*time)?.report(name),
                })
            }

            pub(super) fn curve(&self) -> Result<Curve, SolveError> {
                match self {
                    $(Self::$kind(given) => given.curve(),)*
                    Self::Fate(given) => given.curve(None),
                    Self::Moment(given, time) => given.curve(Some((*time).into())),
                }
            }

            /// The same calculator at parameters that are in range.
            fn easy(&self) -> Self {
                let [rho, p, psi] = [0.5, 0.5, 1.0].map(Double::from);
                let start = turntable::TurntableProblem::Polar { rho, p, psi };
                match self {
                    $(Self::$kind(_) => Self::$kind($easy),)*
                    Self::Fate(_) => Self::Fate(start),
                    Self::Moment(..) => Self::Moment(start, p),
                }
            }
        }
    };
}

asked! {
    Constant: constant::ConstantProblem<Double> = "constant", constant::ConstantProblem {
        lambda: 0.5.into(),
        v0: 1.0.into(),
        theta0: 1.0.into(),
        accel: 1.0.into(),
        at: constant::At::Time(1.0.into()),
    };
    Sinusoidal: sinusoidal::SinusoidalProblem<Double> = "sinusoidal",
        sinusoidal::SinusoidalProblem { lambda0: 0.5.into() };
    Pulse: periodic::PeriodicProblem<Double> = "pulse",
        periodic::PeriodicProblem { eta: 0.5.into(), lambda0: 0.5.into() };
    Anisotropic: anisotropic::AnisotropicProblem<Double> = "anisotropic",
        anisotropic::AnisotropicProblem { q: 2.0.into(), lambda0: 0.5.into() };
    Sphere: sphere::SphereProblem<Double> = "sphere", sphere::SphereProblem {
        gamma: 2.0.into(),
        u0: 1.0.into(),
        theta0: 1.0.into(),
        kappa: 0.5.into(),
        at: constant::At::Time(0.5.into()),
    };
    Boundary: rest::BoundaryProblem<Double> = "turntable-boundary",
        rest::BoundaryProblem { alpha: 0.5.into(), psi: 1.0.into() };
}

pub(super) fn word(value: Value) -> String {
    match value {
        Value::Number(x) => number(x),
        Value::Word(word) => word.to_owned(),
        Value::Missing => "none".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_ends_where_its_answer_is() {
        let [half, p, psi, time] = [0.5, 0.3, 1.0, 0.2].map(Double::from);
        let start = turntable::TurntableProblem::Polar { rho: half, p, psi };
        let fate = start.fate().unwrap().best;
        let there = start.at(time).unwrap().best;
        assert!(fate.tau_rest.unwrap() > 2.0 * 0.2);
        let end = |asked: Asked| *asked.curve().unwrap().points.last().unwrap();
        let [x, y] = end(Asked::Moment(start, time));
        let off = libm::hypot(x - there.position[0], y - there.position[1]);
        assert!(off < 1e-9, "{off}");
        let [x, y] = end(Asked::Fate(start));
        assert!((libm::hypot(x, y) - fate.sigma.unwrap()).abs() < 1e-9);
    }
}
