//! Packed hand-ins: nothing of them reaches the disk, and what is not right is refused by its name.

use super::{Course, RIGHT};
use flate2::Compression;
use flate2::write::GzEncoder;
use rawzip::path::EntryPath;
use std::fs;
use std::io::Write;
use tar::{Builder, EntryType, Header};

const COURSE: &str =
    "[limits]\nfiles = 20\nmegabytes = 1\n[[chapter]]\nchapter = 'ch01'\nexercises = ['ray_at']\n";

/// A zip of names, each with its Unix mode and text.
fn zip(entries: &[(&[u8], u32, &[u8])]) -> Vec<u8> {
    let mut packed = Vec::new();
    let mut archive = rawzip::ZipArchiveWriter::new(&mut packed);
    for (name, mode, text) in entries {
        let name = EntryPath::verbatim(name.to_vec());
        let builder = archive
            .new_file(name)
            .unix_permissions(*mode)
            .compression_method(rawzip::CompressionMethod::DEFLATE);
        let (mut entry, config) = builder.start().expect("an entry");
        let mut writer = config.wrap(flate2::write::DeflateEncoder::new(
            &mut entry,
            Compression::fast(),
        ));
        writer.write_all(text).expect("its text");
        let (encoder, descriptor) = writer.finish().expect("it ends");
        encoder.finish().expect("it ends");
        entry.finish(descriptor).expect("it ends");
    }
    archive.finish().expect("it ends");
    packed
}

/// A `.tar.gz` of names, each with its kind and text. Names are written as they are.
fn tar(entries: &[(&[u8], EntryType, &[u8])]) -> Vec<u8> {
    let mut archive = Builder::new(GzEncoder::new(Vec::new(), Compression::fast()));
    for (name, kind, text) in entries {
        let mut header = Header::new_gnu();
        header.as_old_mut().name[..name.len()].copy_from_slice(name);
        header.set_entry_type(*kind);
        header.set_size(text.len() as u64);
        header.set_mode(0o755);
        if kind.is_symlink() || kind.is_hard_link() {
            header.set_link_name("/etc/passwd").expect("it fits");
        }
        header.set_cksum();
        archive.append(&header, *text).expect("it is added");
    }
    archive
        .into_inner()
        .expect("it ends")
        .finish()
        .expect("it ends")
}

/// Packed hand-ins that are right, with what is left out beside it.
fn right_ones() -> Vec<(&'static str, Vec<u8>)> {
    let right = RIGHT.as_bytes();
    let file = EntryType::Regular;
    let big = vec![b'#'; 64 << 20];
    vec![
        ("plain.zip", zip(&[(b"answer.py", 0o644, right)])),
        ("plain2.tar.gz", tar(&[(b"answer.py", file, right)])),
        (
            "folder.tgz",
            tar(&[
                (b"hand-in/", EntryType::Directory, b""),
                (b"./hand-in/answer.py", file, right),
            ]),
        ),
        (
            "windows.zip",
            zip(&[
                (b"hand-in\\answer.py", 0, right),
                (b"hand-in\\notes.txt", 0, b"x"),
            ]),
        ),
        (
            "tools.zip",
            zip(&[
                (b"answer.py", 0o644, right),
                (b".git/x.py", 0o644, b"x"),
                (b"venv/lib/x.py", 0o644, &big),
            ]),
        ),
        (
            "link.zip",
            zip(&[
                (b"answer.py", 0o644, right),
                (b"passwd.py", 0o120_777, b"/etc/passwd"),
            ]),
        ),
        (
            "links.tar.gz",
            tar(&[
                (b"answer.py", file, right),
                (b"a.py", EntryType::Symlink, b""),
                (b"b.py", EntryType::Link, b""),
            ]),
        ),
        (
            "devices.tar.gz",
            tar(&[
                (b"answer.py", file, right),
                (b"c.py", EntryType::Char, b""),
                (b"f.py", EntryType::Fifo, b""),
            ]),
        ),
    ]
}

/// Packed hand-ins that are refused, and words of the reason.
fn refused_ones() -> Vec<(&'static str, Vec<u8>, &'static str)> {
    let right = RIGHT.as_bytes();
    let bomb = vec![b'#'; 64 << 20];
    let many: Vec<_> = (0..30)
        .map(|i| format!("part{i}.py").into_bytes())
        .collect();
    let many: Vec<_> = many
        .iter()
        .map(|name| (&name[..], 0o644, &b"x"[..]))
        .collect();
    let long = [b"a".repeat(300), b".py".to_vec()].concat();
    let file = EntryType::Regular;
    vec![
        (
            "up.zip",
            zip(&[(b"../../answer.py", 0o644, right)]),
            "leads out",
        ),
        (
            "up2.tar.gz",
            tar(&[(b"a/../../answer.py", file, right)]),
            "leads out",
        ),
        (
            "absolute.tar.gz",
            tar(&[(b"/tmp/raybook-FORGED.py", file, right)]),
            "leads out",
        ),
        (
            "drive.zip",
            zip(&[(b"C:\\answer.py", 0o644, right)]),
            "leads out",
        ),
        (
            "latin.zip",
            zip(&[(b"answer\xe9.py", 0o644, right)]),
            "not UTF-8",
        ),
        (
            "latin2.tar.gz",
            tar(&[(b"answer\xe9.py", file, right)]),
            "not UTF-8",
        ),
        (
            "escape.zip",
            zip(&[(b"answer\x1b[2J.py", 0o644, right)]),
            "cannot be seen",
        ),
        ("long.zip", zip(&[(&long, 0o644, right)]), "too long"),
        (
            "twice.zip",
            zip(&[(b"answer.py", 0o644, right), (b"answer.py", 0o644, b"x")]),
            "twice",
        ),
        (
            "both.zip",
            zip(&[
                (b"answer.py", 0o644, right),
                (b"answer.py/x.py", 0o644, b"x"),
            ]),
            "both a file and a folder",
        ),
        (
            "both2.tar.gz",
            tar(&[(b"a/x.py/y.py", file, b"x"), (b"a/x.py", file, right)]),
            "both a file and a folder",
        ),
        (
            "bomb.zip",
            zip(&[(b"answer.py", 0o644, &bomb)]),
            "more than 1048576 bytes",
        ),
        (
            "bomb2.tar.gz",
            tar(&[(b"answer.py", file, &bomb)]),
            "more than 1048576 bytes",
        ),
        (
            "bomb3.tar.gz",
            tar(&[(b"answer.py", file, right), (b"big.bin", file, &bomb)]),
            "unpacked",
        ),
        ("many.zip", zip(&many), "more than 20 source files"),
        (
            "nothing.zip",
            zip(&[(b"notes.txt", 0o644, b"x")]),
            "no source file",
        ),
        ("no.zip", b"PK no zip".to_vec(), "no .zip"),
        ("no2.tar.gz", b"no tar".to_vec(), "no .tar.gz"),
        (
            "cut.zip",
            zip(&[(b"answer.py", 0o644, right)])[..80].to_vec(),
            "no .zip",
        ),
        (
            "cut2.tar.gz",
            tar(&[(b"answer.py", file, right)])[..90].to_vec(),
            "no .tar.gz",
        ),
    ]
}

#[test]
fn packed_hand_ins_are_graded_or_refused_by_name() {
    let course = Course::new(COURSE);
    let right = right_ones()
        .into_iter()
        .map(|(name, packed)| (name, packed, ""));
    for (name, packed, refused) in right.chain(refused_ones()) {
        fs::write(course.path("hand-ins").join(name), packed).expect("it is written");
        let student = name.split('.').next().expect("a name");
        fs::write(course.path("expected").with_extension(student), refused).expect("it is written");
    }
    let (code, said) = course.grade(&[]);
    assert_eq!(code, Some(0), "{said}");
    for expected in fs::read_dir(course.home.path())
        .expect("it is there")
        .flatten()
    {
        let name = expected.file_name().into_string().expect("a name");
        let Some(student) = name.strip_prefix("expected.") else {
            continue;
        };
        let refused = fs::read_to_string(expected.path()).expect("it is there");
        let grade = course.student(student);
        if refused.is_empty() {
            assert_eq!(grade["points"], 1.0, "{student}: {grade:#}");
        } else {
            let why = grade["refused"].as_str().unwrap_or("it is not refused");
            assert!(
                why.contains(&refused) && grade["points"] == 0.0,
                "{student}: {why}"
            );
            assert!(
                said.contains(&format!("{student} is refused")),
                "{student} is told: {said}"
            );
        }
    }
    assert!(!said.contains('\u{1b}'), "nothing reaches the terminal");
    assert!(
        !std::path::Path::new("/tmp/raybook-FORGED.py").exists(),
        "nothing leaves the archive"
    );
    let notes =
        fs::read_to_string(course.path("results/students/links/index.html")).expect("a page");
    assert!(notes.contains("a.py is left out: it is a link"), "{notes}");
}

#[test]
fn what_lies_beside_hand_ins_is_named() {
    use std::os::unix::ffi::OsStrExt;
    let course = Course::new(COURSE);
    course.hand_in("eve/answer.py", RIGHT);
    course.hand_in("Moodle Name_12_assignsubmission_file_/x", "");
    fs::remove_file(course.path("hand-ins/Moodle Name_12_assignsubmission_file_/x"))
        .expect("it is removed");
    fs::write(
        course.path("hand-ins/Moodle Name_12_assignsubmission_file_/hand-in.zip"),
        zip(&[(b"answer.py", 0o644, RIGHT.as_bytes())]),
    )
    .expect("a file");
    fs::write(course.path("hand-ins/..zip"), "").expect("a file");
    fs::write(course.path("hand-ins/readme.txt"), "").expect("a file");
    fs::create_dir(
        course
            .path("hand-ins")
            .join(std::ffi::OsStr::from_bytes(b"latin\xe9")),
    )
    .expect("a folder");
    std::os::unix::fs::symlink("/etc", course.path("hand-ins/linked")).expect("a link");
    std::os::unix::fs::symlink("/etc", course.path("hand-ins/eve/etc")).expect("a link");
    let (code, said) = course.grade(&[]);
    assert_eq!(code, Some(0), "{said}");
    for words in ["readme.txt", "linked", "not UTF-8"] {
        assert!(said.contains(words), "{words}: {said}");
    }
    assert_eq!(course.points("eve"), 1.0);
    assert_eq!(
        course.points("Moodle Name_12_assignsubmission_file_"),
        1.0,
        "a packed one in a folder"
    );
    let students = fs::read_dir(course.path("results/students"))
        .expect("it is there")
        .count();
    assert_eq!(students, 2, "nobody else");
    course.hand_in("eve.py", RIGHT);
    let (code, said) = course.grade(&[]);
    assert!(
        code == Some(2) && said.contains("the same student"),
        "{said}"
    );
}
