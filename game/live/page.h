#pragma once

#include <cstddef>

// What the module calls of the page that runs it.

// Ends the instance with a sentence: the page throws through the module, and may call only what is for then.
extern "C" [[noreturn]] __attribute__((import_module("page"), import_name("ended"))) void page_ended(
    const char* text, std::size_t size);
