#include "game/app/session_picture.h"

#include <algorithm>

#include "game/files/shelf.h"
#include "render/pictures/fit.h"

namespace game {

render::Picture small_picture(const render::Picture& image) {
    constexpr int kWidth = 288, kHeight = 162;  // px
    return {kWidth, kHeight,
            render::fitted(image.pixels, {image.width, image.height, image.channels}, kWidth, kHeight),
            image.channels};
}

Outcome<void> write_beside(const std::filesystem::path& recording, const render::Picture& small) {
    if (auto written = render::write_png(small, picture_of(recording)); !written)
        return machine_fails(written.error());
    return {};
}

bool SessionPicture::see(std::int64_t moving) {
    peak_ = std::max(peak_, moving);
    return is_late() && moving < peak_ - peak_ / 8;
}

void SessionPicture::take(const render::Picture& image) {
    picture_ = small_picture(image);
    taken_ = peak_;
}

}  // namespace game
