//! What is asked of a calculator at one point of a grid.

use crate::solve::{
    Curve, Double, Field, Report, SolveError, Unit, Value, anisotropic, constant, periodic, rest,
    sinusoidal, sphere, turntable,
};

/// A calculator with its parameters, and what the paper's units are in SI where it is asked in SI.
pub(super) struct Question {
    pub(super) asked: Asked,
    pub(super) units: Vec<Unit>,
    /// Why it is none.
    pub(super) refused: Option<SolveError>,
}

/// A calculator with its parameters, in the paper's units.
pub(super) enum Asked {
    Constant(constant::ConstantProblem<Double>),
    Sinusoidal(sinusoidal::SinusoidalProblem<Double>),
    Pulse(periodic::PeriodicProblem<Double>),
    Anisotropic(anisotropic::AnisotropicProblem<Double>),
    Sphere(sphere::SphereProblem<Double>),
    /// What becomes of a start.
    Fate(turntable::TurntableProblem<Double>),
    /// Its state at a time.
    Moment(turntable::TurntableProblem<Double>, Double),
    Boundary(rest::BoundaryProblem<Double>),
}

impl Question {
    /// The answer in the units that it is asked in.
    ///
    /// # Errors
    /// [`SolveError`] where there is none, where no digit of it is known, or where it is no number in SI.
    pub(super) fn report(&self) -> Result<Report, SolveError> {
        if let Some(refused) = &self.refused {
            return Err(refused.clone());
        }
        let report = self.asked.report(&self.units)?;
        if report.digits == Some(0) {
            return Err(SolveError::Unknown);
        }
        let large = |field: &&Field| matches!(field.value, Value::Number(x) if !x.is_finite());
        match report.fields.iter().find(large) {
            Some(field) => Err(SolveError::NotFinite { name: field.name }),
            None => Ok(report),
        }
    }

    pub(super) fn curve(&self) -> Result<Curve, SolveError> {
        Ok(self.asked.curve()?.in_si(&self.units))
    }

    /// The heads of the columns of what it asks for; they do not depend on the parameters.
    ///
    /// # Errors
    /// None: the parameters at which it looks are in range.
    pub(super) fn heads(&self) -> Result<Vec<String>, SolveError> {
        let fields = self.asked.easy().report(&self.units)?.fields;
        Ok(fields.iter().map(Field::head).collect())
    }
}

impl Asked {
    /// Its name on the command line.
    pub(super) fn name(&self) -> &'static str {
        match self {
            Self::Constant(_) => "constant",
            Self::Sinusoidal(_) => "sinusoidal",
            Self::Pulse(_) => "pulse",
            Self::Anisotropic(_) => "anisotropic",
            Self::Sphere(_) => "sphere",
            Self::Fate(_) | Self::Moment(..) => "turntable",
            Self::Boundary(_) => "turntable-boundary",
        }
    }

    fn report(&self, units: &[Unit]) -> Result<Report, SolveError> {
        let name = self.name();
        Ok(match self {
            Self::Constant(given) => given.solve()?.report_in(name, units),
            Self::Sinusoidal(given) => given.solve()?.report_in(name, units),
            Self::Pulse(given) => given.solve()?.report_in(name, units),
            Self::Anisotropic(given) => given.solve()?.report_in(name, units),
            Self::Sphere(given) => given.solve()?.report_in(name, units),
            Self::Fate(given) => given.fate()?.report_in(name, units),
            Self::Moment(given, time) => given.at(*time)?.report_in(name, units),
            Self::Boundary(given) => given.solve()?.report_in(name, units),
        })
    }

    fn curve(&self) -> Result<Curve, SolveError> {
        match self {
            Self::Constant(given) => given.curve(),
            Self::Sinusoidal(given) => given.curve(),
            Self::Pulse(given) => given.curve(),
            Self::Anisotropic(given) => given.curve(),
            Self::Sphere(given) => given.curve(),
            Self::Fate(given) => given.curve(None),
            Self::Moment(given, time) => given.curve(Some((*time).into())),
            Self::Boundary(given) => given.curve(),
        }
    }

    /// The same calculator at parameters that are in range.
    fn easy(&self) -> Self {
        let [half, one] = [0.5, 1.0].map(Double::from);
        let start = turntable::TurntableProblem::Polar {
            rho: half,
            p: half,
            psi: one,
        };
        match self {
            Self::Constant(_) => Self::Constant(constant::ConstantProblem {
                lambda: half,
                v0: one,
                theta0: one,
                accel: one,
                at: constant::At::Time(one),
            }),
            Self::Sinusoidal(_) => {
                Self::Sinusoidal(sinusoidal::SinusoidalProblem { lambda0: half })
            }
            Self::Pulse(_) => Self::Pulse(periodic::PeriodicProblem {
                eta: half,
                lambda0: half,
            }),
            Self::Anisotropic(_) => Self::Anisotropic(anisotropic::AnisotropicProblem {
                q: Double::from(2.0),
                lambda0: half,
            }),
            Self::Sphere(_) => Self::Sphere(sphere::SphereProblem {
                gamma: one + one,
                u0: one,
                theta0: one,
                kappa: half,
                at: constant::At::Time(half),
            }),
            Self::Fate(_) => Self::Fate(start),
            Self::Moment(..) => Self::Moment(start, half),
            Self::Boundary(_) => Self::Boundary(rest::BoundaryProblem {
                alpha: half,
                psi: one,
            }),
        }
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
