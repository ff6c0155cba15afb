#pragma once

#include <atomic>
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

#include "game/base/job.h"
#include "game/controls/catalogue.h"
#include "render/gl/gl_handle.h"

namespace game::ui {

// The pictures of the scenes that ship, NAME.jpg beside NAME.toml, in one texture at half their size. They are read on a thread; until then,
// and if one is missing or has another size, its scene has none.
class ScenePictures {
  public:
    static constexpr std::size_t kMost = 100;

    // Starts to read those of these scenes, at most kMost. Call it once.
    void read(const std::vector<Catalogue::Entry>& scenes);
    // Makes the texture once they are read. Needs the screen's GL context.
    void upload_if_read();

    struct Part {
        ImTextureID texture = nullptr;
        ImVec2 from, to;  // texture coordinates of its top left and bottom right
    };
    std::optional<Part> of(std::string_view scene) const;

  private:
    struct Atlas {
        std::vector<std::string> scenes;  // from the first row on
        std::vector<std::uint8_t> texels;
    };
    static Outcome<Atlas> read_all(const std::vector<Catalogue::Entry>& scenes,
                                   const std::atomic<bool>& stopped);
    ImTextureID id() const { return std::bit_cast<ImTextureID>(std::uintptr_t{texture_.name()}); }

    std::vector<std::string> scenes_;
    render::Texture texture_;
    Job<Atlas> job_;
};

}  // namespace game::ui
