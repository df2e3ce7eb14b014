//! Text from outside has no way out but an escaped one: by itself, and through the whole command.

use raybook_chapters::kit::untrusted::{Untrusted, is_hidden};

/// What a terminal, a reader, a shell or a browser could take for more than a character.
const NASTY: &str = "\u{1b}[2J\u{1b}]52;c;cm0gLXJmIH4=\u{7} \u{9b}31m \u{90}q\u{9c} a\rb \u{8}\u{0}\u{7f} \u{202e}dlo\u{202c} \u{2066}x\u{2069} \u{200b}\u{200d}\u{200e}\u{200f}\u{61c}\u{feff}\u{ad}\u{2060}\u{2028}\u{2029}\u{e0041}\u{85}";

/// The characters that must not come out, a line end aside.
fn hidden(text: &str) -> Vec<char> {
    let control = |c: char| c.is_control() && c != '\n' && c != '\t';
    let mark = |c: char| {
        matches!(c, '\u{ad}' | '\u{61c}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}'
            | '\u{2060}'..='\u{206f}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e007f}')
    };
    text.chars().filter(|&c| control(c) || mark(c)).collect()
}

#[test]
fn what_is_shown_hides_nothing() {
    let shown = Untrusted::from(NASTY).to_string();
    assert_eq!(hidden(&shown), [], "{shown}");
    assert!(
        shown.contains("\\u{1b}[2J") && shown.contains("a\\rb"),
        "{shown}"
    );
    let debugged = format!("{:?}", Untrusted::from(NASTY));
    assert_eq!(hidden(&debugged), [], "nor where a test prints it");
    assert_eq!(Untrusted::from("a\nb").to_string(), "a\\nb", "one line");
    for c in (0..0x11_0000).filter_map(char::from_u32) {
        let shown = Untrusted::from(c.to_string()).to_string();
        assert!(hidden(&shown).is_empty() && !shown.is_empty(), "{c:?}");
    }
}

#[test]
fn what_people_write_stays_as_it_is() {
    let text =
        "grüße, ναί, да, 你好, שלום, नमस्ते, สวัสดี, e\u{301}, 3 → 4 m², `x`, C:\\rays\t\"q\" 🙂";
    assert_eq!(Untrusted::from(text).to_string(), text, "any language");
    assert!(!text.chars().any(is_hidden), "and no mark of it");
}

#[cfg(unix)]
mod in_a_shell {
    use super::{NASTY, hidden};
    use crate::common::executable::script;
    use raybook_chapters::kit::untrusted::Untrusted;
    use std::fs;
    use std::path::Path;
    use std::process::Command;

    const WORDS: [&str; 14] = [
        "plain/path-1.0",
        "$(touch x)",
        "`touch x`",
        "a b",
        "it's",
        "; touch x #",
        "\"; touch x; \"",
        "'; touch x; '",
        "a\\",
        "",
        "*",
        "~",
        "=ls !! {a,b}",
        "\u{1b}'; touch x; '\\'; touch x; '!",
    ];

    /// What a shell makes of a word, and whether it did anything else.
    fn understood(shell: &str, word: &str) -> Option<(String, bool)> {
        let home = tempfile::tempdir().expect("a temporary folder");
        let command = format!("printf '%s|' {word}");
        let output = Command::new(shell)
            .args(["-c", &command])
            .current_dir(home.path())
            .output()
            .ok()?;
        let said = String::from_utf8_lossy(&output.stdout).into_owned();
        let did = fs::read_dir(home.path()).expect("a folder").count() > 0;
        Some((said, did))
    }

    #[test]
    fn a_word_of_a_command_means_itself() {
        for word in WORDS {
            let quoted = Untrusted::from(word).shell();
            assert_eq!(hidden(&quoted), [], "{quoted}");
            let (said, did) = understood("/bin/sh", &quoted).expect("there is a shell");
            assert!(!did, "{quoted} does nothing");
            // Not every shell knows `$'…'`; in each it is one word.
            assert!(
                said == format!("{word}|") || quoted.starts_with("$'"),
                "{quoted} is {said}"
            );
            assert_eq!(said.matches('|').count(), 1, "{quoted} is {said}");
        }
        let quoted = Untrusted::from(NASTY.replace('\0', "")).shell();
        assert_eq!(hidden(&quoted), [], "{quoted}");
        if let Some((said, did)) = understood("bash", &quoted) {
            assert!(!did, "{quoted} does nothing");
            assert_eq!(said, format!("{}|", NASTY.replace('\0', "")), "{quoted}");
        }
    }

    /// Runs the command in a folder: all that it says, its exit code.
    fn raybook(folder: &Path, arguments: &[&str]) -> (i32, String) {
        crate::common::command::raybook(folder, arguments)
    }

    #[test]
    fn whatever_a_program_says_nothing_hidden_comes_out() {
        let home = tempfile::tempdir().expect("a temporary folder");
        let program = home.path().join("answers");
        // In the sandbox a shell starts no process that could read it from a file.
        let nasty = NASTY.replace('\0', "").replace('\'', r"'\''");
        for (way, say) in [
            ("an answer", "echo \"= $x\""),
            ("a long answer", "echo \"= 1 2 $x$x$x\""),
            ("a todo", "echo \"= todo $x\""),
            ("a panic", "echo \"= panic $x\""),
            ("an error", "echo \"= error $x\""),
            ("a print", "echo \"$x\"; echo \"$x\"; echo '= 1 2 3'"),
            ("no answer", "echo \"$x= 1 2 3\""),
            ("standard error", "echo \"$x\" >&2; echo '= 1 2 3'"),
            ("last words", "echo \"$x\" >&2; exit 3"),
        ] {
            let text = format!("#!/bin/sh\nx='{nasty}'\nwhile read -r q; do {say}; done\n");
            script(&program, &text);
            let check = ["check", "ray_at", "camera_ray", "--program", "answers"];
            for further in [&[][..], &["--plain"], &["--json"]] {
                let (code, said) = raybook(home.path(), &[&check[..], further].concat());
                assert_eq!(code, 1, "{way}: {said}");
                assert_eq!(hidden(&said), [], "{way} {further:?}: {said:?}");
            }
            let case = ["check", "ray_at", "--case", "2", "--program", "answers"];
            let (_, said) = raybook(home.path(), &case);
            assert_eq!(hidden(&said), [], "{way}, one case: {said:?}");
            let shows = said.contains("\\u{1b}") || said.contains("\\u{202e}");
            assert!(shows, "{way}: what it said is shown: {said}");
            let (_, said) = raybook(home.path(), &["hint", "ray_at", "--program", "answers"]);
            assert_eq!(hidden(&said), [], "{way}, a hint: {said:?}");
        }
    }

    #[test]
    fn whatever_files_are_called_nothing_hidden_comes_out() {
        let home = tempfile::tempdir().expect("a temporary folder");
        let name = "a\u{1b}[2J\r\u{202e}b";
        for arguments in [
            &["check", name][..],
            &["check", "--program", name],
            &[
                "check",
                "ray_at",
                "--program",
                "/bin/false",
                "--golden",
                name,
            ],
            &["new", name],
            &["new", name],
            &["bless", "--golden", name],
            &["tour", "--only", name],
            &["draw", name],
            &["samplers", "--patterns", name],
        ] {
            let (_, said) = raybook(home.path(), arguments);
            assert_eq!(hidden(&said), [], "{arguments:?}: {said:?}");
        }
    }

    #[test]
    fn whatever_cases_are_called_nothing_hidden_comes_out() {
        let home = tempfile::tempdir().expect("a temporary folder");
        let folder = home.path().join("golden/ch01_rays");
        fs::create_dir_all(&folder).expect("a folder");
        let text = "a\u{1b}[2J\u{202e}b | 1 2 3  1 0 0  0\n";
        fs::write(folder.join("ray_at.txt"), text).expect("a file");
        script(
            &home.path().join("answers"),
            "#!/bin/sh\nwhile read -r q; do echo = 7; done\n",
        );
        for further in [&[][..], &["--json"]] {
            let check = [
                "check",
                "ray_at",
                "--golden",
                "golden",
                "--program",
                "answers",
            ];
            let (code, said) = raybook(home.path(), &[&check[..], further].concat());
            assert_eq!(code, 1, "{said}");
            assert_eq!(hidden(&said), [], "{said:?}");
            assert!(said.contains("[2J"), "it is shown: {said}");
        }
        let (_, said) = raybook(home.path(), &["bless", "ray_at", "--golden", "golden"]);
        assert_eq!(hidden(&said), [], "{said:?}");
    }

    #[test]
    fn a_page_gets_no_tag() {
        let home = tempfile::tempdir().expect("a temporary folder");
        let said = "<script>alert(1)</script>\u{202e}\u{1b}[2J";
        let text = format!("#!/bin/sh\nwhile read -r q; do echo '= todo {said}'; done\n");
        script(&home.path().join("answers"), &text);
        let (code, said) = raybook(
            home.path(),
            &[
                "samplers",
                "--patterns",
                "regular-grid",
                "--points",
                "9",
                "--samples",
                "1",
                "--realisations",
                "2",
                "--width",
                "16",
                "--out",
                "out",
                "--program",
                "answers",
            ],
        );
        assert_eq!(code, 1, "the pattern is not there: {said}");
        assert_eq!(hidden(&said), [], "{said:?}");
        let page = fs::read_to_string(home.path().join("out/index.html")).expect("a page");
        assert!(!page.contains("<script>alert"), "no tag");
        assert!(page.contains("&lt;script&gt;alert(1)"), "it is shown");
        assert_eq!(hidden(&page), [], "with nothing hidden");
    }

    #[test]
    fn the_suggested_command_does_what_it_says_and_nothing_else() {
        let home = tempfile::tempdir().expect("a temporary folder");
        for name in ["$(touch x)", "it's; touch x", "`touch x` \"y\""] {
            let folder = home.path().join(name);
            fs::create_dir(&folder).expect("a folder");
            script(
                &folder.join("answers"),
                "#!/bin/sh\nwhile read -r q; do echo '= 1 2 3'; done\n",
            );
            fs::write(folder.join("key"), "a key of 16 bytes").expect("a key");
            let program = format!("{name}/answers");
            let key = format!("{name}/key");
            let student = ["--key-file", &key, "--student", name, "--term", name];
            let check = ["check", "ray_at", "--program", &program];
            let (code, said) = raybook(home.path(), &[&check[..], &student].concat());
            assert_eq!(code, 1, "{said}");
            let again = said
                .lines()
                .find_map(|line| line.trim().strip_prefix("Ask this case again: raybook "))
                .expect("a command is suggested");
            let command = format!("{:?} {again}", env!("CARGO_BIN_EXE_raybook"));
            let output = Command::new("/bin/sh")
                .args(["-c", &command])
                .current_dir(home.path())
                .output()
                .expect("the shell runs");
            let said = String::from_utf8_lossy(&output.stdout);
            assert_eq!(output.status.code(), Some(1), "{command}: {said}");
            assert!(said.contains("ray_at, case "), "{command}: {said}");
            assert!(!home.path().join("x").exists(), "{command}");
        }
    }
}
