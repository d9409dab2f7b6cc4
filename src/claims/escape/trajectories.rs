//! The motions that the statements about escape are held against.

use super::prelude::*;

/// A start with p < ρ, by A, α and ψ.
#[derive(Debug, Clone, Copy)]
pub struct Launch {
    /// A = √(ρ² − p²).
    pub a: f64,
    /// α = artanh(p/ρ).
    pub alpha: f64,
    /// ψ in radians.
    pub psi: f64,
}

impl Launch {
    /// The start.
    ///
    /// # Errors
    /// As [`Start::hyperbolic`].
    pub fn start(&self) -> Result<Start, MotionError> {
        Start::hyperbolic(self.a, self.alpha, self.psi)
    }

    /// The start in the paper's symbols.
    pub fn at(&self) -> String {
        let Launch { a, alpha, psi } = self;
        if *alpha < 1e-3 {
            format!("A = {a:.6}, α = {alpha:.5e}, ψ = {psi:.6} at the start")
        } else {
            format!("A = {a:.6}, α = {alpha:.6}, ψ = {psi:.6} at the start")
        }
    }
}

/// A launch and the motion from it.
#[derive(Debug)]
pub struct Flight {
    /// The launch.
    pub launch: Launch,
    /// The motion.
    pub run: Run,
}

impl Flight {
    /// Its start in the paper's symbols.
    pub fn at(&self) -> String {
        self.launch.at()
    }

    /// Follows a launch to the time `until`, or to its rest.
    ///
    /// # Errors
    /// As [`Run::new`].
    pub fn new(launch: Launch, until: f64) -> Result<Self, MotionError> {
        let run = Run::new(&launch.start()?, until)?;
        Ok(Flight { launch, run })
    }
}

/// α of a state; not a number where p ≥ ρ.
pub fn alpha(state: &Intrinsic) -> f64 {
    state.alpha().unwrap_or(f64::NAN)
}

/// A of a state; not a number where p > ρ.
pub fn a(state: &Intrinsic) -> f64 {
    state.a().unwrap_or(f64::NAN)
}

/// The rates of `N` quantities, by central differences of fourth order.
///
/// # Errors
/// Those of `f`.
pub fn rates<const N: usize>(
    t: f64,
    h: f64,
    f: impl Fn(f64) -> Result<[f64; N], MotionError>,
) -> Result<[f64; N], MotionError> {
    let values = [f(t - 2.0 * h)?, f(t - h)?, f(t + h)?, f(t + 2.0 * h)?];
    Ok(std::array::from_fn(|i| {
        let [a, b, c, d] = values.map(|v| v[i]);
        (8.0 * (c - b) - (d - a)) / (12.0 * h)
    }))
}

/// Time to which escapes are followed.
pub const LATE: f64 = 1e8;

/// A late moment of an escape.
#[derive(Debug)]
pub struct Late {
    /// The time τ.
    pub tau: f64,
    /// The state.
    pub state: Intrinsic,
    /// dα/dτ, by differences.
    pub alpha_rate: f64,
    /// dA/dτ, by differences.
    pub a_rate: f64,
}

/// An escape, and 48 moments over its last two decades.
#[derive(Debug)]
pub struct Escape {
    /// The launch.
    pub launch: Launch,
    /// The motion, to τ = 10⁸.
    pub run: Run,
    /// The late moments.
    pub late: Vec<Late>,
}

impl Escape {
    /// Its start in the paper's symbols.
    pub fn at(&self) -> String {
        self.launch.at()
    }
}

/// Escapes from A > 1.
pub(crate) static ESCAPES: Runs<Vec<Escape>> = Runs::new(all_escapes);

/// Others of the same kind.
pub(crate) static OTHER_ESCAPES: Runs<Vec<Escape>> = Runs::new(|| others(all_escapes));

fn all_escapes() -> Result<Vec<Escape>, Failure> {
    let mut points = Points::here();
    let launch = |_| Launch {
        a: points.uniform(1.05, 4.0),
        alpha: points.log_uniform(0.1, 1.5),
        psi: points.uniform(-2.6, 2.6),
    };
    let launches: Vec<_> = (0..20).map(launch).collect();
    every(launches.into_iter().map(escape))
}

/// Follows a launch far out.
///
/// # Errors
/// As [`Run::new`].
pub fn escape(launch: Launch) -> Result<Escape, MotionError> {
    let run = Run::new(&launch.start()?, LATE)?;
    let late = (0..48)
        .map(|i| {
            // Not quite to the end: the differences need room.
            let tau = 0.8 * LATE * libm::pow(1e-2, f64::from(i) / 48.0);
            // In ln τ, of which ln A and α are nearly linear functions, the steps can be long.
            let [alpha_slope, a_slope] = rates(libm::log(tau), 0.1, |log| {
                let state = run.at(libm::exp(log))?;
                Ok([alpha(&state), libm::log(a(&state))])
            })?;
            let state = run.at(tau)?;
            Ok(Late {
                tau,
                state,
                alpha_rate: alpha_slope / tau,
                a_rate: a_slope * a(&state) / tau,
            })
        })
        .collect::<Result<_, MotionError>>()?;
    Ok(Escape { launch, run, late })
}

/// Launches with p < ρ of every kind, followed to their rest or to τ = 10⁴.
pub(crate) static FLIGHTS: Runs<Vec<Flight>> = Runs::new(all_flights);

/// Others of the same kinds.
pub(crate) static OTHER_FLIGHTS: Runs<Vec<Flight>> = Runs::new(|| others(all_flights));

fn all_flights() -> Result<Vec<Flight>, Failure> {
    let mut points = Points::here();
    let launch = |_| Launch {
        a: points.uniform(0.05, 2.0),
        alpha: points.log_uniform(1e-3, 2.0),
        psi: points.uniform(-3.1, 3.1),
    };
    let launches: Vec<_> = (0..100).map(launch).collect();
    every(launches.into_iter().map(|l| Flight::new(l, 1e4)))
}

/// A launch near α = 0, and the state when ψ has relaxed.
#[derive(Debug)]
pub struct Relaxed {
    /// The launch.
    pub launch: Launch,
    /// The state.
    pub state: Intrinsic,
    /// dα/dτ there.
    pub alpha_rate: f64,
}

impl Relaxed {
    /// Its start in the paper's symbols.
    pub fn at(&self) -> String {
        self.launch.at()
    }
}

/// Launches with tiny α and any ψ but near π, with the state when ψ has relaxed: for A > 1, where α grows meanwhile
/// and ψ falls as α^(−A/(A−1)), at a hundred thousand times the initial α, else when p has fallen by the factor 10¹².
pub fn relaxed() -> impl Iterator<Item = Result<&'static Relaxed, Failure>> {
    static RELAXED: Runs<Vec<Relaxed>> = Runs::new(all_relaxed);
    RELAXED.each()
}

/// Others of the same kinds.
pub(crate) static OTHERS_RELAXED: Runs<Vec<Relaxed>> = Runs::new(|| others(all_relaxed));

/// Launches with a ψ of the order of α, so that their ratio has relaxed too. For A < 0.7 it takes too long to be seen, and
/// for A < ½ for ever.
pub(crate) static RELAXED_RATIOS: Runs<Vec<Relaxed>> =
    Runs::new(|| launched(0.7, |alpha, points| alpha * points.uniform(-5.0, 5.0)));

fn all_relaxed() -> Result<Vec<Relaxed>, Failure> {
    launched(0.4, |_, points| points.uniform(-2.9, 2.9))
}

fn launched(least_a: f64, psi: fn(f64, &mut Points) -> f64) -> Result<Vec<Relaxed>, Failure> {
    let mut points = Points::here();
    let launch = |i: usize| {
        let a = if i.is_multiple_of(2) {
            points.uniform(1.05, 3.0)
        } else {
            points.uniform(least_a, 0.95)
        };
        let alpha = points.log_uniform(1e-13, 1e-11);
        let psi = psi(alpha, &mut points);
        Launch { a, alpha, psi }
    };
    let launches: Vec<_> = (0..40).map(launch).collect();
    every(launches.into_iter().map(relax))
}

fn relax(launch: Launch) -> Result<Relaxed, MotionError> {
    let run = Run::new(&launch.start()?, 1e5 * launch.alpha)?;
    let parts = if launch.a > 1.0 {
        run.end().parts
    } else {
        let small = run.nodes().find(|s| s.p() < 1e-12 * launch.alpha);
        small.map_or(run.end().parts, |s| s.parts)
    };
    // From here on with a clock of its own, so that tiny times keep their digits.
    let time = parts.p / parts.xi;
    let run = Run::new(&parts, time)?;
    let [alpha_rate] = rates(0.01 * time, 1e-3 * time, |t| Ok([alpha(&run.at(t)?)]))?;
    Ok(Relaxed {
        launch,
        state: run.at(0.01 * time)?,
        alpha_rate,
    })
}
