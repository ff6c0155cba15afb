// libFuzzer's entry point for the reader that COULOIR_READER names: preset fuzz.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/try_reader.h"
#include "tests/support/places.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static const support::TemporaryFolder folder;
    const std::string fault = game::test::fault_of_reading(game::test::COULOIR_READER, folder.path(),
                                                           {reinterpret_cast<const char*>(bytes), size});
    if (fault.empty()) return 0;
    std::fprintf(stderr, "%s\n", fault.c_str());
    std::abort();
}
