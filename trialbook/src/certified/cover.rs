//! Statements about whole ranges: a box is halved until the statement is plain on every part.

use super::{error::CertifiedError, interval::Interval};
use std::collections::VecDeque;

/// What a part of the range says about the statement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Said {
    /// It holds on all of the part.
    Holds,
    /// It fails on all of the part.
    Fails,
    /// The part is too large to tell.
    Nothing,
}

impl Said {
    /// That a quantity has the sign of `wanted` wherever it has a value. Where it has none it is unbounded: a slope at the
    /// end of a domain may be so.
    pub fn of_sign(quantity: Interval, wanted: f64) -> Said {
        match quantity.sign() {
            None => Said::Nothing,
            Some(sign) if sign == wanted => Said::Holds,
            Some(_) => Said::Fails,
        }
    }

    /// That a quantity that is exactly zero, or some other one, is zero as far as its bounded enclosure
    /// tells.
    pub fn of_zero(quantity: Interval) -> Said {
        if !quantity.contains(0.0) {
            Said::Fails
        } else if quantity.is_bounded() {
            Said::Holds
        } else {
            Said::Nothing
        }
    }

    /// That all of several statements hold.
    pub fn all(all: impl IntoIterator<Item = Said>) -> Said {
        let mut said = Said::Holds;
        for one in all {
            match one {
                Said::Fails => return Said::Fails,
                Said::Nothing => said = Said::Nothing,
                Said::Holds => {}
            }
        }
        said
    }

    /// That one of several statements holds on all of the part; different ones may hold on its halves.
    pub fn any(all: impl IntoIterator<Item = Said>) -> Said {
        if all.into_iter().any(|said| said == Said::Holds) {
            Said::Holds
        } else {
            Said::Nothing
        }
    }
}

/// Far more parts than any statement here needs.
const MOST: usize = 50_000;

/// Proves that `said` holds on all of `range`, by closed parts without gaps; returns how many there were.
///
/// # Errors
/// [`CertifiedError::False`] with a part on which it fails, [`CertifiedError::NotProved`] with a part that no
/// bisection made plain.
pub fn everywhere<const N: usize>(
    range: [Interval; N],
    said: impl Fn(&[Interval; N]) -> Said,
) -> Result<usize, CertifiedError> {
    // In order of size, so that a part on which it fails is met before one that no bisection settles.
    let mut open = VecDeque::from([range]);
    let mut parts = 0;
    while let Some(cell) = open.pop_front() {
        match said(&cell) {
            Said::Holds => parts += 1,
            Said::Fails => return Err(CertifiedError::failing(&cell)),
            Said::Nothing => {
                // A side without width, of which there is no part, is the last to be halved.
                let relative = |i: usize| match range[i].width() {
                    0.0 => 0.0,
                    width => cell[i].width() / width,
                };
                let widest = (0..N).max_by(|&i, &j| relative(i).total_cmp(&relative(j)));
                let side = widest.unwrap_or(0);
                let [a, b] = cell[side].halves();
                if parts + open.len() > MOST || a == cell[side] || b == cell[side] {
                    return Err(CertifiedError::open(&cell));
                }
                for half in [a, b] {
                    let mut part = cell;
                    part[side] = half;
                    open.push_back(part);
                }
            }
        }
    }
    Ok(parts)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certified::jet::{Jet, over};
    use crate::scalar::Scalar;

    fn above(bound: i64) -> Result<usize, CertifiedError> {
        // x² − 2x > bound − 1 on [0, 3]; the left side is at least −1.
        let f = |x: &[Interval; 1]| {
            let jet = over(|[x]| x.squared() - x - x - Jet::int(bound), x);
            Said::of_sign(jet.value, 1.0)
        };
        everywhere([Interval::new(0.0, 3.0)], f)
    }

    #[test]
    fn what_holds_is_proved_and_what_fails_is_refused() {
        assert!(above(-2).unwrap() > 1);
        // It touches: neither can be shown.
        assert!(matches!(above(-1), Err(CertifiedError::NotProved { .. })));
        assert!(matches!(above(0), Err(CertifiedError::False { .. })));
    }

    #[test]
    fn what_has_no_value_neither_has_a_sign_nor_is_zero() {
        let nowhere = Interval::new(2.0, 3.0).asin();
        for quantity in [
            nowhere,
            nowhere.sin(),
            nowhere - nowhere,
            nowhere.exp() + Interval::int(1),
        ] {
            let signs = [1.0, -1.0].map(|sign| Said::of_sign(quantity, sign));
            assert_eq!(signs, [Said::Nothing; 2], "{quantity}");
            assert_eq!(Said::of_zero(quantity), Said::Nothing, "{quantity}");
        }
        // Bounded on one side only it may be anything there.
        for half in [
            Interval::new(0.0, f64::INFINITY),
            Interval::new(f64::NEG_INFINITY, 0.0),
        ] {
            assert_eq!(Said::of_zero(half), Said::Nothing, "{half}");
        }
        let zero = [-1.0, 0.0, 1.0].map(|at| Said::of_zero(Interval::new(at, 2.0)));
        assert_eq!(zero, [Said::Holds, Said::Holds, Said::Fails]);
    }

    #[test]
    fn one_of_several() {
        use Said::{Fails, Holds, Nothing};
        assert_eq!(Said::any([Fails, Nothing, Holds]), Holds);
        assert_eq!(Said::any([Fails, Nothing]), Nothing);
        assert_eq!(Said::any([Fails, Fails]), Nothing);
        assert_eq!(Said::all([Holds, Nothing, Holds]), Nothing);
        assert_eq!(Said::all([Nothing, Fails]), Fails);
    }

    #[test]
    fn the_side_that_is_widest_against_its_range_is_halved() {
        let range = [Interval::new(0.0, 1.0), Interval::new(0.0, 1000.0)];
        let parts = everywhere(range, |[a, b]| {
            if a.width() <= 0.5 && b.width() <= 500.0 {
                Said::Holds
            } else {
                Said::Nothing
            }
        });
        assert_eq!(parts.unwrap(), 4);
    }

    #[test]
    fn a_side_without_width_is_not_halved() {
        // Plain on halves of the side that has width.
        let f = |[x, _]: &[Interval; 2]| {
            if x.width() < 0.75 {
                Said::Holds
            } else {
                Said::Nothing
            }
        };
        let (wide, point) = (Interval::new(0.0, 1.0), Interval::point(2.0));
        assert_eq!(everywhere([wide, point], f).unwrap(), 2);
        assert_eq!(everywhere([point, wide], |&[x, y]| f(&[y, x])).unwrap(), 2);
        let open = everywhere([point, point], |_| Said::Nothing);
        assert!(matches!(open, Err(CertifiedError::NotProved { .. })));
    }

    #[test]
    fn the_search_is_given_up_after_a_number_of_parts() {
        // So many parts are halved before the statement is plain everywhere.
        let after = |halved: usize| {
            let asked = std::cell::Cell::new(0);
            everywhere([Interval::new(0.0, 1.0)], |_| {
                asked.set(asked.get() + 1);
                if asked.get() > halved {
                    Said::Holds
                } else {
                    Said::Nothing
                }
            })
        };
        assert_eq!(after(MOST + 1).unwrap(), MOST + 2);
        assert!(matches!(
            after(MOST + 2),
            Err(CertifiedError::NotProved { .. })
        ));
    }
}
