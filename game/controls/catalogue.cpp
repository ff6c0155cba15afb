#include "game/controls/catalogue.h"

#include <algorithm>
#include <fstream>

#include <fmt/format.h>

#include "game/base/limits.h"
#include "game/files/assets.h"
#include "game/recording/format.h"
#include "game/recording/recording_length.h"
#include "game/scene/lesson.h"
#include "game/scene/scene_file.h"
#include "terrains/json_reader.h"

namespace game {
namespace {

// Reads the title of a scene or a material, and what else is told of a scene.
Outcome<std::string> look_into_toml(Catalogue::Entry& entry) {
    const auto scene = read_scene_file(entry.file);
    if (!scene) return tl::unexpected(scene.error());
    const toml::table& document = scene->document;
    if (document.contains("goal")) entry.kind = Catalogue::Kind::kChallenge;
    if (document.contains("flow")) entry.kind = Catalogue::Kind::kFlowDemo;
    if (scene->harder_than) entry.harder_than = *scene->harder_than;
    entry.about = document["goal"]["say"].value_or(scene->about.value_or(""));
    entry.difficulty = scene->difficulty.value_or(0);
    entry.is_weekly = scene->weekly;
    return document["title"].value_or(entry.name);
}

Outcome<std::string> look_into_lesson(Catalogue::Entry& entry) {
    const auto lesson = read_lesson(entry.file);
    if (!lesson) return tl::unexpected(lesson.error());
    entry.kind = Catalogue::Kind::kLesson;
    entry.about = lesson->about;
    return lesson->title;
}

// Reads only the first line, because recordings are long.
Outcome<std::string> title_of_recording(const Catalogue::Entry& entry) {
    std::ifstream file(entry.file, std::ios::binary);
    std::string line;
    if (!std::getline(file, line)) return unusable(fmt::format("{}: cannot be read", entry.file.string()));
    const auto json = terrains::read_json<Json>(line, kHeaderLimits);
    if (!json) return unusable(fmt::format("{}:1: {}", entry.file.string(), json.error()));
    if (!json->is_object()) return unusable(fmt::format("{}:1: not an object", entry.file.string()));
    const auto title = json->find("title");
    return title != json->end() && title->is_string() ? title->get<std::string>() : entry.name;
}

Outcome<std::vector<Catalogue::Entry>> read_entries(AssetKind kind) {
    const auto names = asset_names(kind);
    if (!names) return tl::unexpected(names.error());
    std::vector<Catalogue::Entry> entries;
    for (const std::string& name : *names) {
        const auto file = find_asset(kind, name);
        if (!file) return tl::unexpected(file.error());
        Catalogue::Entry entry{name, {}, *file};
        auto title = kind == AssetKind::kRecording ? title_of_recording(entry)
                     : kind == AssetKind::kLesson  ? look_into_lesson(entry)
                                                   : look_into_toml(entry);
        if (!title) return tl::unexpected(title.error());
        entry.title = std::move(*title);
        entries.push_back(std::move(entry));
    }
    return entries;
}

}  // namespace

Outcome<Catalogue> read_catalogue() {
    Catalogue catalogue;
    for (const auto& [kind, entries] : {std::pair{AssetKind::kScene, &catalogue.scenes},
                                        std::pair{AssetKind::kMaterial, &catalogue.materials},
                                        std::pair{AssetKind::kRecording, &catalogue.recordings},
                                        std::pair{AssetKind::kLesson, &catalogue.lessons}}) {
        auto found = read_entries(kind);
        if (!found) return tl::unexpected(found.error());
        *entries = std::move(*found);
    }
    std::ranges::stable_sort(catalogue.scenes, {}, [](const Catalogue::Entry& scene) {
        return std::pair(scene.kind, scene.difficulty);
    });
    return catalogue;
}

std::vector<Catalogue::Entry> own_entries(ShelfKind kind) {
    std::vector<Catalogue::Entry> entries;
    for (const ShelfFile& each : shelf(kind, kMostOnShelf)) {
        Catalogue::Entry entry{each.file.stem().string(), each.file.string(), each.file};
        const bool is_picture = kind == ShelfKind::kScreenshot;
        entry.picture = is_picture ? each.file : picture_of(each.file);
        if (kind == ShelfKind::kRecording || kind == ShelfKind::kChallenge)
            entry.length_s = length_of_recording(each.file);
        entries.push_back(std::move(entry));
    }
    return entries;
}

}  // namespace game
