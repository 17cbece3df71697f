//! What was measured, where and when.

use std::process::Command;
use std::time::{SystemTime, UNIX_EPOCH};

use super::gpu::Lab;
use crate::Outcome;

/// The crates whose versions matter.
const CRATES: [&str; 6] = ["naga", "wgpu", "naga_oil", "wesl", "wgsl-minifier", "orogen"];

/// One line: date, machine, adapter, versions.
pub(crate) fn line(lab: &Lab) -> Outcome<String> {
    let cpu = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default(); // Linux only; elsewhere it stays unnamed
    let model = cpu
        .lines()
        .find_map(|line| line.strip_prefix("model name")?.split_once(':'))
        .map(|(_, name)| name.trim());
    let threads = std::thread::available_parallelism()?;
    let lock = include_str!("../../../Cargo.lock");
    let versions = CRATES.map(|name| format!("{name} {}", version(lock, name)));
    let rustc = Command::new("rustc")
        .arg("--version")
        .output()
        .map(|out| String::from_utf8_lossy(&out.stdout).into_owned());
    let rustc = rustc.unwrap_or_default();
    let rustc = rustc.split_whitespace().take(2).collect::<Vec<_>>().join(" ");
    Ok(format!(
        "*Measured on {} on {} ({threads} threads), {}, GPU {} ({}), {rustc}; {}.*",
        date(),
        model.unwrap_or("a CPU without a name"),
        std::env::consts::OS,
        lab.name,
        lab.driver,
        versions.join(", "),
    ))
}

/// The newest version of a crate in a lock file.
fn version<'a>(lock: &'a str, name: &str) -> &'a str {
    let of = format!("name = \"{name}\"\nversion = \"");
    let last = lock.rfind(&of).and_then(|at| lock[at + of.len()..].split('"').next());
    last.unwrap_or("?")
}

/// Today, as `2026-11-29`, in UTC.
fn date() -> String {
    let days = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs() / 86_400);
    civil(days as i64)
}

/// The date of a day since 1970 (after Hinnant's `civil_from_days`).
fn civil(days: i64) -> String {
    let shifted = days + 719_468; // since 0000-03-01
    let era = shifted.div_euclid(146_097);
    let day_of_era = shifted.rem_euclid(146_097);
    let year_of_era = (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let month_from_march = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * month_from_march + 2) / 5 + 1;
    let month = if month_from_march < 10 { month_from_march + 3 } else { month_from_march - 9 };
    let year = year_of_era + era * 400 + i64::from(month <= 2);
    format!("{year}-{month:02}-{day:02}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn days_become_dates() {
        assert_eq!(civil(0), "1970-01-01");
        assert_eq!(civil(11_016), "2000-02-29");
        assert_eq!(civil(20_786), "2026-11-29");
    }

    #[test]
    fn a_lock_file_tells_versions() {
        let lock = "name = \"naga\"\nversion = \"24.0.0\"\n\nname = \"naga\"\nversion = \"30.0.0\"\n";
        assert_eq!(version(lock, "naga"), "30.0.0");
        assert_eq!(version(lock, "nag"), "?");
    }
}
