#include "tests/support/scripted_screen.h"

namespace support {

void ScriptedScreen::tap(game::Key key, game::Modifiers with) {
    happen({game::KeyEvent{key, true, false, with}, game::KeyEvent{key, false, false, with}});
}

void ScriptedScreen::type(std::string_view text) {
    for (const char letter : text) happen({game::TextEvent{static_cast<char32_t>(letter)}});
}

void ScriptedScreen::drop(std::vector<std::filesystem::path> files) {
    dropped_ = std::move(files);
    happen({game::DropEvent{}});
}

std::span<const game::Event> ScriptedScreen::poll() {
    polled_.clear();
    polled_.swap(coming_);
    return polled_;
}

game::DeviceFault ScriptedScreen::device_fault() {
    if (faults_.empty()) return game::DeviceFault::kNone;
    const game::DeviceFault next = faults_.front();
    faults_.erase(faults_.begin());
    return next;
}

}  // namespace support
