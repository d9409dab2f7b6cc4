//! Linear factors of polynomials in one generator, by their rational roots: they keep fractions small.

use super::polynomial::Polynomial;
use dashu_int::IBig;

/// |p| and q up to this.
const LARGEST: i64 = 12;

impl Polynomial {
    /// Factors q x − p with small whole p and q, each as often as it occurs, and what is left; with more than
    /// one generator, nothing is split off.
    pub(super) fn split_linear(self) -> (Vec<(Polynomial, u32)>, Polynomial) {
        let degrees = self.degrees();
        let mut found = Vec::new();
        let Some((&g, &degree)) = degrees.first_key_value().filter(|_| degrees.len() == 1) else {
            return (found, self);
        };
        if degree < 2 {
            return (found, self);
        }
        let coefficients = self.coefficients_in(g);
        let mut ends = coefficients.values().map(Polynomial::as_constant);
        let (first, last) = (ends.next().flatten(), ends.next_back().flatten());
        let (Some(first), Some(last)) = (first, last) else {
            return (found, self);
        };
        let divides = |n: i64, whole: &IBig| whole % IBig::from(n) == IBig::ZERO;
        let mut rest = self;
        for q in (1..=LARGEST).filter(|q| divides(*q, &last)) {
            for p in (1..=LARGEST).flat_map(|p| [p, -p]) {
                // Where p and q have a common divisor, the factor without it has been split off before.
                if !divides(p, &first) {
                    continue;
                }
                let x = Polynomial::generator(g).scale(&IBig::from(q));
                let factor = &x + &Polynomial::constant(IBig::from(-p));
                let mut power = 0;
                while let Some(quotient) = rest.divide_exact(&factor) {
                    rest = quotient;
                    power += 1;
                }
                if power > 0 {
                    found.push((factor, power));
                }
            }
        }
        (found, rest)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factors_and_what_is_left_make_up_the_polynomial() {
        let x = Polynomial::generator(0);
        let number = |n: i64| Polynomial::constant(IBig::from(n));
        let [a, b] = [&(&number(2) * &x) + &number(-3), &x + &number(1)];
        let no_root = &(&x * &x) + &number(1);
        let whole = &(&a * &a) * &(&b * &no_root);
        let (factors, rest) = whole.clone().split_linear();
        assert_eq!(rest, no_root);
        assert_eq!(factors, [(b, 1), (a, 2)]);
        let product = factors
            .iter()
            .fold(rest, |product, (f, k)| &product * &f.pow(*k));
        assert_eq!(product, whole);
        let mixed = &(&x * &x) + &(&x * &Polynomial::generator(1));
        assert!(mixed.split_linear().0.is_empty());
    }

    #[test]
    fn factors_come_by_the_denominators_and_numerators_of_their_roots() {
        let x = Polynomial::generator(0);
        let linear =
            |q: i64, p: i64| &x.scale(&IBig::from(q)) + &Polynomial::constant(IBig::from(-p));
        // By q, then by |p|, positive roots first.
        let factors = [
            linear(1, 1),
            linear(1, -1),
            linear(1, 12),
            linear(2, 3),
            linear(3, 2),
            linear(3, -4),
        ];
        let whole = factors
            .iter()
            .fold(Polynomial::one(), |product, f| &product * f);
        let (found, rest) = whole.split_linear();
        assert_eq!(found, factors.map(|f| (f, 1)));
        assert_eq!(rest, Polynomial::one());
        // The smallest that is split; one that is linear stays, and so does a root beyond the largest.
        let square = &linear(1, 1) * &linear(1, -1);
        assert_eq!(square.split_linear().0.len(), 2);
        assert_eq!(linear(2, 3).split_linear(), (Vec::new(), linear(2, 3)));
        let far = &linear(1, 13) * &linear(1, 17);
        assert!(far.split_linear().0.is_empty());
        // A content stays in what is left.
        let twice = (&linear(1, 1) * &linear(1, -1)).scale(&IBig::from(12));
        let (found, rest) = twice.split_linear();
        assert_eq!(found, [(linear(1, 1), 1), (linear(1, -1), 1)]);
        assert_eq!(rest, Polynomial::constant(IBig::from(12)));
    }
}
