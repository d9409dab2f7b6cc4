//! Numbers enclosed, statements on whole ranges proved: Newton's law put to the tools of [`trialbook::certified`].
//!
//! [`drive`] and [`turntable`] know arcs and polynomial equations of motion, and nothing of the paper. [`numbers`] has
//! its numbers.
//!
//! ```
//! use slipbook_motion::validated::numbers::Q_Y;
//!
//! assert_eq!(Q_Y.decimal(50)?, "4.60333884875170035255658202910301651306739713416053");
//! # Ok::<(), trialbook::certified::error::CertifiedError>(())
//! ```

pub mod drive;
pub mod numbers;
pub mod turntable;
