#include "game/scene/scene_file.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "game/files/assets.h"
#include "game/files/toml_table.h"

namespace game {
namespace {

namespace fs = std::filesystem;

constexpr const char *kHarderThan = "harder_than", *kAbout = "about", *kDifficulty = "difficulty",
                     *kWeekly = "weekly";

// Adds what `document` does not state itself. Nodes are moved, because a copy would forget its line.
void complete(toml::table& document, toml::table&& from) {
    for (auto&& [key, node] : from) {
        toml::node* const own = document.get(key);
        if (!own)
            document.insert(key, std::move(node));
        else if (own->is_table() && node.is_table())
            complete(*own->as_table(), std::move(*node.as_table()));
    }
}

// The file of the scene that `name` means in `file`.
Outcome<fs::path> easier_scene(const std::string& name, const fs::path& file) {
    if (name != fs::path(name).filename()) return unusable("is not the name of a scene");
    if (is_asset(AssetKind::kScene, name)) return find_asset(AssetKind::kScene, name);
    const fs::path beside = file.parent_path() / (name + ".toml");
    std::error_code error;
    if (fs::is_regular_file(beside, error)) return beside;
    return unusable(fmt::format("is \"{}\", which neither ships nor is {} beside this file", name,
                                beside.filename().string()));
}

// Takes what is for people out of the document, so that only the world is left.
void take_words(SceneFile& scene, TomlTable& root) {
    scene.about = root.text(kAbout);
    if (scene.about && scene.about->size() > SceneFile::kMostAbout)
        root.blame(kAbout, fmt::format("has more than {} bytes", SceneFile::kMostAbout));
    scene.difficulty = root.whole(kDifficulty, 1, SceneFile::kHardest);
    if (scene.difficulty && !scene.harder_than && !root.has("goal"))
        root.blame(kDifficulty, "is of a challenge, but the scene has no [goal]");
    scene.weekly = root.truth(kWeekly).value_or(false);
    if (scene.weekly && !scene.document["terrain"]["generator"])
        root.blame(kWeekly, "changes the seed of a generator, and [terrain] names none");
}

void erase_words(toml::table& document) {
    for (const char* key : {kHarderThan, kAbout, kDifficulty, kWeekly}) document.erase(key);
}

}  // namespace

Outcome<SceneFile> read_scene_file(const fs::path& file) {
    auto document = parse_toml(file);
    if (!document) return tl::unexpected(document.error());
    SceneFile scene{std::move(*document), {file}, {}};
    TomlFault fault;
    TomlTable root(scene.document, "", file.string(), fault);
    scene.harder_than = root.text(kHarderThan);
    take_words(scene, root);
    if (fault) return unusable(*fault);
    if (!scene.harder_than) {
        erase_words(scene.document);
        return scene;
    }

    const auto blamed = [&](const std::string& fact) {
        root.blame(kHarderThan, fact);
        return unusable(*fault);
    };
    const auto easier = easier_scene(*scene.harder_than, file);
    if (!easier) return blamed(easier.error().sentence);
    auto other = parse_toml(*easier);
    if (!other) return tl::unexpected(other.error());
    if (other->contains(kHarderThan))
        return blamed(fmt::format("is \"{}\", which is harder than another one itself", *scene.harder_than));
    if (!other->contains("goal"))
        return blamed(fmt::format("is \"{}\", which is no challenge", *scene.harder_than));
    scene.files.push_back(*easier);
    const auto easier_by = (*other)[kDifficulty].value<std::int64_t>();
    if (!scene.difficulty && easier_by) scene.difficulty = std::min(*easier_by + 1, SceneFile::kHardest);
    complete(scene.document, std::move(*other));
    erase_words(scene.document);
    return scene;
}

}  // namespace game
