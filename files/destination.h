#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <sys/types.h>

namespace files {

// The target of an output once all symbolic links are followed.
struct Destination {
    enum class Kind {
        kFile,        // a regular file, or an unused name
        kFolder,      // an existing folder
        kThrough,     // a device, FIFO or socket
        kDescriptor,  // a descriptor of this process: /dev/stdout, /dev/fd/N
    };
    Kind kind = Kind::kFile;
    std::filesystem::path path;
    int descriptor = -1;
};
Destination destination_of(const std::filesystem::path& path);

// Identifies a file regardless of its name: device and inode if it exists, else the canonical path.
struct Identity {
    dev_t device = 0;
    ino_t inode = 0;
    std::filesystem::path free_name;  // if no file exists

    bool operator==(const Identity&) const = default;
};
// FIFOs, sockets and block devices have one too, because two outputs there would be mixed. A path such as
// /dev/fd/N has that of what the descriptor refers to. Empty for character devices (terminals, /dev/null),
// which any number of outputs may share, and for folders.
std::optional<Identity> identity_of(const std::filesystem::path& path);
std::optional<Identity> identity_of(int descriptor);

}  // namespace files
