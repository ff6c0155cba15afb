#include "game/ui/feed.h"

#include <algorithm>
#include <cfloat>
#include <utility>

#include <imgui.h>

namespace game::ui {
namespace {

// The keys that ImGui's text fields handle; every other key reaches them as text. ImGuiKey_… constants are
// stored as int because the name of their type differs between versions.
constexpr std::pair<int, Key> kEditing[] = {
    {ImGuiKey_Tab, Key::kTab},
    {ImGuiKey_LeftArrow, Key::kLeft},
    {ImGuiKey_RightArrow, Key::kRight},
    {ImGuiKey_UpArrow, Key::kUp},
    {ImGuiKey_DownArrow, Key::kDown},
    {ImGuiKey_Home, Key::kHome},
    {ImGuiKey_End, Key::kEnd},
    {ImGuiKey_Delete, Key::kDelete},
    {ImGuiKey_Backspace, Key::kBackspace},
    {ImGuiKey_Enter, Key::kEnter},
    {ImGuiKey_Escape, Key::kEscape},
    {ImGuiKey_PageUp, Key::kPageUp},
    {ImGuiKey_PageDown, Key::kPageDown},
    {ImGuiKey_A, key('A')},
    {ImGuiKey_C, key('C')},
    {ImGuiKey_V, key('V')},
    {ImGuiKey_X, key('X')},
    {ImGuiKey_Y, key('Y')},
    {ImGuiKey_Z, key('Z')},
};

void hold(const Modifiers& with) {
    ImGuiIO& io = ImGui::GetIO();
    io.KeyCtrl = with.control;
    io.KeyShift = with.shift;
    io.KeyAlt = with.alt;
}

}  // namespace

Feed::Feed() {
    ImGuiIO& io = ImGui::GetIO();
    for (const auto& [imgui, ours] : kEditing) io.KeyMap[imgui] = static_cast<int>(ours);
#if IMGUI_VERSION_NUM >= 18700  // Debian 13: else Ctrl and Shift count only after the first key
    io.BackendUsingLegacyKeyArrays = 1;
#endif
}

void Feed::add(std::span<const Event> events) {
    keys_turned_.reset();
    buttons_turned_.reset();
    key_went_down_ = text_came_ = false;
    waiting_.insert(waiting_.end(), events.begin(), events.end());
    const auto next =
        std::find_if(waiting_.begin(), waiting_.end(), [this](const Event& event) { return !take(event); });
    waiting_.erase(waiting_.begin(), next);
}

bool Feed::take(const Event& event) {
    return std::visit([this](const auto& each) { return take(each); }, event);
}

bool Feed::take(const KeyEvent& event) {
    const auto code = static_cast<std::size_t>(event.key);
    if (code >= keys_turned_.size()) return true;
    bool& down = ImGui::GetIO().KeysDown[code];
    if (down != event.down && keys_turned_[code]) return false;
    // ImGui discards text while Ctrl is held.
    if (text_came_ && event.with.control != ImGui::GetIO().KeyCtrl) return false;
    hold(event.with);
    if (down != event.down) keys_turned_.set(code);
    down = event.down;
    const bool edits = std::any_of(std::begin(kEditing), std::end(kEditing),
                                   [&](const auto& pair) { return pair.second == event.key; });
    // Letters are text as well; only with Ctrl do they edit.
    if (event.down && edits && (event.key >= Key::kEscape || event.with.control)) key_went_down_ = true;
    return true;
}

bool Feed::take(const ButtonEvent& event) {
    const auto button = static_cast<std::size_t>(event.button);
    if (buttons_turned_[button]) return false;
    hold(event.with);
    buttons_turned_.set(button);
    ImGui::GetIO().MouseDown[button] = event.down;
    return true;
}

bool Feed::take(const MoveEvent& event) {
    if (buttons_turned_.any()) return false;  // the button changed at the earlier cursor position
    ImGui::GetIO().MousePos = mouse_ = {static_cast<float>(event.x), static_cast<float>(event.y)};
    return true;
}

bool Feed::take(const WheelEvent& event) {
    if (buttons_turned_.any()) return false;
    hold(event.with);
    ImGui::GetIO().MouseWheel += static_cast<float>(event.steps);
    return true;
}

bool Feed::take(const TextEvent& event) {
    if (key_went_down_) return false;  // ImGui would put the text before the key
    text_came_ = true;
    const char32_t character = event.character == ',' && !types_names_ ? '.' : event.character;
    ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(character));
    return true;
}

bool Feed::take(const FocusEvent& event) {
    ImGuiIO& io = ImGui::GetIO();
    if (event.focused) io.MousePos = mouse_;
    if (event.focused) return true;
    std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
    std::fill(std::begin(io.MouseDown), std::end(io.MouseDown), false);
    // Moved off every widget, so that a held button is released without triggering it.
    io.MousePos = {-FLT_MAX, -FLT_MAX};
    hold({});
    return true;
}

}  // namespace game::ui
