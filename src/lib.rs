//! A physics paper that checks itself.
//!
//! The paper, *Slipping and rolling on a rough accelerating surface*, studies a particle and a sphere on a
//! rough plane that accelerates, and a particle on a rough turntable. This crate asks of each of its claims:
//! is it true, how do we know, and what is right where it is not?
//!
//! # Physics
//!
//! A particle on a plane that is shaken, by the values of a function that has no pulse shorter than 0.1; how fast it is, and how
//! well its drive is known:
//!
//! ```
//! use slipbook::motion::{Fitted, State, run};
//!
//! let plane = Fitted::from_fn(|t| [(3.0 * t).sin(), 0.3 * t.cos()], [0.0, 10.0], 0.1, &[])?;
//! let start = State { t: 0.0, v: [1.0, 0.5], x: [0.0; 2] };
//! let motion = run(&plane, 0.4, start, 10.0)?;
//! assert!(motion.at(1.0)?.speed() < start.speed());
//! assert!(motion.drive_error() < 1e-13);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A ball on a shaken plane slips at first, and then rolls, as the pull is never more than rolling can bear:
//!
//! ```
//! use slipbook::motion::Fitted;
//! use slipbook::motion::sphere::{Ball, Contact, Sphere};
//!
//! let solid = Sphere::with_kappa(0.4);
//! let plane = Fitted::from_fn(|t| [2.0 * (3.0 * t).sin(), 0.0], [0.0, 10.0], 0.1, &[])?;
//! let start = Ball { t: 0.0, x: [0.0; 2], v: [1.0, 0.5], omega: [0.0; 3] };
//! let motion = solid.run(&plane, &start, 10.0)?;
//! assert_eq!(motion.contact(0.1)?, Contact::Sliding);
//! assert_eq!(motion.contact(9.0)?, Contact::Rolling);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A census of particles on a turntable, in the paper's units, on all cores with the feature `parallel`:
//!
//! ```
//! use slipbook::motion::turntable::Start;
//! use slipbook::motion::turntable::ensemble::{End, Horizon};
//!
//! let starts = (0..100).map(|i| Start::polar(0.5, 0.015 * f64::from(i), 1.0));
//! let starts = starts.collect::<Result<Vec<_>, _>>()?;
//! let ends = Horizon { rho: 100.0, tau: 50.0 }.follow(&starts)?;
//! let rests = ends.iter().filter(|end| matches!(end, Ok(End::Rest { .. }))).count();
//! assert!(0 < rests && rests < 100);
//! # Ok::<(), slipbook::motion::MotionError>(())
//! ```
//!
//! `examples/portrait.rs` draws a portrait, `examples/census.rs` and `examples/shaken.rs` go further into the other two.
//!
//! # Judging
//!
//! With `default-features = false` there are the formulas, the motions, the calculators
//! alone, and a handful of dependencies; the feature `trials` brings the trials, `book` all that rests on them.
//!
//! ```
//! # #[cfg(feature = "trials")] {
//! use slipbook::claims::PAPER;
//! use slipbook::ledger::{Entry, Verdict};
//!
//! let (topic, claim) = PAPER.find("eq-11").ok_or("no such claim")?;
//! let entry = Entry::try_claim(&PAPER, topic, claim);
//! assert_eq!(entry.judgement.verdict, Verdict::Degenerate);
//! # }
//! # Ok::<(), &str>(())
//! ```
//!
//! # How it is made
//!
//! It has two sides that do not see each other:
//!
//! - [`paper`] holds the formulas as printed, errors included; [`corrections`] what replaces those that fail.
//! - [`motion`] knows Newton's law and Coulomb friction and nothing else; [`numerics`] is its tool box.
//!
//! In a formula of [`paper`] or [`corrections`] a mistake can be [`seeded`], to see that its trials notice.
//!
//! They meet in [`claims`], one row per claim, where trials turn a comparison into [`evidence`]. [`exact`]
//! proves identities, [`validated`] encloses numbers and proves statements on whole ranges. The [`ledger`] judges:
//! evidence in, verdict out. [`figures`] draws, [`explorers`] answer to the reader's hand, and [`book`] writes all
//! of it down; [`breaks`] lets its reader break a formula. [`cli`] is the command. Both get from the [`edition`]
//! what is this paper's own. For parameters of your own there are the calculators of [`solve`].
//!
//! What knows no paper is [`trialbook`], and [`motion`] is [`slipbook_motion`]: crates of their own, whose modules stand here under their names.
// What is public is promised.
#![cfg_attr(not(test), warn(unreachable_pub))]
// Of what trials compute the figures alone read some.
#![cfg_attr(not(feature = "book"), allow(dead_code))]
// Where a module is not built, its name leads to the feature that brings it.
#![cfg_attr(
    not(feature = "trials"),
    doc = "",
    doc = "[`claims`]: #judging",
    doc = "[`evidence`]: #judging",
    doc = "[`ledger`]: #judging",
    doc = "[`exact`]: #judging",
    doc = "[`validated`]: #judging",
    doc = "[`breaks`]: #judging"
)]
#![cfg_attr(
    not(feature = "book"),
    doc = "",
    doc = "[`figures`]: #judging",
    doc = "[`explorers`]: #judging",
    doc = "[`book`]: #judging",
    doc = "[`cli`]: #judging",
    doc = "[`edition`]: #judging"
)]

#[cfg(feature = "trials")]
pub mod breaks;
#[cfg(feature = "trials")]
pub mod claims;
#[cfg(feature = "book")]
mod commands;
pub mod corrections;
#[cfg(feature = "book")]
pub mod edition;
#[cfg(feature = "book")]
pub mod exam;
#[cfg(feature = "book")]
pub mod figures;
pub mod paper;
pub mod scene;
pub mod solve;
#[cfg(feature = "trials")]
pub mod symbols;

#[cfg(feature = "book")]
pub use slipbook_motion::explorers;
#[cfg(feature = "trials")]
pub use slipbook_motion::validated;
pub use slipbook_motion::{self as motion, numerics};
#[cfg(feature = "trials")]
pub use trialbook::exact;
#[cfg(feature = "book")]
pub use trialbook::{book, cli};
#[cfg(feature = "trials")]
pub use trialbook::{evidence, ledger};
pub use trialbook::{scalar, seeded};
