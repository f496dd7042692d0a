//! Measured points: the file that holds them.

use super::input::read_text;
use crate::failure::Failure;
use bladefan_core::formats;
use bladefan_core::report::MeasuredPoint;
use std::path::Path;

/// Reads measured points.
pub(crate) fn read(path: &Path) -> Result<Vec<MeasuredPoint>, Failure> {
    let text = read_text(path)?;
    formats::measured::read(&text).map_err(|faults| Failure::faults(&path.display().to_string(), &faults))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn points_are_read_and_faults_named_by_their_place() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("test.csv");
        fs::write(&path, "label,speed,frequency,source\n1F,1,2,test\n").unwrap();
        let points = read(&path).unwrap();
        assert_eq!(points.iter().map(|point| point.label.to_string()).collect::<Vec<_>>(), ["1F"]);

        fs::write(&path, "# a remark\nlabel,speed,frequency,source\n1F,1,x,test\n").unwrap();
        let message = format!("{}:3:6: points[0].frequency: must be a number (is \"x\")", path.display());
        assert_eq!(read(&path).unwrap_err().lines(), [message]);
    }
}
