#pragma once

#include <sys/resource.h>
#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace game::test {

// What a child process left.
struct Finished {
    int status = -1;  // its exit status; 128 + n after signal n
    std::string out, err;
};

// What a process is given by whoever starts it.
struct Surroundings {
    std::filesystem::path out = {};  // standard output goes here; empty: is kept
    std::vector<int> closed = {};    // descriptors
    // Files that are open for reading and writing, by descriptor, above 3.
    std::vector<std::pair<int, std::filesystem::path>> opened = {};
    std::vector<std::pair<std::string, std::string>> environment = {};  // set in addition
    struct Limit {
        int resource;  // RLIMIT_FSIZE
        rlim_t most;
    };
    std::vector<Limit> limits = {};
};

// Runs `couloir ARGUMENT...` to its end, with nothing on its standard input.
Finished couloir(const std::vector<std::string>& arguments, const Surroundings& around = {});

// Starts it and returns at once; what it prints is lost. The caller waits for it.
pid_t start_couloir(const std::vector<std::string>& arguments);

// Runs it to its end. What it prints is lost.
struct Peak {
    int status = -1;          // its exit status, or -1
    std::uint64_t bytes = 0;  // its greatest resident size
};
Peak peak_of(const std::vector<std::string>& arguments);

// Whole files, as bytes. Reading a file that is not there gives nothing.
std::string read_bytes(const std::filesystem::path& path);
void write_bytes(const std::filesystem::path& path, const std::string& bytes);

}  // namespace game::test
