use super::*;

fn square(x: &Ball) -> Option<[Ball; 2]> {
    Some([x * x - Ball::int(2, x.bits()), x + x])
}

#[test]
fn a_root_has_its_digits() {
    let root = refine(square, Interval::new(1.0, 2.0), 400).unwrap();
    assert_eq!(
        root.decimal(60).unwrap(),
        "1.414213562373095048801688724209698078569671875376948073176680"
    );
    assert!(root.known_bits() > 390);
    let same = Ball::int(2, 400).sqrt().unwrap();
    assert!(same.meets(&root));
}

#[test]
fn no_root_no_proof() {
    for (lo, hi) in [(1.5, 2.0), (-1.0, 2.0), (0.0, 1.4), (1.25, 1.25)] {
        assert!(
            refine(square, Interval::new(lo, hi), 100).is_err(),
            "{lo} {hi}"
        );
    }
}

#[test]
fn an_image_that_touches_the_box_proves_nothing() {
    // The ball around [−16, 16] reaches two units farther, and a quotient by 1 adds two units: the image of all f with
    // f(0) in [−16, 16] and the slope 1 is the ball itself.
    let start = Interval::new(-16.0, 16.0);
    let any = |least: f64| {
        let values = Ball::enclosing(Interval::new(-least, least), 0).unwrap();
        move |x: &Ball| Some([values.with_bits(x.bits()), Ball::int(1, x.bits())])
    };
    let why = |least: f64| refine(any(least), start, 60).unwrap_err().to_string();
    // In units of 1 the ball around [−14, 14] is [−16, 16].
    assert!(
        why(14.0).starts_with("the image of the box is not inside it"),
        "{}",
        why(14.0)
    );
    // Less, and the first step is taken.
    assert!(refine(any(13.0), start, 60).is_ok());
}

#[test]
fn a_root_at_an_end_or_a_double_one_is_not_proved() {
    let line = |x: &Ball| Some([x - Ball::int(1, x.bits()), Ball::int(1, x.bits())]);
    for (lo, hi) in [(0.0, 1.0), (1.0, 2.0)] {
        assert!(
            refine(line, Interval::new(lo, hi), 100).is_err(),
            "{lo} {hi}"
        );
    }
    assert!(refine(line, Interval::new(0.0, 1.0 + 1e-9), 100).is_ok());
    let double = |x: &Ball| {
        let off = x - Ball::int(1, x.bits());
        Some([&off * &off, &off + &off])
    };
    for (lo, hi) in [
        (0.5, 1.25),
        (1.0, 2.0),
        (0.0, 1.0),
        (1.0 - 1e-12, 1.0 + 1e-9),
    ] {
        assert!(
            refine(double, Interval::new(lo, hi), 100).is_err(),
            "{lo} {hi}"
        );
    }
}

#[test]
fn a_root_has_its_bits_where_the_slope_is_small() {
    // 2⁻²⁰ (x² − 2): each step costs twenty bits.
    let flat = |x: &Ball| {
        let factor = Ball::int(1, x.bits())
            .over(&Ball::int(1 << 20, 0))?
            .middle();
        Some([
            (x * x - Ball::int(2, x.bits())) * &factor,
            (x + x) * &factor,
        ])
    };
    for bits in [100, 1000, 4000] {
        let root = refine(flat, Interval::new(1.0, 2.0), bits).unwrap();
        assert!(
            root.known_bits() + 16 > bits,
            "{bits}: {}",
            root.known_bits()
        );
        assert!(root.meets(&Ball::int(2, bits).sqrt().unwrap()));
    }
}

#[test]
fn a_root_that_cannot_be_told_from_the_end_of_the_box_is_not_proved() {
    // Few units of 2⁻⁶⁴ below 1: balls tell it from the end, and the numbers that the box is given by do not.
    let root = |units: i64| {
        let at = |x: &Ball| {
            let unit = Ball::ratio(units, 1 << 62, x.bits())? * &Ball::ratio(1, 4, x.bits())?;
            Some([x - Ball::int(1, x.bits()) + unit, Ball::int(1, x.bits())])
        };
        refine(at, Interval::new(0.0, 1.0), 100)
    };
    let why = root(4).unwrap_err().to_string();
    assert!(why.starts_with("the root may lie outside the box"), "{why}");
    assert!(root(1 << 20).is_ok());
}
