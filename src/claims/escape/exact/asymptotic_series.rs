//! The motions that escape, as series in x = 1/τ with L = ln τ in the coefficients, found order by order.
//!
//! With u = ρ − p and δ = π/2 − ψ: ρ = τ² (q₀ + q₁ x + …), u = τ (u₀ + u₁ x + …), δ = x (d₀ + d₁ x + …), where the
//! coefficients of xᵏ are polynomials in L of degree k. The first order fixes q₀, u₀, d₀; a shift of τ leaves one constant
//! of the second order free, b.

use crate::claims::escape::prelude::*;

/// The laws are stated to the first order in x, logarithms being counted as numbers; two more follow.
const ORDER: i64 = 3;

/// To which power of τ^(−1/2) numbers are carried along.
const ENOUGH: i64 = 12;

/// Coefficients to be found at one order; the last one comes last.
const UNKNOWN: [&str; 12] = [
    "x₁", "x₂", "x₃", "x₄", "x₅", "x₆", "x₇", "x₈", "x₉", "x₁₀", "x₁₁", "x₀",
];

/// As series in τ^(−1/2).
#[derive(Debug, Clone)]
pub(crate) struct Late {
    pub p: Series,
    pub rho: Series,
    /// e^(2α) = (ρ + p)/(ρ − p).
    pub twice_alpha_exp: Series,
    pub a: Series,
    pub alpha_exp: Series,
    /// π/2 − ψ.
    pub lag: Series,
    /// Arc length.
    pub s: Series,
}

/// τ, ln τ as L, √2 and its root, b, and what is to be found.
pub(crate) fn ring() -> Result<Ring, ExactError> {
    let mut ring = Ring::new();
    for name in ["τ", "L", "b", "ρ", "u", "q"].iter().chain(&UNKNOWN) {
        ring.symbol(name);
    }
    ring.angle("δ");
    let two = ring.root(&Rational::int(2), 2)?;
    let root = ring.root(&two, 2)?;
    // For the cube root in (131).
    ring.root_is(&(&two * &root), 3, &root)?;
    Ok(ring)
}

/// dρ/dτ, du/dτ and dδ/dτ in terms of ρ, u and δ.
fn rates() -> [Expr; 3] {
    let [rho, u, delta] = symbols(["ρ", "u", "δ"]);
    let half = (delta / 2).sin();
    let p = rho - u;
    [
        p * delta.sin(),
        1 - u * delta.sin(),
        u.squared() / (rho * p) * delta.cos() - 4 * half.squared(),
    ]
}

/// They are (107) to (109).
fn rewritten(p: &mut Prover<'_>) -> Result<(), Obstacle> {
    rest_on(
        p,
        &[&turntable::EQ107, &turntable::EQ108, &turntable::EQ109],
    )?;
    let [rho, u, delta] = symbols(["ρ", "u", "δ"]);
    let psi = pi() / 2 - delta;
    let outwards = motion::eq108_rho_rate(rho - u, psi);
    let printed = [
        outwards,
        outwards - motion::eq107_p_rate(rho, psi),
        -motion::eq109_psi_rate(rho - u, rho, psi),
    ];
    let names = ["dρ/dτ", "d(ρ − p)/dτ", "d(π/2 − ψ)/dτ"];
    for ((name, printed), formula) in names.into_iter().zip(printed).zip(rates()) {
        let printed = p.read(
            &format!("{name} by (107) to (109), with p = ρ − u, ψ = π/2 − δ"),
            printed,
        )?;
        let rate = p.ring().read(formula)?;
        p.equal(&format!("It is {formula}"), &printed, &rate)?;
    }
    Ok(())
}

/// d/dτ of a series in τ^(−1/`root`).
pub(crate) fn rate(series: &Series, root: i64, ring: &Ring) -> Result<Series, ExactError> {
    let slower = ring.divide(&Rational::int(-1), &Rational::int(root))?;
    let moving = ring.along(&[("L", Rational::int(-root))])?;
    let euler = series.euler(&moving, ring)?.shifted(root);
    euler.map(|c| Ok(c * &slower))
}

/// What the series of ρ, u and δ lack to be a motion.
fn imbalance(ring: &Ring, own: &[Series; 3]) -> Result<Vec<Series>, ExactError> {
    let values = [("ρ", &own[0]), ("u", &own[1]), ("δ", &own[2])];
    let pairs = rates().into_iter().zip(own);
    pairs
        .map(|(formula, series)| {
            let found = ring.expand(formula, &values, ENOUGH)?;
            Ok(rate(series, 1, ring)?.minus(&found))
        })
        .collect()
}

/// The three equations at the order k, counted from their first.
fn at_order(ring: &Ring, own: &[Series; 3], k: i64) -> Result<Vec<Rational>, Obstacle> {
    let left = imbalance(ring, own)?;
    let orders = [k - 1, k, k + 2];
    let pick = |(series, order): (Series, i64)| series.coefficient(order).ok_or(Obstacle::Empty);
    left.into_iter().zip(orders).map(pick).collect()
}

/// Σ xₙ Lⁿ with the next unknowns.
fn polynomial(ring: &Ring, unknown: &[&str]) -> Result<Rational, ExactError> {
    let (mut sum, mut power) = (Rational::int(0), Rational::int(1));
    for name in unknown.iter().rev() {
        sum = sum + ring.named(name)? * &power;
        power = power * ring.named("L")?;
    }
    Ok(sum)
}

fn put(ring: &Ring, x: &Rational, known: &[(Rational, Rational)]) -> Result<Rational, ExactError> {
    let values: Vec<_> = known.iter().map(|(x, value)| (x, value)).collect();
    Ok(ring.normal(&ring.put(x, &values)?))
}

const STARTS: [i64; 3] = [-2, -1, 1];

fn series(coefficients: &[Vec<Rational>; 3]) -> [Series; 3] {
    [0, 1, 2].map(|i| Series::new(STARTS[i], coefficients[i].clone()))
}

/// The first order: q₀, u₀, d₀.
fn first(p: &mut Prover<'_>) -> Result<[Vec<Rational>; 3], Obstacle> {
    let ring = p.ring();
    let mut ansatz = [
        vec![ring.named("q")?],
        vec![ring.named("x₁")?],
        vec![ring.named("x₂")?],
    ];
    let left = at_order(ring, &series(&ansatz), 0)?;
    let solved = p.solve(
        "First order of dρ/dτ and du/dτ, for d₀ = x₂ and u₀ = x₁, q₀ being q",
        &left[..2],
        None,
        &["x₂", "x₁"],
    )?;
    let last = put(ring, &left[2], &solved)?;
    p.note("First order of dδ/dτ, which must vanish", ring.text(&last));
    let amplitude = p.read("Its positive root q", corrected::amplitude::<Expr>())?;
    let known = [(ring.named("q")?, amplitude)];
    p.zero("With that it vanishes", &put(ring, &last, &known)?)?;
    for series in &mut ansatz {
        for c in series {
            *c = put(ring, &put(ring, c, &solved)?, &known)?;
        }
    }
    Ok(ansatz)
}

fn solve(p: &mut Prover<'_>) -> Result<Late, Obstacle> {
    p.shows("ρ, u = ρ − p and δ = π/2 − ψ as series in 1/τ, whose coefficients are polynomials in ln τ, meet (107) to (109) at the first four orders; one constant, b, is left free.");
    rewritten(p)?;
    let ring = p.ring();
    p.note("To be found", "ρ = τ² (q₀ + q₁/τ + …), u = τ (u₀ + u₁/τ + …), δ = (d₀ + d₁/τ + …)/τ, by powers of L = ln τ");
    let mut found = first(p)?;
    let log = ring.named("L")?;
    for k in 1..=ORDER {
        let each = (k + 1) as usize;
        let unknown = &UNKNOWN[UNKNOWN.len() - 3 * each..];
        let mut next = found.clone();
        // ρ comes last, so that what is left free stands in it.
        for (i, part) in unknown.chunks(each).enumerate() {
            next[2 - i].push(polynomial(ring, part)?);
        }
        let left = at_order(ring, &series(&next), k)?;
        let solved = p.solve(
            &format!("Order {k}, for d, u, q as Σ xₙ Lⁿ in this order"),
            &left,
            Some(&log),
            unknown,
        )?;
        let free = ring.named("x₀")?;
        let shift = [(free.clone(), ring.named("b")?)];
        if k == 1 {
            p.note("Left free", "x₀ = b in q₁, which shifts τ");
        }
        for (own, next) in found.iter_mut().zip(next) {
            let Some(ansatz) = next.last() else { continue };
            let value = put(ring, ansatz, &solved)?;
            own.push(if k == 1 {
                put(ring, &value, &shift)?
            } else {
                value
            });
        }
    }
    let own = series(&found);
    for (name, series) in ["ρ", "u", "δ"].into_iter().zip(&own) {
        p.note(name, series.text("x", ring));
    }
    for k in 0..=ORDER {
        for left in at_order(ring, &own, k)? {
            p.zero(
                &format!("An equation of motion holds with these at the order {k}"),
                &left,
            )?;
        }
    }
    finish(p, &own.map(|series| series.in_root(2)))
}

fn finish(p: &mut Prover<'_>, [rho, u, delta]: &[Series; 3]) -> Result<Late, Obstacle> {
    let ring = p.ring();
    let speed = rho.minus(u);
    let sum = rho.plus(&speed);
    // s from ds/dτ = p, term by term.
    let mut way: Vec<Rational> = Vec::new();
    let log = ring.named("L")?;
    for k in 0..2 * ORDER {
        let unknown = &UNKNOWN[UNKNOWN.len() - 1 - (k / 2) as usize..];
        let ansatz = polynomial(ring, unknown)?;
        let trial = way.iter().cloned().chain([ansatz.clone()]);
        let left = rate(&Series::new(-6, trial.collect()), 2, ring)?.minus(&speed);
        let left = left.coefficient(k - 4).ok_or(Obstacle::Empty)?;
        let solved = ring.solve(&[left], Some(&log), unknown)?;
        way.push(put(ring, &ansatz, &solved)?);
    }
    let s = Series::new(-6, way);
    p.note("s, from ds/dτ = p, z being τ^(−1/2)", s.text("z", ring));
    let a_squared = u.times(&sum, ring);
    let twice_alpha_exp = sum.over(u, ring)?;
    let half = ring.divide(&Rational::int(1), &Rational::int(2))?;
    Ok(Late {
        a: a_squared.power(&half, ring)?,
        alpha_exp: twice_alpha_exp.power(&half, ring)?,
        twice_alpha_exp,
        p: speed,
        rho: rho.clone(),
        lag: delta.clone(),
        s,
    })
}

static SOLUTION: Derived<(Option<Late>, Proof)> =
    Derived::new(|| Proof::finding("The escape in powers of 1/τ and ln τ", ring(), solve));

pub(crate) fn from_series(
    title: &str,
    steps: impl FnOnce(&mut Prover<'_>, &Late) -> Result<(), Obstacle>,
) -> Proof {
    Proof::in_ring(title, ring(), |p| {
        SOLUTION.with(|(late, proof)| {
            p.rests_on(proof)?;
            steps(p, late.as_ref().ok_or(Obstacle::Empty)?)
        })
    })
}

/// A law in τ, with L for ln τ, as a series in τ^(−1/2).
pub(crate) fn law_series(p: &mut Prover<'_>, formula: Expr) -> Result<Series, Obstacle> {
    let tau = Series::monomial(Rational::int(1), -2, ENOUGH);
    p.expand(
        "The law, with z = τ^(−1/2)",
        formula,
        &[("τ", &tau)],
        ("z", ENOUGH),
    )
}

/// The first term of a law against that of a quantity; with `logarithm` also the term in (ln τ)/τ.
pub(crate) fn agree(
    p: &mut Prover<'_>,
    law: &Series,
    quantity: &Series,
    logarithm: bool,
) -> Result<(), Obstacle> {
    let ring = p.ring();
    p.note("The quantity", quantity.text("z", ring));
    let first = quantity.start();
    let at = |series: &Series, k| series.coefficient(k).ok_or(Obstacle::Empty);
    for k in law.start().min(first)..=first + 1 {
        p.equal(
            &format!("The two agree at the order z^{k}"),
            &at(law, k)?,
            &at(quantity, k)?,
        )?;
    }
    p.note(
        "What comes first is not zero",
        ring.text(&at(quantity, first)?),
    );
    if logarithm {
        let by = ring.by("L")?;
        let slope = |series| Ok::<_, Obstacle>(ring.derivative(&at(series, first + 2)?, &by)?);
        p.equal(
            "The two agree beside (ln τ)/τ",
            &slope(law)?,
            &slope(quantity)?,
        )?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_to_be_found_is_a_sum_of_powers_of_the_logarithm() {
        let ring = ring().unwrap();
        let found = polynomial(&ring, &["x₁", "x₂", "x₀"]).unwrap();
        let [x0, x1, x2, log] = symbols(["x₀", "x₁", "x₂", "L"]);
        let expected = ring.read(x0 + x2 * log + x1 * log * log).unwrap();
        assert!(ring.is_zero(&(found - expected)).unwrap());
    }

    #[test]
    fn the_way_grows_with_the_speed_at_three_orders() {
        let ring = ring().unwrap();
        SOLUTION.with(|(late, _)| {
            let late = late.as_ref().unwrap();
            // Two powers of τ^(−1/2) for each order, from τ³ on.
            assert_eq!([late.s.start(), late.s.order()], [-6, -1]);
            let growth = rate(&late.s, 2, &ring).unwrap();
            let left = growth.minus(&late.p);
            for power in left.start()..=left.order() {
                let left = left.coefficient(power).unwrap();
                assert!(ring.is_zero(&left).unwrap(), "{power}");
            }
        });
    }
}
