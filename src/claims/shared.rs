//! What the claims of several topics have in common.

use trialbook::trials::read;

/// The conditions and reasons that claims of several topics have.
pub(super) const SHARED: read::File = read::claims!("claims/shared.toml");
