#pragma once

#include <atomic>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

#include "game/base/job.h"
#include "render/gl/gl_handle.h"

namespace game::ui {

// Pictures of cards, JPEG or PNG files, each cut to 16 : 9, in one texture. They are read on a thread; until then, and if one is
// missing or damaged, its card has none.
class ScenePictures {
  public:
    static constexpr std::size_t kMost = 100;

    struct Source {
        std::string name;
        std::filesystem::path file;
        bool operator==(const Source&) const = default;
    };
    // Reads these, at most kMost, in place of those before, unless they are the same or others are being read; then it waits
    // for the next call.
    void show(std::vector<Source> sources);
    // Makes the texture once they are read. Needs the screen's GL context.
    void upload_if_read();

    struct Part {
        ImTextureID texture = nullptr;
        ImVec2 from, to;  // texture coordinates of its top left and bottom right
    };
    std::optional<Part> of(std::string_view name) const;

  private:
    struct Atlas {
        std::vector<std::string> names;  // from the first row on
        std::vector<std::uint8_t> texels;
    };
    static Outcome<Atlas> read_all(const std::vector<Source>& sources, const std::atomic<bool>& stopped);
    ImTextureID id() const { return std::bit_cast<ImTextureID>(std::uintptr_t{texture_.name()}); }

    std::vector<Source> asked_;  // as last read
    std::vector<std::string> names_;
    render::Texture texture_;
    Job<Atlas> job_;
};

}  // namespace game::ui
