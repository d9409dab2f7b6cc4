//! The command `solve`: the calculators of [`crate::claims::solve`].

use super::plot;
use crate::claims::solve::Double;
use crate::claims::solve::constant::At;
use crate::claims::solve::{
    Curve, Field, Report, SolveError, Value, anisotropic, constant, periodic, rest, sinusoidal,
    sphere, turntable,
};
use crate::numerics::error::plain as number;
use clap::{Args, Subcommand};
use std::fmt::Write;
use std::path::PathBuf;
use trialbook::cli::{csv, json, say};
use trialbook::edition::{Failure, Format};

/// A calculator and whether to plot.
#[derive(Args)]
pub(super) struct Solve {
    #[command(subcommand)]
    problem: Problem,
    /// Plot too: into an SVG file, or as text if no file is named
    #[arg(long, global = true, value_name = "FILE", num_args = 0..=1)]
    #[allow(clippy::option_option)]
    plot: Option<Option<PathBuf>>,
}

#[derive(Subcommand)]
enum Problem {
    /// A particle launched on a plane of constant acceleration
    #[command(after_help = "Examples:
  slipbook solve constant --lambda 0.5 --v0 1 --theta0 1 --time 2
  slipbook solve constant --lambda 1.5 --v0 1 --theta0 2 --theta 0.3 --json")]
    Constant(Constant),
    /// The large-time motion under a sinusoidal drive
    #[command(after_help = "Example:\n  slipbook solve sinusoidal --lambda0 0.7 --plot")]
    Sinusoidal {
        /// λ₀ = μg/A₀, friction over the drive's amplitude
        #[arg(long, allow_negative_numbers = true)]
        lambda0: Double,
    },
    /// The large-time motion under a train of pulses
    #[command(after_help = "Example:\n  slipbook solve pulse --eta 0.5 --lambda0 0.3")]
    Pulse {
        /// η, the share of a half period that a pulse fills, from 0 to 1
        #[arg(long, allow_negative_numbers = true)]
        eta: Double,
        /// λ₀ = μg/A₀, friction over the drive's amplitude
        #[arg(long, allow_negative_numbers = true)]
        lambda0: Double,
    },
    /// The large-time motion with a friction that depends on the direction
    #[command(after_help = "Example:\n  slipbook solve anisotropic --q 2 --lambda0 0.45")]
    Anisotropic {
        /// q, backward friction over forward friction
        #[arg(long, allow_negative_numbers = true)]
        q: Double,
        /// λ₀, forward friction over the drive's amplitude
        #[arg(long, allow_negative_numbers = true)]
        lambda0: Double,
    },
    /// A sphere that starts without spin on a plane of constant acceleration
    #[command(
        after_help = "Example:\n  slipbook solve sphere --gamma 2 --u0 1 --theta0 1 --time 0.3"
    )]
    Sphere(Sphere),
    /// A particle on a turntable: rest or escape, or its state at a time
    #[command(after_help = "Examples:
  slipbook solve turntable --rho 0.5 --p 0.3 --psi 1
  slipbook solve turntable --A 0.8 --alpha 0.1 --psi 0.2 --plot path.svg
  slipbook solve turntable --x 0.5 --y 0 --vx 0.1 --vy -0.2 --time 0.4")]
    Turntable(Turntable),
    /// Where rest and escape meet on a turntable
    #[command(after_help = "Example:\n  slipbook solve turntable-boundary --alpha 0.5 --psi 1")]
    TurntableBoundary {
        /// α, with p = A sinh α and ρ = A cosh α
        #[arg(long, allow_negative_numbers = true)]
        alpha: Double,
        /// ψ, the angle from the velocity to the position (radians)
        #[arg(long, allow_hyphen_values = true)]
        psi: Double,
    },
}

#[derive(Args)]
struct Constant {
    /// λ = μg/A, friction over acceleration
    #[arg(long, allow_negative_numbers = true)]
    lambda: Double,
    /// Initial speed
    #[arg(long, allow_negative_numbers = true)]
    v0: Double,
    /// Initial angle of the velocity with the x axis, in (−π, π]
    #[arg(long, allow_hyphen_values = true)]
    theta0: Double,
    /// The plane's acceleration A
    #[arg(long, allow_negative_numbers = true, default_value = "1")]
    accel: Double,
    #[command(flatten)]
    moment: Moment,
}

#[derive(Args)]
struct Sphere {
    /// γ = A/(μg)
    #[arg(long, allow_negative_numbers = true)]
    gamma: Double,
    /// Initial slip
    #[arg(long, allow_negative_numbers = true)]
    u0: Double,
    /// Initial angle of the slip with the x axis, in (−π, π]
    #[arg(long, allow_hyphen_values = true)]
    theta0: Double,
    /// κ = I/(mR²): 0.4 for a solid sphere
    #[arg(long, allow_negative_numbers = true, default_value = "0.4")]
    kappa: Double,
    #[command(flatten)]
    moment: Moment,
}

/// The moment that is asked for.
#[derive(Args)]
#[group(required = true, multiple = false)]
struct Moment {
    /// When the angle has fallen to this (radians)
    #[arg(long, allow_hyphen_values = true)]
    theta: Option<Double>,
    /// At this time
    #[arg(long, allow_negative_numbers = true)]
    time: Option<Double>,
}

impl Moment {
    fn at(&self) -> At<Double> {
        match (self.theta, self.time) {
            (Some(theta), _) => At::Theta(theta),
            (None, time) => At::Time(time.unwrap_or_default()),
        }
    }
}

#[derive(Args)]
struct Turntable {
    #[command(flatten)]
    start: Start,
    /// ψ, the angle from the velocity to the position, counterclockwise (radians)
    #[arg(long, allow_hyphen_values = true, conflicts_with_all = ["x", "y", "vx", "vy"])]
    psi: Option<Double>,
    /// Speed p of a start by --rho
    #[arg(long, allow_negative_numbers = true, requires = "rho", conflicts_with_all = ["A", "x"])]
    p: Option<Double>,
    /// α of a start by --A
    #[arg(long, allow_negative_numbers = true, requires = "A", conflicts_with_all = ["rho", "x"])]
    alpha: Option<Double>,
    /// Position y of a start by --x
    #[arg(long, allow_hyphen_values = true, requires = "x", conflicts_with_all = ["rho", "A"])]
    y: Option<Double>,
    /// Velocity along x, relative to the table
    #[arg(long, allow_hyphen_values = true, requires = "x", conflicts_with_all = ["rho", "A"])]
    vx: Option<Double>,
    /// Velocity along y, relative to the table
    #[arg(long, allow_hyphen_values = true, requires = "x", conflicts_with_all = ["rho", "A"])]
    vy: Option<Double>,
    /// Ask for the state at this time
    #[arg(long, allow_negative_numbers = true)]
    time: Option<Double>,
}

/// The first coordinate of a start says how it is given.
#[derive(Args)]
#[group(required = true, multiple = false)]
struct Start {
    /// Distance ρ from the axis, with --p and --psi
    #[arg(long, allow_negative_numbers = true, requires_all = ["p", "psi"])]
    rho: Option<Double>,
    /// A, with --alpha and --psi
    #[arg(id = "A", long = "A", value_name = "A", allow_negative_numbers = true, requires_all = ["alpha", "psi"])]
    a: Option<Double>,
    /// Position x in the table's axes, with --y, --vx and --vy
    #[arg(long, allow_hyphen_values = true, requires_all = ["y", "vx", "vy"])]
    x: Option<Double>,
}

impl Turntable {
    fn problem(&self) -> turntable::Problem<Double> {
        // The options require one another: none is missing here.
        let given = Option::unwrap_or_default;
        match self.start {
            Start { rho: Some(rho), .. } => turntable::Problem::Polar {
                rho,
                p: given(self.p),
                psi: given(self.psi),
            },
            Start { a: Some(a), .. } => turntable::Problem::Hyperbolic {
                a,
                alpha: given(self.alpha),
                psi: given(self.psi),
            },
            Start { x, .. } => turntable::Problem::Cartesian {
                position: [given(x), given(self.y)],
                velocity: [given(self.vx), given(self.vy)],
            },
        }
    }
}

impl Problem {
    fn report(&self) -> Result<Report, SolveError> {
        Ok(match self {
            Problem::Constant(given) => given.problem().solve()?.report("constant"),
            Problem::Sinusoidal { lambda0 } => {
                let lambda0 = *lambda0;
                sinusoidal::Problem { lambda0 }
                    .solve()?
                    .report("sinusoidal")
            }
            Problem::Pulse { eta, lambda0 } => {
                let (eta, lambda0) = (*eta, *lambda0);
                periodic::Problem { eta, lambda0 }.solve()?.report("pulse")
            }
            Problem::Anisotropic { q, lambda0 } => {
                let (q, lambda0) = (*q, *lambda0);
                anisotropic::Problem { q, lambda0 }
                    .solve()?
                    .report("anisotropic")
            }
            Problem::Sphere(given) => given.problem().solve()?.report("sphere"),
            Problem::Turntable(given) => match given.time {
                Some(time) => given.problem().at(time)?.report("turntable"),
                None => given.problem().fate()?.report("turntable"),
            },
            Problem::TurntableBoundary { alpha, psi } => {
                let (alpha, psi) = (*alpha, *psi);
                let boundary = rest::Problem { alpha, psi };
                boundary.solve()?.report("turntable-boundary")
            }
        })
    }

    fn curve(&self) -> Result<Curve, SolveError> {
        match self {
            Problem::Constant(given) => given.problem().curve(),
            Problem::Sinusoidal { lambda0 } => {
                let lambda0 = *lambda0;
                sinusoidal::Problem { lambda0 }.curve()
            }
            Problem::Pulse { eta, lambda0 } => {
                let (eta, lambda0) = (*eta, *lambda0);
                periodic::Problem { eta, lambda0 }.curve()
            }
            Problem::Anisotropic { q, lambda0 } => {
                let (q, lambda0) = (*q, *lambda0);
                anisotropic::Problem { q, lambda0 }.curve()
            }
            Problem::Sphere(given) => given.problem().curve(),
            Problem::Turntable(given) => given.problem().curve(given.time.map(f64::from)),
            Problem::TurntableBoundary { alpha, psi } => {
                let (alpha, psi) = (*alpha, *psi);
                rest::Problem { alpha, psi }.curve()
            }
        }
    }
}

impl Constant {
    fn problem(&self) -> constant::Problem<Double> {
        constant::Problem {
            lambda: self.lambda,
            v0: self.v0,
            theta0: self.theta0,
            accel: self.accel,
            at: self.moment.at(),
        }
    }
}

impl Sphere {
    fn problem(&self) -> sphere::Problem<Double> {
        sphere::Problem {
            gamma: self.gamma,
            u0: self.u0,
            theta0: self.theta0,
            kappa: self.kappa,
            at: self.moment.at(),
        }
    }
}

impl Solve {
    /// Answers, and plots if that is wanted.
    pub(super) fn run(&self, format: Format) -> Result<u8, Failure> {
        let report = self.problem.report()?;
        let drawn = match &self.plot {
            None => None,
            Some(Some(file)) => {
                plot::to_file(&self.problem.curve()?, file)?;
                None
            }
            Some(None) if format == Format::Text => Some(plot::as_text(&self.problem.curve()?)),
            Some(None) => return Err("--plot: beside JSON or CSV, name an SVG file".into()),
        };
        match format {
            Format::Text => say(&(text(&report) + "\n" + &drawn.unwrap_or_default()))?,
            Format::Json => json(&report)?,
            Format::Csv => table(&report)?,
        }
        Ok(0)
    }
}

fn word(value: Value) -> String {
    match value {
        Value::Number(x) => number(x),
        Value::Word(word) => word.to_owned(),
        Value::Missing => "none".to_owned(),
    }
}

/// The head of the column of values and those of the ways by which they were found, where there are such.
fn ways(report: &Report) -> impl Iterator<Item = (&'static str, &[Field])> {
    let values = Some(("value", &report.fields[..]));
    let formula = report.by_formula.as_deref();
    let motion = report.by_motion.as_deref();
    [
        values,
        formula.map(|fields| ("by formula", fields)),
        motion.map(|fields| ("by motion", fields)),
    ]
    .into_iter()
    .flatten()
}

fn text(report: &Report) -> String {
    let mut lines = vec![format!("{:<20}", "")];
    lines.extend(
        report
            .fields
            .iter()
            .map(|field| format!("{:<20}", field.name)),
    );
    for (head, fields) in ways(report) {
        let words = fields.iter().map(|field| word(field.value));
        for (line, word) in lines
            .iter_mut()
            .zip(std::iter::once(head.to_owned()).chain(words))
        {
            let _ = write!(line, "  {word:<22}");
        }
    }
    if let Some(digits) = report.digits {
        lines.push(format!("{:<20}  {digits}", "digits"));
    }
    lines.push(format!("{:<20}  {}", "note", report.note));
    let lines: Vec<_> = lines.iter().map(|line| line.trim_end()).collect();
    lines.join("\n")
}

fn table(report: &Report) -> Result<(), Failure> {
    let empty = |value: Value| match value {
        Value::Missing => String::new(),
        value => word(value),
    };
    let rows = report.fields.iter().enumerate().map(|(n, field)| {
        let way = |way: &Option<Vec<Field>>| {
            let field = way.as_ref().and_then(|fields| fields.get(n));
            field.map_or(String::new(), |field| empty(field.value))
        };
        vec![
            field.name.to_owned(),
            empty(field.value),
            way(&report.by_formula),
            way(&report.by_motion),
            report
                .digits
                .map_or(String::new(), |digits| digits.to_string()),
            report.note.clone(),
        ]
    });
    csv(
        &[
            "quantity",
            "value",
            "by_formula",
            "by_motion",
            "digits",
            "note",
        ],
        rows,
    )
}
