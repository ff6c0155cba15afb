#include "game/ui/scene_pictures.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <system_error>
#include <utility>

#include "render/pictures/png.h"

namespace game::ui {
namespace {

constexpr int kPictureWidth = Catalogue::kPictureWidth, kPictureHeight = Catalogue::kPictureHeight;

}  // namespace

void ScenePictures::read(const std::vector<Catalogue::Entry>& scenes) {
    try {
        job_ = std::async(std::launch::async, read_all, scenes);
    } catch (const std::system_error&) {  // too many threads; rows have no pictures then
    }
}

// Catches exceptions, because none may leave the thread.
ScenePictures::Atlas ScenePictures::read_all(const std::vector<Catalogue::Entry>& scenes) {
    Atlas atlas;
    try {
        for (const Catalogue::Entry& scene : scenes) {
            std::filesystem::path file = scene.file;
            const auto picture = render::read_png(file.replace_extension(".png"), 3);
            if (!picture || picture->width != kPictureWidth || picture->height != kPictureHeight) continue;
            if (atlas.scenes.size() == kMost) break;
            atlas.scenes.push_back(scene.name);
            atlas.texels.insert(atlas.texels.end(), picture->values.begin(), picture->values.end());
        }
    } catch (const std::exception&) {  // such as out of memory
        return {};
    }
    return atlas;
}

void ScenePictures::upload_if_read() {
    if (!job_.valid() || job_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    Atlas atlas = job_.get();
    if (atlas.scenes.empty()) return;
    const int height = kPictureHeight * static_cast<int>(atlas.scenes.size());
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
    scenes_ = std::move(atlas.scenes);
}

std::optional<ScenePictures::Part> ScenePictures::of(std::string_view scene) const {
    const auto found = std::ranges::find(scenes_, scene);
    if (found == scenes_.end()) return std::nullopt;
    // Half a texel inside, so that no neighbour is seen. The lowest row of a picture comes first.
    const auto row = static_cast<float>(kPictureHeight * (found - scenes_.begin()));
    const auto height = static_cast<float>(kPictureHeight * scenes_.size());
    return Part{id(), {0, (row + kPictureHeight - 0.5f) / height}, {1, (row + 0.5f) / height}};
}

}  // namespace game::ui
