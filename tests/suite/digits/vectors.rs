//! The calculators with formulas, and some of the turntable's, against the foreign program.

use super::{cases, tally::Tally};
use slipbook::solve::{
    Answer, Fields, SolveError, anisotropic, constant, constant::At, known, periodic, rest,
    sinusoidal, sphere, turntable,
};
use std::fs;
use std::path::Path;

pub struct Row<'a> {
    head: &'a [&'a str],
    cells: Vec<&'a str>,
    line: &'a str,
}

impl Row<'_> {
    pub fn text(&self, name: &str) -> &str {
        let column = self.head.iter().position(|head| *head == name);
        self.cells[column.unwrap_or_else(|| panic!("no column {name}"))]
    }

    pub fn number(&self, name: &str) -> f64 {
        self.text(name).parse().unwrap()
    }

    fn at(&self) -> At {
        match self.text("at") {
            "theta" => At::Theta(self.number("moment")),
            _ => At::Time(self.number("moment")),
        }
    }

    fn exact(&self, name: &str) -> Option<String> {
        Some(self.text(name).to_owned()).filter(|text| !text.is_empty())
    }
}

pub fn rows(name: &str, most: usize, mut each: impl FnMut(&Row<'_>)) {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/data/digits/{name}.csv"));
    let text = fs::read_to_string(file).unwrap();
    let mut lines = text.lines();
    let head: Vec<&str> = lines.next().unwrap().split(',').collect();
    let lines: Vec<&str> = lines.collect();
    for line in lines.iter().step_by(lines.len().div_ceil(most)) {
        each(&Row {
            head: &head,
            cells: line.split(',').collect(),
            line,
        });
    }
}

fn try_all<T: Fields + Clone>(
    kind: &str,
    usual: usize,
    solve: impl Fn(&Row<'_>) -> Result<Answer<T>, SolveError>,
) {
    let mut tally = Tally::default();
    let most = cases(usual);
    rows(kind, most, |row| {
        let answer = solve(row).unwrap_or_else(|e| panic!("{}: {e}", row.line));
        tally.answer(&answer, |name| row.exact(name), row.line);
    });
    assert!(tally.closes(kind, most >= 10_000));
}

#[test]
fn constant_acceleration() {
    try_all("constant", 1000, |row| {
        let problem = constant::ConstantProblem {
            lambda: row.number("lambda"),
            v0: row.number("v0"),
            theta0: row.number("theta0"),
            accel: row.number("accel"),
            at: row.at(),
        };
        problem.solve()
    });
}

#[test]
fn a_sphere() {
    try_all("sphere", 500, |row| {
        let problem = sphere::SphereProblem {
            gamma: row.number("gamma"),
            u0: row.number("u0"),
            theta0: row.number("theta0"),
            kappa: row.number("kappa"),
            at: row.at(),
        };
        problem.solve()
    });
}

#[test]
fn a_sinusoidal_drive() {
    try_all("sinusoidal", 2000, |row| {
        let lambda0 = row.number("lambda0");
        sinusoidal::SinusoidalProblem { lambda0 }.solve()
    });
}

#[test]
fn a_train_of_pulses() {
    try_all("pulse", 2000, |row| {
        let (eta, lambda0) = (row.number("eta"), row.number("lambda0"));
        periodic::PeriodicProblem { eta, lambda0 }.solve()
    });
}

#[test]
fn anisotropic_friction() {
    try_all("anisotropic", 2000, |row| {
        let (q, lambda0) = (row.number("q"), row.number("lambda0"));
        anisotropic::AnisotropicProblem { q, lambda0 }.solve()
    });
}

fn start(row: &Row<'_>) -> turntable::TurntableProblem {
    turntable::TurntableProblem::Polar {
        rho: row.number("rho"),
        p: row.number("p"),
        psi: row.number("psi"),
    }
}

#[test]
fn rest_on_the_turntable() {
    let [mut alone, mut of_many] = [(), ()].map(|()| Tally::default());
    let horizon = turntable::Horizon {
        rho: 100.0,
        tau: 100.0,
    };
    rows("turntable-rest", cases(100), |row| {
        let answer = start(row).fate().unwrap();
        alone.answer(&answer, |name| row.exact(name), row.line);
        let [rho, p, psi] = ["rho", "p", "psi"].map(|name| row.number(name));
        if p == 0.0 && rho > 1.0 {
            // No start of an ensemble.
            return;
        }
        let [rho, p, psi] = [rho, p, psi].map(Into::into);
        let end = horizon.follow_exactly(rho, p, psi).unwrap();
        let turntable::End::Rest {
            sigma,
            sigma_error,
            tau,
            tau_error,
        } = end
        else {
            let far = matches!(end, turntable::End::Far { .. });
            assert!(
                far && row.text("outcome") == "escape",
                "{}: {end:?}",
                row.line
            );
            return;
        };
        for (name, value, error) in [("sigma", sigma, sigma_error), ("tau_rest", tau, tau_error)] {
            of_many.number(value, known(value, error), row.number(name), row.line);
        }
    });
    assert!(alone.closes("rest on the turntable", false));
    assert!(of_many.closes("one of an ensemble, exactly", false));
}

#[test]
fn the_turntable_at_a_time() {
    let mut tally = Tally::default();
    rows("turntable-time", cases(50), |row| {
        let answer = start(row).at(row.number("time")).unwrap();
        let exact = |name: &str| match name {
            "rho" | "p" | "psi" => row.exact(&format!("{name}_t")),
            name => row.exact(name),
        };
        tally.answer(&answer, exact, row.line);
    });
    assert!(tally.closes("the turntable at a time", false));
}

#[test]
fn the_boundary_of_rest() {
    let mut tally = Tally::default();
    rows("turntable-boundary", cases(6), |row| {
        let (alpha, psi) = (row.number("alpha"), row.number("psi"));
        let answer = rest::BoundaryProblem { alpha, psi }.solve().unwrap();
        tally.answer(&answer, |name| row.exact(name), row.line);
    });
    assert!(tally.closes("the boundary", false));
}
