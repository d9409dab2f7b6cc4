use super::{Lexicon, Problem, Relation, Value, statements};
use crate::exact::Expr;
use crate::scalar::Scalar;
use proptest::prelude::*;

fn lexicon() -> Lexicon {
    let mut lexicon = Lexicon::new();
    for (latex, plain) in [
        ("a", "a"),
        ("b", "b"),
        (r"\theta", "θ"),
        (r"\theta_0", "θ₀"),
        (r"\tilde\phi_2", "φ̃₂"),
        (r"\lambda_\mathrm{c}", "λ_c"),
        (r"\frac{\mathrm d\psi}{\mathrm d\alpha}", "(dψ/dα)"),
        (r"h(\phi)", "h"),
    ] {
        let name = Value::Number(Expr::symbol(plain));
        lexicon.add(latex, name).unwrap();
    }
    for (latex, parts) in [(r"\bm r", ["x", "y", "z"]), (r"\bm u", ["p", "q", "r"])] {
        let name = Value::Vector(parts.map(Expr::symbol));
        lexicon.add(latex, name).unwrap();
    }
    lexicon
}

fn read(latex: &str) -> Result<Value, super::LatexError> {
    statements(latex)?[0].sides[0].read(&lexicon())
}

#[test]
fn a_number_is_read_as_it_is_printed() {
    for (latex, plain) in [
        (r"\frac{a+1}{2 b}", "(a + 1)/(2 b)"),
        (r"-a b+\tfrac12", "−a b + 1/2"),
        (r"\sin^2 \theta_0-\cot\theta", "sin(θ₀)^2 − cot(θ)"),
        (r"\cos^{-1}\frac{\pi a}{2}", "arccos(π a/2)"),
        (r"\left(\tan\frac{\theta}{2}\right)^{-a}", "tan(θ/2)^(−a)"),
        (
            r"\cos^2\tfrac{\theta_0}{2}\,a^{b-1}",
            "cos(θ₀/2)^2 a^(b − 1)",
        ),
        (r"a^{(2 b-1)/(1-b)}", "a^((2 b − 1)/(1 − b))"),
        (r"b\sqrt2\tilde\phi_2", "b √(2) φ̃₂"),
        (r"\frac{a}{\vert a\vert }", "a/√(a^2)"),
        (r"4.603 \lambda_\mathrm c", "4603/1000 λ_c"),
        (
            r"\frac{b-1}{b}\frac{\mathrm{d} \psi}{\mathrm{d} \alpha}",
            "(b − 1)/b (dψ/dα)",
        ),
        (r"-h( \phi)", "−h"),
        (r"a-1+\cdots", "a − 1"),
        (r"a\left[1-b+O(a^2)\right]+o(1)", "a (1 − b)"),
        (r"\{a [b (a)]\}", "a (b a)"),
        (r"{\ln\theta}\cosh(2 \theta)", "ln(θ) cosh(2 θ)"),
    ] {
        let read = read(latex).map(Value::number);
        let text = read.map(|tree| tree.map(|tree| tree.to_string()));
        assert_eq!(text, Ok(Some(plain.into())), "{latex}");
    }
}

#[test]
fn vectors_are_read_by_components() {
    let [x, y, z, p, q, r] = ["x", "y", "z", "p", "q", "r"].map(Expr::symbol);
    let [zero, one, two] = [0, 1, 2].map(Expr::int);
    let size = (x.squared() + y.squared() + z.squared()).sqrt();
    assert_eq!(
        read(r"2 \bm{r}\times\bm u"),
        Ok(Value::Vector([
            two * y * r - two * z * q,
            two * z * p - two * x * r,
            two * x * q - two * y * p
        ]))
    );
    assert_eq!(
        read(r"-\bm{r}-\bm u/a"),
        Ok(Value::Vector(
            [(x, p), (y, q), (z, r)].map(|(r, u)| { -r - u / Expr::symbol("a") })
        ))
    );
    assert_eq!(
        read(r"\bm r\cdot\bm u"),
        Ok(Value::Number(x * p + y * q + z * r))
    );
    assert_eq!(
        read(r"\hat{\bm z}\cdot\bm r\times\bm u"),
        Ok(Value::Number(
            zero * (y * r - z * q) + zero * (z * p - x * r) + one * (x * q - y * p)
        ))
    );
    assert_eq!(
        read(r"\left\vert\bm r\right\vert^{-1}"),
        Ok(Value::Number(size.pow(-one)))
    );
}

#[test]
fn a_text_is_split_into_statements_and_sides() {
    let found = statements(r"\text{A:}\quad a<b\le\theta,\quad a=1.").unwrap();
    assert_eq!(found[0].relations, [Relation::Less, Relation::AtMost]);
    assert_eq!(found[1].relations, [Relation::Equal]);
    assert_eq!(found[0].sides.len(), 3);
    let one = found[1].sides[1].read(&lexicon());
    assert_eq!(one, Ok(Value::Number(Expr::int(1))));
    let carried_on = statements("=a").unwrap();
    let missing = carried_on[0].sides[0].read(&lexicon()).unwrap_err();
    assert_eq!(missing.problem, Problem::Missing);
}

#[test]
fn cases_lists_and_rates_are_taken_apart() {
    let found = statements(r"a=\begin{cases} b,&0<a<\pi\\ 0,\pi<a \end{cases}.").unwrap();
    let pieces = found[0].sides[1].pieces().unwrap().unwrap();
    let values = pieces.iter().map(|piece| piece.value.read(&lexicon()));
    let expected = [Expr::symbol("b"), Expr::int(0)].map(|x| Ok(Value::Number(x)));
    assert_eq!(values.collect::<Vec<_>>(), expected);
    assert_eq!(pieces[0].condition.sides.len(), 3);
    assert_eq!(pieces[1].condition.relations, [Relation::Less]);

    let found = statements(r"X=(a=1,b=2)").unwrap();
    let listed = found[0].sides[1].listed().unwrap().unwrap();
    assert_eq!(listed.len(), 2);
    assert!(listed[0].sides[0].listed().is_none());

    let found = statements(r"\left(\frac{a}{2}\right)^{\cdot}=b").unwrap();
    let rate = &found[0].sides[0];
    let half = Expr::symbol("a") / Expr::int(2);
    let inner = rate.differentiated().unwrap();
    assert_eq!(inner.read(&lexicon()), Ok(Value::Number(half)));
    assert!(rate.read(&lexicon()).is_err());
    assert!(found[0].sides[1].differentiated().is_none());
    assert!(rate.pieces().is_none());
}

#[test]
fn a_name_with_operators_counts_where_it_is_the_whole() {
    let mut lexicon = lexicon();
    let slip = Value::Number(Expr::symbol("w"));
    lexicon.add("a+b", slip).unwrap();
    let read = |latex| statements(latex).unwrap()[0].sides[0].read(&lexicon);
    let text = |latex| read(latex).unwrap().number().unwrap().to_string();
    assert_eq!(text(r"\theta (a+b)"), "θ w");
    assert_eq!(text(r"\theta a+b"), "θ a + b");
}

#[test]
fn what_is_not_understood_is_said_with_its_place() {
    use Problem::{Ambiguous, Bracket, Kind, Missing, TooLong};
    let name = |name: &str| Problem::Name(name.into());
    let unknown = |what: &str| Problem::Unknown(what.into());
    for (latex, at, problem) in [
        (r"a+\foo", 2, unknown(r"\foo")),
        ("a+$", 2, unknown("$")),
        (r"\left<a", 0, unknown(r"\left")),
        (r"a \begin{array}", 8, unknown("array")),
        ("(a]", 2, Bracket),
        ("(a", 1, Bracket),
        ("a)", 1, Bracket),
        (r"\text{a", 5, Bracket),
        (r"\frac{a}", 8, Missing),
        ("a+", 1, Missing),
        ("a,,b", 0, Missing),
        ("c", 0, name("c")),
        (r"\theta_1", 0, name("theta")),
        (r"\sin 2 a", 7, Ambiguous),
        (r"\sin\theta^2", 10, Ambiguous),
        (r"\sin 2 3", 7, Ambiguous),
        (r"\sin a\frac{a}{b}", 6, Ambiguous),
        (r"\ln a\tilde\phi_2", 5, Ambiguous),
        (r"\tan^{-1} a", 0, Ambiguous),
        ("1/2 a", 4, Ambiguous),
        ("a 2", 2, Ambiguous),
        (r"a+\bm r", 1, Kind),
        (r"\bm r \bm u", 6, Kind),
        (r"a/\bm r", 1, Kind),
        (r"\bm r^2", 0, Kind),
        (r"\sin\bm r", 0, Kind),
        ("99999999999999999999", 0, TooLong),
        ("1.0000000000000000000", 0, TooLong),
    ] {
        assert_eq!(read(latex), Err(problem.at(at)), "{latex}");
    }
    let deep = "(".repeat(100_000);
    assert_eq!(read(&deep).unwrap_err().problem, Problem::TooDeep);
    let deep = r"\hat".repeat(100_000);
    assert_eq!(read(&deep).unwrap_err().problem, Problem::TooDeep);
    let message = read("a+$").unwrap_err().to_string();
    assert_eq!(message, "at character 2: $ has no meaning here");
}

proptest! {
    #[test]
    fn any_text_is_read_or_refused(text in ".{0,40}") {
        read_all(&text);
    }

    #[test]
    fn any_row_of_tokens_is_read_or_refused(tokens in prop::collection::vec(token(), 0..24)) {
        read_all(&tokens.concat());
    }
}

fn token() -> impl Strategy<Value = &'static str> {
    prop::sample::select(vec![
        r"\frac",
        r"\sqrt",
        r"\left",
        r"\right",
        "(",
        ")",
        "[",
        "]",
        "{",
        "}",
        r"\{",
        r"\}",
        r"\vert ",
        "|",
        "^",
        "_",
        "a",
        r"\theta",
        r"\bm r",
        r"\sin",
        r"\cos ",
        "-1",
        "+",
        "-",
        "/",
        r"\cdot ",
        r"\times ",
        r"\cdots ",
        ",",
        ".",
        ":",
        "=",
        "<",
        r"\le ",
        "1",
        "2.5",
        r"\begin{cases}",
        r"\end{cases}",
        r"\\",
        "&",
        r"\text{a:}",
        r"\quad ",
        r"\hat ",
        "\\",
        r"\mathrm d",
        "o",
        "O(",
    ])
}

fn read_all(text: &str) {
    let lexicon = lexicon();
    let Ok(found) = statements(text) else { return };
    for side in found.iter().flat_map(|statement| &statement.sides) {
        let _ = side.read(&lexicon);
        let _ = side.differentiated();
        let _ = side.listed();
        for piece in side.pieces().into_iter().flatten().flatten() {
            let _ = piece.value.read(&lexicon);
        }
    }
}
