#include <dlfcn.h>

// Stands in for the C library's: in a build with the leak sanitizer nothing is unloaded before the process
// ends, so that what a library still points to counts as reachable, and what it did lose is shown with the
// names of its functions.
extern "C" int dlclose(void* /*handle*/) noexcept {
    return 0;
}

// GDAL forgets a file system of its own that another replaces (terrains/gdal_files.cpp), once in a process,
// and OpenImageIO the text of an error.
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libgdal\nleak:libOpenImageIO\n";
}
// Or it would print their number at the end of every run.
extern "C" const char* __lsan_default_options() {
    return "print_suppressions=0";
}
