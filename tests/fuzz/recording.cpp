// libFuzzer's entry point for the reader of recordings: preset fuzz.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/try_recording.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::string_view fault = game::test::fault_of_reading({reinterpret_cast<const char*>(bytes), size});
    if (fault.empty()) return 0;
    std::fprintf(stderr, "%.*s\n", static_cast<int>(fault.size()), fault.data());
    std::abort();
}
