//! Numbers enclosed, statements on whole ranges proved: Newton's law put to the tools of [`trialbook::certified`].
//!
//! [`drive`] and [`turntable`] know arcs and polynomial equations of motion, and nothing of the paper. [`values`] lists
//! the numbers.
//!
//! ```
//! use slipbook::certified::values;
//!
//! let q = values::find("q-Y").ok_or("no such value")?;
//! assert_eq!(q.decimal(50)?, "4.60333884875170035255658202910301651306739713416053");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod drive;
pub mod turntable;
pub mod values;

pub use trialbook::certified::*;
