#include "game/ui/scene_pictures.h"

#include <algorithm>
#include <utility>

#include "render/pictures/png.h"

namespace game::ui {
namespace {

constexpr int kFiner = 2;  // than in the texture
constexpr int kPictureWidth = Catalogue::kPictureWidth / kFiner,
              kPictureHeight = Catalogue::kPictureHeight / kFiner, kChannels = 3;

// Appends the mean of each square of kFiner by kFiner texels.
void append_halved(const render::Texels& picture, std::vector<std::uint8_t>& texels) {
    const auto at = [&](int x, int y, int channel) {
        return picture.values[static_cast<std::size_t>((y * picture.width + x) * kChannels + channel)];
    };
    for (int y = 0; y < kPictureHeight; ++y)
        for (int x = 0; x < kPictureWidth; ++x)
            for (int channel = 0; channel < kChannels; ++channel) {
                int sum = 0;
                for (int v = 0; v < kFiner; ++v)
                    for (int u = 0; u < kFiner; ++u) sum += at(kFiner * x + u, kFiner * y + v, channel);
                texels.push_back(static_cast<std::uint8_t>(sum / (kFiner * kFiner)));
            }
}

}  // namespace

void ScenePictures::read(const std::vector<Catalogue::Entry>& scenes) {
    // Without a thread rows have no pictures.
    (void)job_.begin([scenes](const std::atomic<bool>& stopped) { return read_all(scenes, stopped); });
}

Outcome<ScenePictures::Atlas> ScenePictures::read_all(const std::vector<Catalogue::Entry>& scenes,
                                                      const std::atomic<bool>& stopped) {
    Atlas atlas;
    for (const Catalogue::Entry& scene : scenes) {
        if (stopped || atlas.scenes.size() == kMost) break;
        std::filesystem::path file = scene.file;
        const auto picture = render::read_jpeg(file.replace_extension(".jpg"), kChannels);
        if (!picture || picture->width != Catalogue::kPictureWidth ||
            picture->height != Catalogue::kPictureHeight)
            continue;
        atlas.scenes.push_back(scene.name);
        append_halved(*picture, atlas.texels);
    }
    return atlas;
}

void ScenePictures::upload_if_read() {
    auto read = job_.result();
    if (!read || !*read || (*read)->scenes.empty()) return;
    Atlas& atlas = **read;
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
