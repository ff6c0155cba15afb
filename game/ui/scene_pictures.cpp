#include "game/ui/scene_pictures.h"

#include <algorithm>
#include <utility>

#include "render/pictures/fit.h"
#include "render/pictures/png.h"

namespace game::ui {
namespace {

constexpr int kPictureWidth = 288, kPictureHeight = 162, kChannels = 3;  // in the texture

}  // namespace

void ScenePictures::show(std::vector<Source> sources) {
    if (sources == asked_ || job_.is_busy()) return;
    asked_ = std::move(sources);
    // Without a thread cards have no pictures.
    (void)job_.begin([these = asked_](const std::atomic<bool>& stopped) { return read_all(these, stopped); });
}

Outcome<ScenePictures::Atlas> ScenePictures::read_all(const std::vector<Source>& sources,
                                                      const std::atomic<bool>& stopped) {
    Atlas atlas;
    for (const Source& source : sources) {
        if (stopped || atlas.names.size() == kMost) break;
        const bool is_png = source.file.extension() == ".png";
        const auto picture =
            is_png ? render::read_png(source.file, kChannels) : render::read_jpeg(source.file, kChannels);
        if (!picture) continue;
        atlas.names.push_back(source.name);
        const auto texels = render::fitted(picture->values, {picture->width, picture->height, kChannels},
                                           kPictureWidth, kPictureHeight);
        atlas.texels.insert(atlas.texels.end(), texels.begin(), texels.end());
    }
    return atlas;
}

void ScenePictures::upload_if_read() {
    auto read = job_.result();
    if (!read || !*read || (*read)->names.empty()) return;
    Atlas& atlas = **read;
    const int height = kPictureHeight * static_cast<int>(atlas.names.size());
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &name);
    texture_ = render::Texture(name);
    glTextureParameteri(name, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(name, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureStorage2D(name, 1, GL_RGB8, kPictureWidth, height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(name, 0, 0, 0, kPictureWidth, height, GL_RGB, GL_UNSIGNED_BYTE, atlas.texels.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    names_ = std::move(atlas.names);
}

std::optional<ScenePictures::Part> ScenePictures::of(std::string_view name) const {
    const auto found = std::ranges::find(names_, name);
    if (found == names_.end()) return std::nullopt;
    // Half a texel inside, so that no neighbour is seen. The lowest row of a picture comes first.
    const auto row = static_cast<float>(kPictureHeight * (found - names_.begin()));
    const auto height = static_cast<float>(kPictureHeight * names_.size());
    return Part{id(), {0, (row + kPictureHeight - 0.5f) / height}, {1, (row + 0.5f) / height}};
}

}  // namespace game::ui
