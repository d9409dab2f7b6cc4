//! The command `solve`: the calculators of [`crate::claims::solve`].

use super::axis::{Axis, Point, is_it_degrees};
use super::question::Question;
use super::{plot, sweep};
use crate::claims::solve::constant::At;
use crate::claims::solve::turntable::MotionError;
use crate::claims::solve::{
    Double, Field, Report, SolveError, Value, anisotropic, constant, periodic, rest, sinusoidal,
    sphere, turntable,
};
use crate::numerics::error::plain as number;
use clap::{ArgMatches, Args, FromArgMatches, Subcommand};
use std::fmt::Write;
use std::path::PathBuf;
use trialbook::cli::{Shard, complain, csv, json, say, show};
use trialbook::edition::{Failure, Format};

/// A calculator.
#[derive(Args)]
pub(super) struct Solve {
    #[command(subcommand)]
    problem: Problem,
}

// What is asked behind the name of any problem. As a doc comment it would be the help of each.
#[derive(Args)]
struct Also {
    /// Plot too: into a file of the name FILE.svg, as text if no file is named; `-` writes the SVG alone
    #[arg(long, value_name = "FILE", num_args = 0..=1, value_parser = plot::place)]
    #[allow(clippy::option_option)]
    plot: Option<Option<PathBuf>>,
    /// Only the K-th of N equal parts of the grid; the N parts, put together in order, are the whole, byte for byte
    #[arg(long, value_name = "K/N")]
    shard: Option<Shard>,
}

/// The command `solve` with its problems.
pub(super) fn command() -> clap::Command {
    Solve::augment_args(clap::Command::new("solve")).mut_subcommands(Also::augment_args)
}

/// Answers, and plots if that is wanted.
pub(super) fn run(matches: &ArgMatches, format: Format) -> Result<u8, Failure> {
    let (_, problem) = matches.subcommand().ok_or("no problem is named")?;
    let also = Also::from_arg_matches(problem)?;
    Solve::from_arg_matches(matches)?.run(&also, format)
}

#[derive(Subcommand)]
enum Problem {
    /// A particle launched on a plane of constant acceleration
    #[command(after_help = "Examples:
  slipbook solve constant --lambda 0.5 --v0 1 --theta0 1 --time 2
  slipbook solve constant --mu 0.3 --accel 2 --v0 1 --theta0 120deg --time 0:2:21 --csv
  slipbook solve constant --lambda 1.5 --v0 1 --theta0 2 --theta 0.3 --json")]
    Constant(Box<Constant>),
    /// The large-time motion under a sinusoidal drive
    #[command(after_help = "Examples:
  slipbook solve sinusoidal --lambda0 0.7 --plot
  slipbook solve sinusoidal --mu 0.3 --a0 5 --json")]
    Sinusoidal(Friction),
    /// The large-time motion under a train of pulses
    #[command(after_help = "Example:\n  slipbook solve pulse --eta 0.5 --lambda0 0.3")]
    Pulse {
        /// η, the share of a half period that a pulse fills, from 0 to 1
        #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
        eta: Axis,
        #[command(flatten)]
        friction: Friction,
    },
    /// The large-time motion with a friction that depends on the direction
    #[command(after_help = "Example:\n  slipbook solve anisotropic --q 2 --lambda0 0.45")]
    Anisotropic {
        /// q, backward friction over forward friction
        #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
        q: Axis,
        #[command(flatten)]
        friction: Friction,
    },
    /// A sphere that starts without spin on a plane of constant acceleration
    #[command(
        after_help = "Example:\n  slipbook solve sphere --gamma 2 --u0 1 --theta0 1 --time 0.3"
    )]
    Sphere(Box<Sphere>),
    /// A particle on a turntable: rest or escape, or its state at a time
    #[command(after_help = "Examples:
  slipbook solve turntable --rho 0.5 --p 0.3 --psi 1
  slipbook solve turntable --A 0.8 --alpha 0.1 --psi 0.2 --plot path.svg
  slipbook solve turntable --x 0.5 --y 0 --vx 0.1 --vy -0.2 --time 0.4
  slipbook solve turntable --mu 0.4 --omega 3.5 --r 0.1 --speed 0.05 --psi 30deg")]
    Turntable(Box<Turntable>),
    /// Where rest and escape meet on a turntable
    #[command(after_help = "Example:\n  slipbook solve turntable-boundary --alpha 0.5 --psi 1")]
    TurntableBoundary {
        /// α, with p = A sinh α and ρ = A cosh α
        #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
        alpha: Axis,
        /// ψ, the angle from the velocity to the position (radians; `120deg` are degrees)
        #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
        psi: Axis,
    },
}

/// The acceleration of gravity where nobody says another, in m/s².
const GRAVITY: &str = "9.80665";

/// The friction on a unit of mass in SI units, in place of a ratio.
#[derive(Args)]
struct Weight {
    /// The coefficient of friction μ instead, all in SI units
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    mu: Option<Axis>,
    /// The acceleration of gravity g in m/s², beside --mu
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true, default_value = GRAVITY)]
    g: Axis,
}

impl Weight {
    /// μg, where μ is given.
    fn on(&self, point: &mut Point) -> Option<Double> {
        let mu = self.mu?;
        let g = point.on("g", &self.g);
        Some(point.on("mu", &mu) * g)
    }
}

/// Friction over the drive's amplitude: as it is, or by both in SI units.
#[derive(Args)]
#[command(mut_arg("mu", |mu| mu.requires("a0")), mut_arg("g", |g| g.conflicts_with("lambda0")))]
struct Friction {
    /// λ₀ = μg/A₀, friction over the drive's amplitude; with anisotropic friction, the forward one
    #[arg(
        long,
        value_name = "RANGE",
        allow_hyphen_values = true,
        required_unless_present = "mu",
        conflicts_with = "mu"
    )]
    lambda0: Option<Axis>,
    #[command(flatten)]
    weight: Weight,
    /// The drive's amplitude A₀ in m/s²
    #[arg(
        long,
        value_name = "RANGE",
        allow_hyphen_values = true,
        requires = "mu",
        conflicts_with = "lambda0"
    )]
    a0: Option<Axis>,
}

impl Friction {
    fn on(&self, point: &mut Point) -> Double {
        match &self.a0 {
            Some(a0) => {
                let a0 = point.on("a0", a0);
                self.weight.on(point).unwrap_or_default() / a0
            }
            None => point.on("lambda0", &self.lambda0.unwrap_or_default()),
        }
    }
}

#[derive(Args)]
#[command(mut_arg("mu", |mu| mu.requires("accel")), mut_arg("g", |g| g.conflicts_with("lambda")))]
struct Constant {
    /// λ = μg/A, friction over acceleration
    #[arg(
        long,
        value_name = "RANGE",
        allow_hyphen_values = true,
        required_unless_present = "mu",
        conflicts_with = "mu"
    )]
    lambda: Option<Axis>,
    #[command(flatten)]
    weight: Weight,
    /// Initial speed
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    v0: Axis,
    /// Initial angle of the velocity with the x axis, in (−π, π]; `120deg` are degrees
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    theta0: Axis,
    /// The plane's acceleration A [default: 1]
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    accel: Option<Axis>,
    #[command(flatten)]
    moment: Moment,
}

#[derive(Args)]
#[command(mut_arg("mu", |mu| mu.requires("accel")), mut_arg("g", |g| g.conflicts_with("gamma")))]
struct Sphere {
    /// γ = A/(μg)
    #[arg(
        long,
        value_name = "RANGE",
        allow_hyphen_values = true,
        required_unless_present = "mu",
        conflicts_with = "mu"
    )]
    gamma: Option<Axis>,
    #[command(flatten)]
    weight: Weight,
    /// The plane's acceleration A in m/s², beside --mu
    #[arg(
        long,
        value_name = "RANGE",
        allow_hyphen_values = true,
        requires = "mu",
        conflicts_with = "gamma"
    )]
    accel: Option<Axis>,
    /// Initial slip
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    u0: Axis,
    /// Initial angle of the slip with the x axis, in (−π, π]; `120deg` are degrees
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    theta0: Axis,
    /// κ = I/(mR²): 0.4 for a solid sphere
    #[arg(
        long,
        value_name = "RANGE",
        allow_hyphen_values = true,
        default_value = "0.4"
    )]
    kappa: Axis,
    #[command(flatten)]
    moment: Moment,
}

/// The moment that is asked for.
#[derive(Args)]
#[group(required = true, multiple = false)]
struct Moment {
    /// When the angle has fallen to this (radians)
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    theta: Option<Axis>,
    /// At this time
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    time: Option<Axis>,
}

impl Moment {
    fn at(&self, point: &mut Point) -> At<Double> {
        match (self.theta, self.time) {
            (Some(theta), _) => At::Theta(point.on("theta", &theta)),
            (None, time) => At::Time(point.on("time", &time.unwrap_or_default())),
        }
    }
}

#[derive(Args)]
struct Turntable {
    #[command(flatten)]
    start: Start,
    /// ψ, the angle from the velocity to the position, counterclockwise (radians; `120deg` are degrees)
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true, conflicts_with_all = ["x", "y", "vx", "vy"])]
    psi: Option<Axis>,
    /// Speed p of a start by --rho
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true, requires = "rho", conflicts_with_all = ["A", "x", "r"])]
    p: Option<Axis>,
    /// α of a start by --A
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true, requires = "A", conflicts_with_all = ["rho", "x", "r"])]
    alpha: Option<Axis>,
    /// Position y of a start by --x
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true, requires = "x", conflicts_with_all = ["rho", "A", "r"])]
    y: Option<Axis>,
    /// Velocity along x, relative to the table
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true, requires = "x", conflicts_with_all = ["rho", "A", "r"])]
    vx: Option<Axis>,
    /// Velocity along y, relative to the table
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true, requires = "x", conflicts_with_all = ["rho", "A", "r"])]
    vy: Option<Axis>,
    /// Speed relative to the table in m/s, of a start by --r
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true, requires = "r", conflicts_with_all = ["rho", "A", "x"])]
    speed: Option<Axis>,
    /// The coefficient of friction μ, of a start by --r
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true, requires = "r", conflicts_with_all = ["rho", "A", "x"])]
    mu: Option<Axis>,
    /// The table's angular velocity Ω in 1/s, of a start by --r
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true, requires = "r", conflicts_with_all = ["rho", "A", "x"])]
    omega: Option<Axis>,
    /// The acceleration of gravity g in m/s², of a start by --r
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true, default_value = GRAVITY, conflicts_with_all = ["rho", "A", "x"])]
    g: Axis,
    /// Ask for the state at this time, in units of 1/Ω
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    time: Option<Axis>,
}

/// The first coordinate of a start says how it is given.
#[derive(Args)]
#[group(required = true, multiple = false)]
struct Start {
    /// Distance ρ from the axis, with --p and --psi
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true, requires_all = ["p", "psi"])]
    rho: Option<Axis>,
    /// A, with --alpha and --psi
    #[arg(id = "A", long = "A", value_name = "RANGE", allow_hyphen_values = true, requires_all = ["alpha", "psi"])]
    a: Option<Axis>,
    /// Position x in the table's axes, with --y, --vx and --vy
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true, requires_all = ["y", "vx", "vy"])]
    x: Option<Axis>,
    /// Distance from the axis in m, with --speed, --psi, --mu and --omega; the answer is in units of μg/Ω², μg/Ω and 1/Ω
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true, requires_all = ["speed", "psi", "mu", "omega"])]
    r: Option<Axis>,
}

impl Turntable {
    fn problem(&self, point: &mut Point) -> turntable::TurntableProblem<Double> {
        // The options require one another: none is missing here.
        let mut on = |name, axis: Option<Axis>| point.on(name, &axis.unwrap_or_default());
        match self.start {
            Start { rho: Some(rho), .. } => {
                let (psi, p) = (on("psi", self.psi), on("p", self.p));
                let rho = on("rho", Some(rho));
                turntable::TurntableProblem::Polar { rho, p, psi }
            }
            Start { a: Some(a), .. } => {
                let (psi, alpha) = (on("psi", self.psi), on("alpha", self.alpha));
                let a = on("A", Some(a));
                turntable::TurntableProblem::Hyperbolic { a, alpha, psi }
            }
            Start { r: Some(r), .. } => {
                let (psi, speed) = (on("psi", self.psi), on("speed", self.speed));
                let (r, g) = (on("r", Some(r)), on("g", Some(self.g)));
                let (omega, mu) = (on("omega", self.omega), on("mu", self.mu));
                let unit = mu * g / omega;
                let (rho, p) = (r * omega / unit, speed / unit);
                turntable::TurntableProblem::Polar { rho, p, psi }
            }
            Start { x, .. } => {
                let velocity = [on("vy", self.vy), on("vx", self.vx)];
                let position = [on("y", self.y), on("x", x)];
                turntable::TurntableProblem::Cartesian {
                    position: [position[1], position[0]],
                    velocity: [velocity[1], velocity[0]],
                }
            }
        }
    }
}

impl Constant {
    fn problem(&self, point: &mut Point) -> constant::ConstantProblem<Double> {
        let at = self.moment.at(point);
        let accel = self.accel.unwrap_or_else(|| Axis::from(Double::from(1.0)));
        let accel = point.on("accel", &accel);
        let theta0 = point.on("theta0", &self.theta0);
        let v0 = point.on("v0", &self.v0);
        let lambda = match self.weight.on(point) {
            Some(weight) => weight / accel,
            None => point.on("lambda", &self.lambda.unwrap_or_default()),
        };
        constant::ConstantProblem {
            lambda,
            v0,
            theta0,
            accel,
            at,
        }
    }
}

impl Sphere {
    fn problem(&self, point: &mut Point) -> sphere::SphereProblem<Double> {
        let at = self.moment.at(point);
        let kappa = point.on("kappa", &self.kappa);
        let theta0 = point.on("theta0", &self.theta0);
        let u0 = point.on("u0", &self.u0);
        let gamma = match &self.accel {
            Some(accel) => {
                let accel = point.on("accel", accel);
                accel / self.weight.on(point).unwrap_or_default()
            }
            None => point.on("gamma", &self.gamma.unwrap_or_default()),
        };
        sphere::SphereProblem {
            gamma,
            u0,
            theta0,
            kappa,
            at,
        }
    }
}

impl Problem {
    /// What is asked at a point of the grid; the last option runs fastest.
    fn question(&self, point: &mut Point) -> Question {
        match self {
            Problem::Constant(given) => Question::Constant(given.problem(point)),
            Problem::Sinusoidal(friction) => {
                let lambda0 = friction.on(point);
                Question::Sinusoidal(sinusoidal::SinusoidalProblem { lambda0 })
            }
            Problem::Pulse { eta, friction } => {
                let lambda0 = friction.on(point);
                let eta = point.on("eta", eta);
                Question::Pulse(periodic::PeriodicProblem { eta, lambda0 })
            }
            Problem::Anisotropic { q, friction } => {
                let lambda0 = friction.on(point);
                let q = point.on("q", q);
                Question::Anisotropic(anisotropic::AnisotropicProblem { q, lambda0 })
            }
            Problem::Sphere(given) => Question::Sphere(given.problem(point)),
            Problem::Turntable(given) => match given.time {
                Some(time) => {
                    let time = point.on("time", &time);
                    Question::Moment(given.problem(point), time)
                }
                None => Question::Fate(given.problem(point)),
            },
            Problem::TurntableBoundary { alpha, psi } => {
                let psi = point.on("psi", psi);
                let alpha = point.on("alpha", alpha);
                Question::Boundary(rest::BoundaryProblem { alpha, psi })
            }
        }
    }

    /// What was given in SI units and stands in an error as a ratio.
    fn converted(&self) -> &'static [&'static str] {
        let of = |mu: Option<Axis>, names: &'static [&'static str]| match mu {
            Some(_) => names,
            None => &[],
        };
        match self {
            Problem::Constant(given) => of(given.weight.mu, &["lambda"]),
            Problem::Sinusoidal(friction)
            | Problem::Pulse { friction, .. }
            | Problem::Anisotropic { friction, .. } => {
                of(friction.weight.mu, &["lambda0", "q lambda0"])
            }
            Problem::Sphere(given) => of(given.weight.mu, &["gamma"]),
            Problem::Turntable(given) => of(given.mu, &["rho", "p"]),
            Problem::TurntableBoundary { .. } => &[],
        }
    }

    /// An error, with what it has to do with what was given: an angle out of range was most likely meant in degrees.
    fn explained(&self, error: SolveError) -> Failure {
        match error {
            SolveError::Parameter { name, value, .. }
                if name.starts_with("theta") && value.abs() > std::f64::consts::PI =>
            {
                let degrees = number(value);
                format!("{error}; it is in radians, {degrees}deg would be degrees").into()
            }
            SolveError::Parameter { name, .. }
            | SolveError::Motion(MotionError::Argument { name, .. })
                if self.converted().contains(&name) =>
            {
                format!("{error}; that is what the SI units given come to").into()
            }
            other => other.into(),
        }
    }

    /// The angles that may be of any size.
    fn angle(&self) -> Option<&Axis> {
        match self {
            Problem::Turntable(given) => given.psi.as_ref(),
            Problem::TurntableBoundary { psi, .. } => Some(psi),
            _ => None,
        }
    }
}

impl Solve {
    fn run(&self, also: &Also, format: Format) -> Result<u8, Failure> {
        let mut point = Point::new(0);
        let question = self.problem.question(&mut point);
        let total = point.total.ok_or("more than 2⁶⁴ points together")?;
        let warning = self
            .problem
            .angle()
            .and_then(|psi| is_it_degrees("psi", psi));
        if let Some(warning) = warning {
            complain("slipbook", &warning);
        }
        if total > 1 || also.shard.is_some() {
            if also.plot.is_some() {
                return Err("--plot: it draws one answer, and here are several".into());
            }
            let ask = |point: &mut Point| self.problem.question(point);
            return sweep::run(&ask, total, also.shard, format);
        }
        let report = question
            .report()
            .map_err(|error| self.problem.explained(error))?;
        let drawn = match &also.plot {
            None => None,
            Some(Some(file)) => {
                let svg = plot::svg(&question.curve()?)?;
                if file.as_os_str() == plot::STDOUT {
                    say(&svg)?;
                    return Ok(0);
                }
                plot::to_file(&svg, file)?;
                None
            }
            Some(None) if format == Format::Text => Some(plot::as_text(&question.curve()?)),
            Some(None) => return Err("--plot: beside JSON or CSV, name an SVG file".into()),
        };
        match format {
            Format::Text => show(&(text(&report) + "\n" + &drawn.unwrap_or_default()))?,
            Format::Json => json(&report)?,
            Format::Csv => table(&report)?,
        }
        Ok(0)
    }
}

pub(super) fn word(value: Value) -> String {
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
    let names = ["", "digits", "note"].into_iter();
    let names: Vec<_> = names
        .chain(report.fields.iter().map(|field| field.name))
        .collect();
    let first = names.iter().map(|name| name.len()).max().unwrap_or(0);
    let mut lines = vec![format!("{:<first$}", "")];
    let fields = report.fields.iter();
    lines.extend(fields.map(|field| format!("{:<first$}", field.name)));
    for (head, fields) in ways(report) {
        let words: Vec<_> = std::iter::once(head.to_owned())
            .chain(fields.iter().map(|field| word(field.value)))
            .collect();
        let width = words
            .iter()
            .map(|word| word.chars().count())
            .max()
            .unwrap_or(0);
        for (line, word) in lines.iter_mut().zip(words) {
            let _ = write!(line, "  {word:<width$}");
        }
    }
    if let Some(digits) = report.digits {
        lines.push(format!("{:<first$}  {digits}", "digits"));
    }
    lines.push(format!("{:<first$}  {}", "note", report.note));
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_si_units_an_error_says_what_they_come_to() {
        for (line, told) in [
            (
                "constant --mu 0.3 --accel 1e-20 --v0 1 --theta0 1 --time 1",
                true,
            ),
            ("constant --lambda 3e20 --v0 1 --theta0 1 --time 1", false),
            (
                "constant --mu 0.3 --v0 1e30 --accel 1 --theta0 1 --time 1",
                false,
            ),
            ("sinusoidal --mu 0.3 --a0 1e9", true),
            ("sinusoidal --lambda0 1e-9", false),
            ("pulse --eta 0.5 --mu 0.3 --a0 1e9", true),
            ("pulse --eta 1.5 --mu 0.3 --a0 1", false),
            ("anisotropic --q 2 --mu 0.3 --a0 1e9", true),
            ("anisotropic --q 1000 --mu 0.3 --a0 1e-4", true),
            ("anisotropic --q 1000 --lambda0 1e5", false),
            (
                "sphere --mu 0.3 --accel 1e12 --u0 1 --theta0 1 --time 1",
                true,
            ),
            ("sphere --gamma 1e12 --u0 1 --theta0 1 --time 1", false),
            (
                "turntable --mu 0.3 --omega 1 --r 1e12 --speed 1 --psi 1",
                true,
            ),
            (
                "turntable --mu 0.3 --omega 1 --r 1 --speed 1e12 --psi 1",
                true,
            ),
            ("turntable --rho 1e12 --p 1 --psi 1", false),
        ] {
            let asked = command().no_binary_name(true);
            let matches = asked.try_get_matches_from(line.split(' ')).unwrap();
            let problem = Solve::from_arg_matches(&matches).unwrap().problem;
            let error = problem.question(&mut Point::new(0)).report().unwrap_err();
            let said = problem.explained(error).to_string();
            let units = "; that is what the SI units given come to";
            assert_eq!(said.ends_with(units), told, "{line}: {said}");
        }
    }

    #[test]
    fn of_every_angle_of_any_size_it_is_asked_whether_it_is_in_degrees() {
        for (line, angle) in [
            ("turntable --rho 0.5 --p 1 --psi 120", Some(120.0)),
            ("turntable --A 0.5 --alpha 1 --psi 90", Some(90.0)),
            ("turntable --x 0.5 --y 1 --vx 0 --vy 1", None),
            ("turntable-boundary --alpha 0.5 --psi 45", Some(45.0)),
            ("sinusoidal --lambda0 0.5", None),
        ] {
            let asked = command().no_binary_name(true);
            let matches = asked.try_get_matches_from(line.split(' ')).unwrap();
            let problem = Solve::from_arg_matches(&matches).unwrap().problem;
            let warned = problem
                .angle()
                .map(|axis| is_it_degrees("psi", axis).unwrap());
            let expected = angle.map(|x| format!("psi = {x} is in radians"));
            match (&warned, &expected) {
                (Some(warned), Some(expected)) => {
                    assert!(warned.starts_with(expected), "{line}: {warned}")
                }
                _ => assert_eq!(warned, expected, "{line}"),
            }
        }
    }

    /// Each number that is given takes its own place in what is asked.
    #[test]
    fn a_line_asks_what_it_says() {
        let cartesian = || turntable::TurntableProblem::Cartesian {
            position: [0.5, -0.25].map(Double::from),
            velocity: [0.125, -0.375].map(Double::from),
        };
        let launch = |at| {
            Question::Constant(constant::ConstantProblem {
                lambda: 0.5.into(),
                v0: 1.25.into(),
                theta0: 1.0.into(),
                accel: 0.75.into(),
                at,
            })
        };
        let rolling = |at| {
            Question::Sphere(sphere::SphereProblem {
                gamma: 2.0.into(),
                u0: 1.5.into(),
                theta0: 1.0.into(),
                kappa: 0.625.into(),
                at,
            })
        };
        for (line, asked) in [
            (
                "constant --lambda 0.5 --v0 1.25 --theta0 1 --accel 0.75 --time 2",
                launch(At::Time(2.0.into())),
            ),
            (
                "constant --lambda 0.5 --v0 1.25 --theta0 1 --accel 0.75 --theta 0.25",
                launch(At::Theta(0.25.into())),
            ),
            (
                "sinusoidal --lambda0 0.375",
                Question::Sinusoidal(sinusoidal::SinusoidalProblem {
                    lambda0: 0.375.into(),
                }),
            ),
            (
                "pulse --eta 0.5 --lambda0 0.25",
                Question::Pulse(periodic::PeriodicProblem {
                    eta: 0.5.into(),
                    lambda0: 0.25.into(),
                }),
            ),
            (
                "anisotropic --q 2 --lambda0 0.375",
                Question::Anisotropic(anisotropic::AnisotropicProblem {
                    q: 2.0.into(),
                    lambda0: 0.375.into(),
                }),
            ),
            (
                "sphere --gamma 2 --u0 1.5 --theta0 1 --kappa 0.625 --time 0.25",
                rolling(At::Time(0.25.into())),
            ),
            (
                "sphere --gamma 2 --u0 1.5 --theta0 1 --kappa 0.625 --theta 0.75",
                rolling(At::Theta(0.75.into())),
            ),
            (
                "turntable --rho 0.5 --p 0.25 --psi 1",
                Question::Fate(turntable::TurntableProblem::Polar {
                    rho: 0.5.into(),
                    p: 0.25.into(),
                    psi: 1.0.into(),
                }),
            ),
            (
                "turntable --A 0.75 --alpha 0.125 --psi 0.25 --time 0.0625",
                Question::Moment(
                    turntable::TurntableProblem::Hyperbolic {
                        a: 0.75.into(),
                        alpha: 0.125.into(),
                        psi: 0.25.into(),
                    },
                    0.0625.into(),
                ),
            ),
            (
                "turntable --x 0.5 --y -0.25 --vx 0.125 --vy -0.375",
                Question::Fate(cartesian()),
            ),
            (
                "turntable --x 0.5 --y -0.25 --vx 0.125 --vy -0.375 --time 0.25",
                Question::Moment(cartesian(), 0.25.into()),
            ),
            (
                "turntable-boundary --alpha 0.5 --psi 1",
                Question::Boundary(rest::BoundaryProblem {
                    alpha: 0.5.into(),
                    psi: 1.0.into(),
                }),
            ),
        ] {
            let command = command().no_binary_name(true);
            let matches = command.try_get_matches_from(line.split(' ')).unwrap();
            let problem = Solve::from_arg_matches(&matches).unwrap().problem;
            let question = problem.question(&mut Point::new(0));
            assert_eq!(question.name(), asked.name(), "{line}");
            assert_eq!(
                question.report().unwrap(),
                asked.report().unwrap(),
                "{line}"
            );
        }
    }
}
