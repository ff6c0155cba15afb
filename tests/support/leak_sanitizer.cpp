#include <dlfcn.h>

// Replaces the C library's function. In a build with the leak sanitizer nothing is unloaded before the
// process ends, so that memory that a library still points to counts as reachable, and real leaks are
// reported with the names of their functions.
extern "C" int dlclose(void* /*handle*/) noexcept {
    return 0;
}

// GDAL leaks a file system that another replaces (terrains/gdal_files.cpp), once per process, and OpenImageIO
// leaks the text of an error.
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libgdal\nleak:libOpenImageIO\n";
}
// Otherwise the number of suppressions is printed at the end of every run.
extern "C" const char* __lsan_default_options() {
    return "print_suppressions=0";
}

// Without the thread-local memory of libraries that are loaded late: up to LLVM 16 the sanitizer takes the two words before it
// for its address and length where its place in a page is that of a header that glibc had before 2.25, and crashes at the end
// of the process, once in some hundred runs.
extern "C" const char* __asan_default_options() {
    return "intercept_tls_get_addr=0";
}
