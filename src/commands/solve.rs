//! The command `solve`: the calculators of [`crate::solve`].

use super::{
    axis::{Axis, Plain, Point, is_it_degrees},
    pieces::Stop,
    plot,
    question::{Asked, Question},
    sweep::{self, aligned},
};
use crate::numerics::error::plain as number;
use crate::solve::{
    DIMENSIONLESS, Double, Field, RADIANS, Report, SolveError, Unit, Value, anisotropic, axes,
    constant, constant::At, periodic, rest, sinusoidal, sphere, turntable, turntable::MotionError,
};
use clap::{Arg, ArgMatches, Args, FromArgMatches, Subcommand};
use std::fmt::Write;
use std::path::PathBuf;
use trialbook::cli::{Shard, complain, json, say, screen, show};
use trialbook::publishing::{Failure, Format};

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
    let range = |arg: Arg| {
        let arg = arg.value_name("RANGE").value_parser(Plain);
        arg.allow_hyphen_values(true)
    };
    Solve::augment_args(clap::Command::new("solve")).mut_subcommands(|problem| {
        let axes = match problem.get_name() {
            "constant" | "sphere" => axes::LINE,
            "turntable" | "turntable-boundary" => axes::TABLE,
            _ => axes::DRIVE,
        };
        directed(Also::augment_args(problem.mut_args(range)), axes)
    })
}

/// A command whose help says which way the axes point.
pub(super) fn directed(command: clap::Command, axes: &str) -> clap::Command {
    let about = command.get_about().map(ToString::to_string);
    let axes = axes.replace("```text\n", "").replace("```\n", "");
    command.long_about(about.unwrap_or_default() + "\n\n" + &axes)
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
  slipbook solve sinusoidal --mu 0.3 --a0 5 --omega 2*pi --json")]
    Sinusoidal(FrictionArgs),
    /// The large-time motion under a train of pulses
    #[command(after_help = "Example:\n  slipbook solve pulse --eta 0.5 --lambda0 0.3")]
    Pulse {
        /// η, the share of a half period that a pulse fills, from 0 to 1
        #[arg(long)]
        eta: Axis,
        #[command(flatten)]
        friction: FrictionArgs,
    },
    /// The large-time motion with a friction that depends on the direction
    #[command(after_help = "Example:\n  slipbook solve anisotropic --q 2 --lambda0 0.45")]
    Anisotropic {
        /// q = μ₋/μ₊, backward friction over forward friction; forward is along +x
        #[arg(long)]
        q: Axis,
        #[command(flatten)]
        friction: FrictionArgs,
    },
    /// A sphere that starts without spin on a plane of constant acceleration
    #[command(after_help = "Examples:
  slipbook solve sphere --gamma 2 --u0 1 --theta0 1 --time 0.3
  slipbook solve sphere --mu 0.08 --accel 0.1 --u0 5 --theta0 0 --time 1.5")]
    Sphere(Box<Sphere>),
    /// A particle on a turntable: rest or escape, or its state at a time
    #[command(after_help = "Examples:
  slipbook solve turntable --rho 0.5 --p 0.3 --psi 1
  slipbook solve turntable --A 0.8 --alpha 0.1 --psi 0.2 --plot path.svg
  slipbook solve turntable --x 0.5 --y 0 --vx 0.1 --vy -0.2 --time 0.4
  slipbook solve turntable --mu 0.4 --omega 3.5 --r 0.1 --speed 0.05 --psi 30deg --time 0.01")]
    Turntable(Box<Turntable>),
    /// Where rest and escape meet on a turntable
    #[command(after_help = "Example:\n  slipbook solve turntable-boundary --alpha 0.5 --psi 1")]
    TurntableBoundary {
        /// α, with p = A sinh α and ρ = A cosh α
        #[arg(long)]
        alpha: Axis,
        /// ψ, the angle from the velocity to the position, counterclockwise as the table turns (radians; `120deg` are degrees)
        #[arg(long)]
        psi: Axis,
    },
}

/// The unit of an acceleration that is given beside λ.
const ACCELERATION: &str = "that of A";

/// The acceleration of gravity where nobody says another, in m/s².
const GRAVITY: &str = "9.80665";

/// The friction on a unit of mass in SI units, in place of a ratio.
#[derive(Args)]
struct Weight {
    /// The coefficient of friction μ instead: everything is in SI units then, what is given and what is answered
    #[arg(long)]
    mu: Option<Axis>,
    /// The acceleration of gravity g in m/s², beside --mu
    #[arg(long, default_value = GRAVITY)]
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
#[command(mut_arg("mu", |mu| mu.requires_all(["a0", "omega"])), mut_arg("g", |g| g.conflicts_with("lambda0")))]
struct FrictionArgs {
    /// λ₀ = μg/A₀, friction over the drive's amplitude; with anisotropic friction, the forward one
    #[arg(long, required_unless_present = "mu", conflicts_with = "mu")]
    lambda0: Option<Axis>,
    #[command(flatten)]
    weight: Weight,
    /// The drive's amplitude A₀ in m/s²
    #[arg(long, requires = "mu", conflicts_with = "lambda0")]
    a0: Option<Axis>,
    /// The drive's angular frequency ω in 1/s
    #[arg(long, requires = "mu", conflicts_with = "lambda0")]
    omega: Option<Axis>,
}

impl FrictionArgs {
    fn on(&self, point: &mut Point) -> (Double, Vec<Unit>) {
        let (Some(a0), Some(omega)) = (&self.a0, &self.omega) else {
            let lambda0 = point.on("lambda0", &self.lambda0.unwrap_or_default());
            return (lambda0, Vec::new());
        };
        let (omega, a0) = (point.size("omega", omega), point.size("a0", a0));
        let lambda0 = self.weight.on(point).unwrap_or_default() / a0;
        let speed = a0 / omega;
        let units = vec![
            Unit::new(sinusoidal::VELOCITY, speed, "m/s"),
            Unit::new(anisotropic::DISPLACEMENT, speed / omega, "m"),
        ];
        (lambda0, units)
    }
}

#[derive(Args)]
#[command(mut_arg("mu", |mu| mu.requires("accel")), mut_arg("g", |g| g.conflicts_with("lambda")))]
struct Constant {
    /// λ = μg/A, friction over acceleration
    #[arg(long, required_unless_present = "mu", conflicts_with = "mu")]
    lambda: Option<Axis>,
    #[command(flatten)]
    weight: Weight,
    /// Initial speed, in m/s beside --mu
    #[arg(long)]
    v0: Axis,
    /// Initial angle of the velocity with the x axis, which points against the plane's acceleration; radians in (−π, π], `120deg` are degrees
    #[arg(long)]
    theta0: Axis,
    /// The plane's acceleration A, which points along −x; in m/s² beside --mu [default: 1]
    #[arg(long)]
    accel: Option<Axis>,
    #[command(flatten)]
    moment: Moment,
}

#[derive(Args)]
#[command(mut_arg("mu", |mu| mu.requires("accel")), mut_arg("g", |g| g.conflicts_with("gamma")))]
struct Sphere {
    /// γ = A/(μg)
    #[arg(long, required_unless_present = "mu", conflicts_with = "mu")]
    gamma: Option<Axis>,
    #[command(flatten)]
    weight: Weight,
    /// The plane's acceleration A in m/s², which points along −x, beside --mu
    #[arg(long, requires = "mu", conflicts_with = "gamma")]
    accel: Option<Axis>,
    /// Initial slip, in √(μgR), or in m/s beside --mu
    #[arg(long)]
    u0: Axis,
    /// Initial angle of the slip with the x axis, which points against the plane's acceleration; radians in (−π, π], `120deg` are degrees
    #[arg(long)]
    theta0: Axis,
    /// The sphere's radius R in m, beside --mu: the spin is answered in 1/s then, else the speed ωR that it gives the rim
    #[arg(long, requires = "mu", conflicts_with = "gamma")]
    radius: Option<Axis>,
    /// κ = I/(mR²): 0.4 for a solid sphere
    #[arg(long, default_value = "0.4")]
    kappa: Axis,
    #[command(flatten)]
    moment: Moment,
}

/// The moment that is asked for: if none is named, that of the stop.
#[derive(Args)]
#[group(multiple = false)]
struct Moment {
    /// When the angle has fallen to this (radians) [default: when it stops for good; of a sphere, when it rolls]
    #[arg(long)]
    theta: Option<Axis>,
    /// At this time instead: in s beside --mu, else as v/A counts it, or for a sphere in √(R/(μg))
    #[arg(long)]
    time: Option<Axis>,
}

impl Moment {
    fn at(&self, point: &mut Point) -> At<Double> {
        match (self.theta, self.time) {
            (Some(theta), _) => At::Theta(point.on("theta", &theta)),
            (None, Some(time)) => At::Time(point.on("time", &time)),
            (None, None) => At::Stop,
        }
    }
}

#[derive(Args)]
struct Turntable {
    #[command(flatten)]
    start: Start,
    /// ψ, the angle from the velocity to the position, counterclockwise as the table turns (radians; `120deg` are degrees)
    #[arg(long, conflicts_with_all = ["x", "y", "vx", "vy"])]
    psi: Option<Axis>,
    /// Speed p of a start by --rho, in units of μg/Ω
    #[arg(long, requires = "rho", conflicts_with_all = ["A", "x", "r"])]
    p: Option<Axis>,
    /// α of a start by --A
    #[arg(long, requires = "A", conflicts_with_all = ["rho", "x", "r"])]
    alpha: Option<Axis>,
    /// Position y of a start by --x, in units of μg/Ω²
    #[arg(long, requires = "x", conflicts_with_all = ["rho", "A", "r"])]
    y: Option<Axis>,
    /// Velocity along x, relative to the table, in units of μg/Ω
    #[arg(long, requires = "x", conflicts_with_all = ["rho", "A", "r"])]
    vx: Option<Axis>,
    /// Velocity along y, relative to the table, in units of μg/Ω
    #[arg(long, requires = "x", conflicts_with_all = ["rho", "A", "r"])]
    vy: Option<Axis>,
    /// Speed relative to the table in m/s, of a start by --r
    #[arg(long, requires = "r", conflicts_with_all = ["rho", "A", "x"])]
    speed: Option<Axis>,
    /// The coefficient of friction μ, of a start by --r
    #[arg(long, requires = "r", conflicts_with_all = ["rho", "A", "x"])]
    mu: Option<Axis>,
    /// The table's angular velocity Ω in 1/s, counterclockwise, of a start by --r
    #[arg(long, requires = "r", conflicts_with_all = ["rho", "A", "x"])]
    omega: Option<Axis>,
    /// The acceleration of gravity g in m/s², of a start by --r
    #[arg(long, default_value = GRAVITY, conflicts_with_all = ["rho", "A", "x"])]
    g: Axis,
    /// Ask for the state at this time: in s for a start by --r, else in units of 1/Ω
    #[arg(long)]
    time: Option<Axis>,
}

/// The first coordinate of a start says how it is given.
#[derive(Args)]
#[group(required = true, multiple = false)]
struct Start {
    /// Distance ρ from the axis in units of μg/Ω², with --p and --psi
    #[arg(long, requires_all = ["p", "psi"])]
    rho: Option<Axis>,
    /// A, with --alpha and --psi
    #[arg(id = "A", long = "A", requires_all = ["alpha", "psi"])]
    a: Option<Axis>,
    /// Position x in the table's axes in units of μg/Ω², with --y, --vx and --vy
    #[arg(long, requires_all = ["y", "vx", "vy"])]
    x: Option<Axis>,
    /// Distance from the axis in m, with --speed, --psi, --mu and --omega: everything is in SI units then, what is given and what is answered
    #[arg(long, requires_all = ["speed", "psi", "mu", "omega"])]
    r: Option<Axis>,
}

impl Turntable {
    fn asked(&self, point: &mut Point) -> (Asked, Vec<Unit>) {
        // The options require one another: none is missing here.
        let mut on = |name, axis: Option<Axis>| point.on(name, &axis.unwrap_or_default());
        let time = self.time.map(|time| on("time", Some(time)));
        let mut units = Vec::new();
        let mut tau = time;
        let start = match self.start {
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
                let r = on("r", Some(r));
                let mut size =
                    |name, axis: Option<Axis>| point.size(name, &axis.unwrap_or_default());
                let g = size("g", Some(self.g));
                let (omega, mu) = (size("omega", self.omega), size("mu", self.mu));
                let unit = mu * g / omega;
                units = vec![
                    Unit::new(turntable::LENGTH, unit / omega, "m"),
                    Unit::new(turntable::SPEED, unit, "m/s"),
                    Unit::new(turntable::TIME, Double::from(1.0) / omega, "s"),
                ];
                tau = time.map(|time| time * omega);
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
        };
        let asked = match tau {
            Some(tau) => Asked::Moment(start, tau),
            None => Asked::Fate(start),
        };
        (asked, units)
    }
}

impl Constant {
    fn asked(&self, point: &mut Point) -> (Asked, Vec<Unit>) {
        let at = self.moment.at(point);
        let one = Double::from(1.0);
        let accel = self.accel.unwrap_or_else(|| one.into());
        let accel = match self.weight.mu {
            Some(_) => point.size("accel", &accel),
            None => point.on("accel", &accel),
        };
        let theta0 = point.on("theta0", &self.theta0);
        let v0 = point.on("v0", &self.v0);
        let (lambda, units) = match self.weight.on(point) {
            Some(weight) => {
                let units = vec![
                    Unit::new(constant::SPEED, one, "m/s"),
                    Unit::new(constant::TIME, one, "s"),
                    Unit::new(constant::LENGTH, one, "m"),
                    Unit::new(ACCELERATION, one, "m/s²"),
                ];
                (weight / accel, units)
            }
            None => {
                let lambda = point.on("lambda", &self.lambda.unwrap_or_default());
                (lambda, Vec::new())
            }
        };
        let asked = constant::ConstantProblem {
            lambda,
            v0,
            theta0,
            accel,
            at,
        };
        (Asked::Constant(asked), units)
    }
}

impl Sphere {
    fn asked(&self, point: &mut Point) -> (Asked, Vec<Unit>) {
        let at = self.moment.at(point);
        let kappa = point.on("kappa", &self.kappa);
        let radius = self.radius.map(|radius| point.size("radius", &radius));
        let theta0 = point.on("theta0", &self.theta0);
        let mut u0 = point.on("u0", &self.u0);
        let (gamma, units) = match (&self.accel, &self.weight.mu) {
            (Some(accel), Some(mu)) => {
                let accel = point.size("accel", accel);
                let g = point.size("g", &self.weight.g);
                let weight = point.size("mu", mu) * g;
                // Slip and rolling do not depend on the radius: with R = μg · 1 s² the paper's unit of time is 1 s and that
                // of the slip is μg · 1 s, which is that of ωR as well.
                u0 = u0 / weight;
                let (spin, of_spin) = match radius {
                    Some(radius) => (weight / radius, "1/s"),
                    None => (weight, "m/s"),
                };
                let units = vec![
                    Unit::new(sphere::SLIP, weight, "m/s"),
                    Unit::new(sphere::TIME, 1.0.into(), "s"),
                    Unit::new(sphere::SPIN, spin, of_spin),
                ];
                (accel / weight, units)
            }
            _ => {
                let gamma = point.on("gamma", &self.gamma.unwrap_or_default());
                (gamma, Vec::new())
            }
        };
        let asked = sphere::SphereProblem {
            gamma,
            u0,
            theta0,
            kappa,
            at,
        };
        (Asked::Sphere(asked), units)
    }
}

impl Problem {
    /// What is asked at a point of the grid; the last option runs fastest.
    fn question(&self, point: &mut Point) -> Question {
        let (asked, units) = match self {
            Problem::Constant(given) => given.asked(point),
            Problem::Sinusoidal(friction) => {
                let (lambda0, units) = friction.on(point);
                let asked = sinusoidal::SinusoidalProblem { lambda0 };
                (Asked::Sinusoidal(asked), units)
            }
            Problem::Pulse { eta, friction } => {
                let (lambda0, units) = friction.on(point);
                let eta = point.on("eta", eta);
                let asked = periodic::PeriodicProblem { eta, lambda0 };
                (Asked::Pulse(asked), units)
            }
            Problem::Anisotropic { q, friction } => {
                let (lambda0, units) = friction.on(point);
                let q = point.on("q", q);
                let asked = anisotropic::AnisotropicProblem { q, lambda0 };
                (Asked::Anisotropic(asked), units)
            }
            Problem::Sphere(given) => given.asked(point),
            Problem::Turntable(given) => given.asked(point),
            Problem::TurntableBoundary { alpha, psi } => {
                let psi = point.on("psi", psi);
                let alpha = point.on("alpha", alpha);
                let asked = rest::BoundaryProblem { alpha, psi };
                (Asked::Boundary(asked), Vec::new())
            }
        };
        Question {
            asked,
            units,
            refused: point.refused.take(),
        }
    }

    /// The unit of a number that is given, in the paper's quantities where it is not in SI always.
    fn unit(&self, name: &str) -> &'static str {
        match (name, self) {
            ("theta" | "theta0" | "psi", _) => RADIANS,
            ("g" | "a0", _) => "m/s²",
            ("omega", _) => "1/s",
            ("r" | "radius", _) => "m",
            ("speed", _) => "m/s",
            ("v0", _) => constant::SPEED,
            ("u0", _) => sphere::SLIP,
            ("time", Problem::Constant(_)) => constant::TIME,
            ("time", Problem::Sphere(_)) => sphere::TIME,
            ("time", _) => turntable::TIME,
            ("accel", Problem::Sphere(_)) => "m/s²",
            ("accel", _) => ACCELERATION,
            ("rho" | "x" | "y", _) => turntable::LENGTH,
            ("p" | "vx" | "vy", _) => turntable::SPEED,
            _ => DIMENSIONLESS,
        }
    }

    /// Whether something given in SI units stands in an error by this name, as a ratio.
    fn is_converted(&self, name: &str) -> bool {
        let (mu, names) = match self {
            Problem::Constant(given) => (given.weight.mu, "lambda"),
            Problem::Sinusoidal(friction)
            | Problem::Pulse { friction, .. }
            | Problem::Anisotropic { friction, .. } => (friction.weight.mu, "lambda0, q lambda0"),
            Problem::Sphere(given) => (given.weight.mu, "gamma, u0"),
            Problem::Turntable(given) => (given.mu, "rho, p, time"),
            Problem::TurntableBoundary { .. } => (None, ""),
        };
        mu.is_some() && names.split(", ").any(|of| of == name)
    }

    /// An error, with what it has to do with what was given: an angle out of range was most likely meant in degrees.
    fn explained(&self, error: SolveError) -> Failure {
        if let SolveError::Parameter { name, value, .. } = error
            && let Some(hint) = self.instead(name, value)
        {
            return format!("{error}; {hint}").into();
        }
        match error {
            SolveError::Parameter { name, value, .. }
                if name.starts_with("theta") && value.abs() > std::f64::consts::PI =>
            {
                let degrees = number(value);
                format!("{error}; it is in radians, {degrees}deg would be degrees").into()
            }
            SolveError::Parameter { name, .. }
            | SolveError::Motion(MotionError::Argument { name, .. })
                if self.is_converted(name) =>
            {
                format!("{error}; that is what the SI units given come to").into()
            }
            other => other.into(),
        }
    }

    /// What to ask instead, where there is nothing of what is given or it is the other way round.
    fn instead(&self, name: &str, value: f64) -> Option<&'static str> {
        Some(match (self, name) {
            (Problem::Turntable(_), "omega") if value < 0.0 => {
                "a table that turns clockwise is the mirror image: turn the sign of psi"
            }
            (Problem::Constant(given), "lambda") if given.weight.mu.is_some() && value > 1.0 => {
                "for no pull --accel 1e-12 serves, to 12 digits"
            }
            _ if value != 0.0 => return None,
            (_, "accel" | "gamma") => "for none 1e-12 serves, to 12 digits",
            (_, "v0" | "u0") => "for none 1e-20 serves",
            (Problem::Turntable(_), "omega") => "a table at rest is `solve constant --accel 1e-12`",
            (Problem::Turntable(_), "mu") => {
                "without friction it goes straight on, seen from the room"
            }
            (Problem::Sphere(_), "mu") => {
                "without friction its centre goes as in `solve constant --mu 0`"
            }
            _ => return None,
        })
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
        if !point.swept.is_empty() || also.shard.is_some() {
            if also.plot.is_some() {
                return Err("--plot: it draws one answer, and here are several".into());
            }
            let ask = |point: &mut Point| self.problem.question(point);
            let unit = |name: &str| Unit::name(self.problem.unit(name), &question.units);
            let swept = sweep::run(&ask, &unit, total, also.shard, format);
            return swept.or_else(Stop::code);
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
            Format::Csv => say(&sweep::single(report)?)?,
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

fn text(report: &Report) -> String {
    let mut heads = vec!["", "value", "unit"];
    let mut ways = vec![];
    for (head, way) in [
        ("by formula", &report.by_formula),
        ("by motion", &report.by_motion),
    ] {
        if let Some(fields) = way {
            heads.push(head);
            ways.push(fields);
        }
    }
    heads.push("");
    let row = |(n, field): (usize, &Field)| {
        let own = [
            field.name.to_owned(),
            word(field.value),
            field.unit.to_owned(),
        ];
        let ways = ways.iter().map(|fields| word(fields[n].value));
        own.into_iter().chain(ways).chain([String::new()]).collect()
    };
    let rows: Vec<Vec<_>> = report.fields.iter().enumerate().map(row).collect();
    let mut text = aligned(&heads, 1, &rows, screen().width);
    // Nothing can fail in writing to a string.
    if let Some(digits) = report.digits {
        let _ = writeln!(text, "digits  {digits}");
    }
    let _ = write!(text, "note    {}", report.note);
    text
}
