//! Whether two trees are the same formula.

use slipbook::exact::{Binary, ExactError, Expr, Function, Node, Rational, Ring};
use slipbook::numerics::double::Double;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Same {
    Proved,
    Measured,
}

const POINTS: usize = 20;
const TRIED: u32 = 400;
/// Relative. Each operation is right to 1e-31, on numbers of order one; the largest loss is some thousand-fold. No slip of the
/// pen is so small.
const TOLERANCE: f64 = 1e-27;

pub fn same(a: Expr, b: Expr) -> Result<Same, String> {
    if let Some(why) = differ(a, b) {
        return Err(why);
    }
    Ok(match Atoms::default().difference_is_zero(a, b) {
        Ok(true) => Same::Proved,
        Ok(false) | Err(_) => Same::Measured,
    })
}

pub fn differ(a: Expr, b: Expr) -> Option<String> {
    if a == b {
        return None;
    }
    let mut compared = 0;
    for point in 0..TRIED {
        let value = |tree: Expr| tree.evaluate(&|name| Some(Double::from(coordinate(name, point))));
        let (x, y) = (value(a)?, value(b)?);
        let off = f64::from(x - y).abs();
        let [x, y] = [x, y].map(f64::from);
        let scale = x.abs().max(y.abs()).max(1e-3);
        if x.is_finite() != y.is_finite() || off > TOLERANCE * scale {
            return Some(format!("{a} is {x}, {b} is {y}, {off:e} apart"));
        }
        compared += usize::from(x.is_finite());
        if compared == POINTS {
            return None;
        }
    }
    Some(format!("{a} and {b} have {compared} values"))
}

/// For half of the points between 0.1 and 0.9, where the paper's ratios lie; then between −2 and 2, for what holds with the other
/// sign or beyond 1.
fn coordinate(name: &str, point: u32) -> f64 {
    let seed = name.bytes().fold(u64::from(point), |seed, byte| {
        seed.wrapping_mul(0x0100_0000_01b3) ^ u64::from(byte)
    });
    let share = fastrand::Rng::with_seed(seed).f64();
    if point.is_multiple_of(2) {
        0.1 + 0.8 * share
    } else {
        4.0 * share - 2.0
    }
}

/// A ring in which each elementary function, and each power that is not whole, is a symbol; the same one for arguments whose
/// difference is zero. So what is zero there is zero.
#[derive(Default)]
struct Atoms {
    ring: Ring,
    known: Vec<(Atom, Rational)>,
}

enum Atom {
    Call(Function, Rational),
    Power(Rational, Rational),
}

impl Atoms {
    fn difference_is_zero(mut self, a: Expr, b: Expr) -> Result<bool, ExactError> {
        let difference = self.read(a)? - self.read(b)?;
        self.ring.is_zero(&difference)
    }

    fn read(&mut self, tree: Expr) -> Result<Rational, ExactError> {
        Ok(match tree.node() {
            Node::Int(n) => Rational::int(n),
            Node::Pi => self.ring.read(tree)?,
            Node::Symbol(name) => self.ring.symbol(name),
            Node::Neg(x) => -self.read(x)?,
            Node::Call(function, x) => {
                let x = self.read(x)?;
                self.atom(Atom::Call(function, x))?
            }
            Node::Binary(op, x, y) => {
                let (x, y) = (self.read(x)?, self.read(y)?);
                match op {
                    Binary::Add => x + y,
                    Binary::Sub => x - y,
                    Binary::Mul => x * y,
                    Binary::Div => self.ring.divide(&x, &y)?,
                    Binary::Pow => self.raise(x, y)?,
                }
            }
        })
    }

    fn raise(&mut self, base: Rational, exponent: Rational) -> Result<Rational, ExactError> {
        let whole = exponent.as_integer().and_then(|n| i32::try_from(n).ok());
        match whole.filter(|n| n.abs() <= 8) {
            Some(n) => {
                let power = base.pow(n.unsigned_abs());
                if n < 0 {
                    self.ring.divide(&Rational::int(1), &power)
                } else {
                    Ok(power)
                }
            }
            None => self.atom(Atom::Power(base, exponent)),
        }
    }

    fn atom(&mut self, atom: Atom) -> Result<Rational, ExactError> {
        for (known, value) in &self.known {
            let equal = |x: &Rational, y: &Rational| self.ring.is_zero(&(x - y));
            let same = match (known, &atom) {
                (Atom::Call(f, x), Atom::Call(g, y)) => f == g && equal(x, y)?,
                (Atom::Power(x, e), Atom::Power(y, f)) => equal(x, y)? && equal(e, f)?,
                _ => false,
            };
            if same {
                return Ok(value.clone());
            }
        }
        // Names of symbols live as long as the program.
        let name = format!("f{}", self.known.len()).leak();
        let value = self.ring.symbol(name);
        self.known.push((atom, value.clone()));
        Ok(value)
    }
}

#[test]
fn the_same_formula_is_told_from_others() {
    use slipbook::scalar::Scalar;
    let [x, y] = ["x", "y"].map(Expr::symbol);
    let two = Expr::int(2);
    let half = |x: Expr| (x / two).tan();
    assert_eq!(
        same((x + y).squared(), x * x + two * x * y + y * y),
        Ok(Same::Proved)
    );
    assert_eq!(
        same(half(x + y).pow(y), half(y + x).pow(y)),
        Ok(Same::Proved)
    );
    assert_eq!(
        same(x.sin().squared() + x.cos().squared(), two - Expr::int(1)),
        Ok(Same::Measured)
    );
    assert!(same(x.squared().sqrt(), x).is_err());
    assert!(same(x.asin(), x.acos()).is_err());
    assert!(same((x.squared() + two).asin(), y).is_err());
}
