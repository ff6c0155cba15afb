#include "game/app/session_picture.h"

#include "game/files/shelf.h"
#include "render/pictures/fit.h"

namespace game {

bool SessionPicture::wants(std::int64_t moving, double now_s) const {
    constexpr double kPause = 2;  // s
    if (picture_ && now_s - taken_s_ < kPause) return false;
    return moving > moving_ + moving_ / 4;
}

void SessionPicture::take(const render::Picture& image, std::int64_t moving, double now_s) {
    picture_ = render::Picture{
        kWidth, kHeight,
        render::fitted(image.pixels, {image.width, image.height, image.channels}, kWidth, kHeight),
        image.channels};
    moving_ = moving;
    taken_s_ = now_s;
}

Outcome<void> SessionPicture::write(const std::filesystem::path& recording) const {
    if (!picture_) return {};
    if (auto written = render::write_png(*picture_, picture_of(recording)); !written)
        return machine_fails(written.error());
    return {};
}

}  // namespace game
