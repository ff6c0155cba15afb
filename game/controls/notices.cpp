#include "game/controls/notices.h"

#include <algorithm>
#include <utility>

#include "sim/core/check.h"

namespace game {

void Notices::tell(Notice::Kind kind, std::string sentence, double now_s) {
    if (size_ > 0) {
        Notice& last = notices_[(first_ + size_ - 1) % kKept];
        if (last.kind == kind && last.sentence == sentence && strength(last, now_s) > 0) {
            last.told_s = now_s;
            ++last.times;
            return;
        }
    }
    if (size_ == kKept)
        first_ = (first_ + 1) % kKept;
    else
        ++size_;
    notices_[(first_ + size_ - 1) % kKept] = {kind, std::move(sentence), now_s, 1};
}

const Notice& Notices::operator[](std::size_t i) const {
    CHECK(i < size_);
    return notices_[(first_ + i) % kKept];
}

double Notices::strength(const Notice& notice, double now_s) {
    const double stays = notice.kind == Notice::Kind::kWarning ? kWarningStays : kInfoStays;
    return std::clamp(notice.told_s + stays - now_s, 0.0, 1.0);
}

}  // namespace game
