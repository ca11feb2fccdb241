//! How much memory this process has used.

/// The most memory that this process has held so far, in bytes; none where the system does not tell.
pub fn peak_memory() -> Option<u64> {
    // Linux; `VmHWM:    12345 kB`.
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status
        .lines()
        .find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kilobytes: u64 = line.split_whitespace().next()?.parse().ok()?;
    Some(kilobytes * 1024)
}
