#include <algorithm>

#include <fmt/format.h>

#include "game/base/print.h"
#include "game/commands/commands.h"
#include "game/files/assets.h"
#include "game/recording/format.h"

namespace game {
Outcome<int> list(const ListOptions& options) {
    struct Shelf {
        AssetKind kind;
        const char *key, *heading;
    };
    constexpr Shelf kShelves[] = {{AssetKind::kScene, "scenes", "scenes (couloir run NAME)"},
                                  {AssetKind::kMaterial, "materials", "materials (--material NAME)"},
                                  {AssetKind::kRecording, "recordings", "recordings (couloir replay NAME)"},
                                  {AssetKind::kLesson, "lessons", "lessons (couloir play --lesson NAME)"}};
    Json json;
    std::string text;
    for (const Shelf& shelf : kShelves) {
        const auto names = asset_names(shelf.kind);
        if (!names) return tl::unexpected(names.error());
        text += fmt::format("{}\n", shelf.heading);
        json[shelf.key] = Json::array();
        std::size_t longest = 0;
        for (const std::string& name : *names) longest = std::max(longest, one_line(name).size());
        for (const std::string& name : *names) {
            const bool titled = shelf.kind != AssetKind::kRecording;
            const std::string title = titled ? asset_title(shelf.kind, name) : "";
            json[shelf.key].push_back(titled ? Json{{"name", name}, {"title", title}} : Json{{"name", name}});
            text += titled ? fmt::format("  {:<{}}  {}\n", one_line(name), longest, one_line(title))
                           : fmt::format("  {}\n", one_line(name));
        }
    }
    text += "terrains (generator = \"NAME\" in a scene)\n  slope-of-soil\n  alpine-valley\n";
    json["terrains"] = {{{"name", "slope-of-soil"}}, {{"name", "alpine-valley"}}};
    print_text(options.json ? printed(json) : text);
    return 0;
}

}  // namespace game
