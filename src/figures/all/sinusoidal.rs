//! The figures of section 2.2, from what its trials compare.

use super::AllFiguresError;
use crate::claims::sinusoidal::drawn;
use crate::figures::sinusoidal;
use trialbook::claims::compare::Failure;
use trialbook::figures::Figure;

/// The figures of section 2.2.
pub(super) fn figures() -> Result<Vec<Figure>, AllFiguresError> {
    let said = |error: Failure| AllFiguresError::Data(error.to_string());
    let curves = drawn::transients().map_err(said)?;
    let panel = |lambda: f64, title: &str| {
        let own = curves.iter().filter(|curve| curve.lambda == lambda);
        let shown = |curve: &drawn::Transient| sinusoidal::Transient {
            lambda,
            w_y: curve.w_y,
            points: curve.states.iter().map(|s| [s.phi, s.w_x]).collect(),
        };
        (title.to_owned(), own.map(shown).collect())
    };
    let two_periods = |lambda: f64| drawn::two_periods(lambda).map_err(said);
    let (small, large) = (two_periods(drawn::SMALL)?, two_periods(drawn::LARGE)?);
    let decay = |lambda: f64| -> Result<_, AllFiguresError> {
        let points = drawn::depths(lambda).map_err(said)?;
        Ok(sinusoidal::Decay { lambda, points })
    };
    let periodic = |lambda: f64| -> Result<_, AllFiguresError> {
        let mut points = drawn::two_periods(lambda).map_err(said)?;
        points.truncate(points.len() / 2 + 1);
        Ok(sinusoidal::Periodic { lambda, points })
    };
    let decays: Result<Vec<_>, _> = [0.1, 0.2, 0.3, 0.45].into_iter().map(decay).collect();
    let family: Result<Vec<_>, _> = [0.1, 0.3, 0.5, 0.6, 0.8]
        .into_iter()
        .map(periodic)
        .collect();
    Ok(vec![
        sinusoidal::fig2(&[
            panel(drawn::SMALL, "λ_0 = 1/π"),
            panel(drawn::LARGE, "λ_0 = 1/√2"),
        ])?,
        sinusoidal::two_periods(&sinusoidal::TwoPeriods {
            id: "fig-3",
            lambda: "1/π",
            top: 1.0,
            mark: 0.8,
            points: &small,
        })?,
        sinusoidal::two_periods(&sinusoidal::TwoPeriods {
            id: "fig-4",
            lambda: "1/√2",
            top: 0.35,
            mark: 0.3,
            points: &large,
        })?,
        sinusoidal::decay(&decays?)?,
        sinusoidal::rest_share(&drawn::rest_shares().map_err(said)?, drawn::critical())?,
        sinusoidal::family(&family?)?,
    ])
}
