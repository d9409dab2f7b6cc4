//! Krawczyk's test of a root, with intervals of f64 and nothing of the crate.

use serde_json::Value;

/// From a number to another; each operation goes a little farther than rounding can.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Span(f64, f64);

/// What libm's functions may be off, relative to 1 and to their size.
const OFF: f64 = 1e-15;

impl Span {
    fn point(x: f64) -> Self {
        Span(x, x)
    }

    fn about(low: f64, high: f64) -> Self {
        Span(low.next_down(), high.next_up())
    }

    fn wide(low: f64, high: f64) -> Self {
        let off = |x: f64| OFF * (1.0 + x.abs());
        Span(low - off(low), high + off(high))
    }

    fn add(self, other: Self) -> Self {
        Self::about(self.0 + other.0, self.1 + other.1)
    }

    fn neg(self) -> Self {
        Span(-self.1, -self.0)
    }

    fn sub(self, other: Self) -> Self {
        self.add(other.neg())
    }

    fn mul(self, other: Self) -> Self {
        let all = [
            self.0 * other.0,
            self.0 * other.1,
            self.1 * other.0,
            self.1 * other.1,
        ];
        let [low, high] = [f64::min, f64::max].map(|f| all.into_iter().fold(all[0], f));
        Self::about(low, high)
    }

    fn over(self, other: Self) -> Option<Self> {
        let inverse = Self::about(1.0 / other.1, 1.0 / other.0);
        (other.0 > 0.0 || other.1 < 0.0).then(|| self.mul(inverse))
    }

    fn middle(self) -> f64 {
        0.5 * (self.0 + self.1)
    }

    fn inside(self, other: Self) -> bool {
        other.0 < self.0 && self.1 < other.1
    }

    /// sin(x + `turn` π/2) for 0 or 1: its extremes lie at odd multiples of π/2, less the turn.
    fn sine(self, turn: f64) -> Self {
        let quarter = std::f64::consts::FRAC_PI_2;
        let at = |x: f64| if turn == 0.0 { x.sin() } else { x.cos() };
        let (mut low, mut high) = (at(self.0).min(at(self.1)), at(self.0).max(at(self.1)));
        for k in -6..6 {
            let extreme = (f64::from(2 * k + 1) - turn) * quarter;
            if self.0 - 1e-9 <= extreme && extreme <= self.1 + 1e-9 {
                if k % 2 == 0 { high = 1.0 } else { low = -1.0 }
            }
        }
        assert!(self.0 > -9.0 && self.1 < 9.0, "{self:?}");
        Self::wide(low, high)
    }

    fn root(self) -> Option<Self> {
        (self.0 > 0.0).then(|| Self::wide(self.0.sqrt(), self.1.sqrt()))
    }
}

/// A value with its slopes.
type Sloped = (Span, Vec<Span>);

struct Place<'a> {
    names: &'a [Value],
    cell: Vec<Span>,
}

impl Place<'_> {
    fn constant(&self, value: Span) -> Sloped {
        (value, vec![Span::point(0.0); self.cell.len()])
    }

    fn chain((_, slopes): &Sloped, value: Span, slope: Span) -> Sloped {
        (value, slopes.iter().map(|s| s.mul(slope)).collect())
    }

    /// A formula's value and slopes on the box; `None` if it may have none.
    fn of(&self, tree: &Value) -> Option<Sloped> {
        if let Some(leaf) = tree.as_str() {
            if let Some(i) = self.names.iter().position(|name| name == leaf) {
                let mut x = self.constant(self.cell[i]);
                x.1[i] = Span::point(1.0);
                return Some(x);
            }
            return match leaf {
                "π" => {
                    Some(self.constant(Span::about(std::f64::consts::PI, std::f64::consts::PI)))
                }
                _ => Some(self.constant(Span::point(leaf.parse().ok()?))),
            };
        }
        let name = tree[0].as_str()?;
        let x = self.of(&tree[1])?;
        let one = Span::point(1.0);
        let Some(y) = tree.get(2) else {
            let chain = |value, slope| Some(Self::chain(&x, value, slope));
            return match name {
                "-" => chain(x.0.neg(), one.neg()),
                "sin" => chain(x.0.sine(0.0), x.0.sine(1.0)),
                "cos" => chain(x.0.sine(1.0), x.0.sine(0.0).neg()),
                "cot" => {
                    let sine = x.0.sine(0.0);
                    let slope = one.neg().over(sine.mul(sine))?;
                    chain(x.0.sine(1.0).over(sine)?, slope)
                }
                "√" => chain(x.0.root()?, one.over(x.0.root()?.add(x.0.root()?))?),
                "arcsin" => {
                    let slope = one.over(one.sub(x.0.mul(x.0)).root()?)?;
                    chain(Span::wide(x.0.0.asin(), x.0.1.asin()), slope)
                }
                _ => None,
            };
        };
        let y = self.of(y)?;
        let both = |value, by_x: Span, by_y: Span| {
            let slopes = x.1.iter().zip(&y.1);
            let slopes = slopes.map(|(a, b)| a.mul(by_x).add(b.mul(by_y)));
            Some((value, slopes.collect()))
        };
        match name {
            "+" => both(x.0.add(y.0), one, one),
            "-" => both(x.0.sub(y.0), one, one.neg()),
            "*" => both(x.0.mul(y.0), y.0, x.0),
            "/" => {
                let quotient = x.0.over(y.0)?;
                both(quotient, one.over(y.0)?, quotient.neg().over(y.0)?)
            }
            _ => None,
        }
    }
}

/// A number m·2^e, to the nearest f64.
pub fn number(text: &Value) -> f64 {
    let text = text.as_str().unwrap();
    let (mantissa, exponent) = text.split_once("*2^").unwrap_or((text, "0"));
    mantissa.parse::<f64>().unwrap() * exponent.parse::<f64>().unwrap().exp2()
}

/// Whether a root is the only one of its box, and where it is said to be; or what is wrong.
pub fn check(witness: &Value) -> Result<(), &'static str> {
    let list = |key: &str| witness[key].as_array().unwrap().as_slice();
    let (names, functions) = (list("variables"), list("functions"));
    let n = names.len();
    let on = |cell: Vec<Span>| {
        let place = Place { names, cell };
        let values = functions
            .iter()
            .map(|f| place.of(f))
            .collect::<Option<Vec<_>>>();
        values.ok_or("no value")
    };
    let within: Vec<_> = list("within")
        .iter()
        .map(|side| Span(number(&side[0]), number(&side[1])))
        .collect();
    for (end, values) in list("corners").iter().enumerate() {
        let corner = within
            .iter()
            .map(|x| Span::point(if end == 0 { x.0 } else { x.1 }));
        for ((value, _), stored) in on(corner.collect())?.iter().zip(values.as_array().unwrap()) {
            let off = value.middle() - number(stored) * (-30.0_f64).exp2();
            if off.abs() > 0.51 * (-30.0_f64).exp2() {
                return Err("a corner");
            }
        }
    }
    let c: Vec<Vec<_>> = list("preconditioner")
        .iter()
        .map(|row| {
            row.as_array()
                .unwrap()
                .iter()
                .map(|x| Span::point(number(x)))
                .collect()
        })
        .collect();
    // m − C f(m) + (1 − C f′) (X − m)
    let image = |x: &[Span]| {
        let middle: Vec<_> = x.iter().map(|x| Span::point(x.middle())).collect();
        let (at, of) = (on(middle.clone())?, on(x.to_vec())?);
        let row = |i: usize| {
            let mut k = middle[i];
            for j in 0..n {
                k = k.sub(c[i][j].mul(at[j].0));
                let unit = Span::point(if i == j { 1.0 } else { 0.0 });
                let product = (0..n).fold(unit, |rest, l| rest.sub(c[i][l].mul(of[l].1[j])));
                k = k.add(product.mul(x[j].sub(middle[j])));
            }
            k
        };
        Ok::<Vec<_>, &'static str>((0..n).map(row).collect())
    };
    let mut x = image(&within)?;
    if x.iter().zip(&within).any(|(k, side)| !k.inside(*side)) {
        return Err("the image");
    }
    for _ in 0..20 {
        let next = image(&x)?;
        x = x
            .iter()
            .zip(&next)
            .map(|(a, b)| Span(a.0.max(b.0), a.1.min(b.1)))
            .collect();
    }
    let near = |(x, root): (&Span, &Value)| {
        let (_, unit) = root.as_str().unwrap().split_once("*2^").unwrap();
        let half = 0.51 * unit.parse::<f64>().unwrap().exp2();
        (x.middle() - number(root)).abs() < half + x.1 - x.0
    };
    let narrow = x.iter().all(|x| x.1 - x.0 < 1e-11);
    if narrow && x.iter().zip(list("root")).all(near) {
        Ok(())
    } else {
        Err("the root")
    }
}
