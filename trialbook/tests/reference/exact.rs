//! Verdicts of the exact ring against FLINT's (`exact.py`): which formulas are equal, and which only look so.

use crate::table::rows;
use trialbook::exact::{ExactError, Expr, Ring};
use trialbook::scalar::Scalar;

fn ring() -> Result<Ring, ExactError> {
    let mut ring = Ring::new();
    let [x, y, e] = ["x", "y", "e"].map(|name| ring.symbol(name));
    ring.angle("a");
    ring.angle("b");
    ring.hyperbolic("h");
    let one = ring.read(Expr::int(1))?;
    let two = ring.read(Expr::int(2))?;
    ring.root(&two, 2)?;
    ring.root(&x, 2)?;
    ring.root(&(&one + &(&y * &y)), 2)?;
    ring.power(&y, &e)?;
    ring.logarithm(&x)?;
    ring.logarithm(&y)?;
    Ok(ring)
}

fn formula(text: &str) -> Option<Expr> {
    let mut stack: Vec<Expr> = Vec::new();
    for token in text.chars() {
        let mut operand = || stack.pop();
        let next = match token {
            '0'..='9' => Expr::int(i64::from(token.to_digit(10)?)),
            'x' => Expr::symbol("x"),
            'y' => Expr::symbol("y"),
            'e' => Expr::symbol("e"),
            'a' => Expr::symbol("a"),
            'b' => Expr::symbol("b"),
            'h' => Expr::symbol("h"),
            'p' => Expr::pi(),
            '+' | '-' | '*' | '/' | '^' => {
                let (right, left) = (operand()?, operand()?);
                match token {
                    '+' => left + right,
                    '-' => left - right,
                    '*' => left * right,
                    '/' => left / right,
                    _ => left.pow(right),
                }
            }
            'N' => -operand()?,
            's' => operand()?.sin(),
            'c' => operand()?.cos(),
            't' => operand()?.tan(),
            'o' => operand()?.cot(),
            'S' => operand()?.sinh(),
            'C' => operand()?.cosh(),
            'T' => operand()?.tanh(),
            'O' => operand()?.coth(),
            'E' => operand()?.exp(),
            'L' => operand()?.ln(),
            'R' => operand()?.sqrt(),
            _ => return None,
        };
        stack.push(next);
    }
    stack.pop().filter(|_| stack.is_empty())
}

#[test]
fn the_verdicts_are_those_of_flint() {
    let ring = ring().expect("the ring is what it is declared to be");
    let read = |text| ring.read(formula(text).expect("a formula"));
    let mut counts = [0, 0];
    for [verdict, left, right] in rows(include_str!("exact.csv")) {
        let difference = || ring.is_zero(&(read(left)? - read(right)?));
        let equal = verdict == "1";
        assert_eq!(difference(), Ok(equal), "{left} and {right}");
        counts[usize::from(equal)] += 1;
    }
    assert!(
        counts.iter().sum::<usize>() == 10_000 && counts.iter().all(|n| *n > 4000),
        "{counts:?}"
    );
}
