//! Blade files (TOML, JSON) and measured points (CSV).
