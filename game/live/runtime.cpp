// What a C++ program expects around it, and a page does not have.
#include <cstdlib>
#include <cstring>
#include <exception>
#include <typeinfo>

#include "game/live/page.h"

// There is no unwinding: what is thrown ends the instance. Nothing here throws but for a world's own mistakes and for memory,
// because readers return their errors.
extern "C" void* __cxa_allocate_exception(std::size_t size) noexcept {
    return std::malloc(size);
}
extern "C" [[noreturn]] void __cxa_throw(void* thrown, std::type_info* /*type*/,
                                         void (* /*destroy*/)(void*)) {
    const char* what = static_cast<std::exception*>(thrown)->what();  // all that is thrown is one
    page_ended(what, std::strlen(what));
}
