//! The answers: comma-separated text below a line of headings.

use trialbook::certified::ball::Ball;

pub fn rows<const N: usize>(text: &'static str) -> impl Iterator<Item = [&'static str; N]> {
    text.lines().skip(1).map(|line| {
        let fields: Vec<_> = line.split(',').collect();
        fields.try_into().expect("as many fields as columns")
    })
}

pub fn number(field: &str) -> f64 {
    field.parse().expect("a number")
}

/// Within two units of the last of so many bits after the point.
pub fn ball(decimals: &str, bits: usize) -> Ball {
    let (sign, size) = match decimals.strip_prefix('-') {
        Some(size) => (-1, size),
        None => (1, decimals),
    };
    let (whole, part) = size.split_once('.').unwrap_or((size, ""));
    let ten = Ball::int(10, 0);
    let digits = whole.bytes().chain(part.bytes());
    let units = digits.fold(Ball::int(0, 0), |n, digit| {
        n * &ten + Ball::int(i64::from(digit - b'0'), 0)
    });
    let below = part.bytes().fold(Ball::int(1, 0), |n, _| n * &ten);
    let exact = (units * Ball::int(sign, 0)).with_bits(bits);
    exact.over(&below).expect("a power of ten is not zero")
}
