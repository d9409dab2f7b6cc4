//! Every proof holds, and fails for every formula that differs in one place and is not the same in value.

use super::*;
use crate::exact::mutations;

/// A formula and what proves it.
type Provable = (&'static str, Expr, Box<dyn Fn(Expr) -> Proof>);

fn provable() -> Vec<Provable> {
    let [lambda0, phi] = symbols(["λ₀", "φ"]);
    let (phi1, phi3) = (paper::eq27_phi1(lambda0), paper::eq29_phi3(lambda0));
    let turn = paper::eq39_phi_t1(lambda0);
    let cases33 = paper::eq33_w(lambda0, phi1, phi3, phi);
    let cases38 = paper::eq38_w(lambda0, turn, phi);
    let ends38 = paper::eq38_ends(turn);
    let sides36 = paper::eq36_sides(lambda0);
    let sides40 = paper::eq40_sides(lambda0);
    vec![
        (
            "26+",
            eq26_rate(),
            Box::new(|rate| prove_eq26(units(), rate, 1)),
        ),
        (
            "26−",
            eq26_rate(),
            Box::new(|rate| prove_eq26(units(), rate, -1)),
        ),
        ("21", units()[0], Box::new(|x| defined(0, x))),
        ("22", units()[1], Box::new(|x| defined(1, x))),
        ("23", units()[2], Box::new(|x| defined(2, x))),
        ("24", units()[3], Box::new(|x| defined(3, x))),
        ("27", phi1, Box::new(|phase| prove_phase(phase, 1))),
        (
            "28",
            paper::eq28_phi2(lambda0),
            Box::new(|phase| prove_phase(phase, 1)),
        ),
        ("29", phi3, Box::new(|phase| prove_phase(phase, -1))),
        (
            "30",
            paper::eq30_phi4(lambda0),
            Box::new(|phase| prove_phase(phase, -1)),
        ),
        (
            "31",
            paper::eq31_w(lambda0, phi1, phi),
            Box::new(prove_eq31),
        ),
        (
            "33 forward",
            cases33[0],
            Box::new(move |w| prove_eq33([w, cases33[1], cases33[2], cases33[3]])),
        ),
        (
            "33 backward",
            cases33[2],
            Box::new(move |w| prove_eq33([cases33[0], cases33[1], w, cases33[3]])),
        ),
        (
            "25",
            paper::eq25_sides(lambda0)[0],
            Box::new(move |left| prove_eq25([left, paper::eq25_sides(lambda0)[1]])),
        ),
        (
            "25 right",
            paper::eq25_sides(lambda0)[1],
            Box::new(move |right| prove_eq25([paper::eq25_sides(lambda0)[0], right])),
        ),
        ("32", eq32_left(), Box::new(prove_eq32)),
        ("34", eq34_left(), Box::new(prove_eq34)),
        ("35", paper::eq35_left(lambda0), Box::new(prove_eq35)),
        (
            "36",
            sides36[1],
            Box::new(move |right| prove_eq36([sides36[0], right])),
        ),
        ("37", paper::eq37_lambda_c(), Box::new(prove_eq37)),
        (
            "38 forward",
            cases38[0],
            Box::new(move |w| prove_eq38([w, cases38[1]], ends38)),
        ),
        (
            "38 backward",
            cases38[1],
            Box::new(move |w| prove_eq38([cases38[0], w], ends38)),
        ),
        ("39", turn, Box::new(prove_eq39)),
        (
            "40",
            sides40[1],
            Box::new(move |right| prove_eq40([sides40[0], right])),
        ),
    ]
}

/// The use of (21) to (24) with one of them changed.
fn defined(place: usize, formula: Expr) -> Proof {
    let mut all = units();
    all[place] = formula;
    prove_eq26(all, eq26_rate(), 1)
}

/// A number for each symbol; 𝔴 of the sign that the proof is about.
fn number(sign: f64) -> impl Fn(&str) -> Option<f64> {
    move |name| {
        Some(match name {
            "λ₀" => 0.31,
            "φ" => 1.83,
            "φ̃₂" => 2.41,
            "A₀" => 1.3,
            "ϖ" => 0.7,
            "t" => 2.9,
            "μ" => 0.43,
            "g" => 9.1,
            "v_x" => 0.57,
            "𝔴" => 0.7 * sign,
            _ => return None,
        })
    }
}

#[test]
fn proofs_hold_for_the_printed_formulas_and_for_nothing_else() {
    let (mut refuted, mut same) = (0, 0);
    for (name, formula, prove) in provable() {
        let proof = prove(formula);
        assert!(proof.holds(), "{name}\n{proof}");
        let value = number(if name == "26−" { -1.0 } else { 1.0 });
        let ours = formula.evaluate(&value).expect("all symbols are known");
        for mutation in mutations(formula) {
            let proof = prove(mutation.formula);
            let theirs = mutation.formula.evaluate(&value).expect("the same symbols");
            let equal = (ours - theirs).abs() < 1e-12;
            // These proofs know a phase by its sine or its cosine only; which of two it is, the motions tell.
            let mirrored = match name {
                "27" | "28" | "29" | "30" => (libm::sin(ours) - libm::sin(theirs)).abs() < 1e-12,
                "39" => (libm::cos(ours) - libm::cos(theirs)).abs() < 1e-12,
                // λ_c stands in them by its square.
                "36" | "40" => (ours + theirs).abs() < 1e-12,
                _ => false,
            };
            let expected = equal || mirrored;
            assert_eq!(
                proof.holds(),
                expected,
                "{name}, {}\n{proof}",
                mutation.change
            );
            if expected { same += 1 } else { refuted += 1 }
        }
    }
    println!("{refuted} mutants refuted, {same} the same in value");
    assert!(refuted > 120, "too few mutants: {refuted}");
}

#[test]
fn both_signs_of_the_velocity_are_tried() {
    let signs = |proof: Proof, sign: &str| {
        proof
            .to_string()
            .contains(&format!("The velocity's sign: {sign}\n"))
    };
    assert!(signs(EQ26.proof(), "-1") && signs(DEFINITIONS.proof(), "1"));
    assert!(!signs(DEFINITIONS.proof(), "-1"));
}
