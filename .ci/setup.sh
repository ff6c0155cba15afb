# Set-up for ./play, ./check and .ci/run, which source this file from the top of the checkout: what Couloir needs on a
# machine, and the steps from a bare Debian 12 or 13 to a configured build folder. Nothing is done twice.
# Progress goes to standard error, one line per step; a step that fails ends the script with status 3.

# Needed by whom | package, of one name in Debian 12 and 13 | what for | how to see on another system that it is there
# Only the maintainer's are of Debian 12 alone: the code is laid out by clang-format 14.
packages='
program|g++|a C++20 compiler|program g++
program|cmake|CMake 3.24 or later|program cmake
program|ninja-build|Ninja|program ninja
program|pkg-config|pkg-config|program pkg-config
program|libgdal-dev|GDAL 3 headers|header gdal.h
program|libproj-dev|PROJ headers|header proj.h
program|libopenal-dev|OpenAL headers|header AL/alext.h
program|libopenimageio-dev|OpenImageIO 2.4 headers|header OpenImageIO/imageio.h
program|libgeographiclib-dev|GeographicLib headers|header GeographicLib/Geodesic.hpp
program|libepoxy-dev|epoxy headers|header epoxy/gl.h
program|libglfw3-dev|GLFW 3.3 headers|header GLFW/glfw3.h
program|libegl-dev|EGL headers|header EGL/egl.h
program|libglm-dev|GLM|header glm/glm.hpp
program|libfmt-dev|fmt headers|header fmt/core.h
program|libexpected-dev|tl::expected|header tl/expected.hpp
program|libtomlplusplus-dev|toml++ headers|header toml++/toml.h
program|nlohmann-json3-dev|JSON for Modern C++|header nlohmann/json.hpp
program|libcli11-dev|CLI11|header CLI/CLI.hpp
program|libxxhash-dev|xxHash headers|header xxhash.h
program|libzstd-dev|Zstandard headers|header zstd.h
program|zlib1g-dev|zlib headers|header zlib.h
program|libimgui-dev|Dear ImGui headers|header imgui/imgui.h
program|libegl1|EGL at run time|library libEGL.so.1
program|libegl-mesa0|Mesa as the EGL driver|library libEGL_mesa.so.0
program|libgl1|libGL.so.1, which Dear ImGui opens at run time|library libGL.so.1
program|libgl1-mesa-dri|the OpenGL driver of Mesa that needs no GPU|library dri/swrast_dri.so
program|proj-data|the coordinate systems of PROJ|data proj/proj.db
program|fonts-roboto-unhinted|the letters of the panels|
program|fonts-dejavu-core|the same, where there is no Roboto|
tests|libgtest-dev|GoogleTest|header gtest/gtest.h
tests|libbenchmark-dev|Google Benchmark|header benchmark/benchmark.h
tests|libopenmpi-dev|MPI headers, for ensembles on many machines|program mpicxx
tests|openmpi-bin|starts a program many times|program mpirun
tests|pybind11-dev|pybind11 headers, for import couloir|header pybind11/pybind11.h
tests|python3-dev|headers of Python|program python3-config
tests|python3-numpy|NumPy|
tests|xvfb|a display without a screen|program Xvfb
tests|xdotool|a mouse and a keyboard without hands|program xdotool
tests|blackbox|a window manager, to minimise and to close|program blackbox
tests|wmctrl|asks it to close a window|program wmctrl
tests|chromium|opens the page of a slide|program chromium
aarch64|g++-aarch64-linux-gnu|a compiler for 64-bit ARM|program aarch64-linux-gnu-g++
aarch64|qemu-user|runs programs for 64-bit ARM|program qemu-aarch64
aarch64|mmdebstrap|unpacks packages for 64-bit ARM|program mmdebstrap
wasm|clang-19|clang++ 19, for WebAssembly|program clang++-19
wasm|lld-19|its linker|program wasm-ld-19
wasm|libclang-rt-19-dev-wasm32|its run time|
wasm|mmdebstrap|unpacks headers and libraries|program mmdebstrap
wasm|dpkg-dev|unpacks a source|program dpkg-source
maintainer|clang|clang++|program clang++
maintainer|libclang-rt-14-dev|run time of the clang sanitizers|
maintainer|clang-format|clang-format 14|program clang-format
maintainer|clang-tidy|clang-tidy 14|program clang-tidy
'

say() { printf 'couloir: %s\n' "$*" >&2; }

# step LOG SENTENCE COMMAND...: runs the command into build/LOG.log.
step() {
    local log=build/$1.log sentence=$2 start=$SECONDS
    shift 2
    mkdir -p build
    printf 'couloir: %s ... ' "$sentence" >&2
    if "$@" >"$log" 2>&1 </dev/null; then
        printf '%d s\n' $((SECONDS - start)) >&2
        return
    fi
    printf 'failed\n' >&2
    tail -n 30 "$log" >&2
    say "$sentence failed; the lines above are the end of $log"
    exit 3
}

# Prints 12 or 13 on that Debian, or on a derivative that says it is built on it; else nothing.
debian_release() {
    [ -r /etc/os-release ] && [ -n "$(command -v apt-get)" ] && [ -n "$(command -v dpkg-query)" ] || return 0
    (
        . /etc/os-release
        case " ${ID:-} ${ID_LIKE:-} " in *' debian '*) ;; *) exit 0 ;; esac
        case "${ID:-} ${VERSION_ID:-} ${DEBIAN_CODENAME:-${VERSION_CODENAME:-}}" in
        'debian 12 '* | *' bookworm') echo 12 ;;
        'debian 13 '* | *' trixie') echo 13 ;;
        esac
    )
}

# found 'KIND NAME': is it there, on a system whose packages we cannot ask for? Looks where compilers and loaders look.
found() {
    local kind=${1%% *} name=${1#* } folder
    case $kind in
    program)
        command -v "$name" >/dev/null
        return
        ;;
    header) set -- {/usr,/usr/local,/opt/homebrew}/include{,/gdal,/*-linux-gnu} ;;
    library) set -- {/usr,/usr/local,/opt/homebrew}/lib{,64,/*-linux-gnu} ;;
    data) set -- {/usr,/usr/local,/opt/homebrew}/share ;;
    *) return 0 ;;
    esac
    for folder; do
        [ ! -e "$folder/$name" ] || return 0
    done
    return 1
}

# Ends with status 3, a list and an install line if something is missing.
require_found() {
    local for_whom=$1 who package purpose probe list='' names=''
    while IFS='|' read -r who package purpose probe; do
        [[ " $for_whom " == *" $who "* ]] && ! found "$probe" || continue
        list+="  $purpose ($package)"$'\n'
        names+=" $package"
    done <<<"$packages"
    [ -n "$list" ] || return 0
    say 'only on Debian 12 and 13 does this script install packages. Missing here, with the names that Debian uses:'
    printf '%s' "$list" >&2
    say 'install these and start again. A line to adapt to this system (untested):'
    printf '  sudo apt-get install --no-install-recommends%s\n' "$names" >&2
    exit 3
}

# Names of the packages that dpkg does not have as installed, one per line.
missing_packages() {
    local for_whom=$1 who package rest installed wanted=()
    while IFS='|' read -r who package rest; do
        [[ -n $package && " $for_whom " == *" $who "* ]] && wanted+=("$package")
    done <<<"$packages"
    installed=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' "${wanted[@]}" 2>/dev/null || true)
    for package in "${wanted[@]}"; do
        [[ $'\n'$installed$'\n' == *$'\n'"$package installed"$'\n'* ]] || printf '%s\n' "$package"
    done
}

# apt_get ARGS...: as root, waiting for another package manager to finish rather than failing.
apt_get() {
    local as_root=()
    [ "$(id -u)" = 0 ] || as_root=(sudo)
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=600 \
        -o Acquire::Retries=3 "$@"
}

# A list that cannot be fetched (somebody's third-party source) is no reason to stop: the installation will tell.
update_and_install() {
    apt_get update || true
    apt_get install --no-install-recommends "$@"
}

# install_packages 'program tests': needed by whom. dpkg answers in a few hundredths of a second, so it is asked every time:
# a stamp would be wrong after a package is removed.
install_packages() {
    local release missing
    release=$(debian_release)
    if [ -z "$release" ]; then
        require_found "$1"
        return
    fi
    if [ "$release" != 12 ] && [[ " $1 " == *' maintainer '* ]]; then
        say "the maintainer's packages, clang 14 and its tools, are of Debian 12; this is Debian $release"
        exit 3
    fi
    mapfile -t missing < <(missing_packages "$1")
    [ ${#missing[@]} -gt 0 ] || return 0
    if [ "$(id -u)" != 0 ] && [ -z "$(command -v sudo)" ]; then
        say "these packages are missing, and without root or sudo they cannot be installed: ${missing[*]}"
        exit 3
    fi
    step packages "installing packages (${#missing[@]} and what they need)" update_and_install "${missing[@]}"
}

# Is build/PRESET configured by these presets, for this place, and with tests where they are wanted?
configured() {
    local folder=build/$1 tests=$2
    [ "$folder/build.ninja" -nt CMakePresets.json ] || return 1
    grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$(pwd -P)" "$folder/CMakeCache.txt" || return 1
    [ "$tests" = OFF ] || grep -qxF 'COULOIR_TESTS:BOOL=ON' "$folder/CMakeCache.txt"
}

# configure PRESET ON|OFF: with or without tests; a folder that is configured with them serves both. Ninja itself sees
# to changes of CMakeLists.txt files later.
configure() {
    local preset=$1 tests=$2 fresh=()
    configured "$preset" "$tests" && return
    # A cache that came along with a copied or moved checkout is refused by CMake.
    [ ! -e "build/$preset/CMakeCache.txt" ] || fresh=(--fresh)
    step "configure-$preset" "configuring $preset" \
        cmake --preset "$preset" "${fresh[@]}" -DCOULOIR_TESTS="$tests"
}

# build PRESET [TARGET...]: everything without a target.
build() {
    local preset=$1 parallel
    shift
    parallel=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
    step "build-$preset" "building $preset" cmake --build --preset "$preset" --parallel "$parallel" ${1:+--target "$@"}
}

# run_tests PRESET [CTEST ARGS]: to standard output. Of a program that fails, prints what its failing tests printed, without
# the tests that passed; closes with ctest's summary and how many tests passed, failed and were skipped.
run_tests() {
    local folder=build/$1 status=0
    shift
    ctest --test-dir "$folder" --parallel "$(nproc)" --output-on-failure --no-tests=error --no-label-summary "$@" |
        sed -u '/^\[-*\]/d; /^\[ RUN      \]/{N; /\n\[       OK \]/d}' || status=$?
    awk '/^\[       OK \]/ { ++passed }
        /^\[  FAILED  \] .* ms\)$/ { failed[$4]; ++failures }
        /^\[  SKIPPED \] .* ms\)$/ { skipped[$4]; ++skips }
        END {
            printf "%d tests passed, %d skipped, %d failed\n", passed, skips, failures
            for (name in skipped) print "  skipped: " name
            for (name in failed) print "  failed: " name
        }' "$folder/Testing/Temporary/LastTest.log"
    return $status
}
