#include "game/bench/memory.h"

#include <malloc.h>

#include <fstream>
#include <string>
#include <string_view>

#include "game/base/number.h"

namespace game {
namespace {

// A line of /proc/self/status, "VmHWM:     51234 kB".
std::size_t bytes_of(std::string_view key) {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (word == key && status >> word) return 1024 * number_from<std::size_t>(word).value_or(0);
    return 0;
}

}  // namespace

std::size_t resident_bytes() {
    return bytes_of("VmRSS:");
}

std::size_t peak_bytes() {
    return bytes_of("VmHWM:");
}

void forget_peak() {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << '5';  // proc(5): resets the peak to what is resident now
}

}  // namespace game
