#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <sys/types.h>

namespace files {

// Where an output goes when all symbolic links are followed.
struct Destination {
    enum class Kind {
        kFile,        // a regular file, or a name that is still free
        kFolder,      // a folder stands there
        kThrough,     // a device, FIFO or socket
        kDescriptor,  // a descriptor of this process: /dev/stdout, /dev/fd/N
    };
    Kind kind = Kind::kFile;
    std::filesystem::path path;
    int descriptor = -1;
};
Destination destination_of(const std::filesystem::path& path);

// What makes two names one file: device and inode if it is there, else the canonical path.
struct Identity {
    dev_t device = 0;
    ino_t inode = 0;
    std::filesystem::path free_name;  // if nothing is there

    bool operator==(const Identity&) const = default;
};
// Nothing for devices, FIFOs and folders: writing there replaces nothing.
std::optional<Identity> identity_of(const std::filesystem::path& path);
// Of an open descriptor; nothing unless it is a regular file.
std::optional<Identity> identity_of(int descriptor);

}  // namespace files
