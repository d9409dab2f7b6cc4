//! Puts the claims of a paper on trial.
//!
//! A paper says that a stone falls `s = gt` in the time t. Its motion says something else:
//!
//! ```
//! # #[cfg(feature = "trials")] {
//! use trialbook::prelude::*;
//!
//! fn eq2_way(g: f64, t: f64) -> f64 { g * t }
//!
//! let falls = Points::here().within(20, [[1.0, 10.0], [0.1, 2.0]]);
//! let trial = Trial::motion(Printed, Compared::one("the formula", "the integrated motion"));
//! let evidence = trial.at(["g", "t"], falls, 20.0, |[g, t]| {
//!     let law = |_, [_, v]: &[f64; 2]| [*v, g];
//!     let [way, _] = dop853::end(law, 0.0, [0.0, 0.0], t, 1e-14, 1e-14)?;
//!     Ok([eq2_way(g, t), way])
//! });
//! assert!(evidence.failed > 0);
//! # }
//! ```
//!
//! An identity is proved, not measured:
//!
//! ```
//! # #[cfg(feature = "trials")] {
//! use trialbook::exact::{Expr, Proof, Ring};
//! use trialbook::scalar::Scalar;
//!
//! let mut ring = Ring::new();
//! ring.angle("θ");
//! let theta = Expr::symbol("θ");
//! let proof = Proof::of("sin′ = cos", &ring, |p| {
//!     let sine = p.read("the sine", theta.sin())?;
//!     let slope = p.derivative("d sin θ/dθ", &sine, &ring.by("θ")?)?;
//!     let cosine = p.read("the cosine", theta.cos())?;
//!     p.equal("they are the same", &slope, &cosine)
//! });
//! assert!(proof.holds());
//! # }
//! ```
//!
//! `examples/fall.rs` is a whole paper, with its command and its book.
//!
//! # How it is made
//!
//! A trial compares what a paper claims with what is found without it, and gives [`evidence`]; the [`ledger`]
//! judges. A printed formula is written once, over any [`scalar`]; a mistake can be [`seeded`] in it, to see
//! that its trials notice.
//!
//! [`numerics`] finds without the paper; [`exact`] proves identities, [`certified`] encloses numbers and
//! proves statements on whole ranges; [`plotting`] draws.
//!
//! The [`book`] writes it down, [`cli`] is the command; what a paper has of its own for them is said in
//! [`publishing`].
//!
//! # Features
//!
//! With `default-features = false` there are the formulas, the numerics that
//! a motion needs alone; the feature `trials` brings the trials, `book` all that rests on them.
// What is public is promised.
#![cfg_attr(not(test), warn(unreachable_pub))]
// Where a module is not built, its name leads to the feature that brings it.
#![cfg_attr(
    not(feature = "trials"),
    doc = "",
    doc = "[`evidence`]: #features",
    doc = "[`exact`]: #features",
    doc = "[`ledger`]: #features",
    doc = "[`certified`]: #features"
)]
#![cfg_attr(
    not(feature = "book"),
    doc = "",
    doc = "[`plotting`]: #features",
    doc = "[`book`]: #features",
    doc = "[`cli`]: #features",
    doc = "[`publishing`]: #features"
)]

#[cfg(feature = "book")]
pub mod book;
#[cfg(feature = "trials")]
pub mod certified;
#[cfg(feature = "book")]
pub mod cli;
#[cfg(feature = "trials")]
pub mod data;
#[cfg(feature = "trials")]
pub mod evidence;
#[cfg(feature = "trials")]
pub mod exact;
#[cfg(feature = "trials")]
pub mod ledger;
#[cfg(feature = "trials")]
pub mod notation;
pub mod numerics;
#[cfg(feature = "book")]
pub mod plotting;
#[cfg(feature = "trials")]
pub mod prelude;
#[cfg(feature = "book")]
pub mod publishing;
pub mod scalar;
pub mod seeded;
pub mod stop;
#[cfg(feature = "trials")]
pub mod theorems;
#[cfg(feature = "trials")]
pub mod trials;
