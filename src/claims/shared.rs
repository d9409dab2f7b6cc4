//! What the claims of several topics have in common.

use trialbook::claims::read;

/// The conditions and reasons that claims of several topics have.
pub const SHARED: read::File = read::claims!("../../claims/shared.toml");
