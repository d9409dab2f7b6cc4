//! The figures of section 3.

use super::AllFiguresError;
use crate::claims::sphere::drawn;
use crate::figures::sphere::{Swinging, swinging, times};
use trialbook::figures::Figure;

/// λ₀ below λ_c, between λ_c and 1, above 1.
const LAMBDAS: [f64; 3] = [0.3, 0.75, 1.2];

pub(super) fn figures() -> Result<Vec<Figure>, AllFiguresError> {
    let motions: Vec<Swinging> = drawn::swinging(&LAMBDAS)?
        .into_iter()
        .map(|motion| Swinging {
            lambda: motion.lambda,
            points: motion.points,
            rolls: motion.rolls,
        })
        .collect();
    Ok(vec![
        times(&drawn::times_over_printed()?)?,
        swinging(&motions)?,
    ])
}
