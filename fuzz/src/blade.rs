//! Bytes to a blade file and a question about it.

use arbitrary::{Result, Unstructured};
use serde_json::{Value, json};

/// A blade file as JSON, and what is asked of it.
#[derive(Clone, Debug)]
pub struct Question {
    /// The file.
    pub text: String,
    /// Options by their names on the command line.
    pub options: Vec<(&'static str, String)>,
    /// Last speed of a chart [rad/s].
    pub fastest: f64,
}

/// A number: ordinary, round, of any magnitude that is not absurd, or any at all.
fn number(bytes: &mut Unstructured<'_>) -> Result<f64> {
    let mantissa = 1.0 + f64::from(bytes.arbitrary::<u16>()?) / 65536.0 * 9.0;
    Ok(match bytes.int_in_range(0..=9)? {
        0..=3 => mantissa * 10_f64.powi(bytes.int_in_range(-3..=3)?),
        4 => f64::from(bytes.int_in_range(0..=20_u8)?),
        5..=7 => mantissa * 10_f64.powi(bytes.int_in_range(-20..=20)?),
        8 => mantissa * 10_f64.powi(bytes.int_in_range(-300..=300)?),
        _ => f64::from_bits(bytes.arbitrary()?),
    })
}

/// A property: one number, or its own radii that reach from 0 to the tip, with a step here and there.
fn property(bytes: &mut Unstructured<'_>, radius: f64) -> Result<Value> {
    if bytes.ratio(1, 3)? {
        return Ok(json!(number(bytes)?));
    }
    let (mut r, mut values) = (vec![0.0], vec![number(bytes)?]);
    let mut at = 0.0;
    for _ in 0..bytes.int_in_range(0..=5)? {
        // A part of what is left, down to slivers.
        let part = f64::from(bytes.int_in_range(1..=255_u8)?) / 256.0;
        let part = if bytes.ratio(1, 8)? { part * 1e-8 } else { part };
        at += part * (radius - at);
        r.push(at);
        values.push(number(bytes)?);
        if bytes.arbitrary()? {
            r.push(at);
            values.push(number(bytes)?);
        }
    }
    r.push(radius);
    values.push(number(bytes)?);
    Ok(json!({ "r": r, "values": values }))
}

fn root(bytes: &mut Unstructured<'_>, kinds: &[(&str, bool)]) -> Result<Value> {
    let (kind, sprung) = *bytes.choose(kinds)?;
    let ratio = if bytes.arbitrary()? { f64::from(bytes.int_in_range(0..=255_u8)?) / 256.0 } else { 0.0 };
    let mut root = json!({ "root": kind, "offset_ratio": ratio });
    if sprung {
        root["spring"] = json!(number(bytes)?);
    }
    Ok(root)
}

/// A question from bytes; too few of them give zeros.
pub fn question(bytes: &[u8]) -> Result<Question> {
    let bytes = &mut Unstructured::new(bytes);
    let radius = number(bytes)?;
    let bending = [("hingeless", false), ("hinged", false), ("spring-hinged", true)];
    let torsion = [("rigid", false), ("spring", true)];
    let nominal = number(bytes)?;
    let mut distribution = json!({});
    for key in ["mass", "flap_stiffness", "lag_stiffness", "torsion_stiffness", "polar_inertia", "mass_offset"] {
        distribution[key] = property(bytes, radius)?;
    }
    let text = json!({
        "schema": "bladefan-blade/1",
        "name": "bytes",
        "rotor": { "radius": radius, "nominal_speed": nominal },
        "flap": root(bytes, &bending)?,
        "lag": root(bytes, &bending)?,
        "torsion": root(bytes, &torsion)?,
        "distribution": distribution,
    });
    let mut options = vec![
        ("modes", bytes.int_in_range(1..=8_u8)?.to_string()),
        ("basis", (*bytes.choose(&["piecewise", "classical"])?).to_string()),
        ("functions", bytes.int_in_range(1..=20_u8)?.to_string()),
    ];
    if bytes.arbitrary()? {
        let speed = number(bytes)?.abs();
        options.push(("speed", speed.to_string()));
    }
    let fastest = number(bytes)?.abs();
    Ok(Question { text: text.to_string(), options, fastest })
}
