#include "tests/readers/work.h"

#include <cstddef>

namespace {

thread_local std::int64_t steps = 0, bytes = 0;

}  // namespace

test::Work test::work() {
    return {steps, bytes};
}

// The compiler calls this in every basic block of the sources listed in CMakeLists.txt.
extern "C" void __sanitizer_cov_trace_pc() {
    ++steps;
}

// These allocate from the C library's heap, so its own free() releases the memory.
extern "C" {

void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);

void* malloc(std::size_t size) noexcept {
    bytes += static_cast<std::int64_t>(size);
    return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
    bytes += static_cast<std::int64_t>(count * size);
    return __libc_calloc(count, size);
}
void* realloc(void* memory, std::size_t size) noexcept {
    bytes += static_cast<std::int64_t>(size);
    return __libc_realloc(memory, size);
}
}
