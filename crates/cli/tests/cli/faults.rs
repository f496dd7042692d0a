//! The bad files of the whole project through the command line.

use super::run_in;
use bladefan_tests::faults::cases;
use std::fs;

#[test]
fn every_bad_file_gives_its_faults_in_their_places() {
    let folder = tempfile::tempdir().unwrap();
    for case in cases() {
        let name = format!("bad.{}", case.format);
        fs::write(folder.path().join(&name), case.text()).unwrap();
        let expected: Vec<String> = case
            .faults
            .iter()
            .map(|fault| match fault.path.as_str() {
                "" => format!("{name}:{}:{}: {}", fault.line, fault.column, fault.message),
                path => format!("{name}:{}:{}: {path}: {}", fault.line, fault.column, fault.message),
            })
            .collect();
        for command in ["check", "fan"] {
            let stderr = run_in(folder.path(), &[command, &name]).refused();
            assert_eq!(stderr.lines().collect::<Vec<_>>(), expected, "{}", case.name);
        }
    }
}
