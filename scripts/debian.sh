# For scripts that install Debian packages; sourced.

as_root() { if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi; }

# The lists of packages are fetched anew only where the installation fails without: absent or old.
install_debian() { # PACKAGE...
    local install=(env DEBIAN_FRONTEND=noninteractive apt-get -qq install -y --no-install-recommends "$@")
    as_root "${install[@]}" >/dev/null 2>&1 && return
    as_root apt-get -qq update >&2
    as_root "${install[@]}" >/dev/null
}
