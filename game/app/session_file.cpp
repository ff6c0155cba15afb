#include "game/app/session_file.h"

#include <system_error>
#include <utility>

namespace game {

void SessionFile::begin(std::optional<std::filesystem::path> path) {
    path_ = std::move(path);
    keeps_ = path_ && path_ == wanted_;
    if (keeps_) wanted_.reset();
}

void SessionFile::stop(const Failure& failure) {
    if ((path_ || wanted_) && !failure_) failure_ = failure;
    path_.reset();
}

void SessionFile::end(bool touched) {
    if (!path_ || remains(touched)) return;
    std::error_code ignored;  // then it remains, which does no harm
    std::filesystem::remove(*path_, ignored);
    path_.reset();
}

}  // namespace game
