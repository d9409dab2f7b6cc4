//! Motions on the turntable by which the printed formulas are tried.
//!
//! Each is integrated three times by programs that share no equation: in the frame of the table, in the laboratory,
//! and by components along the velocity.

use super::prelude::*;

/// The particle's speed relative to the table against that of the table under it, ρ, over a stretch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Class {
    /// p < ρ throughout.
    Slower,
    /// p > ρ throughout.
    Faster,
    /// p = ρ at some time.
    Through,
}

pub(crate) const ANY: &[Class] = &[Class::Slower, Class::Faster, Class::Through];
/// The first case, (110).
pub(crate) const SLOWER: &[Class] = &[Class::Slower];
/// The second case, (116).
pub(crate) const FASTER: &[Class] = &[Class::Faster];

/// In the quantities of section 4, from position and velocity alone.
#[derive(Debug, Clone, Copy)]
pub(crate) struct View {
    pub position: [f64; 2],
    /// d𝛒/dτ.
    pub rate: [f64; 2],
    pub p: f64,
    pub rho: f64,
    /// Angle from the velocity to the position; 0 where one of them is zero.
    pub psi: f64,
    /// Position along the velocity; ρ where that is zero.
    pub xi: f64,
    /// Moment of the velocity about the axis over p; 0 where that is zero.
    pub ell: f64,
}

impl View {
    /// Of a state relative to the table with Ω = μ = g = 1.
    pub(crate) fn of(state: &State) -> Self {
        let (position, rate) = (state.x, state.v);
        let ([x, y], [u, v]) = (position, rate);
        let (p, rho) = (state.speed(), state.radius());
        let (along, moment) = (x * u + y * v, x * v - y * u);
        let moves = p > 0.0;
        let turned = moves && rho > 0.0;
        View {
            position,
            rate,
            p,
            rho,
            psi: if turned {
                libm::atan2(-moment, along)
            } else {
                0.0
            },
            xi: if moves { along / p } else { rho },
            ell: if moves { moment / p } else { 0.0 },
        }
    }

    /// 𝛒·d𝛒/dτ.
    pub(crate) fn along(&self) -> f64 {
        self.position[0] * self.rate[0] + self.position[1] * self.rate[1]
    }

    /// ẑ·(𝛒 × d𝛒/dτ).
    pub(crate) fn moment(&self) -> f64 {
        self.position[0] * self.rate[1] - self.position[1] * self.rate[0]
    }

    /// A and α, for p < ρ.
    pub(crate) fn inner(&self) -> (f64, f64) {
        let a = libm::sqrt((self.rho - self.p) * (self.rho + self.p));
        (a, libm::asinh(self.p / a))
    }

    /// B and β, for p > ρ.
    pub(crate) fn outer(&self) -> (f64, f64) {
        let b = libm::sqrt((self.p - self.rho) * (self.p + self.rho));
        (b, libm::asinh(self.rho / b))
    }
}

pub(crate) type Quantity = (&'static str, fn(&View) -> f64);

pub(crate) const P: Quantity = ("$p$", |v| v.p);
pub(crate) const RHO: Quantity = (r"$\rho$", |v| v.rho);
pub(crate) const PSI: Quantity = (r"$\psi$", |v| v.psi);
pub(crate) const ELL: Quantity = (r"$\ell$", |v| v.ell);
pub(crate) const XI: Quantity = (r"$\xi$", |v| v.xi);
pub(crate) const ALONG: Quantity = (r"$\bm\rho\cdot\mathrm d\bm\rho/\mathrm d\tau$", View::along);
pub(crate) const MOMENT: Quantity = (
    r"$\hat{\bm z}\cdot(\bm\rho\times\mathrm d\bm\rho/\mathrm d\tau)$",
    View::moment,
);
pub(crate) const ALPHA: Quantity = (r"$\alpha$", |v| v.inner().1);
pub(crate) const BETA: Quantity = (r"$\beta$", |v| v.outer().1);

/// Part of a motion on the dimensionless table, off rest and off the axis.
#[derive(Debug)]
pub(crate) struct Stretch {
    pub class: Class,
    /// By the frame of the table.
    pub turning: Path,
    /// By the laboratory.
    pub still: Path,
    /// By components along the velocity.
    pub parts: Run,
    pub from: f64,
    pub to: f64,
}

impl Stretch {
    pub(crate) fn view(&self, tau: f64) -> Result<View, MotionError> {
        Ok(View::of(&self.turning.at(tau)?))
    }

    pub(crate) fn part(&self, tau: f64) -> Result<Intrinsic, MotionError> {
        self.parts.at(tau)
    }

    /// ∫ of a rate dτ by the frame of the table; not a number where a formula gives none.
    pub(crate) fn sum(&self, rate: impl Fn(&View) -> f64, error: f64) -> f64 {
        let at = |tau: f64| self.view(tau).map_or(f64::NAN, |view| rate(&view));
        sum(at, self.from, self.to, error)
    }

    pub(crate) fn at(&self) -> String {
        match self.view(self.from) {
            Ok(View { rho, p, psi, .. }) => format!(
                "ρ = {rho:.6}, p = {p:.6}, ψ = {psi:.6}, then for τ = {:.6}",
                self.to - self.from
            ),
            Err(error) => error.to_string(),
        }
    }
}

const EACH: usize = 20;
const TRIES: usize = 5000;
/// How far from rest, from the axis and (but for the last class) from p = ρ a stretch stays.
const OFF: f64 = 0.1;

static STRETCHES: Runs<Vec<Stretch>> = Runs::new(|| {
    let mut points = Points::here();
    let mut found: Vec<Stretch> = Vec::new();
    for _ in 0..TRIES {
        if ANY.iter().all(|class| count(&found, *class) == EACH) {
            break;
        }
        let mut any = || points.uniform(-1.5, 1.5);
        let start = State {
            t: 0.0,
            x: [any(), any()],
            v: [any(), any()],
        };
        let from = points.uniform(0.0, 1.0);
        let to = from + points.uniform(0.3, 1.5);
        let table = Table::default();
        let turning = rotating::run(&table, &start, to)?;
        if let Some(class) = class(&turning, from, to)?
            && count(&found, class) < EACH
        {
            found.push(Stretch {
                class,
                turning,
                still: inertial::run(&table, &table.to_laboratory(&start), to)?,
                parts: Run::new(&Start::cartesian(start.x, start.v)?, to)?,
                from,
                to,
            });
        }
    }
    for [rho, p] in FAR {
        let start = State {
            t: 0.0,
            x: [rho, 0.0],
            v: [0.8 * p, -0.6 * p],
        };
        let (table, to) = (Table::default(), 0.002);
        found.push(Stretch {
            class: if p < rho {
                Class::Slower
            } else {
                Class::Faster
            },
            turning: rotating::run(&table, &start, to)?,
            still: inertial::run(&table, &table.to_laboratory(&start), to)?,
            parts: Run::new(&Start::cartesian(start.x, start.v)?, to)?,
            from: 0.0,
            to,
        });
    }
    Ok(found)
});

/// ρ and p at which α or β is below 0.01 or above 3.
const FAR: [[f64; 2]; 4] = [[30.0, 0.15], [1.84, 1.8315], [0.15, 30.0], [1.8315, 1.84]];

fn count(found: &[Stretch], class: Class) -> usize {
    found.iter().filter(|s| s.class == class).count()
}

/// Its ends included.
pub(crate) fn samples(from: f64, to: f64) -> impl Iterator<Item = f64> {
    (0..=40).map(move |i| (from + (to - from) * f64::from(i) / 40.0).min(to))
}

/// Nothing if it comes too close to where formulas divide by zero.
fn class(path: &Path, from: f64, to: f64) -> Result<Option<Class>, MotionError> {
    let mut lead = [f64::INFINITY, f64::NEG_INFINITY];
    for t in samples(from, to) {
        let view = View::of(&path.at(t)?);
        if view.p < OFF || view.rho < OFF {
            return Ok(None);
        }
        lead = [
            lead[0].min(view.p - view.rho),
            lead[1].max(view.p - view.rho),
        ];
    }
    Ok(match lead {
        [_, most] if most < -OFF => Some(Class::Slower),
        [least, _] if least > OFF => Some(Class::Faster),
        [least, most] if least < -OFF && most > OFF => Some(Class::Through),
        _ => None,
    })
}

/// The classes in turn.
pub(crate) fn stretches(
    classes: &[Class],
) -> impl Iterator<Item = Result<&'static Stretch, Failure>> {
    parts(STRETCHES.get().map(|all| {
        let of = |class: &Class| -> Vec<_> { all.iter().filter(|s| s.class == *class).collect() };
        let groups: Vec<_> = classes.iter().map(of).collect();
        (0..all.len()).flat_map(move |i| {
            let row = groups.iter().filter_map(|group| group.get(i).copied());
            row.collect::<Vec<_>>()
        })
    }))
}

/// Of any Ω, μ, g and m.
#[derive(Debug)]
pub(crate) struct Launch {
    pub table: Table,
    /// Relative to the table.
    pub start: State,
    /// By the frame of the table.
    pub turning: Path,
    /// By the laboratory.
    pub still: Path,
    pub to: f64,
}

impl Launch {
    pub(crate) fn at(&self) -> String {
        let Table {
            omega,
            mu,
            g,
            mass: m,
        } = self.table;
        let (r, v) = (self.start.radius(), self.start.speed());
        format!(
            "Ω = {omega:.6}, μ = {mu:.6}, g = {g:.6}, m = {m:.6}, r = {r:.6}, v = {v:.6}, t = {:.6}",
            self.to
        )
    }
}

pub(crate) fn any_table(points: &mut Points, slowest: f64) -> Table {
    Table {
        omega: points.log_uniform(slowest, 3.0),
        mu: points.uniform(0.1, 1.4),
        g: points.uniform(1.5, 20.0),
        mass: 1.0,
    }
}

static LAUNCHES: Runs<Vec<Launch>> = Runs::new(|| {
    let mut points = Points::here();
    let mut found = Vec::new();
    while found.len() < 2 * EACH {
        let mut table = any_table(&mut points, 0.05);
        table.mass = points.log_uniform(0.2, 5.0);
        let length = table.length();
        let mut any = |unit: f64| unit * points.uniform(-1.5, 1.5);
        let start = State {
            t: 0.0,
            x: [any(length), any(length)],
            v: [any(length * table.omega), any(length * table.omega)],
        };
        let to = points.uniform(0.5, 1.5) / table.omega;
        let turning = rotating::run(&table, &start, to)?;
        let slowest = samples(0.0, to).try_fold(f64::INFINITY, |least, t| {
            Ok::<_, MotionError>(turning.at(t)?.speed().min(least))
        })?;
        if slowest > OFF * length * table.omega {
            found.push(Launch {
                table,
                start,
                turning,
                still: inertial::run(&table, &table.to_laboratory(&start), to)?,
                to,
            });
        }
    }
    Ok(found)
});

pub(crate) fn launches() -> impl Iterator<Item = Result<&'static Launch, Failure>> {
    LAUNCHES.each()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stretch_is_looked_at_from_end_to_end() {
        let times: Vec<_> = samples(1.5, 2.0).collect();
        assert_eq!((times[0], times[40], times.len()), (1.5, 2.0, 41));
        for pair in times.windows(2) {
            assert!((pair[1] - pair[0] - 0.0125).abs() < 1e-15);
        }
    }

    #[test]
    fn stretches_are_counted_by_their_class() {
        let (table, start) = (
            Table::default(),
            State {
                t: 0.0,
                x: [1.0, 0.0],
                v: [0.5, 0.5],
            },
        );
        let stretch = |class| Stretch {
            class,
            turning: rotating::run(&table, &start, 0.1).unwrap(),
            still: inertial::run(&table, &table.to_laboratory(&start), 0.1).unwrap(),
            parts: Run::new(&Start::cartesian(start.x, start.v).unwrap(), 0.1).unwrap(),
            from: 0.0,
            to: 0.1,
        };
        let some = [Class::Slower, Class::Through, Class::Slower].map(stretch);
        assert_eq!(
            [Class::Slower, Class::Faster, Class::Through].map(|c| count(&some, c)),
            [2, 0, 1]
        );
    }
}
