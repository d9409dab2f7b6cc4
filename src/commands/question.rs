//! What is asked of a calculator at one point of a grid.

use crate::claims::solve::{
    Curve, Double, Report, SolveError, anisotropic, constant, periodic, rest, sinusoidal, sphere,
    turntable,
};

/// A calculator with its parameters.
pub(super) enum Question {
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

    pub(super) fn report(&self) -> Result<Report, SolveError> {
        let name = self.name();
        Ok(match self {
            Self::Constant(given) => given.solve()?.report(name),
            Self::Sinusoidal(given) => given.solve()?.report(name),
            Self::Pulse(given) => given.solve()?.report(name),
            Self::Anisotropic(given) => given.solve()?.report(name),
            Self::Sphere(given) => given.solve()?.report(name),
            Self::Fate(given) => given.fate()?.report(name),
            Self::Moment(given, time) => given.at(*time)?.report(name),
            Self::Boundary(given) => given.solve()?.report(name),
        })
    }

    pub(super) fn curve(&self) -> Result<Curve, SolveError> {
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

    /// The names of the quantities that it asks for; they do not depend on the parameters.
    ///
    /// # Errors
    /// None: the parameters at which it looks are in range.
    pub(super) fn quantities(&self) -> Result<Vec<&'static str>, SolveError> {
        let [half, one] = [0.5, 1.0].map(Double::from);
        let start = turntable::TurntableProblem::Polar {
            rho: half,
            p: half,
            psi: one,
        };
        let easy = match self {
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
        };
        let fields = easy.report()?.fields;
        Ok(fields.iter().map(|field| field.name).collect())
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
        let end = |question: Question| *question.curve().unwrap().points.last().unwrap();
        let [x, y] = end(Question::Moment(start, time));
        let off = libm::hypot(x - there.position[0], y - there.position[1]);
        assert!(off < 1e-9, "{off}");
        let [x, y] = end(Question::Fate(start));
        assert!((libm::hypot(x, y) - fate.sigma.unwrap()).abs() < 1e-9);
    }
}
