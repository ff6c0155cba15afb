#include "game/app/session_picture.h"

#include <algorithm>

#include "game/files/shelf.h"
#include "render/pictures/fit.h"

namespace game {

bool SessionPicture::see(std::int64_t moving) {
    peak_ = std::max(peak_, moving);
    return is_late() && moving < peak_ - peak_ / 8;
}

void SessionPicture::take(const render::Picture& image) {
    picture_ = render::Picture{
        kWidth, kHeight,
        render::fitted(image.pixels, {image.width, image.height, image.channels}, kWidth, kHeight),
        image.channels};
    taken_ = peak_;
}

Outcome<void> SessionPicture::write(const std::filesystem::path& recording) const {
    if (!picture_) return {};
    if (auto written = render::write_png(*picture_, picture_of(recording)); !written)
        return machine_fails(written.error());
    return {};
}

}  // namespace game
