//! The command as its users meet it.

mod cases;

use crate::{cells, slipbook};
use serde_json::Value;
use slipbook::ledger::Format;
use slipbook::solve::axes;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use trialbook::data::text;

fn words(line: &str) -> Vec<&str> {
    let parts = line.split('\'').enumerate();
    let words = parts.flat_map(|(i, part)| match i % 2 {
        0 => part.split_whitespace().collect(),
        _ => vec![part],
    });
    words.collect()
}

fn asked(line: &str) -> Output {
    slipbook(&words(line))
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

fn json(line: &str) -> Value {
    let output = asked(&format!("{line} --json"));
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert_eq!(
        text(&output.stderr),
        "",
        "progress shows on a terminal only"
    );
    serde_json::from_slice(&output.stdout).unwrap()
}

#[test]
fn what_is_wrong_has_the_same_verdict_alone() {
    let record = text!("snapshots/verdicts.snap").as_str();
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
fn no_option_is_given_in_vain() {
    let cases = include_str!("command/vain.txt").lines();
    for (line, idle) in cases.map(|case| case.split_once(" => ").unwrap()) {
        let output = asked(line);
        assert!(output.status.success(), "{line}: {}", text(&output.stderr));
        for option in idle.split(' ') {
            let more = format!("{line} --{option} 1");
            let output = asked(&more);
            assert_eq!(output.status.code(), Some(2), "{more}");
            assert!(
                line.starts_with("scene") || text(&output.stderr).contains("cannot be used with"),
                "{more}"
            );
        }
    }
}

#[test]
fn what_solve_has_lost_a_scene_answers() {
    let problems = "constant sinusoidal pulse anisotropic sphere turntable turntable-boundary";
    for problem in problems.split(' ') {
        for option in "mu g a0 omega radius r speed".split(' ') {
            let refused = asked(&format!("solve {problem} --{option} 1"));
            let told = text(&refused.stderr);
            assert!(told.contains("unexpected argument"), "{told}");
            let scene = told
                .split('`')
                .find(|part| part.starts_with("slipbook scene"));
            let scene = scene.unwrap().split_once(' ').unwrap().1;
            assert!(asked(scene).status.success(), "{scene}");
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
    let commands = "verify show list errata find solve scene measure completions man schema";
    let problems = "constant sinusoidal pulse anisotropic sphere turntable turntable-boundary";
    let problems = problems
        .split(' ')
        .map(|problem| format!("solve {problem}"));
    for command in commands.split(' ').map(str::to_owned).chain(problems) {
        let output = asked(&format!("{command} --help"));
        assert_eq!(output.status.code(), Some(0), "{command}");
        let help = text(&output.stdout);
        assert!(help.contains(&format!("slipbook {command}")), "{command}");
        let common = help.find("      --json").unwrap();
        assert!(help[common..].find(" <RANGE>").is_none(), "{help}");
    }
}

#[test]
fn shells_get_their_completions() {
    let verify = text(&asked("verify --help").stdout);
    assert!(!verify.contains("--round") && !verify.contains("--record"));
    assert!(!text(&asked("show --help").stdout).contains("s21-frictionless-parabola"));
    assert!(text(&asked("completions bash").stdout).contains("s21-frictionless-parabola"));
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = text(&asked(&format!("completions {shell}")).stdout);
        assert!(script.contains("slipbook") && script.contains("shard"));
        // What no help names is not completed.
        for form in ["--round", "'round'", "-l round"] {
            assert!(!script.contains(form), "{shell}");
        }
    }
}

#[test]
fn the_manual_and_the_schema_come_from_what_they_describe() {
    let page = text(&asked("man").stdout);
    assert!(page.contains(".TH slipbook 1"), "{page}");
    let json = include_str!("../../book/src/json.md");
    assert!(
        [axes::LINE, axes::DRIVE, axes::TABLE]
            .iter()
            .all(|axes| json.contains(axes))
    );
    let schema: Value = serde_json::from_slice(&asked("schema").stdout).unwrap();
    let find = &schema["$defs"]["find"]["properties"];
    assert_eq!(
        find["matches"]["items"]["properties"]["first_wrong"]["type"],
        serde_json::json!(["number", "null"])
    );
    let answers = schema["anyOf"].as_array().unwrap();
    assert!(answers.len() > 12, "{answers:?}");
}

#[test]
fn errors_are_counted_alike_everywhere() {
    let read = |file: &str| fs::read_to_string(crate::BOOK.join(file)).unwrap();
    let register = text(&asked("errata --csv").stdout);
    let mut rows = register.lines();
    assert_eq!(
        rows.next().unwrap(),
        "id,section,equation,verdict,printed,corrected,reason,evidence,inherits,check"
    );
    let misprint = rows.find(|row| row.contains(",misprint,")).unwrap();
    let (id, _) = misprint.split_once(',').unwrap();
    let check = format!(",slipbook verify {id}");
    assert!(misprint.ends_with(&check), "{misprint}");
    let count = |verdict: &str| register.matches(&format!(",{verdict},")).count();
    let heirs = count("inherited");
    let slips = count("misprint");
    let text = trialbook::notation::without_tags(&read("index.html"));
    let numbers = text.split(|c: char| !c.is_ascii_digit());
    let numbers: Vec<usize> = numbers.filter_map(|n| n.parse().ok()).collect();
    assert!(
        numbers.contains(&slips) && numbers.contains(&heirs),
        "{text}"
    );
}

/// No file may grow beyond a few kilobytes.
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

fn earlier_book(folder: &Path) -> PathBuf {
    let out = folder.join("book");
    fs::create_dir(&out).unwrap();
    fs::write(out.join(".slipbook"), "").unwrap();
    fs::write(out.join("index.html"), "the earlier book").unwrap();
    out
}

/// Twice at once: one whole book is left.
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
        "scene block --mu 0.3 --throw 1m/s --every 0.1s --csv",
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
    let rows = text(&asked("ensemble --rho 0.5 --p 0.2:1.4:3 --psi=-1:2:2 --csv").stdout);
    for row in rows.lines().skip(1) {
        let row: Vec<_> = row.split(',').collect();
        let single = json(&format!(
            "solve turntable --rho {} --p {} --psi {}",
            row[0], row[1], row[2]
        ));
        let outcome = single["outcome"].as_str().unwrap();
        match row[4].parse::<f64>() {
            Ok(sigma) => assert!(
                outcome == row[3] && (sigma - single["sigma"].as_f64().unwrap()).abs() < 1e-9,
                "{row:?}"
            ),
            Err(_) => assert_eq!((row[3], outcome), ("far", "escape")),
        }
    }
}

#[test]
fn a_row_of_a_sweep_is_what_is_answered_alone() {
    let sweep = "solve constant --lambda 0.5:1.5:3 --v0 1 --theta0 1:1.5:2 --time 0.25 --csv";
    for row in text(&asked(sweep).stdout).lines().skip(1) {
        let row: Vec<_> = row.split(',').collect();
        let alone = json(&format!(
            "solve constant --lambda {} --v0 1 --theta0 {} --time 0.25",
            row[0], row[1]
        ));
        assert_eq!(row[2].parse(), Ok(alone["v"].as_f64().unwrap()), "{row:?}");
        assert_eq!(row[10], alone["digits"].to_string());
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
    let wrong = said("list --verdict misprint --csv", 80, &[]);
    let (wrong, _) = wrong.lines().nth(1).unwrap().split_once(',').unwrap();
    let [verify, show] = ["verify", "show"].map(|command| format!("{command} {wrong}"));
    for line in [&*verify, &*show, "find 0.53701"] {
        let painted = said(line, 80, &["--color", "always"]);
        assert!(painted.contains("\u{1b}[31m"), "{painted}");
        assert!(!said(line, 80, &[]).contains('\u{1b}'), "{line}");
    }
    assert!(!said("verify eq-82", 80, &[]).contains('\u{1b}'));
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

/// Only where there are signals.
#[cfg(unix)]
#[test]
fn long_work_stops_in_good_order() {
    use std::io::{BufRead, BufReader, Read};

    let ensemble = "ensemble --rho 0.5 --p 0:1.5:100000 --psi=-3:3:100000";
    let solve = "solve constant --lambda 0.5 --v0 1 --theta0 1 --time 0:2:1000000";
    let boundary = "solve turntable-boundary --alpha 0.1:1:100 --psi 0:3:100";
    for (line, part, list, of, total) in [
        (ensemble, "", "ends", 10_000_000_000_u64, 10_000_000_000_u64),
        (
            ensemble,
            " --shard 1/2",
            "ends",
            5_000_000_000,
            10_000_000_000,
        ),
        (solve, "", "answers", 1_000_000, 1_000_000),
        (solve, " --shard 1/2", "answers", 500_000, 1_000_000),
        (boundary, "", "answers", 10_000, 10_000),
    ] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_slipbook"))
            .args(format!("{line}{part} --json").split(' '))
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
        assert_eq!(output.status.code(), Some(130), "{line}");
        let whole: Value = serde_json::from_str(&said).unwrap();
        let rows = whole[list].as_array().unwrap().len();
        assert!(
            rows > 0 && whole["done"] == rows,
            "{rows} {}",
            whole["done"]
        );
        assert_eq!(whole["of"], total);
        let what = if list == "ends" { "starts" } else { "rows" };
        let told = format!("stopped after {rows} of {of} {what}");
        assert!(text(&output.stderr).contains(&told), "{line}");
    }
}

#[cfg(unix)]
fn interrupted(line: &str) -> Output {
    let child = Command::new(env!("CARGO_BIN_EXE_slipbook"))
        .args(words(line))
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    std::thread::sleep(std::time::Duration::from_millis(500));
    let id = child.id().to_string();
    let sent = Command::new("kill").args(["-INT", &id]).status();
    assert!(sent.unwrap().success());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130), "{line}");
    output
}

#[cfg(unix)]
#[test]
fn trials_stop_in_good_order() {
    let out = tempfile::tempdir().unwrap();
    let book = out.path().join("book");
    let book = format!("--out {} --json", book.to_str().unwrap());
    for line in ["verify --json", "list --try --json", &book] {
        let output = interrupted(line);
        let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
        let claims = answer["claims"].as_array().unwrap();
        let told = format!("stopped: {} of ", claims.len());
        assert!(text(&output.stderr).starts_with(&told), "{line}");
        assert_eq!(answer["differences"], serde_json::json!([]), "{line}");
    }
    assert_eq!(fs::read_dir(out.path()).unwrap().count(), 0);
}

#[cfg(unix)]
#[test]
fn scenes_stop_in_good_order() {
    let output = interrupted("scene block --throw 3m/s --vary mu=0.1:0.9:100000000 --json");
    let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
    let rows = answer["answers"].as_array().unwrap().len();
    let told = format!("stopped after {rows} of 100000000 rows");
    assert!(rows > 0 && text(&output.stderr).contains(&told), "{rows}");
    let find = "scene block --pull 4*sin(10*pi*t) --until 20s --find mu=0.1:2 --where path=55m";
    assert_eq!(interrupted(find).stdout, b"");
}

#[test]
fn a_claim_is_tried_in_depth() {
    // Whether or not what it comes from is asked for.
    let output = asked("verify eq-83 --depth 2");
    let said = text(&output.stdout);
    assert!(
        said.contains("1 of 1 verdicts as recorded, in 2 rounds"),
        "{said}"
    );
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
}

#[test]
fn mistakes_are_put_to_the_trials_of_a_claim() {
    let output = asked("distrust eq-16 s22-attractor-ignores-vy");
    let said = text(&output.stdout);
    assert!(output.status.success(), "{said}");
    assert!(
        said.contains("that agree all but 1 notice one at least; 0 at fault"),
        "{said}"
    );
    let matrix = json("distrust eq-16");
    let trials = matrix["trials"].as_array().unwrap();
    assert!(
        trials
            .iter()
            .all(|trial| !trial["rejects"].as_array().unwrap().is_empty())
    );
}

#[test]
fn a_table_and_its_json_say_the_same() {
    for (arguments, rows) in [
        ("ensemble --rho 0.5:0.95:6 --p 0.1 --psi 0.3", "ends"),
        ("distrust s2-no-permanent-rest eq-20", "trials"),
        ("find 0.53700", "matches"),
        ("list --section 2.1 --verdict misprint --try", "claims"),
    ] {
        let answer = json(arguments);
        let table = text(&asked(&format!("{arguments} --csv")).stdout);
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

#[test]
fn ensembles_on_the_pages_run() {
    let mut count = 0;
    let page = text!("book/src/json.md").as_str();
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
    assert!(count > 0);
}

#[test]
fn the_readme_gives_the_exit_codes() {
    let (_, says) = text!("README.md").as_str().split_once("exit code").unwrap();
    let digits = says.chars().filter(char::is_ascii_digit).take(3);
    assert_eq!(digits.collect::<String>(), "012");
    assert_eq!(asked("verify eq-11").status.code(), Some(0));
    assert_eq!(asked("verify no-claim").status.code(), Some(2));
}
