#include "game/app/guide_memory.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "game/files/text_file.h"
#include "game/files/user_folders.h"

namespace game {
namespace {

namespace fs = std::filesystem;

constexpr int kVersion = 1;
constexpr std::uintmax_t kLargest = 4096;  // bytes

// The step that a file names. Errors: what is wrong with it.
tl::expected<Guide::Step, std::string> step_in(const fs::path& path) {
    std::error_code error;
    if (fs::file_size(path, error) > kLargest || error)
        return tl::unexpected(fmt::format("has more than {} bytes", kLargest));
    const auto text = read_text(path);
    if (!text) return tl::unexpected(std::string("cannot be read"));
    const auto json = nlohmann::json::parse(*text, nullptr, false);
    if (!json.is_object()) return tl::unexpected(std::string("is no JSON object"));
    if (json.value("version", nlohmann::json()) != kVersion)
        return tl::unexpected(fmt::format("does not say \"version\": {}", kVersion));
    const auto step = json.find("step");
    if (step == json.end() || !step->is_string()) return tl::unexpected(std::string("has no text \"step\""));
    const auto named = Guide::step_of(step->get<std::string>());
    if (!named) return tl::unexpected(fmt::format("names no step of the guide: {}", step->dump()));
    return *named;
}

}  // namespace

Remembered remembered_guide() {
    const auto path = data_folder("guide.json");
    std::error_code error;
    if (!path || !fs::exists(*path, error)) return {};
    const auto step = step_in(*path);
    if (step) return {Guide(*step), ""};
    const auto aside = set_aside(*path);
    return {Guide(), fmt::format("{}: {}; the first steps start again{}", path->string(), step.error(),
                                 aside ? fmt::format(", and it is kept as {}", aside->string()) : "")};
}

Outcome<void> remember(const Guide& guide) {
    const auto path = data_folder("guide.json");
    if (!path) return tl::unexpected(path.error());
    const nlohmann::json json{{"version", kVersion}, {"step", Guide::name_of(guide.step())}};
    return write_text(*path, json.dump() + "\n");
}

}  // namespace game
