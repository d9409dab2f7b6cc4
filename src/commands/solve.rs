//! The command `solve`: the calculators of [`crate::solve`].

use super::{
    axis::{Axis, Point, is_it_degrees},
    pieces::Stop,
    plot,
    question::{Asked, word},
    sweep::{self, aligned},
};
use crate::solve::{
    DIMENSIONLESS, Double, Field, RADIANS, Report, anisotropic, axes, constant, constant::At,
    periodic, rest, sinusoidal, sphere, turntable,
};
use clap::builder::UnknownArgumentValueParser;
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

/// What earlier versions were given in SI units.
const IN_SI: [&str; 7] = ["mu", "g", "a0", "omega", "radius", "r", "speed"];

/// The command `solve` with its problems.
pub(super) fn command() -> clap::Command {
    let range = |arg: Arg| arg.value_name("RANGE").allow_hyphen_values(true);
    Solve::augment_args(clap::Command::new("solve")).mut_subcommands(|problem| {
        let (axes, scene) = match problem.get_name() {
            "constant" => (
                axes::LINE,
                "block --mu 0.3 --pull 2m/s^2 --throw 1m/s@120deg",
            ),
            "sphere" => (axes::LINE, "ball --radius 11cm --mu 0.08 --throw 5m/s"),
            "turntable" | "turntable-boundary" => (
                axes::TABLE,
                "block --mu 0.4 --turn 33.3rpm --at 10cm --throw 5cm/s@-30deg --until rest",
            ),
            _ => (
                axes::DRIVE,
                "block --mu 0.3 --pull '5*sin(2*pi*t)' --until 10s",
            ),
        };
        let tip = format!("with units it is asked as a scene: `slipbook scene {scene}`");
        let tip = UnknownArgumentValueParser::suggest(tip);
        let in_si = IN_SI.map(|name| {
            range(Arg::new(name))
                .long(name)
                .hide(true)
                .value_parser(tip.clone())
        });
        directed(
            Also::augment_args(problem.mut_args(range)).args(in_si),
            axes,
        )
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
  slipbook solve constant --lambda 1.5 --v0 1 --theta0 120deg --time 0:2:21 --csv
  slipbook solve constant --lambda 1.5 --v0 1 --theta0 2 --theta 0.3 --json")]
    Constant(Box<Constant>),
    /// The large-time motion under a sinusoidal drive
    #[command(after_help = "Example:\n  slipbook solve sinusoidal --lambda0 0.7 --plot")]
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
    #[command(
        after_help = "Example:\n  slipbook solve sphere --gamma 2 --u0 1 --theta0 1 --time 0.3"
    )]
    Sphere(Box<Sphere>),
    /// A particle on a turntable: rest or escape, or its state at a time
    #[command(after_help = "Examples:
  slipbook solve turntable --rho 0.5 --p 0.3 --psi 1
  slipbook solve turntable --A 0.8 --alpha 0.1 --psi 0.2 --plot path.svg
  slipbook solve turntable --x 0.5 --y 0 --vx 0.1 --vy -0.2 --time 0.4")]
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

#[derive(Args)]
struct FrictionArgs {
    /// λ₀ = μg/A₀, friction over the drive's amplitude; with anisotropic friction, the forward one
    #[arg(long)]
    lambda0: Axis,
}

#[derive(Args)]
struct Constant {
    /// λ = μg/A, friction over acceleration
    #[arg(long)]
    lambda: Axis,
    /// Initial speed
    #[arg(long)]
    v0: Axis,
    /// Initial angle of the velocity with the x axis, which points against the plane's acceleration; radians in (−π, π], `120deg` are degrees
    #[arg(long)]
    theta0: Axis,
    /// The plane's acceleration A, which points along −x
    #[arg(long, default_value = "1")]
    accel: Axis,
    #[command(flatten)]
    moment: Moment,
}

#[derive(Args)]
struct Sphere {
    /// γ = A/(μg)
    #[arg(long)]
    gamma: Axis,
    /// Initial slip, in √(μgR)
    #[arg(long)]
    u0: Axis,
    /// Initial angle of the slip with the x axis, which points against the plane's acceleration; radians in (−π, π], `120deg` are degrees
    #[arg(long)]
    theta0: Axis,
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
    /// At this time instead, as v/A counts it, or for a sphere in √(R/(μg))
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
    #[arg(long, requires = "rho", conflicts_with_all = ["A", "x"])]
    p: Option<Axis>,
    /// α of a start by --A
    #[arg(long, requires = "A", conflicts_with_all = ["rho", "x"])]
    alpha: Option<Axis>,
    /// Position y of a start by --x, in units of μg/Ω²
    #[arg(long, requires = "x", conflicts_with_all = ["rho", "A"])]
    y: Option<Axis>,
    /// Velocity along x, relative to the table, in units of μg/Ω
    #[arg(long, requires = "x", conflicts_with_all = ["rho", "A"])]
    vx: Option<Axis>,
    /// Velocity along y, relative to the table, in units of μg/Ω
    #[arg(long, requires = "x", conflicts_with_all = ["rho", "A"])]
    vy: Option<Axis>,
    /// Ask for the state at this time, in units of 1/Ω
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
}

impl Turntable {
    fn asked(&self, point: &mut Point) -> Asked {
        // The options require one another: none is missing here.
        let mut on = |name, axis: Option<Axis>| point.on(name, &axis.unwrap_or_default());
        let time = self.time.map(|time| on("time", Some(time)));
        let start = match self.start {
            Start { rho: Some(rho), .. } => turntable::TurntableProblem::Polar {
                psi: on("psi", self.psi),
                p: on("p", self.p),
                rho: on("rho", Some(rho)),
            },
            Start { a: Some(a), .. } => turntable::TurntableProblem::Hyperbolic {
                psi: on("psi", self.psi),
                alpha: on("alpha", self.alpha),
                a: on("A", Some(a)),
            },
            Start { x, .. } => {
                let [vy, vx] = [on("vy", self.vy), on("vx", self.vx)];
                let [y, x] = [on("y", self.y), on("x", x)];
                turntable::TurntableProblem::Cartesian {
                    position: [x, y],
                    velocity: [vx, vy],
                }
            }
        };
        match time {
            Some(time) => Asked::Moment(start, time),
            None => Asked::Fate(start),
        }
    }
}

impl Problem {
    /// What is asked at a point of the grid; the last option runs fastest, which is read first.
    fn asked(&self, point: &mut Point) -> Asked {
        match self {
            Problem::Constant(given) => Asked::Constant(constant::ConstantProblem {
                at: given.moment.at(point),
                accel: point.on("accel", &given.accel),
                theta0: point.on("theta0", &given.theta0),
                v0: point.on("v0", &given.v0),
                lambda: point.on("lambda", &given.lambda),
            }),
            Problem::Sinusoidal(FrictionArgs { lambda0 }) => {
                let lambda0 = point.on("lambda0", lambda0);
                Asked::Sinusoidal(sinusoidal::SinusoidalProblem { lambda0 })
            }
            Problem::Pulse { eta, friction } => Asked::Pulse(periodic::PeriodicProblem {
                lambda0: point.on("lambda0", &friction.lambda0),
                eta: point.on("eta", eta),
            }),
            Problem::Anisotropic { q, friction } => {
                Asked::Anisotropic(anisotropic::AnisotropicProblem {
                    lambda0: point.on("lambda0", &friction.lambda0),
                    q: point.on("q", q),
                })
            }
            Problem::Sphere(given) => Asked::Sphere(sphere::SphereProblem {
                at: given.moment.at(point),
                kappa: point.on("kappa", &given.kappa),
                theta0: point.on("theta0", &given.theta0),
                u0: point.on("u0", &given.u0),
                gamma: point.on("gamma", &given.gamma),
            }),
            Problem::Turntable(given) => given.asked(point),
            Problem::TurntableBoundary { alpha, psi } => Asked::Boundary(rest::BoundaryProblem {
                psi: point.on("psi", psi),
                alpha: point.on("alpha", alpha),
            }),
        }
    }

    /// The unit of a number that is given.
    fn unit(&self, name: &str) -> &'static str {
        match (name, self) {
            ("theta" | "theta0" | "psi", _) => RADIANS,
            ("v0", _) => constant::SPEED,
            ("u0", _) => sphere::SLIP,
            ("time", Problem::Constant(_)) => constant::TIME,
            ("time", Problem::Sphere(_)) => sphere::TIME,
            ("time", _) => turntable::TIME,
            ("accel", _) => "that of A",
            ("rho" | "x" | "y", _) => turntable::LENGTH,
            ("p" | "vx" | "vy", _) => turntable::SPEED,
            _ => DIMENSIONLESS,
        }
    }

    /// An angle of the start.
    fn angle(&self) -> Option<(&'static str, &Axis)> {
        Some(match self {
            Problem::Constant(given) => ("theta0", &given.theta0),
            Problem::Sphere(given) => ("theta0", &given.theta0),
            Problem::Turntable(given) => ("psi", given.psi.as_ref()?),
            Problem::TurntableBoundary { psi, .. } => ("psi", psi),
            _ => return None,
        })
    }
}

impl Solve {
    fn run(&self, also: &Also, format: Format) -> Result<u8, Failure> {
        let mut point = Point::new(0);
        let asked = self.problem.asked(&mut point);
        let total = point.total.ok_or("more than 2⁶⁴ points together")?;
        let angle = self.problem.angle();
        if let Some(warning) = angle.and_then(|(name, angle)| is_it_degrees(name, angle)) {
            complain("slipbook", &warning);
        }
        if !point.swept.is_empty() || also.shard.is_some() {
            if also.plot.is_some() {
                return Err("--plot: it draws one answer, and here are several".into());
            }
            let ask = |point: &mut Point| self.problem.asked(point);
            let unit = |name: &str| self.problem.unit(name);
            let swept = sweep::run(&ask, &unit, total, also.shard, format);
            return swept.or_else(Stop::code);
        }
        let report = asked.report()?;
        let drawn = match &also.plot {
            None => None,
            Some(Some(file)) => {
                let svg = plot::svg(&asked.curve()?)?;
                if file.as_os_str() == plot::STDOUT {
                    say(&svg)?;
                    return Ok(0);
                }
                plot::to_file(&svg, file)?;
                None
            }
            Some(None) if format == Format::Text => Some(plot::as_text(&asked.curve()?)),
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
