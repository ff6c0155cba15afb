# The package mirrors of this machine, for root file systems made with mmdebstrap. .ci/distro and .ci/aarch64 source this.

own_suite() { (. /etc/os-release && printf '%s' "$VERSION_CODENAME"); }

# Source lines of SUITE, on the mirrors that this machine has for its own Debian.
source_lines() {
    local suite=$1 own site release component
    own=$(own_suite)
    apt-get indextargets --format '$(SITE) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' 'Origin: Debian' | sort -u |
        while read -r site release component; do
            case $release in
            "$own" | "$own"-*) printf 'deb %s %s %s\n' "$site" "$suite${release#"$own"}" "$component" ;;
            esac
        done
}

# bare_root SUITE FOLDER OPTION...: mmdebstrap with the mirrors and the proxy of this machine's apt.
bare_root() {
    local suite=$1 folder=$2 proxies
    shift 2
    [ -n "$(source_lines "$suite")" ] || apt-get -q update >&2  # a bare image has no lists
    mapfile -t proxies < <(apt-config dump | grep -E '^Acquire::https?::Proxy ' | sed 's/^/--aptopt=/')
    source_lines "$suite" | mmdebstrap --quiet "${proxies[@]}" "$@" "$suite" "$folder" -
}
