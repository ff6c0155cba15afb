#include "files/input.h"

#include <cerrno>
#include <cstring>

#include <fmt/format.h>

namespace files {

namespace fs = std::filesystem;

tl::expected<void, std::string> check_input(const fs::path& path) {
    const auto bad = [&path](const std::string& fact) {
        return tl::unexpected(fmt::format("{}: {}", path.string(), fact));
    };
    std::error_code error;
    switch (fs::status(path, error).type()) {
        case fs::file_type::regular:
            return {};
        case fs::file_type::not_found:
            return bad(path.string().find('\\') == std::string::npos
                           ? "there is no such file"
                           : "there is no such file; / parts folders, not \\");
        case fs::file_type::directory:
            return bad("is a folder, not a file");
        case fs::file_type::none:
        case fs::file_type::unknown:
            return bad(fmt::format("cannot be opened ({})", error.message()));
        default:
            return bad("is a pipe or a device, not a file; copy its contents into a file first");
    }
}

tl::expected<std::ifstream, std::string> open_input(const fs::path& path) {
    if (auto is_file = check_input(path); !is_file) return tl::unexpected(is_file.error());
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return tl::unexpected(fmt::format("{}: cannot be opened ({})", path.string(), std::strerror(errno)));
    return file;
}

bool is_within(const fs::path& folder, const fs::path& path) {
    std::error_code error;
    // From the absolute path, because a relative one of which nothing exists would stay relative.
    const fs::path absolute = fs::absolute(path, error);
    if (error) return false;
    const fs::path real =
        fs::weakly_canonical(absolute, error)
            .lexically_relative(fs::canonical(folder.empty() ? fs::path(".") : folder, error));
    return !error && !real.empty() && *real.begin() != "..";
}

}  // namespace files
