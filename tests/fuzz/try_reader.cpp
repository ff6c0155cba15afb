#include "tests/fuzz/try_reader.h"

#include <exception>
#include <fstream>

#include <fmt/format.h>

namespace game::test {

Outcome<void> check_numbers(const std::vector<float>& field, float least, float most, const char* what) {
    for (const float value : field)
        if (!(value >= least && value <= most)) return broken(fmt::format("{} is {}", what, value));
    return {};
}

std::string fault_of_reading(const TriedReader& reader, const std::filesystem::path& folder,
                             std::string_view bytes) {
    const std::filesystem::path file = folder / reader.file_name;
    std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    try {
        const Outcome<void> read = reader.read(file);
        if (read) return {};
        const auto& [status, sentence] = read.error();
        if (status == Failure::kBadAnswer) return "accepted, and " + sentence;
        if (status != Failure::kUnusable)
            return fmt::format("refused with status {}: {}", static_cast<int>(status), sentence);
        if (sentence.find(reader.file_name) == std::string::npos)
            return "does not name the file: " + sentence;
        return {};
    } catch (const std::exception& thrown) {
        return fmt::format("threw {}", thrown.what());
    }
}

}  // namespace game::test
