#include <dlfcn.h>

// Stands in for the C library's: in a build with the leak sanitizer nothing is unloaded before the process
// ends, so that what a library still points to counts as reachable, and what it did lose is shown with the
// names of its functions.
extern "C" int dlclose(void* /*handle*/) noexcept {
    return 0;
}
