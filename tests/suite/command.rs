//! The command as its users meet it.

use serde_json::Value;
use slipbook::ledger::Format;
use std::f64::consts::PI;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::Duration;

fn slipbook(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_slipbook"));
    command.args(arguments).output().unwrap()
}

/// The command with the words of a line.
fn asked(line: &str) -> Output {
    slipbook(&line.split(' ').collect::<Vec<_>>())
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

#[test]
fn a_folder_that_cannot_be_written_is_named_and_nothing_is_left() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    fs::write(&file, "mine").unwrap();
    for out in [file.clone(), file.join("below")] {
        let output = slipbook(&["--out", out.to_str().unwrap()]);
        assert_eq!(output.status.code(), Some(2));
        assert!(text(&output.stderr).contains(out.to_str().unwrap()));
    }
    assert_eq!(fs::read_to_string(&file).unwrap(), "mine");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn a_folder_with_something_else_in_it_is_left_alone() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("thesis.tex"), "mine").unwrap();
    let output = slipbook(&["--out", folder.path().to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(2));
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn bad_usage_is_exit_code_2_and_help_has_an_example() {
    assert_eq!(slipbook(&["--nonsense"]).status.code(), Some(2));
    let help = slipbook(&["--help"]);
    assert_eq!(help.status.code(), Some(0));
    assert!(text(&help.stdout).contains("Example"));
}

/// The JSON that a command writes, after a success.
fn json(arguments: &[&str]) -> Value {
    let output = slipbook(&[arguments, &["--json"]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert_eq!(
        text(&output.stderr),
        "",
        "progress shows on a terminal only"
    );
    serde_json::from_slice(&output.stdout).unwrap()
}

#[test]
fn some_claims_are_verified_shown_and_listed() {
    assert!(text(&slipbook(&["verify", "eq-11"]).stdout).contains("\n1 claim: "));
    let said = text(&slipbook(&["verify", "eq-11", "eq-82"]).stdout);
    for words in [
        "eq-11 ",
        "eq-82 ",
        "2 claims: ",
        "2 of 2 verdicts as recorded",
    ] {
        assert!(said.contains(words), "no `{words}` in\n{said}");
    }
    let sheet = text(&slipbook(&["show", "eq-75"]).stdout);
    assert!(
        sheet.contains("verdict: misprint") && sheet.contains("trial by"),
        "{sheet}"
    );
    let list = json(&["list", "--section", "2", "--verdict", "confirmed"]);
    let claims = list["claims"].as_array().unwrap();
    assert!(!claims.is_empty());
    assert!(
        claims
            .iter()
            .all(|c| c["section"] == "2" && c["verdict"] == "confirmed")
    );
    let table = text(&slipbook(&["list", "--section", "2", "--csv"]).stdout);
    let listed = text(&slipbook(&["list", "--section", "2"]).stdout);
    assert_eq!(table.lines().count(), listed.lines().count() + 1);
    assert!(table.starts_with("id,section,equation,kind,verdict,"));
    let none = slipbook(&["list", "--section", "2", "--verdict", "undecided"]);
    assert_eq!(text(&none.stdout), "there is no such claim\n");
}

/// Whether an error is a misprint or inherited is seen from the neighbours, which are tried too.
#[test]
fn what_is_wrong_has_the_same_verdict_alone() {
    let record = include_str!("../../snapshots/verdicts.snap");
    let wrong = record.lines().filter_map(|line| {
        let (id, verdict) = line.split_once(": ")?;
        ["misprint", "misderived", "inherited"]
            .contains(&verdict)
            .then_some(id)
    });
    let ids: Vec<_> = wrong.collect();
    assert!(ids.len() > 10);
    let output = slipbook(&[&["verify"], &ids[..]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stdout));
}

#[test]
fn the_number_of_threads_changes_nothing() {
    let of = |jobs| text(&slipbook(&["verify", "eq-13", "eq-96", "--csv", "--jobs", jobs]).stdout);
    assert_eq!(of("1"), of("3"));
}

#[test]
fn the_letter_as_plain_text_has_no_formulas_of_latex() {
    let ledger = &*crate::LEDGER;
    for letter in [ledger.letter(Format::Text), ledger.supplement(Format::Text)] {
        let letter = letter.unwrap();
        assert!(letter.contains("(134)"));
        let left: Vec<_> = letter
            .lines()
            .filter(|line| line.contains(['$', '\\']))
            .collect();
        assert!(left.is_empty(), "{left:#?}");
    }
}

#[test]
fn numbers_are_found_and_graded() {
    let first = |number: &str| json(&["find", number])["matches"][0].clone();
    assert_eq!(first("0.54")["name"], "lambda-c");
    assert_eq!(first("0.537")["first_wrong"], Value::Null);
    let wrong = first("0.53701");
    assert_eq!(
        (wrong["right"].as_u64(), wrong["first_wrong"].as_u64()),
        (Some(4), Some(5))
    );
    let marked = text(&slipbook(&["find", "0.53701"]).stdout);
    assert!(marked.contains("    0.53701\n          ^\n"), "{marked}");
    assert_eq!(first("4.603")["claim"], "eq-58");
    let graded = |number: &str| text(&slipbook(&["find", number]).stdout);
    assert!(graded("0.537").contains("all digits given are right"));
    assert!(
        graded("0.87204385604999")
            .contains("the first 11 digits are right; no more are known here")
    );
    assert!(!graded("0.872043856049").contains("all digits given are right"));
    assert!(graded("0.53702").contains("cut off: rounded, the last is one more"));
    assert_eq!(first("5.37029e-1")["name"], "lambda-c");
    let none = slipbook(&["find", "77.7", "--json"]);
    assert_eq!(none.status.code(), Some(1));
    let none: Value = serde_json::from_slice(&none.stdout).unwrap();
    assert_eq!(none["matches"], Value::Array(Vec::new()));
    assert_eq!(slipbook(&["find", "twelve"]).status.code(), Some(2));
    // A single digit is a number of its own, not the beginning of others.
    assert_eq!(slipbook(&["find", "1"]).status.code(), Some(1));
    assert_eq!(first("0.4")["name"], "kappa-solid");
    assert!(graded("7/6").contains("= 1.1666666666666666667\nboundary-curvature"));
    assert!(graded("2/sqrt(4+pi^2)").contains("lambda-c = 0.537029272146"));
    assert!(graded("exp(pi*sqrt(2))").contains("turn = 85.019695223207217583 = exp(sqrt(2)*pi)"));
    assert!(graded("4.603").contains("y-q-printed = 4.603  q of Y"));
    // Nothing but what is known of an expression is printed.
    for (given, digits) in [
        ("exp(1)-2.718281828459045", "2.3536028747135266250e-16"),
        ("sinh(1)^(1/3)", "1.0552873721751119164"),
        ("ln(10)^-2", "0.18861169701161392922"),
        ("123456789012345678901*1.5", "185185183518518518351.5"),
        ("exp(-100)", "3.7200759760208359630e-44"),
        ("-1/3e-300", "-333333333333"),
    ] {
        let said = graded(given);
        assert!(said.starts_with(&format!("{given} = {digits}")), "{said}");
    }
    for (given, why) in [
        ("tan(pi/2)", "has no finite value"),
        ("cos(pi/2)", "is 0, or not to be told from it"),
        ("exp(1e9)", "has no finite value"),
        ("ln(0)", "has no finite value"),
    ] {
        let refused = slipbook(&["find", given]);
        assert_eq!(refused.status.code(), Some(2));
        assert!(text(&refused.stderr).contains(why), "{given}");
    }
    let refused = slipbook(&["find", "--jsn"]);
    assert!(text(&refused.stderr).contains("there is no such option"));
    let refused = slipbook(&["find", "0,537"]);
    assert!(text(&refused.stderr).contains("a point, not a comma"));
    let all = json(&["find"]);
    assert_eq!(
        all["values"].as_array().unwrap().len(),
        slipbook::claims::PAPER.values().count()
    );
    assert!(text(&slipbook(&["find"]).stdout).contains("lambda-c = 0.537029272146"));
}

#[test]
fn ids_are_taken_as_people_write_them() {
    let id = |word: &str| {
        let output = slipbook(&["show", word, "--json"]);
        let shown: Value = serde_json::from_slice(&output.stdout)
            .unwrap_or_else(|_| panic!("{word}: {}", text(&output.stderr)));
        shown["claims"][0]["id"].as_str().unwrap().to_owned()
    };
    for word in ["13", "(13)", "EQ-13", "eq13", "Eq. (13)", "eq_13", "013"] {
        assert_eq!(id(word), "eq-13", "{word}");
    }
    for (word, meant) in [
        ("Figure 3", "fig-3"),
        ("s24-y", "s24-Y"),
        ("s2-stops", "s2-stops-if-weak"),
        ("parabola", "s21-frictionless-parabola"),
    ] {
        assert_eq!(id(word), meant, "{word}");
    }
    let several = json(&["verify", "11", "eq-11", "82"]);
    assert_eq!(several["claims"].as_array().unwrap().len(), 2);
    let sheets = text(&slipbook(&["show", "11", "75"]).stdout);
    assert!(sheets.contains("eq-11: ") && sheets.contains("\neq-75: "));
    for (word, hint) in [
        (
            "s21-portrait-consistant",
            "did you mean `s21-portrait-consistent`?",
        ),
        ("s24-region", "may be s24-region-1, s24-region-2"),
        ("148", "there is no claim `148`"),
        (
            "2.1",
            "`2.1` is no claim but a section: `slipbook list --section 2.1`",
        ),
        ("eq. 2.4", "slipbook list --section 2.4`"),
        ("§3.1", "slipbook list --section 3.1`"),
        ("13.5", "there is no claim `13.5`"),
        ("1(3)", "there is no claim `1(3)`"),
        ("(13", "there is no claim `(13`"),
        ("1 3", "there is no claim `1 3`"),
        ("0", "there is no claim `0`"),
        ("24-y", "there is no claim `24-y`"),
        ("", "there is no claim ``"),
    ] {
        let output = slipbook(&["show", word]);
        let complaint = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{word}");
        assert!(complaint.contains(hint), "{complaint}");
    }
    assert!(text(&slipbook(&["completions", "bash"]).stdout).contains("s21-frictionless-parabola"));
    assert!(!text(&slipbook(&["show", "--help"]).stdout).contains("s21-frictionless-parabola"));
}

#[test]
fn a_book_is_not_written_where_nobody_looks_for_it() {
    let folder = tempfile::tempdir().unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_slipbook"))
        .current_dir(folder.path())
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("--out FOLDER"));
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn bad_input_says_what_is_wrong_and_writes_nothing() {
    let cases = [
        (
            "solve constant --lambda -1 --v0 1 --theta0 1 --time 1",
            "lambda = -1 must be",
        ),
        ("solve constant --lambda 1 --v0 1 --theta0 1", "--time"),
        (
            "solve constant --lambda 1 --v0 1 --theta0 1 --time 1 --theta 1",
            "--theta",
        ),
        (
            "solve constant --lambda 0.5 --v0 1 --theta0 1 --theta 2",
            "theta0 = 1",
        ),
        (
            "solve constant --lambda 0.5 --v0 nan --theta0 1 --time 2",
            "v0 = NaN",
        ),
        ("solve anisotropic --q -2 --lambda0 0.3", "q = -2 must be"),
        ("solve sinusoidal --lambda0 0", "between 1e-6 and 1e6"),
        ("solve turntable --rho 1 --p 1", "--psi"),
        ("solve turntable --rho 1 --x 1 --y 1 --vx 1 --vy 1", "--rho"),
        ("solve turntable --rho -1 --p 1 --psi 0", "rho"),
        ("solve pulse --eta 0.5 --lambda0 0.3 --json --plot", "SVG"),
        ("solve --plot pulse --eta 0.5 --lambda0 0.3", "--plot"),
        ("verify eq-999", "eq-999"),
        ("list --section 9", "9"),
        ("exam stop-place none", "'none'"),
        ("exam stop-plac", "'stop-place'"),
        ("show s2", "`s2` may be s2-stops-if-weak, "),
        ("find 1/0", "`1/0` has no finite value"),
        ("find pi/", "missing at the end"),
        (
            "solve turntable --mu 0.4 --omega -3.5 --r 0.1 --speed 0.05 --psi 1",
            "omega = -3.5 must be",
        ),
        (
            "solve sinusoidal --mu -0.4 --a0 1 --omega 1",
            "what the SI units given come to",
        ),
        // What is in SI units is in SI units altogether.
        ("solve pulse --eta 1 --mu 0.4 --a0 1", "--omega"),
        ("solve anisotropic --q 2 --mu 0.4 --a0 1", "--omega"),
        (
            "solve sphere --gamma 1 --radius 0.1 --u0 1 --theta0 1 --time 1",
            "--radius",
        ),
        ("solve turntable --rho 1 --p 1 --psi 0 --omega 2", "--omega"),
        // The number that was given has to be mended, not what it comes to.
        (
            "solve constant --mu 0.5 --accel 0 --v0 6 --theta0 0 --time 1",
            "accel = 0 must be",
        ),
        (
            "solve constant --mu 0.5 --accel 1e-300 --v0 6 --theta0 0 --time 1",
            "accel = 1e-300 must be",
        ),
        (
            "solve sphere --mu 0.08 --accel 0 --u0 5 --theta0 0 --time 1",
            "accel = 0 must be",
        ),
        (
            "solve sphere --mu 0 --accel 1 --u0 5 --theta0 0 --time 1",
            "mu = 0 must be",
        ),
        (
            "solve sinusoidal --mu 0.4 --a0 0 --omega 1",
            "a0 = 0 must be",
        ),
        (
            "solve turntable --rho 1 --p 1e-300 --psi 0",
            "p = 0 μg/Ω at the time 0/Ω",
        ),
        // Two ways that have no digit in common are no answer.
        (
            "solve turntable --rho 1e-300 --p 1e-300 --psi 1 --time 1e-300",
            "no digit of the answer is known",
        ),
        ("solve turntable --rho 1 --p 0 --psi 0 --alpha 3", "--alpha"),
        ("solve turntable --A 1 --alpha 1 --psi 0 --p 3", "--p"),
        ("solve turntable --x 1 --y 0 --vx 1 --vy 0 --p 3", "--p"),
        (
            "solve constant --lambda 1 --v0 1 --theta0 1 --time 1 --accel -1",
            "accel = -1 must be",
        ),
        (
            "solve constant --lambda 1 --v0 1e300 --theta0 1 --time 1",
            "v0 = 1e300 must be",
        ),
        ("errata --format latex --json", "--json"),
        ("errata --format text --csv", "--csv"),
    ];
    for (command, named) in cases {
        let output = asked(command);
        let complaint = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{command}");
        assert!(complaint.contains(named), "{command}: {complaint}");
        assert!(output.stdout.is_empty(), "{command}");
    }
}

/// What the rest of the line leaves idle is not taken in silence.
#[test]
fn no_option_is_given_in_vain() {
    let cases = [
        ("constant --lambda 1 --v0 1 --theta0 1 --time 1", "g mu"),
        ("sinusoidal --lambda0 0.5", "g mu a0 omega"),
        ("pulse --eta 0.5 --lambda0 0.5", "g mu a0 omega"),
        ("anisotropic --q 2 --lambda0 0.5", "g mu a0 omega"),
        (
            "sphere --gamma 1 --u0 1 --theta0 1 --time 1",
            "g mu accel radius",
        ),
        (
            "turntable --rho 0.5 --p 0.1 --psi 1",
            "A alpha x y vx vy r speed mu omega g",
        ),
        (
            "turntable --A 0.5 --alpha 1 --psi 1",
            "rho p x y vx vy r speed mu omega g",
        ),
        (
            "turntable --x 0 --y 0 --vx 0 --vy 0",
            "psi rho p A alpha r speed mu omega g",
        ),
        (
            "turntable --r 0.1 --speed 0.1 --psi 1 --mu 0.3 --omega 3",
            "rho p A alpha x y vx vy",
        ),
    ];
    for (line, idle) in cases {
        let alone = format!("solve {line}");
        let output = asked(&alone);
        assert!(output.status.success(), "{alone}: {}", text(&output.stderr));
        for option in idle.split(' ') {
            let more = format!("{alone} --{option} 1");
            let output = asked(&more);
            assert_eq!(output.status.code(), Some(2), "{more}");
            assert!(
                text(&output.stderr).contains("cannot be used with"),
                "{more}"
            );
        }
    }
}

#[test]
fn an_answer_is_text_json_or_a_table() {
    let solve = "solve constant --lambda 0.5 --v0 1 --theta0 -1 --time 2";
    let with = |more: &str| text(&asked(&format!("{solve}{more}")).stdout);
    assert!(with("").contains("by formula") && with("").contains("digits "));
    let answer: Value = serde_json::from_str(&with(" --json")).unwrap();
    assert!((answer["v"].as_f64().unwrap() - 1.721_996_770_095_711).abs() < 1e-14);
    assert_eq!(answer["stop_time"], Value::Null);
    assert!(with(" --csv").starts_with(
        "quantity,value,unit,by_formula,by_motion,digits,note\nv,1.72199677009571,unit of v0,1.72199677009571,1.72199677009571,15,"
    ));
    assert!(with(" --plot").contains("v_y (unit of v0) against v_x (unit of v0)"));
}

/// In each form the formula's number stands where the formula is named, and the motion's where the motion is.
#[test]
fn the_two_ways_of_an_answer_keep_their_names() {
    let question = |form: &[&'static str]| {
        let problem = [
            "solve",
            "turntable-boundary",
            "--alpha",
            "0.2",
            "--psi",
            "1",
        ];
        text(&slipbook(&[&problem, form].concat()).stdout)
    };
    // To the digits that the motion bears out: 0.8945… beside 0.8876….
    let formula = (10.0 * slipbook::corrections::rest::boundary_a(0.2, 1.0)).round() / 10.0;
    let motion = slipbook::motion::turntable::boundary(0.2, 1.0).unwrap();
    let close = |word: &str, to: f64| {
        let number: f64 = word.parse().unwrap();
        assert!((number - to).abs() < 1e-9, "{word} {to}");
    };
    let json: Value = serde_json::from_str(&question(&["--json"])).unwrap();
    for (way, to) in [("by_formula", formula), ("by_motion", motion)] {
        close(&json[way]["A"].to_string(), to);
    }
    close(&json["A"].to_string(), motion);
    let ways = ["value", "unit", "by_formula", "by_motion"];
    for (form, parts) in [(&["--csv"][..], ','), (&[], ' ')] {
        let said = question(form)
            .replace("by formula", "by_formula")
            .replace("by motion", "by_motion");
        let mut lines = said
            .lines()
            .map(|line| line.split(parts).filter(|word| !word.is_empty()));
        let (mut head, mut row) = (lines.next().unwrap(), lines.next().unwrap());
        if parts == ',' {
            head.next();
        }
        row.next();
        assert!(head.by_ref().take(4).eq(ways), "{said}");
        close(row.next().unwrap(), motion);
        assert_eq!(row.next(), Some("dimensionless"));
        for to in [formula, motion] {
            close(row.next().unwrap(), to);
        }
    }
}

#[test]
fn a_plot_is_a_file_that_is_replaced_whole() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("path.svg");
    let plot = |file: &Path| {
        let start = [
            "solve",
            "turntable",
            "--rho",
            "0.5",
            "--p",
            "0.3",
            "--psi",
            "1",
            "--plot",
        ];
        slipbook(&[&start[..], &[file.to_str().unwrap()]].concat())
    };
    for _ in 0..2 {
        assert_eq!(plot(&file).status.code(), Some(0));
        assert!(fs::read_to_string(&file).unwrap().starts_with("<svg"));
    }
    let nowhere = plot(&folder.path().join("none/path.svg"));
    assert!(text(&nowhere.stderr).contains("there is no such folder"));
    // The folder of this test has such a name itself.
    let own = |complaint: &str| complaint.replace(folder.path().to_str().unwrap(), "");
    for (nowhere, why) in [
        (file.join("below.svg"), "below.svg"),
        (folder.path().join("none").join("path.svg"), "none"),
        (folder.path().join("path.png"), "it draws SVG"),
    ] {
        let nowhere = plot(&nowhere);
        let complaint = text(&nowhere.stderr);
        assert_eq!(nowhere.status.code(), Some(2));
        assert!(nowhere.stdout.is_empty());
        assert!(
            complaint.contains(why) && !own(&complaint).contains(".tmp"),
            "{complaint}"
        );
    }
    assert!(text(&plot(Path::new("-")).stdout).starts_with("<svg"));
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[cfg(unix)]
#[test]
fn a_plot_follows_a_link_keeps_the_rights_of_a_file_and_replaces_nothing_else() {
    use std::os::unix::fs::{FileTypeExt, MetadataExt, PermissionsExt, symlink};
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name);
    let plot = |name: &str| {
        let file = place(name);
        let solve = ["solve", "sinusoidal", "--lambda0", "0.7", "--plot"];
        let output = slipbook(&[&solve[..], &[file.to_str().unwrap()]].concat());
        (output.status.code(), text(&output.stderr))
    };
    fs::write(place("old.svg"), "").unwrap();
    fs::set_permissions(place("old.svg"), fs::Permissions::from_mode(0o640)).unwrap();
    symlink("old.svg", place("link.svg")).unwrap();
    assert_eq!(plot("link.svg"), (Some(0), String::new()));
    assert!(place("link.svg").is_symlink());
    assert_eq!(place("old.svg").metadata().unwrap().mode() & 0o777, 0o640);
    assert!(
        fs::read_to_string(place("old.svg"))
            .unwrap()
            .starts_with("<svg")
    );
    // A new one has the rights of any new file.
    fs::write(place("any"), "").unwrap();
    assert_eq!(plot("new.svg").0, Some(0));
    let mode = |name: &str| place(name).metadata().unwrap().mode();
    assert_eq!(mode("new.svg"), mode("any"));
    symlink("nowhere", place("lost.svg")).unwrap();
    assert_eq!(plot("lost.svg").0, Some(2));
    let _end = std::os::unix::net::UnixListener::bind(place("socket.svg")).unwrap();
    let (code, complaint) = plot("socket.svg");
    assert!(
        code == Some(2) && complaint.contains("no ordinary file"),
        "{complaint}"
    );
    assert!(
        place("socket.svg")
            .symlink_metadata()
            .unwrap()
            .file_type()
            .is_socket()
    );
}

#[test]
fn every_command_has_help_with_an_example() {
    let mut commands: Vec<Vec<&str>> = [
        "verify",
        "show",
        "list",
        "errata",
        "find",
        "solve",
        "completions",
        "man",
        "schema",
    ]
    .map(|command| vec![command])
    .into();
    let problems = [
        "constant",
        "sinusoidal",
        "pulse",
        "anisotropic",
        "sphere",
        "turntable",
        "turntable-boundary",
    ];
    commands.extend(problems.map(|problem| vec!["solve", problem]));
    for command in commands {
        let output = slipbook(&[&command[..], &["--help"]].concat());
        assert_eq!(output.status.code(), Some(0));
        let example = format!("slipbook {}", command.join(" "));
        let help = text(&output.stdout);
        assert!(help.contains(&example), "{example}");
        // What is its own comes first, what all take last.
        let common = help.find("      --json").unwrap();
        assert!(help[common..].find(" <RANGE>").is_none(), "{help}");
    }
    let help = text(&slipbook(&["solve", "--help"]).stdout);
    for (problem, about) in [
        ("constant", "A particle launched on a plane"),
        ("turntable", "A particle on a turntable"),
    ] {
        let mut lines = help.lines().map(str::trim_start);
        let line = lines.find(|line| line.split(' ').next() == Some(problem));
        assert!(line.unwrap().contains(about), "{help}");
    }
}

#[test]
fn shells_get_their_completions() {
    let help = text(&slipbook(&["verify", "--help"]).stdout);
    assert!(
        help.starts_with("Try claims") && !help.contains("--round"),
        "{help}"
    );
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = text(&slipbook(&["completions", shell]).stdout);
        assert!(script.contains("slipbook") && script.contains("shard"));
        // What no help names is not completed.
        assert!(
            !script.contains("--round") && !script.contains("'record'"),
            "{shell}"
        );
        assert!(
            !script.contains("--record") && !script.contains("'round'"),
            "{shell}"
        );
        assert!(
            !script.contains("-l round") && !script.contains("-l record"),
            "{shell}"
        );
    }
}

#[test]
fn the_manual_and_the_schema_come_from_what_they_describe() {
    let page = text(&slipbook(&["man"]).stdout);
    assert!(page.contains(".TH slipbook 1"), "{page}");
    for name in [
        "SLIPBOOK VERIFY",
        "SLIPBOOK SOLVE TURNTABLE-BOUNDARY",
        "SLIPBOOK ENSEMBLE",
    ] {
        assert!(page.contains(&format!(".SH \"{name}\"")), "{name}");
    }
    let schema: Value = serde_json::from_slice(&slipbook(&["schema"]).stdout).unwrap();
    let find = &schema["$defs"]["find"]["properties"];
    assert_eq!(
        find["matches"]["items"]["properties"]["first_wrong"]["type"],
        serde_json::json!(["number", "null"])
    );
    let answers = schema["anyOf"].as_array().unwrap();
    assert!(answers.len() > 12, "{answers:?}");
}

/// The counts of errors on the first page and in the letter, and what the register says of each.
#[test]
fn errors_are_counted_alike_everywhere() {
    let read = |file: &str| fs::read_to_string(crate::BOOK.join(file)).unwrap();
    let register = text(&slipbook(&["errata", "--csv"]).stdout);
    let mut rows = register.lines();
    assert_eq!(
        rows.next().unwrap(),
        "id,section,equation,verdict,printed,corrected,reason,evidence,inherits,check"
    );
    let misprint = rows.find(|row| row.starts_with("eq-75,")).unwrap();
    assert!(
        misprint.contains(",misprint,") && misprint.ends_with(",slipbook verify eq-75"),
        "{misprint}"
    );
    let count = |verdict: &str| register.matches(&format!(",{verdict},")).count();
    let own = count("misderived") + count("refuted");
    let heirs = count("inherited");
    let slips = count("misprint");
    let without_tags = |html: &str| {
        let texts = html.split('<').filter_map(|part| part.split('>').nth(1));
        texts.collect::<String>()
    };
    for (file, text, beside) in [
        ("errata.txt", read("errata.txt"), [own, heirs]),
        (
            "index.html",
            without_tags(&read("index.html")),
            [slips, heirs],
        ),
    ] {
        let numbers = text.split(|c: char| !c.is_ascii_digit());
        let numbers: Vec<usize> = numbers.filter_map(|n| n.parse().ok()).collect();
        assert!(numbers.windows(2).any(|two| two == beside), "{file}");
    }
}

/// A file system without room: no file may grow beyond a few kilobytes.
#[cfg(unix)]
#[test]
fn without_room_the_earlier_book_stays() {
    let folder = tempfile::tempdir().unwrap();
    let out = earlier_book(folder.path());
    let script = "trap '' XFSZ; ulimit -f 16; exec \"$0\" --out \"$1\"";
    let program = env!("CARGO_BIN_EXE_slipbook");
    let output = Command::new("bash")
        .args(["-c", script, program, out.to_str().unwrap()])
        .output()
        .unwrap();
    let complained = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{complained}");
    assert!(complained.contains("slipbook: "), "{complained}");
    let page = fs::read_to_string(out.join("index.html")).unwrap();
    assert_eq!(page, "the earlier book");
    assert_eq!(fs::read_dir(&out).unwrap().count(), 2);
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

/// A place for a book with an earlier one in it.
fn earlier_book(folder: &Path) -> PathBuf {
    let out = folder.join("book");
    fs::create_dir(&out).unwrap();
    fs::write(out.join(".slipbook"), "").unwrap();
    fs::write(out.join("index.html"), "the earlier book").unwrap();
    out
}

#[test]
fn a_killed_run_leaves_the_earlier_book_and_the_next_run_cleans_up() {
    let folder = tempfile::tempdir().unwrap();
    let out = earlier_book(folder.path());
    let mut child = Command::new(env!("CARGO_BIN_EXE_slipbook"))
        .args(["--out", out.to_str().unwrap()])
        .stdout(Stdio::null())
        .spawn()
        .unwrap();
    // Half-written: a page is there, and the run is still under way.
    let half_written = || {
        let entries = fs::read_dir(folder.path()).unwrap();
        let mut places = entries.map(|entry| entry.unwrap().path().join("book"));
        places.any(|place| place.join("index.html").exists())
    };
    while !half_written() {
        assert!(child.try_wait().unwrap().is_none(), "it ended too early");
        std::thread::sleep(Duration::from_millis(1));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    let page = fs::read_to_string(out.join("index.html")).unwrap();
    assert_eq!(page, "the earlier book");
    assert_eq!(fs::read_dir(&out).unwrap().count(), 2);
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
    slipbook::book::check(&slipbook::edition::EDITION, &out).unwrap();
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

/// The main job, twice at once: both print the ledger, one whole book is left.
#[test]
fn the_main_job_prints_the_ledger_and_writes_the_book() {
    let folder = tempfile::tempdir().unwrap();
    let parent = folder.path().join("a folder");
    fs::create_dir(&parent).unwrap();
    let out = earlier_book(&parent);
    let run = || slipbook(&["--out", out.to_str().unwrap()]);
    let outputs = std::thread::scope(|scope| {
        [scope.spawn(run), scope.spawn(run)].map(|run| run.join().unwrap())
    });
    let all = slipbook::claims::PAPER.claims().count();
    for output in outputs {
        let (said, complained) = (text(&output.stdout), text(&output.stderr));
        assert_eq!(output.status.code(), Some(0), "{said}\n{complained}");
        for line in [
            "Section 2.1",
            "  eq-13 ",
            &format!("{all} claims: "),
            &format!("{all} of {all} verdicts as recorded"),
            out.join("index.html").to_str().unwrap(),
        ] {
            assert!(said.contains(line), "no `{line}` in\n{said}");
        }
        assert_eq!(complained, "", "progress shows on a terminal only");
    }
    let page = fs::read_to_string(out.join("index.html")).unwrap();
    assert!(page.contains("Slipbook"));
    // What the record names is there.
    let record = include_str!("../../codecheck.yml");
    let files = record
        .lines()
        .filter_map(|line| line.strip_prefix("  - file: "));
    let files: Vec<_> = files.collect();
    assert!(files.len() > 4);
    for file in files {
        let name = file.strip_prefix("target/book/").unwrap();
        assert!(out.join(name).is_file(), "{name}");
    }
    assert!(out.join("errata.html").exists() && out.join(".slipbook").exists());
    assert_eq!(fs::read_dir(&parent).unwrap().count(), 1);
}

#[cfg(target_os = "linux")]
#[test]
fn an_answer_that_cannot_be_written_is_a_failure() {
    for command in [
        "find 0.537",
        "verify eq-11 --json",
        "solve sinusoidal --lambda0 0.3 --csv",
        "ensemble --rho 0.5 --p 0.3 --psi 1",
        "exam creep",
        "completions bash",
        "--help",
        "--version",
    ] {
        let full = fs::OpenOptions::new().write(true).open("/dev/full");
        let output = Command::new(env!("CARGO_BIN_EXE_slipbook"))
            .args(command.split(' '))
            .stdout(full.unwrap())
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(2), "{command}");
        let complaint = text(&output.stderr);
        assert!(
            complaint.contains("slipbook: standard output: No space left"),
            "{complaint}"
        );
    }
}

#[test]
fn an_ensemble_ends_as_its_particles_do() {
    let grid = [
        "ensemble",
        "--rho",
        "0.5",
        "--p",
        "0.2:1.4:3",
        "--psi=-1:2:2",
    ];
    let output = slipbook(&[&grid[..], &["--csv"]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let rows = text(&output.stdout);
    let rows: Vec<Vec<&str>> = rows.lines().map(|row| row.split(',').collect()).collect();
    let head = [
        "rho (μg/Ω²)",
        "p (μg/Ω)",
        "psi (rad)",
        "outcome",
        "sigma (μg/Ω²)",
        "tau (1/Ω)",
    ];
    assert_eq!(rows[0][..6], head);
    assert_eq!(rows[0][6..], ["sigma_digits", "tau_digits", "note"]);
    assert_eq!(rows.len(), 7);
    for row in &rows[1..] {
        let single = slipbook(&[
            "solve",
            "turntable",
            "--rho",
            row[0],
            "--p",
            row[1],
            "--psi",
            row[2],
            "--json",
        ]);
        let single: Value = serde_json::from_slice(&single.stdout).unwrap();
        match row[3] {
            "rest" => {
                let sigma: f64 = row[4].parse().unwrap();
                assert!(
                    (sigma - single["sigma"].as_f64().unwrap()).abs() < 1e-9,
                    "{row:?}"
                );
            }
            outcome => assert_eq!(
                (outcome, single["outcome"].as_str()),
                ("far", Some("escape"))
            ),
        }
    }
    assert!(rows.iter().any(|row| row[3] == "rest") && rows.iter().any(|row| row[3] == "far"));
    let some = [&grid[..], &["--late", "0.7"]].concat();
    let rows = text(&slipbook(&[&some[..], &["--csv"]].concat()).stdout);
    let ended = |how: &str| rows.matches(&format!(",{how},")).count();
    let [rest, far, late] = ["rest", "far", "late"].map(ended);
    assert!(rest > 0 && late > 0 && rest + far + late == 6, "{rows}");
    let said = text(&slipbook(&some).stdout);
    let summary = format!("{rest} come to rest, {far} go away, {late} are still under way");
    let plural = said.replace("1 comes", "1 come").replace("1 goes", "1 go");
    assert!(plural.replace("1 is", "1 are").contains(&summary), "{said}");
    let output = slipbook(&[&grid[..], &["--json"]].concat());
    let whole: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(whole["ends"].as_array().unwrap().len(), 6);
    assert_eq!((&whole["done"], &whole["of"]), (&6.into(), &6.into()));
}

#[test]
fn an_ensemble_names_what_is_out_of_range() {
    for (option, wrong, named) in [
        ("--rho", "-1", "rho"),
        ("--rho", "1:2", "LOW:HIGH:COUNT"),
        ("--rho", "0,5", "a point, not a comma"),
        ("--far", "-1", "--far = -1 must be positive"),
        ("--far", "0", "--far = 0 must be positive"),
        ("--late", "-1", "--late = -1 must be positive"),
        ("--shard", "1/2", "--csv or --json"),
        ("--jobs", "-1", "1..=1024"),
    ] {
        let rho = if option == "--rho" { wrong } else { "1" };
        let mut arguments = vec!["ensemble", "--rho", rho, "--p", "1", "--psi", "0"];
        if option != "--rho" {
            arguments.extend([option, wrong]);
        }
        let output = slipbook(&arguments);
        assert_eq!(output.status.code(), Some(2));
        assert!(
            text(&output.stderr).contains(named),
            "{}",
            text(&output.stderr)
        );
        assert!(output.stdout.is_empty());
    }
}

#[test]
fn an_answer_fits_the_screen() {
    let said = |line: &str, columns: usize, more: &[&str]| {
        let output = Command::new(env!("CARGO_BIN_EXE_slipbook"))
            .args(line.split(' '))
            .args(more)
            .env("COLUMNS", columns.to_string())
            .output()
            .unwrap();
        text(&output.stdout)
    };
    // Marks above letters have no width of their own.
    let mark = |c: &char| ('\u{300}'..='\u{36f}').contains(c);
    let width = |line: &str| line.chars().filter(|c| !mark(c)).count();
    for line in [
        "verify eq-13 eq-47 eq-58 s24-region-2 eq-82",
        "show eq-58 eq-82",
        "list --section 2",
        "find 0.53701",
        "solve constant --lambda 0.5 --v0 1 --theta0 -1 --time 2",
        "solve constant --lambda 0.1:2:3 --v0 1 --theta0 120deg --time 0:1:3",
        "solve sphere --gamma 2 --u0 1 --theta0 1 --time 0:1:3",
        "exam",
        "--help",
    ] {
        for columns in [60, 80, 120, 200] {
            let wide: Vec<_> = said(line, columns, &[])
                .lines()
                .filter(|line| width(line) > columns)
                .map(str::to_owned)
                .collect();
            assert!(wide.is_empty(), "{columns}: {wide:#?}");
        }
    }
    let table = |columns| said("verify eq-47 eq-58", columns, &[]);
    assert!(table(200).lines().count() < table(40).lines().count());
    for line in ["verify eq-75", "show eq-75", "find 0.53701"] {
        let painted = said(line, 80, &["--color", "always"]);
        assert!(painted.contains("\u{1b}[31m"), "{painted}");
        assert!(!said(line, 80, &[]).contains('\u{1b}'), "{line}");
    }
    assert!(!said("verify eq-82", 80, &[]).contains('\u{1b}'));
    assert_eq!(
        said("verify eq-11 -q -j 1", 80, &[]),
        "1 of 1 verdicts as recorded\n"
    );
}

#[test]
fn a_bad_point_of_a_grid_is_a_row_that_says_why() {
    let line = "ensemble --rho 0:2:3 --p 0:1.5:4 --psi -1:1:2 --csv";
    let rows = text(&asked(line).stdout);
    assert_eq!(rows.lines().count(), 25);
    let refused: Vec<_> = rows.lines().filter(|row| row.contains("refused")).collect();
    assert_eq!(
        refused,
        ["2,0,-1", "2,0,1"]
            .map(|at| format!("{at},refused,,,,,\"p = 0 must be positive where rho > 1\""))
    );
    let said = text(&asked(&line[..line.len() - 6]).stdout);
    assert!(said.contains("2 are out of range"), "{said}");
    let line = "solve sinusoidal --lambda0 -0.1:0.8:10";
    let rows = text(&asked(line).stdout);
    assert_eq!(rows.matches("must be between").count(), 2, "{rows}");
}

/// How many, and an exit code of its own where there is no other row.
#[test]
fn refused_rows_are_counted() {
    let constant = "solve constant --lambda 1 --v0 1 --time 1 --theta0";
    for (line, told, code) in [
        (format!("{constant} 4:5:2"), "2 of 2 rows refused", 2),
        (format!("{constant} 3:5:3"), "2 of 3 rows refused", 0),
        (format!("{constant} 1:2:3"), "", 0),
        (
            "ensemble --rho -2:-1:2 --p 1 --psi 0".into(),
            "2 of 2 rows refused",
            2,
        ),
        (
            "ensemble --rho -1:1:3 --p 1 --psi 0".into(),
            "1 of 3 rows refused",
            0,
        ),
    ] {
        for form in ["", " --csv", " --json"] {
            let line = format!("{line}{form}");
            let output = asked(&line);
            let said = text(&output.stderr);
            assert_eq!(output.status.code(), Some(code), "{line}");
            assert_eq!(
                said.trim_start_matches("slipbook: ").trim_end(),
                told,
                "{line}"
            );
        }
    }
    let part = asked(&format!("{constant} 3:5:3 --csv --shard 2/2"));
    assert_eq!(part.status.code(), Some(2));
}

#[test]
fn a_sweep_has_a_row_for_each_point_as_asked_alone() {
    let said = |line: &str| {
        let output = asked(line);
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        text(&output.stdout)
    };
    let rows = said("solve constant --lambda 0.5:1.5:3 --v0 1 --theta0 1:1.5:2 --time 0.25 --csv");
    assert!(
        rows.starts_with(
            "lambda (dimensionless),theta0 (rad),v (unit of v0),theta (rad),t (unit of v0/A),vx (unit of v0),vy (unit of v0),\
             stop_time (unit of v0/A),digits,note\n"
        ),
        "{rows}"
    );
    let rows: Vec<Vec<&str>> = rows.lines().map(|row| row.split(',').collect()).collect();
    assert_eq!(rows.len(), 7);
    for row in &rows[1..] {
        let (lambda, theta0) = (row[0], row[1]);
        let line =
            format!("solve constant --lambda {lambda} --v0 1 --theta0 {theta0} --time 0.25 --json");
        let alone: Value = serde_json::from_str(&said(&line)).unwrap();
        assert_eq!(
            row[2].parse::<f64>().unwrap(),
            alone["v"].as_f64().unwrap(),
            "{row:?}"
        );
        assert_eq!(row[8], alone["digits"].to_string());
    }
    // What is swept is no answer beside.
    for line in [
        "constant --lambda 1.5 --v0 1 --theta0 2 --theta 0.1:0.3:3",
        "sphere --gamma 2 --u0 1 --theta0 1 --theta 0.2:0.8:3",
    ] {
        let rows = said(&format!("solve {line} --csv"));
        let heads: Vec<_> = rows.lines().next().unwrap().split(',').collect();
        let angles = heads.iter().filter(|head| head.starts_with("theta ("));
        assert_eq!(angles.count(), 1, "{heads:?}");
        for row in rows.lines() {
            assert_eq!(row.split(',').count(), heads.len(), "{row}");
        }
    }
    let json: Value = serde_json::from_str(&said(
        "solve turntable --rho 0.5 --p 0.1:0.3:3 --psi pi/2 --json",
    ))
    .unwrap();
    assert_eq!(json["answers"][1]["given"]["p"], 0.2);
    assert_eq!(json["answers"][1]["answer"]["outcome"], "rest");
    for problem in [
        "sinusoidal --lambda0 0.3:0.5:2",
        "pulse --eta 0.5 --lambda0 0.3:0.4:2",
        "anisotropic --q 2:3:2 --lambda0 0.45",
        "sphere --gamma 2:3:2 --u0 1 --theta0 1 --time 0.3",
        "turntable --x 0.5 --y 0 --vx -0.1:0.1:2 --vy 0.2 --time 0.4",
        "turntable-boundary --alpha 0.1:0.5:2 --psi 1",
    ] {
        let rows = said(&format!("solve {problem} --csv"));
        let head = rows.lines().next().unwrap();
        assert!(
            rows.lines().count() == 3 && head.ends_with(",digits,note"),
            "{rows}"
        );
        assert!(said(&format!("solve {problem}")).lines().count() > 3);
    }
    let refused = slipbook(&["solve", "sinusoidal", "--lambda0", "0.3:0.5:2", "--plot"]);
    assert_eq!(refused.status.code(), Some(2));
}

#[test]
fn the_parts_of_a_grid_make_the_whole() {
    for line in [
        "ensemble --rho 0.5 --p 0:1.4:5 --psi -1:2:3 --csv",
        "ensemble --rho 0.5 --p 0:1.4:5 --psi -1:2:3 --json",
        "solve turntable --rho 0.5 --p 0:1.4:5 --psi 1 --csv",
        "solve turntable --rho 0.5 --p 0:1.4:5 --psi 1 --json",
    ] {
        let said = |more: &str| text(&asked(&format!("{line}{more}")).stdout);
        for of in [3, 7] {
            let parts = (1..=of).map(|part| said(&format!(" --shard {part}/{of}")));
            assert_eq!(parts.collect::<String>(), said(""), "{line}");
        }
    }
}

/// By hand in SI units: the slip of a ball on a level plane falls at the rate 7μg/2, rolling it has 5/7 of its speed; with
/// λ = 7μg/(2A) under a pull rolling begins at u₀(λ + cos θ₀)/(A(λ² − 1)). On the table by other integrators in metres and seconds.
/// Slips of a drive by (31), with λ₀ = 3/5, A₀/ω = 2.5 m/s and A₀/ω² = 1.25 m.
#[test]
fn what_is_asked_in_si_units_is_answered_in_them() {
    let lambda = 3.5 * 0.2 * 9.80665 / 3.0;
    let rolls_at = (lambda + libm::cos(1.0)) / (3.0 * (lambda * lambda - 1.0));
    let rolled = "--mu 0.08 --g 9.8 --accel 1e-12 --u0 5 --theta0 0 --time 9";
    let drive = "--mu 0.3 --g 10 --a0 5 --omega 2";
    let at_rest = "turntable --mu 0.4 --omega 3.5 --r 0.1 --speed 0.05 --psi 30deg";
    for (line, numbers) in [
        (
            "sphere --mu 0.08 --g 9.8 --accel 1e-12 --u0 5 --theta0 0 --time 1.5",
            &[
                ("u", 0.884, "m/s"),
                ("rolls_at", 5.0 / 2.744, "s"),
                ("tau", 1.5, "s"),
            ][..],
        ),
        (
            &format!("sphere {rolled}"),
            &[("zeta_y", 25.0 / 7.0, "m/s")],
        ),
        (
            &format!("sphere {rolled} --radius 0.1"),
            &[("zeta_y", 250.0 / 7.0, "1/s")],
        ),
        (
            "sphere --mu 0.2 --accel 3 --u0 1 --theta0 1 --time 0.1",
            &[("rolls_at", rolls_at, "s")],
        ),
        (
            "turntable --mu 0.25 --omega 5 --r 0.12 --speed 0.2 --psi 2 --time 0.2",
            &[
                ("rho", 0.129_970_309_805, "m"),
                ("p", 0.120_287_880_7, "m/s"),
            ],
        ),
        (
            at_rest,
            &[
                ("sigma", 0.100_394_214_824, "m"),
                ("tau_rest", 0.017_844_099_876, "s"),
            ],
        ),
        (
            "constant --mu 0.5 --g 9.81 --accel 1e-12 --v0 6 --theta0 0 --time 1",
            &[("v", 1.095, "m/s"), ("stop_time", 6.0 / 4.905, "s")],
        ),
        (
            &format!("pulse --eta 0.5 {drive}"),
            &[("w_max", 0.5 * PI, "m/s")],
        ),
        (
            &format!("sinusoidal {drive}"),
            &[
                ("w_max", 2.5 * 0.487_245_738_398, "m/s"),
                ("positive_start", libm::asin(0.6), "rad"),
                ("rest_fraction", 0.083_282_234_656, "dimensionless"),
            ],
        ),
        (
            &format!("anisotropic --q 2 {drive}"),
            &[("drift_per_period", 1.25 * 0.788_372_108_748, "m")],
        ),
    ] {
        let line = format!("solve {line}");
        let answer = json(&line.split(' ').collect::<Vec<_>>());
        let table = text(&asked(&line).stdout);
        assert_eq!(answer["digits"], 15, "{line}");
        for (name, right, unit) in numbers {
            let found = answer[name].as_f64().unwrap();
            assert!(
                (found - right).abs() < 1e-9,
                "{line}: {name} = {found}, {right}"
            );
            assert_eq!(answer["units"][name], *unit, "{line}");
            let mut rows = table.lines().map(|row| row.split_whitespace());
            let row = rows.find_map(|mut row| (row.next()? == *name).then_some(row));
            let [number, beside] = [0, 1].map(|n| row.clone().unwrap().nth(n).unwrap());
            assert_eq!((number.parse(), beside), (Ok(found), *unit), "{table}");
        }
    }
    let swept = "solve turntable --mu 0.25 --omega 5 --r 0.1:0.12:2 --speed 0.2 --psi 2 --time 0.2";
    let rows = text(&asked(&format!("{swept} --csv")).stdout);
    let head = "r (m),x (m),y (m),vx (m/s),vy (m/s),rho (m),p (m/s),psi (rad),digits,note\n0.1,";
    assert!(
        rows.starts_with(head) && rows.contains(",0.12997030980"),
        "{rows}"
    );
    let answers = json(&swept.split(' ').collect::<Vec<_>>());
    assert_eq!(answers["units"]["r"], "m");
    assert_eq!(answers["answers"][1]["answer"]["units"]["p"], "m/s");
    let plot = text(&asked(&format!("solve {at_rest} --plot")).stdout);
    assert!(
        plot.contains("y (m) against x (m)") && plot.contains("0.1"),
        "{plot}"
    );
}

/// A number in the paper's units names them.
#[test]
fn what_is_asked_in_the_papers_units_is_answered_in_them() {
    for (line, units) in [
        (
            "sphere --gamma 2 --u0 1 --theta0 1 --time 0.3",
            "√(μgR) √(R/(μg)) √(μg/R) rad",
        ),
        (
            "turntable --rho 0.5 --p 0.3 --psi 1 --time 1",
            "μg/Ω² μg/Ω rad",
        ),
        ("turntable --rho 0.5 --p 0.3 --psi 1", "μg/Ω² 1/Ω"),
        ("anisotropic --q 2 --lambda0 0.45", "rad A₀/ω²"),
        ("sinusoidal --lambda0 0.7", "rad A₀/ω dimensionless"),
    ] {
        let said = text(&asked(&format!("solve {line}")).stdout);
        let missing = |unit: &&str| !said.contains(&format!(" {unit} "));
        assert_eq!(units.split(' ').find(missing), None, "{said}");
    }
}

#[test]
fn angles_are_in_radians_unless_they_name_degrees() {
    let refused = asked("solve constant --lambda 1 --v0 1 --theta0 120 --time 1");
    assert!(text(&refused.stderr).contains("120deg would be degrees"));
    let warned = asked("solve turntable --rho 0.5 --p 0.3 --psi 720");
    assert_eq!(warned.status.code(), Some(0));
    assert!(text(&warned.stderr).contains("720deg is in degrees"));
}

/// Ctrl-C is a signal only where there are signals.
#[cfg(unix)]
#[test]
fn an_ensemble_stops_in_good_order() {
    use std::io::{BufRead, BufReader, Read};

    // The whole, and a part that is not the last.
    for (part, of) in [
        (&[][..], 10_000_000_000_u64),
        (&["--shard", "1/2"], 5_000_000_000),
    ] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_slipbook"))
            .args([
                "ensemble",
                "--rho",
                "0.5",
                "--p",
                "0:1.5:100000",
                "--psi=-3:3:100000",
                "--json",
            ])
            .args(part)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut out = BufReader::new(child.stdout.take().unwrap());
        let mut said = String::new();
        for _ in 0..10 {
            out.read_line(&mut said).unwrap();
        }
        let interrupted = Command::new("kill")
            .args(["-INT", &child.id().to_string()])
            .status();
        assert!(interrupted.unwrap().success());
        out.read_to_string(&mut said).unwrap();
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(130));
        let whole: Value = serde_json::from_str(&said).unwrap();
        let rows = whole["ends"].as_array().unwrap().len();
        assert!(
            rows > 0 && whole["done"] == rows,
            "{rows} {}",
            whole["done"]
        );
        assert_eq!(whole["of"], 10_000_000_000_u64);
        assert!(text(&output.stderr).contains(&format!("stopped after {rows} of {of} starts")));
    }
}

#[test]
fn a_claim_is_tried_in_depth() {
    let output = slipbook(&["verify", "eq-16", "--depth", "3"]);
    let said = text(&output.stdout);
    assert!(output.status.success(), "{said}");
    // A thousand points a round, and the proof once.
    assert!(
        said.contains("1 of 1 verdicts as recorded, in 3 rounds and 3001 comparisons"),
        "{said}"
    );
    // An error that is inherited is one at every depth, whether or not what it comes from is asked for.
    let output = slipbook(&["verify", "eq-83", "--depth", "2"]);
    let said = text(&output.stdout);
    assert!(
        said.contains("1 of 1 verdicts as recorded, in 2 rounds"),
        "{said}"
    );
    // The rounds are at other points.
    let [first, second] =
        ["1", "2"].map(|round| text(&slipbook(&["verify", "eq-16", "--round", round]).stdout));
    assert!(
        first.starts_with("eq-16 ") && first != second,
        "{first}{second}"
    );
    // Many jobs with a part each are one run.
    let folder = tempfile::tempdir().unwrap();
    let asked = ["verify", "eq-16", "eq-20", "--depth", "5"];
    let with = |more: &[&str]| slipbook(&[&asked[..], more].concat());
    let parts: Vec<_> = (1..=3)
        .map(|part| {
            let said = with(&["--shard", &format!("{part}/3")]);
            assert!(said.status.success(), "{}", text(&said.stderr));
            let path = folder.path().join(format!("{part}.tsv"));
            std::fs::write(&path, said.stdout).unwrap();
            path.to_str().unwrap().to_owned()
        })
        .collect();
    for format in [&[][..], &["--json"], &["--csv"]] {
        let joined = with(&[format, &["--parts", &parts[2], &parts[0], &parts[1]]].concat());
        assert_eq!(joined.stdout, with(format).stdout);
    }
    let lost = with(&["--parts", &parts[0], &parts[2]]);
    assert_eq!(lost.status.code(), Some(2));
    assert!(text(&lost.stderr).contains("round 1 is missing"));
    let refused = slipbook(&["verify", "--shard", "1/2"]);
    assert!(text(&refused.stderr).contains("--depth"));
    let refused = slipbook(&["find", "0.5", "--depth", "3"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(text(&refused.stderr).contains("--depth goes without a command or with verify"));
}

#[test]
fn mistakes_are_put_to_the_trials_of_a_claim() {
    let output = slipbook(&["distrust", "eq-16", "s22-attractor-ignores-vy"]);
    let said = text(&output.stdout);
    assert!(output.status.success(), "{said}");
    assert!(
        said.contains("that agree all but 1 notice one at least; 0 at fault"),
        "{said}"
    );
    let matrix = json(&["distrust", "eq-16"]);
    let trials = matrix["trials"].as_array().unwrap();
    assert!(
        trials
            .iter()
            .all(|trial| !trial["rejects"].as_array().unwrap().is_empty())
    );
    assert_eq!(slipbook(&["distrust", "eq-999"]).status.code(), Some(2));
}

/// A table for programs and the JSON of the same question have the same under the same names; of a list the table has the length.
#[test]
fn a_table_and_its_json_say_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("certificates");
    let out = out.to_str().unwrap();
    for (arguments, rows) in [
        (
            &[
                "ensemble",
                "--rho",
                "0.5:0.95:6",
                "--p",
                "0.1",
                "--psi",
                "0.3",
            ][..],
            "ends",
        ),
        (&["distrust", "s2-no-permanent-rest", "eq-20"], "trials"),
        (&["certify", "eq-20", "--out", out], "proofs"),
        (&["find", "0.53700"], "matches"),
        (
            &["list", "--section", "2.1", "--verdict", "misprint"],
            "claims",
        ),
    ] {
        let answer = json(arguments);
        let table = text(&slipbook(&[arguments, &["--csv"]].concat()).stdout);
        let cells = |line: &'_ str| -> Vec<String> {
            let mut quoted = false;
            let between = |c| {
                quoted ^= c == '"';
                c == ',' && !quoted
            };
            line.split(between).map(str::to_owned).collect()
        };
        let mut lines = table.lines().map(cells);
        let head = lines.next().unwrap();
        let answers = answer[rows].as_array().unwrap();
        assert_eq!(lines.clone().count(), answers.len(), "{table}");
        let mut compared = 0;
        for (line, answer) in lines.zip(answers) {
            for (name, cell) in head.iter().zip(line) {
                let name = name.split(" (").next().unwrap();
                let evidence = answer["evidence"].as_array().map(Vec::as_slice);
                let expected = match &answer[name] {
                    // LaTeX there, plain text here.
                    _ if ["formula", "meaning"].contains(&name) => continue,
                    Value::Null if name == "points" => {
                        let points = evidence
                            .unwrap()
                            .iter()
                            .map(|e| e["points"].as_u64().unwrap());
                        points.sum::<u64>().to_string()
                    }
                    Value::Null => continue,
                    Value::Bool(so) => u8::from(*so).to_string(),
                    Value::Array(list) => list.len().to_string(),
                    Value::String(word) => word.clone(),
                    number => number.to_string(),
                };
                assert_eq!(cell, expected, "{name} of {answer}");
                compared += 1;
            }
        }
        assert!(
            !answers.is_empty() && compared >= 5 * answers.len(),
            "{compared}"
        );
    }
}

/// The rounds of a deep run are all at other points, however many there are.
#[test]
fn each_round_has_points_of_its_own() {
    let mut rounds: Vec<_> = [0, 1, 2, 3, 4, 5, 8, 16, 64, 100]
        .into_iter()
        .map(|round: u32| {
            text(&slipbook(&["verify", "eq-2", "--round", &round.to_string()]).stdout)
        })
        .collect();
    let all = rounds.len();
    rounds.sort();
    rounds.dedup();
    assert_eq!(rounds.len(), all);
}

/// Where a mistake passes, the JSON of the claim says so.
#[test]
fn json_counts_the_mistakes_that_pass() {
    let shown = text(&slipbook(&["show", "s21-along-acceleration", "--json"]).stdout);
    assert!(
        shown.contains("\"variants\": 8") && shown.contains("\"rejected\": 7"),
        "{shown}"
    );
}

/// What the pages tell to type for an ensemble, with fewer particles.
#[test]
fn ensembles_on_the_pages_run() {
    let mut count = 0;
    for page in [
        include_str!("../../book/src/python.md"),
        include_str!("../../book/src/speed.md"),
    ] {
        for line in page
            .lines()
            .filter_map(|line| line.strip_prefix("slipbook ensemble "))
        {
            let line = line.split(" > ").next().unwrap().replace(":1000", ":4");
            let arguments: Vec<_> = ["ensemble"].into_iter().chain(line.split(' ')).collect();
            let output = slipbook(&arguments);
            assert!(
                output.status.success() && !output.stdout.is_empty(),
                "{line}"
            );
            count += 1;
        }
    }
    assert!(count > 0);
}

#[test]
fn the_readme_gives_the_exit_codes() {
    let (_, says) = include_str!("../../README.md")
        .split_once("exit code")
        .unwrap();
    let digits = says.chars().filter(char::is_ascii_digit).take(3);
    assert_eq!(digits.collect::<String>(), "012");
    assert_eq!(slipbook(&["verify", "eq-11"]).status.code(), Some(0));
    assert_eq!(slipbook(&["verify", "no-claim"]).status.code(), Some(2));
}
