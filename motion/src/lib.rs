//! What bodies do on a rough moving plane, from Newton's law and Coulomb's friction alone.
//!
//! A load on a truck that brakes, in everybody's units, by a [`scene`]:
//!
//! ```
//! use slipbook_motion::{Scene, scene::{Part, Until}};
//!
//! let load = Scene { frame: vec![Part::accelerate("-4.2m/s^2:4.79s,0")?], ..Scene::block(0.3) };
//! let end = load.run(Until::Stop)?.end()?;
//! assert!((end.way.0 - 20.603).abs() < 1e-3);
//! # Ok::<(), slipbook_motion::scene::SceneError>(())
//! ```
//!
//! A particle on a table that turns, in units in which μg and Ω are 1:
//!
//! ```
//! use slipbook_motion::{Fate, fate, turntable::Start};
//!
//! // From the axis with speed 0.4: it stops, and stays where it is.
//! let Fate::Rest { sigma, .. } = fate(&Start::launched(0.4)?)? else { panic!("it escapes") };
//! assert!(sigma < 1.0);
//! # Ok::<(), slipbook_motion::MotionError>(())
//! ```
//!
//! # How
//!
//! The plane is pulled with the acceleration A(t); in its frame a body feels −A per unit of mass. Dry friction adds μg against
//! the velocity while the body slides. At rest, friction holds it as long as it can, up to the same μg: the body starts to slide
//! when |A| exceeds μg, and not before. That is all the physics:
//!
//! ```text
//! sliding:   dv/dt = −A(t) − μg v/|v|
//! sticking:  v = 0 while |A(t)| ≤ μg
//! ```
//!
//! Where it holds more than it brakes, as static friction does, a [`Friction`] says so.
//!
//! A is how the plane accelerates in the laboratory; what the body on it feels is the opposite.
//!
//! ```text
//!      in the laboratory                on the plane
//!   ┌─────────────────────┐        ┌─────────────────────┐
//!   │                     │  A     │    −A               │
//!   │          ■          │ ───→   │   ←───── ■          │
//!   │                     │        │                     │
//!   └─────────────────────┘        └─────────────────────┘     ───→ x
//!     A = (2, 0): the plane          the block is pulled
//!     gets faster along x            along −x
//! ```
//!
//! Velocities and places are those on the plane, in axes that do not turn. What moves with a truck while that speeds up slides
//! against its A; where a formula of section 2.1 has the pull along x, as in [`Launch`], A is −A x̂.
//!
//! Two points with v = 0 need care. On the way to a stop the direction of v can turn infinitely fast; so sliding is integrated in
//! a time s that runs ever faster, dt = |v| ds, in which nothing is singular ([`run`]). And a body at rest whose friction is just
//! overcome has no direction yet; its first moments come from a power series in t about the start.
//!
//! A [`Spring`] may hold the block too: one more force in the same law. What is known of A(t) by its values alone,
//! from a function or a table, becomes pieces of polynomials with a stated error ([`Fitted`]). What a sensor on the body
//! has recorded says how large the friction is ([`measure`](mod@measure)).
//!
//! No solution in closed form is used here, not even as a first guess.
//!
//! [`validated`] encloses such motions, [`exam`] makes questions for physics engines of them, and [`explorers`] answers what the
//! figures of a book ask. The tools are [`numerics`].
//!
//! # Features
//!
//! `parallel`: ensembles on all cores. `trials`: enclosures, the exam, and motions as sides of trials. `explorers`: what figures ask. `sources`: the sources
//! as texts.
// What is public is promised.
#![cfg_attr(not(test), warn(unreachable_pub))]
// Where a module is not built, its name leads to the feature that brings it.
#![cfg_attr(
    not(feature = "trials"),
    doc = "",
    doc = "[`exam`]: #features",
    doc = "[`validated`]: #features"
)]
#![cfg_attr(not(feature = "explorers"), doc = "", doc = "[`explorers`]: #features")]

mod acceleration;
mod clock;
mod creep;
pub mod drive;
mod error;
#[cfg(feature = "trials")]
pub mod exam;
#[cfg(feature = "explorers")]
pub mod explorers;
mod fitted;
mod launch;
pub mod measure;
pub mod numerics;
mod onset;
mod particle;
pub mod scene;
mod signal;
pub mod sphere;
mod spring;
mod track;
mod trajectory;
pub mod turntable;
#[cfg(feature = "trials")]
pub mod validated;

pub use acceleration::{Acceleration, Plane, Series};
pub use error::MotionError;
pub use fitted::{Columns, FitError, Fitted, Recording};
pub use launch::Launch;
pub use measure::measure;
pub use numerics::taylor::Coefficients;
pub use onset::{Onset, onset};
pub use particle::{Friction, Line, run, run_to_stop};
pub use scene::Scene;
pub use signal::Signal;
pub use sphere::{Ball, Sphere};
pub use spring::{Spring, SpringMotion, SpringState};
pub use track::Track;
pub use trajectory::{Motion, Phase, PhaseKind, State};
pub use turntable::{Fate, Table, fate};

#[cfg(any(test, feature = "trials"))]
use trialbook::scalar;
#[cfg(feature = "trials")]
use trialbook::trials::runs::{Setting, failures};

#[cfg(feature = "trials")]
failures!(drive::DriveError, MotionError);

#[cfg(feature = "trials")]
impl Setting for drive::Drive {}

/// The sources of this crate, by their paths below `src`.
#[cfg(feature = "sources")]
pub static SOURCES: include_dir::Dir<'static> =
    include_dir::include_dir!("$CARGO_MANIFEST_DIR/src");
