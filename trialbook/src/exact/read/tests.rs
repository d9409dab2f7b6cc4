//! Reading against numbers, and what the ring must prove, refute and refuse.

use super::*;
use crate::scalar::Scalar;
use crate::seeded::{formulas, with};

fn ring() -> Result<Ring, ExactError> {
    let mut ring = Ring::new();
    for name in ["a", "b", "λ"] {
        ring.symbol(name);
    }
    ring.angle("θ");
    ring.angle("φ");
    ring.hyperbolic("α");
    Ok(ring)
}

fn same(ring: &Ring, x: Expr, y: Expr) -> Result<bool, ExactError> {
    ring.is_zero(&(ring.read(x)? - ring.read(y)?))
}

/// The generators of `ring()`, in order: π, a, b, λ, θ, tan θ/2, cos θ/2, φ, tan φ/2, cos φ/2, α, exp α/2.
fn point() -> [f64; 12] {
    let (theta, phi, alpha) = (0.7_f64, 1.9_f64, 0.4_f64);
    let half = |x: f64| [libm::tan(x / 2.0), libm::cos(x / 2.0)];
    let [u, h] = half(theta);
    let [w, k] = half(phi);
    let e = libm::exp(alpha / 2.0);
    [
        std::f64::consts::PI,
        1.3,
        0.6,
        2.2,
        theta,
        u,
        h,
        phi,
        w,
        k,
        alpha,
        e,
    ]
}

fn number(name: &str) -> Option<f64> {
    let index = ["π", "a", "b", "λ", "θ", "", "", "φ", "", "", "α"]
        .iter()
        .position(|n| *n == name);
    index.map(|i| point()[i])
}

formulas! {

symbols &[];

/// What the ring reads in all its ways.
pub fn readable<S: Scalar>(a: S, b: S, theta: S, phi: S, alpha: S) -> [S; 6] {
    let [one, two, three] = [1, 2, 3].map(S::int);
    let pi = S::pi();
    [
        (theta + two * phi - pi / two).sin() / (a - b).pow(-three),
        (three * theta / two - phi).cos() * (pi - phi).cot(),
        (theta / two - phi / two).tan() - (theta + pi).tan() * theta,
        (alpha / two).sinh() * (two * alpha).coth() - (-alpha).tanh(),
        (three * alpha).cosh() + (alpha / two - three * alpha).exp() * pi,
        -(a / (b * b) - b / a) / (one - a.squared()) - (a / b).pow(three),
    ]
}

/// The right sides of identities.
pub fn right_sides<S: Scalar>(theta: S, phi: S, alpha: S) -> [S; 6] {
    let [one, two] = [1, 2].map(S::int);
    [
        theta.sin() * phi.cos() + theta.cos() * phi.sin(),
        (one + theta.cos()) / two,
        (one - theta.cos()) / theta.sin(),
        one + two * alpha.sinh().squared(),
        two * alpha.tanh() / (one + alpha.tanh().squared()),
        -theta.cos(),
    ]
}

}

fn wrong<const N: usize>(name: &str, arguments: [Expr; N]) -> Vec<Vec<Expr>> {
    let formula = formulas::<Expr>().into_iter().find(|f| f.name == name);
    let formula = formula.expect("it stands above");
    let seeds = formula.seeds(&arguments).into_iter();
    seeds
        .map(|seed| with(seed, || (formula.value)(&arguments)))
        .collect()
}

#[test]
fn an_element_has_the_value_of_the_formula() -> Result<(), ExactError> {
    let ring = ring()?;
    let arguments = ["a", "b", "θ", "φ", "α"].map(Expr::symbol);
    let [a, b, theta, phi, alpha] = arguments;
    let right = readable(a, b, theta, phi, alpha);
    let mut read = 0;
    for formula in wrong("readable", arguments).into_iter().flatten() {
        let Ok(element) = ring.read(formula) else {
            continue;
        };
        let found = ring.normal(&element).value(&point());
        let expected = formula.evaluate(&number).unwrap_or(f64::NAN);
        assert!(
            (found - expected).abs() <= 1e-11 * (1.0 + expected.abs()),
            "{formula}: {found}, {expected}"
        );
        read += 1;
    }
    assert!(read > 80, "only {read} formulas could be read");
    for formula in right {
        ring.read(formula)?;
    }
    Ok(())
}

#[test]
fn identities_hold_and_their_wrong_variants_do_not() -> Result<(), ExactError> {
    let ring = ring()?;
    let arguments = ["θ", "φ", "α"].map(Expr::symbol);
    let [theta, phi, alpha] = arguments;
    let two = Expr::int(2);
    let left = [
        (theta + phi).sin(),
        (theta / two).cos().squared(),
        (theta / two).tan(),
        (two * alpha).cosh(),
        (two * alpha).tanh(),
        (Expr::pi() - theta).cos(),
    ];
    let mut refuted = 0;
    for (left, right) in left.into_iter().zip(right_sides(theta, phi, alpha)) {
        assert!(same(&ring, left, right)?, "{left} = {right}");
    }
    for right in wrong("right_sides", arguments) {
        for (left, right) in left.into_iter().zip(right) {
            let holds = same(&ring, left, right) == Ok(true);
            let [x, y] = [left, right].map(|f| f.evaluate(&number).unwrap_or(f64::NAN));
            assert_eq!(holds, (x - y).abs() < 1e-9, "{left} = {right}");
            refuted += usize::from(!holds);
        }
    }
    assert!(refuted > 80, "only {refuted} wrong variants");
    Ok(())
}

#[test]
fn derivatives_agree_with_difference_quotients() -> Result<(), ExactError> {
    let mut ring = ring()?;
    let u = ring.half_tangent("θ")?;
    let lambda = ring.named("λ")?;
    let power = ring.power(&u, &lambda)?;
    let [a, theta, l] = ["a", "θ", "λ"].map(Expr::symbol);
    let radicand = ring.read(Expr::int(1) + a * theta.sin())?;
    ring.root(&radicand, 2)?;
    ring.logarithm(&u)?;
    let half_tan = (theta / Expr::int(2)).tan();
    let formula = half_tan.pow(-l - Expr::int(2)) * (Expr::int(1) + a * theta.sin()).sqrt() * theta
        - half_tan.ln() * theta.cos();
    let at = |theta: f64| {
        let [u, h] = [libm::tan(theta / 2.0), libm::cos(theta / 2.0)];
        let mut values = point().to_vec();
        values[4..7].copy_from_slice(&[theta, u, h]);
        values.extend([
            libm::pow(u, 2.2),
            libm::sqrt(1.0 + 1.3 * libm::sin(theta)),
            libm::log(u),
        ]);
        values
    };
    let element = ring.read(formula)?;
    let slope = ring.derivative(&element, &ring.by("θ")?)?;
    let step = 1e-5;
    let quotient = (element.value(&at(0.7 + step)) - element.value(&at(0.7 - step))) / (2.0 * step);
    assert!((slope.value(&at(0.7)) - quotient).abs() < 1e-7 * quotient.abs());
    // With ln u at hand, even the exponent may vary: d(u^λ)/dλ = u^λ ln u.
    let by_exponent = ring.derivative(&power, &ring.by("λ")?)?;
    assert!(ring.is_zero(&(by_exponent - power * ring.read(half_tan.ln())?))?);
    Ok(())
}

#[test]
fn a_hyperbolic_change_of_variables() -> Result<(), ExactError> {
    // p′ = ρ cos ψ − 1 and ρ′ = p cos ψ, with p = A sinh α and ρ = A cosh α, where A′ and α′ are solved for.
    let mut ring = Ring::new();
    ring.symbol("A");
    ring.angle("ψ");
    ring.hyperbolic("α");
    let [a, psi, alpha] = ["A", "ψ", "α"].map(Expr::symbol);
    let (p, rho) = (a * alpha.sinh(), a * alpha.cosh());
    let rates = [
        ring.read(alpha.sinh())?,
        ring.read(psi.cos() - alpha.cosh() / a)?,
    ];
    let [a_rate, alpha_rate] = rates;
    let motion = ring.along(&[("A", a_rate), ("α", alpha_rate)])?;
    for (x, rate) in [(p, rho * psi.cos() - Expr::int(1)), (rho, p * psi.cos())] {
        let found = ring.derivative(&ring.read(x)?, &motion)?;
        assert!(ring.is_zero(&(found - ring.read(rate)?))?, "{x}");
    }
    Ok(())
}

#[test]
fn roots_and_inverse_functions() -> Result<(), ExactError> {
    let mut ring = ring()?;
    let sine = ring.read(Expr::symbol("φ").sin())?;
    let cosine = ring.read(Expr::symbol("φ").cos())?;
    ring.define("s", sine.clone())?;
    let phi = ring.named("φ")?;
    ring.inverse(Function::Asin, &sine, &phi)?;
    let one = Rational::int(1);
    ring.root_is(&(&one - &sine * &sine), 2, &cosine)?;
    let s = Expr::symbol("s");
    let one_e = Expr::int(1);
    assert!(same(
        &ring,
        (Expr::pi() + s.asin()).cos(),
        -(one_e - s.squared()).sqrt()
    )?);
    assert!(!same(
        &ring,
        (Expr::pi() + s.asin()).cos(),
        (one_e - s.squared()).sqrt()
    )?);
    assert!(ring.inverse(Function::Acos, &sine, &phi).is_err());
    assert!(ring.root_is(&sine, 2, &cosine).is_err());

    ring.root(&Rational::int(3), 2)?;
    let a = ring.named("a")?;
    let four_a = &Rational::int(4) * &a;
    let cube = ring.root(&four_a, 3)?;
    let a = Expr::symbol("a");
    let root = Expr::int(3).sqrt();
    assert!(same(&ring, one_e / root, root / Expr::int(3))?);
    assert!(same(
        &ring,
        one_e / (root - one_e),
        (root + one_e) / Expr::int(2)
    )?);
    assert!(!same(&ring, root, Expr::int(2))?);
    let third = (Expr::int(4) * a).pow(one_e / Expr::int(3));
    assert!(same(
        &ring,
        third.pow(Expr::int(4)),
        Expr::int(4) * a * third
    )?);
    assert_eq!(ring.text(&cube), "(4 a)^(1/3)");
    Ok(())
}

#[test]
fn what_has_no_meaning_is_refused() -> Result<(), ExactError> {
    let mut ring = ring()?;
    let [a, theta] = ["a", "θ"].map(Expr::symbol);
    let zero = theta.sin().squared() + theta.cos().squared() - Expr::int(1);
    let error = |x: Expr| ring.read(x).expect_err("has no meaning").to_string();
    assert!(error(a / zero).contains("which is zero"));
    assert!(error(Expr::symbol("nobody")).contains("nobody is not declared"));
    assert!(error((theta / Expr::int(3)).sin()).contains("not a sum of half multiples"));
    assert!(error((Expr::int(1000) * theta).sin()).contains("up to 32"));
    assert!(error(theta.cosh()).contains("hyperbolic"));
    assert!(error(a.pow(Expr::symbol("λ"))).contains("declared powers"));
    assert!(error(a.pow(Expr::int(1_000_000_000))).contains("from −64 to 64"));
    assert!(error(a.sqrt()).contains("declared powers"));
    assert!(error(a.ln()).contains("declared logarithms"));
    assert!(error(a.acos()).contains("not a declared angle"));
    assert!(ring.along(&[("π", Rational::int(1))]).is_err());
    assert!(ring.define("a", Rational::int(1)).is_err());
    assert!(ring.root(&Rational::int(2), 0).is_err());
    // With r² = 3, the divisor r² − 3 is zero though its text is not.
    let root = ring.root(&Rational::int(3), 2)?;
    let hidden = &root * &root - Rational::int(3);
    assert!(ring.divide(&Rational::int(1), &hidden).is_err());
    Ok(())
}

#[test]
fn a_function_has_so_many_halves_and_no_more() -> Result<(), ExactError> {
    let ring = ring()?;
    let [alpha, theta] = ["α", "θ"].map(Expr::symbol);
    for (n, known) in [(16, true), (17, false), (20, false), (-17, false)] {
        assert_eq!(
            ring.read((Expr::int(n) * alpha).exp()).is_ok(),
            known,
            "{n}"
        );
        assert_eq!(
            ring.read((Expr::int(n) * theta).sin()).is_ok(),
            known,
            "{n}"
        );
    }
    Ok(())
}

#[test]
fn what_stands_for_something_else_is_not_free() -> Result<(), ExactError> {
    let mut ring = ring()?;
    let twice = Rational::int(2) * ring.named("a")?;
    ring.define("s", twice)?;
    ring.define("half turn", Rational::generator(PI))?;
    assert!(ring.by("a").is_ok());
    for name in ["s", "half turn"] {
        let error = ring.by(name).unwrap_err();
        assert!(matches!(error, ExactError::NotFree { .. }), "{error}");
    }
    Ok(())
}

#[test]
fn a_root_of_a_product_finds_its_number_in_any_order() -> Result<(), ExactError> {
    for number_first in [true, false] {
        let mut ring = Ring::new();
        let (x, two) = (ring.symbol("x"), Rational::int(2));
        let radicands = if number_first { [two, x] } else { [x, two] };
        for radicand in &radicands {
            ring.root(radicand, 2)?;
        }
        let (x, int) = (Expr::symbol("x"), Expr::int);
        for (left, right) in [
            ((int(2) * x).sqrt(), int(2).sqrt() * x.sqrt()),
            ((int(8) * x).sqrt(), int(2) * int(2).sqrt() * x.sqrt()),
            ((x / int(2)).sqrt(), x.sqrt() * int(2).sqrt() / int(2)),
            ((int(9) * x).sqrt(), int(3) * x.sqrt()),
        ] {
            let difference = ring.read(left)? - ring.read(right)?;
            assert!(ring.is_zero(&difference)?, "{left} {right}");
        }
        assert!(ring.read((int(3) * x).sqrt()).is_err());
    }
    Ok(())
}

#[test]
fn a_branch_is_said() {
    type Declare = fn(&mut Ring, Rational, Rational) -> Result<(), ExactError>;
    let cases: [(Declare, &[&str]); 6] = [
        (|ring, x, _| ring.root_is(&x.pow(2), 2, &x), &["x"]),
        (|ring, x, _| ring.root_is(&x.pow(2), 2, &-x), &["−x"]),
        (|ring, x, _| ring.root_is(&x.pow(4), 2, &x.pow(2)), &[]),
        (
            |ring, _, sine| ring.inverse(Function::Asin, &sine, &ring.named("θ")?),
            &["π + 2 θ", "π − 2 θ"],
        ),
        (
            |ring, _, sine| {
                ring.define("λ", sine.clone())?;
                ring.inverse(Function::Asin, &sine, &ring.named("θ")?)?;
                let cosine = ring.read(Expr::symbol("θ").cos())?;
                ring.root_is(&(Rational::int(1) - &sine * &sine), 2, &cosine)
            },
            &[],
        ),
        (
            |ring, x, _| {
                ring.suppose_positive(&x - &Rational::int(1));
                Ok(())
            },
            &["x − 1"],
        ),
    ];
    for (declare, said) in cases {
        let mut ring = Ring::of(["x"]);
        ring.angle("θ");
        let (x, sine) = (Expr::symbol("x"), Expr::symbol("θ").sin());
        let [x, sine] = [x, sine].map(|f| ring.read(f).unwrap());
        declare(&mut ring, x.clone(), sine).unwrap();
        assert_eq!(ring.positive().into_iter().collect::<Vec<_>>(), said);
        // What has a root already would be 0 for some sign of it.
        assert!(ring.root(&x.pow(6), 2).is_err() && ring.root(&x.pow(3), 2).is_ok());
    }
}

#[test]
fn what_is_positive_by_its_form_is_told() {
    let mut ring = Ring::of(["x", "λ"]);
    ring.angle("θ");
    let [x, lambda, theta] = Expr::symbols(["x", "λ", "θ"]);
    let (one, own) = (Expr::int(1), ring.named("x").unwrap());
    ring.root(&own, 2).unwrap();
    let above = ring.read(lambda - one).unwrap();
    let (more, less) = (
        (lambda - one) * (x.squared() + x.sqrt()),
        lambda + theta.cos(),
    );
    for supposed in [false, true] {
        for (formula, expected) in [
            (x.squared() + x.sqrt(), true),
            (one + theta.cos(), true),
            (more, supposed),
            (-more, false),
            (less, false),
            (x - x, false),
        ] {
            let x = ring.read(formula).unwrap();
            assert_eq!(ring.is_positive(&x).unwrap(), expected, "{formula}");
        }
        ring.suppose_positive(above.clone());
    }
}
