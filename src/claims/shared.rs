//! What the claims of several topics have in common.

use trialbook::trials::read;

pub(super) const SHARED: read::File = read::claims!("claims/shared.toml");
