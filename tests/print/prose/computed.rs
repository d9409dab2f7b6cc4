//! Counts that are computed, from the library, its data or what the page itself lists.

use super::numbers::WORDS;
use crate::hold::Library;
use slipbook::claims::PAPER;
use slipbook::claims::anisotropic::census;
use slipbook::claims::anisotropic::simulated::{attractor, curve_a, curve_e, order};
use slipbook::claims::corners::CORNERS;
use slipbook::claims::periodic::drawn;
use slipbook::claims::periodic::drives::{Phase, motion, third_harmonic};
use slipbook::claims::rest::fates::recorded;
use slipbook::claims::solve::Double;
use slipbook::claims::solve::sinusoidal::SinusoidalProblem;
use slipbook::claims::tolerances::{ESCAPE_CORRECTION, ESCAPE_LIMIT};
use slipbook::claims::values::VALUES;
use slipbook::evidence::{Compared, Evidence, Kind, Route, Subject, Tolerance};
use slipbook::ledger::{Verdict, judge};
use slipbook::motion::drive::{Drive, DriveState, Friction, Interval, Sign};
use slipbook::motion::sphere::{Ball, Sphere};
use slipbook::motion::turntable::{Start, intrinsic};
use slipbook::motion::{Launch, Plane};
use slipbook::numerics::fit::fit;
use slipbook::paper::{sinusoidal, sphere};
use slipbook::seeded::Corner;
use std::f64::consts::{FRAC_PI_2, PI, SQRT_2, TAU};

/// How many digits the calculators claimed, and had.
const DIGITS: &str = include_str!("../../../snapshots/digits.csv");
/// The mistakes that are made in the physics of a drive.
const PHYSICS: &str = include_str!("../../../mutants/physics/2-drive.txt");
/// The example that a page speaks of.
const DRAG: &str = include_str!("../../../trialbook/examples/drag/main.rs");

/// A small example.
const FALL: &str = include_str!("../../../trialbook/examples/fall.rs");
/// The independent program that makes reference values.
const PROGRAM: &str = include_str!("../../data/digits/make.py");
/// The test that finds tolerances too loose.
const LOOSENESS: &str = include_str!("../../claims.rs");
/// What becomes of published numbers.
const PUBLISHED: &str = include_str!("../../../src/exam/published.rs");
/// What was timed.
const RESULTS: &str = include_str!("../../../benches/results.json");
/// What is timed of the turntable.
const BENCH: &str = include_str!("../../../benches/turntable.rs");
/// The page on answers as JSON.
const JSON: &str = include_str!("../../../book/src/json.md");

/// A count that is computed: page, words with `{}` for it, and what it has to be there.
type Computed = (&'static str, &'static str, fn() -> String);

pub const COMPUTED: &[Computed] = &[
    ("anisotropic", "nearly {} points", || {
        let points = census::COLUMNS * census::ROWS;
        in_thousands(points.next_multiple_of(10_000))
    }),
    (
        "anisotropic",
        "These are the paper's {} kinds of motion",
        || word(named("s24-region-")),
    ),
    ("general", "The paper draws {} conclusions", || {
        word(in_words_only("general"))
    }),
    (
        "general",
        "## {} statements about every acceleration",
        || capital(&word(in_words_only("general"))),
    ),
    (
        "sinusoidal",
        "That makes {} phases of a period special",
        || word(VALUES.iter().filter(|v| v.id.starts_with("phi-")).count() as f64),
    ),
    ("speed", "{} particles go side by side", || {
        let source = include_str!("../../../src/motion/turntable/ensemble.rs");
        let lanes = source.split("const LANES: usize = ").nth(1).unwrap();
        capital(&word(lanes.split(';').next().unwrap().parse().unwrap()))
    }),
    ("accuracy", "asked {} times", || {
        let rows = DIGITS.lines().skip(1);
        let mut asked = std::collections::BTreeMap::<&str, usize>::new();
        for row in rows {
            let cells: Vec<&str> = row.split(',').collect();
            *asked.entry(cells[0]).or_default() += cells[3].parse::<usize>().unwrap();
        }
        let of_each: std::collections::BTreeSet<usize> = asked.into_values().collect();
        format!("{of_each:?}").replace("{10000}", "ten thousand")
    }),
    ("accuracy", "has all its {} digits", || word(most_digits())),
    (
        "json",
        "a number of up to {} digits",
        || word(most_digits()),
    ),
    ("proved", "friction that is a part in {} too strong", || {
        slips("1e-7", "ten million")
    }),
    ("proved", "that gives way a part in {} too early", || {
        slips("1e-9", "10⁹")
    }),
    ("escape", "differ by {} per cent or less", || {
        let value = |id| {
            VALUES
                .iter()
                .find(|v| v.id == id)
                .unwrap()
                .number()
                .unwrap()
        };
        let pairs = [("a-printed", "a"), ("p-printed", "p"), ("s-printed", "s")];
        let apart = pairs.map(|(printed, right)| (value(printed) / value(right) - 1.0).abs());
        word((100.0 * apart.into_iter().fold(0.0, f64::max)).ceil())
    }),
    ("escape", "which turns {} times meanwhile", || {
        format!("{} million", word(((1e8 - 1e4) / TAU / 1e6).round()))
    }),
    ("rest", "the code does, to {} digits", || word(critical())),
    ("rest", "{} of their digits are certain", || {
        // Of an interval as long above as below.
        word(decimals(2.0 * certain()))
    }),
    ("new", "are proved to {} ten-millionths", || {
        word((certain() * 1e7).round())
    }),
    ("new", "ten-millionths, and measured to {}", || {
        word(critical())
    }),
    ("new", "also measured to {} digits", || {
        word(decimals(ESCAPE_LIMIT.value))
    }),
    ("new", "logarithm to {}", || {
        word(decimals(ESCAPE_CORRECTION.value))
    }),
    ("escape", "the fit gives {}", || {
        word(decimals(ESCAPE_LIMIT.value))
    }),
    (
        "escape",
        "allows only for powers of § stalls at {} digits",
        || word(by_powers()),
    ),
    ("escape", "a little more than {} around", || {
        times((SQRT_2 * 1e4_f64.ln() / TAU).floor())
    }),
    ("rest", "For {} values of § the fates", || {
        let mut all: Vec<f64> = recorded().unwrap().iter().map(|map| map[0].a).collect();
        all.dedup();
        word(all.len() as f64)
    }),
    ("rest", "the census to a {} starts", || {
        let counts = ["launches(651, ", "launches(652, "].map(|words| {
            let (count, _) = BENCH.split_once(words).unwrap().1.split_once(',').unwrap();
            count.replace('_', "").parse::<f64>().unwrap()
        });
        word(counts.iter().sum())
    }),
    ("rest", "the bisection to {} digits", || {
        let (_, width) = BENCH.split_once("1.0 + 1e-9, ").unwrap();
        word(decimals(width.split(')').next().unwrap().parse().unwrap()))
    }),
    ("speed", "takes some {} steps to rest or far away", || {
        word(10.0 * (steps() / 10.0).round())
    }),
    ("turntable", "subject of the next {} chapters", || {
        let stems = PAPER.topics.iter().map(|topic| topic.stem);
        word(
            stems
                .skip_while(|stem| *stem != "turntable")
                .skip(1)
                .count() as f64,
        )
    }),
    ("own", "a whole paper in some {} lines", || {
        (10 * DRAG.lines().count().div_ceil(10)).to_string()
    }),
    ("own", "{} equations,", || {
        let numbers = (1..100).filter(|n| DRAG.contains(&format!("pub fn eq{n}_")));
        word(numbers.count() as f64)
    }),
    ("own", "equations, {} of them proved", || {
        word(DRAG.matches("> = proved(").count() as f64)
    }),
    // Accuracy, and what the methods ask for.
    ("accuracy", "with numbers of {} digits. Functions", || {
        digits_of_two().to_string()
    }),
    ("accuracy", "in numbers of {} digits (sums", || {
        digits_of_two().to_string()
    }),
    ("accuracy", "(sums of {} floating-point numbers)", || {
        word(parts_of_two() as f64)
    }),
    (
        "accuracy",
        "by an independent program with {} digits",
        || {
            let first = after(PROGRAM, "\n    digits = ");
            let factor = after(PROGRAM, "digits * 3 // ");
            assert!(PROGRAM.contains("mp.workdps(digits * 3 // "));
            format!("{} to {}", word(first), word(first * 3.0 / factor))
        },
    ),
    ("json", "in numbers of {} digits, and so is", || {
        digits_of_two().to_string()
    }),
    ("json", "relative to 1): {}, if", || word(most_digits())),
    ("adding", "at least {} independent routes", || {
        word(routes_needed())
    }),
    (
        "methods",
        "by {} independent routes or by a proof, or",
        || word(routes_needed()),
    ),
    (
        "methods",
        "holds by {} independent routes or by a proof",
        || word(routes_needed()),
    ),
    ("own", "{} independent routes, or one proof", || {
        capital(&word(routes_needed()))
    }),
    ("adding", "more than {} times the worst", || {
        word(after(LOOSENESS, "const SLACK: f64 = "))
    }),
    ("methods", "more than {} times as large", || {
        word(after(LOOSENESS, "const SLACK: f64 = "))
    }),
    ("exam", "no more than {} units of the last one", || {
        word(after(PUBLISHED, "} else if apart <= "))
    }),
    ("proved", "changed by {} the tolerance", slight),
    ("json", "wrong by {} the tolerance", slight),
    ("proved", "{}, from either side", || {
        let near = edges("λ₀").map(|c| c.high - c.low).fold(0.0, f64::max);
        assert!(edges("λ₀").all(|c| (c.high - c.low - near).abs() < 1e-15));
        let ends = edges("λ₀").flat_map(|c| [c.low, c.high]);
        let whole = ends.filter(|end| end.fract() == 0.0);
        let mut at: Vec<String> = whole.map(|end| end.to_string()).collect();
        at.dedup();
        format!("within a {}th of {}", word(1.0 / near), at.join(" or of "))
    }),
    ("proved", "a coefficient of friction above {};", || {
        edges("μ").next().unwrap().low.to_string()
    }),
    ("proved", "§ or § above {}.", || {
        let ends = |letter| {
            let above = edges(letter).find(|c| c.high.is_infinite()).unwrap().low;
            let below = edges(letter).find(|c| c.low == 0.0).unwrap().high;
            format!("{above} or below a {}th", word(1.0 / below))
        };
        assert_eq!(ends("α"), ends("β"));
        ends("α")
    }),
    // What the motion does.
    (
        "constant",
        "which falls from {} as the velocity turns",
        || {
            let launch = Launch::new(0.5, 1.0, 1.0, 2.0).unwrap();
            let motion = launch.motion(1e4).unwrap();
            let r = |t| (motion.at(t).unwrap().direction() / 2.0).tan() / 1.0_f64.tan();
            format!("{:.0} to {:.0}", r(0.0), r(1e4))
        },
    ),
    ("constant", "ends up with {} its initial speed", || {
        word(kept(90.0))
    }),
    ("constant", "at {}° to the inertial force", || {
        let (mut near, mut far) = (1.0, 179.0);
        while far - near > 1e-6 {
            let middle = 0.5 * (near + far);
            *(if kept(middle) > 0.75 {
                &mut near
            } else {
                &mut far
            }) = middle;
        }
        format!("{near:.0}")
    }),
    ("constant", "it takes a {} longer", || {
        let launch = Launch::new(2.0, 1.0, 1.0, FRAC_PI_2).unwrap();
        let on_table = launch.motion_to_rest().unwrap().end().t;
        word(on_table / (1.0 / 2.0) - 1.0)
    }),
    (
        "sinusoidal",
        "At § the {}, if both ends of § are counted)",
        || {
            let special: [fn(f64) -> f64; 4] = [
                sinusoidal::eq27_phi1,
                sinusoidal::eq28_phi2,
                sinusoidal::eq29_phi3,
                sinusoidal::eq30_phi4,
            ];
            let different = |turn: f64| {
                let mut at: Vec<f64> = special.iter().map(|phase| phase(0.0) % turn).collect();
                at.sort_by(f64::total_cmp);
                at.dedup();
                word(at.len() as f64)
            };
            let (all, circle, line) = (word(special.len() as f64), different(TAU), different(9.0));
            format!("{all} merge into {circle}, § and § (or {line}")
        },
    ),
    ("sinusoidal", "so only {} can end a rest", || {
        let special: [fn(f64) -> f64; 4] = [
            sinusoidal::eq27_phi1,
            sinusoidal::eq28_phi2,
            sinusoidal::eq29_phi3,
            sinusoidal::eq30_phi4,
        ];
        let swing = Drive::new(libm::sin, &[]).unwrap();
        let friction = Friction::new(0.5, 0.5).unwrap();
        let moves = |phase: &fn(f64) -> f64| {
            let start = DriveState {
                phi: phase(0.5) - 1e-3,
                w: 0.0,
            };
            let at_rest = swing.advance(friction, start, start.phi + 5e-4).unwrap();
            let later = swing.advance(friction, start, start.phi + 0.1).unwrap();
            at_rest.end.w == 0.0 && later.end.w != 0.0
        };
        let ends = special.iter().filter(|phase| moves(phase)).count();
        format!(
            "{} of the {}",
            word(ends as f64),
            word(special.len() as f64)
        )
    }),
    ("sinusoidal", "says nothing about its {} borders", || {
        word(regimes().len() as f64 - 1.0)
    }),
    ("sphere", "so the {} kinds of motion carry over", || {
        word(regimes().len() as f64)
    }),
    (
        "sinusoidal",
        "passes through zero {} in a period, and there",
        || times(zeros(0.3)),
    ),
    ("sinusoidal", "With {} zeros in a period", || {
        word(zeros(0.3))
    }),
    ("sinusoidal", "there are {} passages per period", || {
        word(zeros(0.3))
    }),
    ("sphere", "at the {} instants of each period", || {
        word(zeros(0.3))
    }),
    ("sphere", "the printed formulas give {} that", || {
        let start = Ball {
            t: 0.0,
            x: [0.0; 2],
            v: [0.0, 1.0],
            omega: [0.0; 3],
        };
        let plane = Plane::constant([-2.0, 0.0]);
        let motion = Sphere::with_kappa(0.4).run(&plane, &start, 1.0).unwrap();
        let printed = sphere::eq82_time(3.5 / 2.0, 1.0, FRAC_PI_2, 1e-9);
        times((printed / motion.transitions()[0].t * 1e6).round() / 1e6)
    }),
    ("sphere", "the angular velocity, with {} components", || {
        let ball = Ball {
            t: 0.0,
            x: [0.0; 2],
            v: [0.0; 2],
            omega: [0.0; 3],
        };
        word(ball.omega.len() as f64)
    }),
    ("turntable", "so {}: how fast", || {
        let library = Library::new();
        let rates = ["eq107_p_rate", "eq108_rho_rate", "eq109_psi_rate"];
        let arguments = rates
            .iter()
            .flat_map(|name| library.formula(name).arguments);
        let ours: std::collections::BTreeSet<_> = arguments.collect();
        let start = slipbook::motion::turntable::State {
            t: 0.0,
            x: [0.0; 2],
            v: [0.0; 2],
        };
        let all = start.x.len() + start.v.len();
        format!(
            "{} numbers suffice instead of {}",
            word(ours.len() as f64),
            word(all as f64)
        )
    }),
    (
        "periodic",
        "ends at {} that distance after the maximum",
        || {
            // A sine is 1 − x²/2 at its maximum.
            let swing = Drive::new(libm::sin, &[]).unwrap();
            let friction = Friction::new(1.0 - 1e-6, 1.0 - 1e-6).unwrap();
            let start = DriveState { phi: 0.0, w: 0.0 };
            let path = swing.advance(friction, start, PI).unwrap();
            let slip = path
                .intervals
                .iter()
                .find(|i| i.sign == Sign::Positive)
                .unwrap();
            times((slip.end - FRAC_PI_2).div_euclid(0.99 * (FRAC_PI_2 - slip.start)))
        },
    ),
    (
        "periodic",
        "passes through zero {} times in a period",
        || word(loops(0.04).len() as f64),
    ),
    ("periodic", "there are {} shallow ones", || {
        let sizes = loops(0.04);
        let large = sizes
            .iter()
            .filter(|size| **size > 0.5 * sizes.iter().fold(0.0, |a: f64, b| a.max(*b)))
            .count();
        format!(
            "{} large loops and {}",
            word(large as f64),
            word((sizes.len() - large) as f64)
        )
    }),
    (
        "periodic",
        "More friction deepens {}, until these end in rests",
        || {
            // The same loops one after the other, as none has gone.
            let (weak, strong) = (loops(0.02), loops(0.05));
            assert_eq!(weak.len(), strong.len());
            let most = weak.iter().fold(0.0, |a: f64, b| a.max(*b));
            let shallow = || {
                weak.iter()
                    .zip(&strong)
                    .filter(|(size, _)| **size < 0.5 * most)
            };
            let deeper = shallow().filter(|(before, after)| after > before).count();
            let flatter = shallow().count() - deeper;
            format!(
                "{} of the shallow loops and flattens the other {}",
                word(deeper as f64),
                word(flatter as f64)
            )
        },
    ),
    ("periodic", "it goes from none to {} again", || {
        let rows = drawn::census(100).unwrap();
        let mut rests: Vec<usize> = rows[1]
            .phases
            .iter()
            .map(|phase| match phase {
                Phase::Rests(n) => *n,
                other => panic!("{other:?}"),
            })
            .collect();
        rests.dedup();
        let words: Vec<String> = rests
            .iter()
            .map(|n| {
                if *n == 1 {
                    "one".to_owned()
                } else {
                    word(*n as f64)
                }
            })
            .collect();
        let [_, first @ .., last] = &words[..] else {
            panic!("{words:?}")
        };
        assert_eq!(rests[0], 0);
        format!("{}, and {last}", first.join(", "))
    }),
    (
        "anisotropic",
        "or with one rest in each period, or {}, or",
        || {
            let kinds =
                [0.2, 0.38, 0.45, 0.55, 1.1].map(|x| order(attractor(2.0, x).unwrap().intervals()));
            word(
                kinds
                    .iter()
                    .map(|kind| kind.matches('0').count())
                    .max()
                    .unwrap() as f64,
            )
        },
    ),
    ("anisotropic", "(53) gives a {} of that", || {
        let q = 1e4;
        word((1e3 * curve_a(q).unwrap() / curve_e(q).unwrap().unwrap()).round() / 1e3)
    }),
    ("anisotropic", "{} numbers decide which", || {
        capital(&word(coordinates()))
    }),
    ("anisotropic", "a map of these {} numbers", || {
        word(coordinates())
    }),
    // What stands in other files, or on the page itself.
    ("anisotropic", "## {} borders", || {
        let page = include_str!("../../../book/src/anisotropic.md");
        let (_, section) = page.split_once("{#borders}").unwrap();
        let (section, _) = section.split_once("\n## ").unwrap();
        let heads = || section.lines().filter(|line| line.starts_with("### "));
        let asked = heads().filter(|line| line.contains('?')).count();
        let drawn = heads().filter(|line| line.contains("Curve ")).count();
        format!(
            "{} questions, {}",
            capital(&word(asked as f64)),
            word(drawn as f64)
        )
    }),
    ("speed", "The cost per start is the same for a {}:", || {
        let results: serde_json::Value = serde_json::from_str(RESULTS).unwrap();
        let rows = results["growth"].as_array().unwrap();
        let starts = |row: &serde_json::Value| row["starts"].as_f64().unwrap();
        let round = |n: f64| 10_f64.powf(n.log10().round());
        let [few, many] = [rows.first(), rows.last()].map(|row| word(round(starts(row.unwrap()))));
        format!("{few} starts as for a {many}")
    }),
    ("speed", "follows a {} starts", || {
        let page = include_str!("../../../book/src/speed.md");
        let (_, command) = page.split_once("slipbook ensemble ").unwrap();
        let ranges = command
            .lines()
            .next()
            .unwrap()
            .split(':')
            .skip(2)
            .step_by(2);
        word(ranges.map(number).product())
    }),
    ("anisotropic", "{} questions decide what comes next", || {
        let page = include_str!("../../../book/src/anisotropic.md");
        let heads = page.lines().filter(|line| line.starts_with("### "));
        let asked = heads.filter(|line| line.contains('?') && line.contains("Curve "));
        capital(&word(asked.count() as f64))
    }),
    ("related", "about {} of the steepest slope", || {
        let y = VALUES.iter().find(|v| v.id == "y-q").unwrap();
        let q = y.number().unwrap();
        format!("{} thirds", word((3.0 * (q - 1.0) / (q + 1.0)).round()))
    }),
    ("sphere", "takes {} axes, gives", || {
        let proof = include_str!("../../../src/claims/sphere/exact/newton.rs");
        let axes = after(proof, "for axis in 0..");
        let (_, ways) = proof.split_once("for way in [").unwrap();
        let ways = ways.split(']').next().unwrap().split(", ").count();
        format!(
            "{} point masses on {}",
            word(axes * ways as f64),
            word(axes)
        )
    }),
    ("proved", "; {} more orders are found as well", || {
        let proof = include_str!("../../../src/claims/rest/exact/boundary.rs");
        let found = after(proof, "const ORDER: i64 = ");
        let (_, claim) = PAPER.find("s4-envelope-is-boundary").unwrap();
        let stated = after(claim.correction.unwrap().latex, r"+O(\alpha^") - 1.0;
        word(found - stated)
    }),
    ("snapshots", "rounded {} digits short of it", || {
        let sheet = include_str!("../../../trialbook/src/ledger/sheet.rs");
        word(after(sheet, "(vouched.floor() as i32 - "))
    }),
    ("json", "for {} numbers from the first", || {
        let (_, range) = JSON.split_once("in the place of a number, `").unwrap();
        word(number(range.split(':').nth(2).unwrap()))
    }),
    ("json", "writes the {} parts", || {
        let (_, shard) = JSON.split_once("`--shard ").unwrap();
        let (which, of) = shard.split_once('/').unwrap();
        let ordinal = ["first", "second", "third", "fourth"][which.parse::<usize>().unwrap() - 1];
        format!("{ordinal} of {}", word(number(of)))
    }),
    ("json", "this page describes version {}.", || {
        slipbook::claims::solve::VERSION.to_string()
    }),
    ("json", "the {} of them add up to", || {
        let (_, section) = JSON.split_once("{#solve-anisotropic}").unwrap();
        let (section, _) = section.split_once("\n## ").unwrap();
        word(section.matches("| number | length of ").count() as f64)
    }),
    ("exam", "The second prints {} of them", || {
        let page = include_str!("../../../book/src/exam.md");
        let (_, command) = page
            .split_once("\nslipbook exam --json > exam.json\nslipbook exam ")
            .unwrap();
        word(command.lines().next().unwrap().split(' ').count() as f64)
    }),
    ("own", "{} equations are printed", || {
        let (_, printed) = FALL.split_once("mod paper {").unwrap();
        let (printed, _) = printed.split_once("\n}").unwrap();
        capital(&word(printed.matches("pub fn eq").count() as f64))
    }),
    ("own", "it takes {} commands", || {
        let page = include_str!("../../../book/src/own.md");
        let (steps, _) = page.split_once("## Break it").unwrap();
        let blocks = steps
            .split("```text")
            .skip(1)
            .filter_map(|block| block.split("```").next());
        let commands = blocks
            .flat_map(str::lines)
            .filter(|line| line.starts_with("cargo ") || line.starts_with("cd "));
        word(commands.count() as f64)
    }),
    ("certificates", "What became of {} spoiled files", || {
        let text = include_str!("../../../certificates/corrupted.txt");
        let (_, count) = text.split_once(": of ").unwrap();
        count.split(' ').next().unwrap().to_owned()
    }),
    ("trust", "mpmath to a {} decimals", || {
        let rows = include_str!("../../data/digits/certified.csv")
            .lines()
            .skip(1);
        let long = rows.map(|row| row.split(',').nth(2).unwrap());
        let decimals = long.map(|digits| digits.split_once('.').unwrap().1.len());
        word((decimals.min().unwrap() / 1000 * 1000) as f64)
    }),
];

fn most_digits() -> f64 {
    let rows = DIGITS.lines().skip(1);
    let claimed = rows.map(|row| row.split(',').nth(1).unwrap().parse::<usize>().unwrap());
    claimed.max().unwrap() as f64
}

/// To how many digits the critical radius and speed are given.
fn critical() -> f64 {
    let value = |id| VALUES.iter().find(|v| v.id == id).unwrap().decimals;
    value("critical-radius").min(value("critical-speed")) as f64
}

/// How near to them the code on the page on rest comes with its proofs.
fn certain() -> f64 {
    let page = include_str!("../../../book/src/rest.md");
    let (_, from) = page.split_once("while left.abs() > ").unwrap();
    from.split(' ').next().unwrap().parse().unwrap()
}

/// How many decimals are right of what is right to so much.
fn decimals(off: f64) -> f64 {
    (-off.log10() + 1e-9).floor()
}

/// To how many digits p/τ² is found by a fit that knows only powers of 1/τ.
fn by_powers() -> f64 {
    let start = Start::hyperbolic(1.5, 0.3, 1.0).unwrap();
    let data: Vec<_> = (0..40)
        .map(|i| {
            let tau = 10_f64.powf(6.0 + f64::from(i) / 20.0);
            let end = intrinsic::Run::new(&start, tau).unwrap().end();
            (tau, end.p() / (tau * tau))
        })
        .collect();
    let powers = fit(&data, &[&|_| 1.0, &|t| 1.0 / t, &|t| 1.0 / (t * t)]).unwrap();
    let limit = 1.0 / (3.0 * SQRT_2);
    decimals((powers.coefficients[0] / limit - 1.0).abs())
}

/// How many steps a motion on the turntable takes to rest, or to a time of 100, at a middle.
fn steps() -> f64 {
    let starts = [0.3, 0.6, 0.9, 1.2, 1.5].map(|a| Start::hyperbolic(a, 0.3, 1.0).unwrap());
    let runs = starts.map(|start| intrinsic::Run::new(&start, 100.0).unwrap());
    let mut steps = runs.map(|run| run.nodes().count());
    steps.sort_unstable();
    steps[2] as f64
}

/// The words, if the list of mistakes in the physics has one of this size.
fn slips(size: &str, words: &str) -> String {
    let there = PHYSICS.contains(size);
    if there {
        words.to_owned()
    } else {
        format!("no mistake of {size}")
    }
}

/// How many claims begin their ids so.
fn named(prefix: &str) -> f64 {
    PAPER
        .claims()
        .filter(|(_, claim)| claim.id.starts_with(prefix))
        .count() as f64
}

/// How many claims of a topic have no number.
fn in_words_only(stem: &str) -> f64 {
    let claims = PAPER
        .claims()
        .filter(|(topic, claim)| topic.stem == stem && claim.equation.is_none());
    claims.count() as f64
}

fn capital(word: &str) -> String {
    word[..1].to_uppercase() + &word[1..]
}

/// A number as a word, where it is as close to one as a motion that was followed can be.
fn word(n: f64) -> String {
    let found = WORDS.iter().find(|(_, value)| (value - n).abs() < 1e-9 * n);
    found.map_or_else(|| n.to_string(), |(word, _)| (*word).to_owned())
}

/// How many times, as a word.
fn times(n: f64) -> String {
    if n == 2.0 {
        "twice".to_owned()
    } else {
        format!("{} times", word(n))
    }
}

/// The number at the beginning of a text.
fn number(text: &str) -> f64 {
    let end = text.find(|c: char| !c.is_ascii_digit() && c != '.');
    text[..end.unwrap_or(text.len())]
        .trim_end_matches('.')
        .parse()
        .unwrap()
}

/// The number in a text behind these words.
fn after(text: &str, words: &str) -> f64 {
    number(text.split(words).nth(1).unwrap())
}

/// How many floating-point numbers the calculators' numbers are made of.
fn parts_of_two() -> usize {
    size_of::<Double>() / size_of::<f64>()
}

/// How many decimal digits such a number has.
fn digits_of_two() -> f64 {
    let bits = parts_of_two() as f64 * f64::from(f64::MANTISSA_DIGITS);
    (bits * 2_f64.log10()).floor()
}

/// How many routes that measure the judge wants, each with motions of its own.
fn routes_needed() -> f64 {
    const ANY: Tolerance = Tolerance {
        name: "ANY",
        value: 1e-10,
        reason: "whichever",
    };
    let routes = [
        Route::Integration,
        Route::Quadrature,
        Route::Root,
        Route::Limit,
    ];
    let by = |route: &Route| Evidence {
        points: 1000,
        worst: 1e-12,
        ..Evidence::new(
            *route,
            Subject::Printed,
            Compared::one("a formula", "the motion"),
            ANY,
        )
    };
    let confirmed = |n: &usize| {
        let evidence: Vec<Evidence> = routes[..*n].iter().map(by).collect();
        judge(Kind::Equation, None, &[], &evidence).verdict == Verdict::Confirmed
    };
    (0..=routes.len()).find(confirmed).unwrap() as f64
}

/// How many tolerances a slight mistake has.
fn slight() -> String {
    let part = after(
        include_str!("../../../trialbook/src/ledger/slight.rs"),
        "let part = (",
    );
    times(1.0 / part)
}

/// The corners of a symbol.
fn edges(letter: &'static str) -> impl Iterator<Item = &'static Corner> {
    CORNERS.iter().filter(move |corner| corner.letter == letter)
}

/// The share of its speed that a particle keeps at λ = 1, launched at so many degrees to the inertial force.
fn kept(degrees: f64) -> f64 {
    let launch = Launch::new(1.0, 1.0, 1.0, degrees.to_radians()).unwrap();
    launch.motion(400.0).unwrap().end().speed()
}

/// The regimes of sinusoidal shaking, from little friction to much.
fn regimes() -> Vec<&'static str> {
    let of = |i: u32| {
        let lambda0 = f64::from(i) / 20.0;
        let swing = SinusoidalProblem { lambda0 }.solve().unwrap();
        swing.best.regime
    };
    let mut all: Vec<_> = (1..30).map(of).collect();
    all.dedup();
    all
}

/// How often the large-time velocity is zero in a period of a sine without resting.
fn zeros(lambda: f64) -> f64 {
    let swing = Drive::new(libm::sin, &[]).unwrap();
    let friction = Friction::new(lambda, lambda).unwrap();
    let outcome = swing.attractor(friction, DriveState { phi: 0.0, w: 0.0 }, 99);
    let motion = outcome.unwrap().settled().unwrap();
    assert!(motion.intervals().iter().all(|i| i.sign != Sign::Rest));
    motion.intervals().len() as f64
}

/// The largest speed in each loop under the drive of which the page on any drive speaks.
fn loops(lambda: f64) -> Vec<f64> {
    let shape = third_harmonic(drawn::THIRD).unwrap();
    let motion = motion(&shape, lambda).unwrap().unwrap();
    let loops = motion.intervals().iter().filter(|i| i.sign != Sign::Rest);
    let largest = |i: &Interval| {
        let phases = (0..=200).map(|k| i.start + i.length() * f64::from(k) / 200.0);
        phases.map(|phi| motion.w(phi).abs()).fold(0.0, f64::max)
    };
    loops.map(largest).collect()
}

/// How many numbers beside the phase the law with two frictions has.
fn coordinates() -> f64 {
    let library = Library::new();
    let rates = ["eq51_rate", "eq52_rate"];
    let arguments = rates
        .iter()
        .flat_map(|name| library.formula(name).arguments);
    let all: std::collections::BTreeSet<_> = arguments.filter(|name| **name != "phi").collect();
    all.len() as f64
}

fn in_thousands(n: usize) -> String {
    format!("{} thousand", word(n as f64 / 1e3))
}
