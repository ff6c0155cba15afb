#include "game/controls/key_map.h"

#include <algorithm>
#include <array>

#include "game/controls/gamepad.h"
#include "game/words/words.h"

namespace game {
namespace {

constexpr Modifiers kAlone{}, kShift{true, false, false}, kControl{false, true, false},
    kControlShift{true, true, false};

// In the order of the help panel.
constexpr std::array kKeyBindings{
    KeyBinding{Key::kLeftBracket, kAlone, true, Verb::kSmallerBrush, "smaller_brush", "smaller brush"},
    KeyBinding{Key::kRightBracket, kAlone, true, Verb::kLargerBrush, "larger_brush", "larger brush"},
    KeyBinding{Key::kLeftBracket, kShift, true, Verb::kWeakerBrush, "weaker_brush", "weaker brush"},
    KeyBinding{Key::kRightBracket, kShift, true, Verb::kStrongerBrush, "stronger_brush", "stronger brush"},
    KeyBinding{key('L'), kAlone, false, Verb::kPourStandingOrRolling, "poured_layer",
               "pour onto the standing or into the rolling layer"},
    KeyBinding{Key::kSpace, kAlone, false, Verb::kPauseOrGoOn, "pause",
               "pause or resume; tools act in a pause too"},
    KeyBinding{Key::kPeriod, kAlone, true, Verb::kStepOnce, "step", "step one tick"},
    KeyBinding{Key::kComma, kAlone, true, Verb::kStepBack, "step_back", "step one tick back"},
    KeyBinding{Key::kBackspace, kAlone, false, Verb::kRunBack, "rewind", "rewind, or run forward again"},
    KeyBinding{Key::kComma, kControl, false, Verb::kMarkBefore, "mark_before",
               "go back to the mark before on the timeline"},
    KeyBinding{Key::kPeriod, kControl, false, Verb::kMarkAfter, "mark_after",
               "go to the next mark on the timeline"},
    KeyBinding{Key::kEnd, kAlone, false, Verb::kSkip, "skip", "skip to the end of the slide, or stop that"},
    KeyBinding{Key::kEnter, kAlone, false, Verb::kTakeOver, "continue_here",
               "continue from here, in the past or a recording"},
    KeyBinding{Key::kMinus, kAlone, false, Verb::kSlower, "slower", "half the speed"},
    KeyBinding{Key::kEqual, kAlone, false, Verb::kFaster, "faster", "twice the speed"},
    KeyBinding{key('0'), kAlone, false, Verb::kUsualSpeed, "usual_speed", "normal speed"},
    KeyBinding{key('Z'), kControl, false, Verb::kUndo, "undo", "undo the last action"},
    KeyBinding{key('Y'), kControl, false, Verb::kRedo, "redo", "redo what was undone last"},
    KeyBinding{key('Z'), kControlShift, false, Verb::kRedo, "redo_too", "redo what was undone last"},
    KeyBinding{key('R'), kControl, false, Verb::kReset, "restart", "restart the scene"},
    KeyBinding{Key::kHome, kAlone, false, Verb::kOverview, "overview", "show the whole terrain"},
    KeyBinding{key('T'), kAlone, false, Verb::kTopDown, "top_view", "top view on or off"},
    KeyBinding{key('F'), kAlone, false, Verb::kFly, "fly", "fly mode on or off"},
    KeyBinding{key('V'), kAlone, false, Verb::kChase, "follow", "follow the front of a slide, or stop that"},
    KeyBinding{key('N'), kAlone, false, Verb::kLabels, "labels", "labels of the slide on or off"},
    KeyBinding{function_key(1), kAlone, false, Verb::kToggleHelp, "help", "this help"},
    KeyBinding{function_key(2), kAlone, false, Verb::kToggleScene, "scene_panel", "scene panel"},
    KeyBinding{function_key(3), kAlone, false, Verb::kTogglePhysics, "physics_panel", "physics panel"},
    KeyBinding{function_key(4), kAlone, false, Verb::kToggleDisplay, "display_panel", "display panel"},
    KeyBinding{function_key(5), kAlone, false, Verb::kTogglePerformance, "performance_panel",
               "performance panel"},
    KeyBinding{function_key(6), kAlone, false, Verb::kToggleFilm, "film_panel", "film panel"},
    KeyBinding{function_key(7), kAlone, false, Verb::kToggleMeasure, "measure_panel", "measure panel"},
    KeyBinding{function_key(8), kAlone, false, Verb::kPhoto, "photo", "photo mode on or off"},
    KeyBinding{Key::kEscape, kAlone, false, Verb::kClosePanel, "close",
               "close a list or a panel; else show the menu"},
    KeyBinding{function_key(9), kAlone, false, Verb::kMenu, "menu", "menu"},
    KeyBinding{Key::kTab, kAlone, false, Verb::kTogglePanels, "all_panels", "show or hide all panels"},
    KeyBinding{function_key(10), kAlone, false, Verb::kShare, "share", "share this slide as a web page"},
    KeyBinding{function_key(11), kAlone, false, Verb::kFullscreen, "full_screen", "full screen on or off"},
    KeyBinding{key('M'), kAlone, false, Verb::kMute, "sound", "sound on or off"},
    KeyBinding{key('X'), kAlone, false, Verb::kSlowMotion, "slow_motion", "slow motion on or off"},
    KeyBinding{key('O'), kAlone, false, Verb::kSpeedColours, "speed_colours", "colours of speed on or off"},
    KeyBinding{key('G'), kAlone, false, Verb::kFieldWords, "field_words", "plain words, or the field's"},
    KeyBinding{function_key(12), kAlone, false, Verb::kScreenshot, "screenshot", "take a screenshot"},
    KeyBinding{key('Q'), kControl, false, Verb::kQuit, "quit", "quit"},
};

constexpr std::array<std::string_view, kTools> kToolNames{"pour",  "dig",   "blast", "sculpt", "smooth",
                                                          "level", "water", "drain", "plant",  "house",
                                                          "net",   "road",  "lift"};

constexpr std::array kHeldBindings{
    HeldBinding{key('W'), Held::kForward, "forward", "move forward"},
    HeldBinding{Key::kUp, Held::kForward, "forward_too", "move forward"},
    HeldBinding{key('S'), Held::kBack, "back", "move back"},
    HeldBinding{Key::kDown, Held::kBack, "back_too", "move back"},
    HeldBinding{key('A'), Held::kLeft, "left", "move left"},
    HeldBinding{Key::kLeft, Held::kLeft, "left_too", "move left"},
    HeldBinding{key('D'), Held::kRight, "right", "move right"},
    HeldBinding{Key::kRight, Held::kRight, "right_too", "move right"},
    HeldBinding{key('E'), Held::kUp, "up", "move up"},
    HeldBinding{Key::kPageUp, Held::kUp, "up_too", "move up"},
    HeldBinding{key('Q'), Held::kDown, "down", "move down"},
    HeldBinding{Key::kPageDown, Held::kDown, "down_too", "move down"},
};

constexpr std::array kGestureBindings{
    GestureBinding{"Left drag", Button::kLeft, false, Gesture::kBrush,
                   "use the tool; Ctrl does the opposite, Shift smooths earth"},
    GestureBinding{"Right drag", Button::kRight, false, Gesture::kTurn,
                   "rotate about the point under the cursor; in fly mode, look"},
    GestureBinding{"Middle drag", Button::kMiddle, false, Gesture::kPan, "pan the view"},
    GestureBinding{"Shift+right drag", Button::kRight, true, Gesture::kPan, "pan the view"},
    GestureBinding{"Wheel", std::nullopt, false, Gesture::kZoom,
                   "zoom toward the cursor; while brushing, brush radius"},
    GestureBinding{"Shift+wheel", std::nullopt, true, Gesture::kResizeBrush, "brush radius"},
};

std::string_view bare_name(Key key) {
    switch (key) {
        case Key::kSpace:
            return message("Space");
        case Key::kEscape:
            return message("Esc");
        case Key::kEnter:
            return message("Enter");
        case Key::kTab:
            return message("Tab");
        case Key::kBackspace:
            return message("Backspace");
        case Key::kDelete:
            return message("Delete");
        case Key::kLeft:
            return message("Left");
        case Key::kRight:
            return message("Right");
        case Key::kUp:
            return message("Up");
        case Key::kDown:
            return message("Down");
        case Key::kHome:
            return message("Home");
        case Key::kEnd:
            return message("End");
        case Key::kPageUp:
            return message("PageUp");
        case Key::kPageDown:
            return message("PageDown");
        case Key::kShift:
            return message("Shift");
        case Key::kControl:
            return message("Ctrl");
        case Key::kAlt:
            return message("Alt");
        default:
            return {};
    }
}

}  // namespace

KeyMap::KeyMap() : holds_(kHeldBindings.begin(), kHeldBindings.end()) {
    for (const ToolInfo& tool : tool_infos())
        presses_.push_back({tool.key, kAlone, false, tool.tool,
                            kToolNames.at(static_cast<std::size_t>(tool.tool)), tool.plain->purpose});
    presses_.insert(presses_.end(), kKeyBindings.begin(), kKeyBindings.end());
}

const KeyMap& KeyMap::usual() {
    static const KeyMap map;
    return map;
}

Chord KeyMap::at(std::size_t row) const {
    if (row >= presses_.size()) return {holds_.at(row - presses_.size()).key, kAlone};
    return {presses_[row].key, presses_[row].with};
}

std::string_view KeyMap::name(std::size_t row) const {
    return row < presses_.size() ? presses_[row].name : holds_.at(row - presses_.size()).name;
}

std::string_view KeyMap::meaning(std::size_t row) const {
    return row < presses_.size() ? presses_[row].meaning : holds_.at(row - presses_.size()).meaning;
}

bool KeyMap::may_change(std::size_t row) const {
    const Verb* const verb = row < presses_.size() ? std::get_if<Verb>(&presses_[row].does) : nullptr;
    return !verb || *verb != Verb::kClosePanel;
}

bool KeyMap::accepts(std::size_t row, Chord chord) const {
    if (chord.key == Key::kShift || chord.key == Key::kControl || chord.key == Key::kAlt) return false;
    return row < presses_.size() || chord.with == kAlone;
}

// A held key acts with Shift too, and then is faster.
std::optional<std::size_t> KeyMap::conflict(std::size_t row, Chord chord) const {
    const auto held_with = [](Modifiers with) { return !with.control && !with.alt; };
    const bool holds = row >= presses_.size();
    for (std::size_t other = 0; other < size() && chord.key != Key::kNone; ++other) {
        const Chord its = at(other);
        if (other == row || its.key != chord.key) continue;
        const bool other_holds = other >= presses_.size();
        if (its.with == chord.with || (holds && held_with(its.with)) ||
            (other_holds && held_with(chord.with)))
            return other;
    }
    return std::nullopt;
}

void KeyMap::bind(std::size_t row, Chord chord) {
    while (const auto other = conflict(row, chord)) {
        if (*other >= presses_.size())
            holds_[*other - presses_.size()].key = Key::kNone;
        else
            presses_[*other].key = Key::kNone, presses_[*other].with = kAlone;
    }
    if (row >= presses_.size())
        holds_.at(row - presses_.size()).key = chord.key;
    else
        presses_[row].key = chord.key, presses_[row].with = chord.with;
}

bool KeyMap::operator==(const KeyMap& other) const {
    for (std::size_t row = 0; row < size(); ++row)
        if (at(row) != other.at(row)) return false;
    return true;
}

std::span<const GestureBinding> gesture_bindings() {
    return kGestureBindings;
}

namespace {

// `word`: how the words on keys are written.
template <class Word>
std::string spelled(const KeyboardLayout& layout, Key key, Modifiers with, const Word& word) {
    std::string name;
    const auto hold = [&](bool held, const char* modifier) {
        if (held) name.append(word(modifier)).append("+");
    };
    hold(with.control, message("Ctrl"));
    hold(with.alt, message("Alt"));
    hold(with.shift, message("Shift"));
    const int code = static_cast<int>(key), function = code - static_cast<int>(Key::kF1) + 1;
    if (function >= 1 && function <= 12) {
        name += 'F';
        if (function >= 10) name += '1';
        name += static_cast<char>('0' + function % 10);
    } else if (const std::string_view bare = bare_name(key); !bare.empty()) {
        name += word(bare);
    } else {
        name += layout.name_of(key);
    }
    return name;
}

// As files spell it, in any language.
std::string spelled(Key key, Modifiers with) {
    return spelled({}, key, with, [](std::string_view word) { return word; });
}

}  // namespace

std::string name_of(const KeyboardLayout& layout, Key key, Modifiers with) {
    return spelled(layout, key, with, [](std::string_view word) { return tr(word); });
}

std::string text_of(Chord chord) {
    return chord.key == Key::kNone ? std::string() : spelled(chord.key, chord.with);
}

std::optional<Chord> chord_of(std::string_view text) {
    Chord chord;
    if (text.empty()) return chord;
    const auto takes = [&](std::string_view prefix, bool& held) {
        held = text.size() > prefix.size() && text.starts_with(prefix);
        if (held) text.remove_prefix(prefix.size());
    };
    takes("Ctrl+", chord.with.control);
    takes("Alt+", chord.with.alt);
    takes("Shift+", chord.with.shift);
    for (int code = 1; code < kKeys; ++code)
        if (spelled(static_cast<Key>(code), kAlone) == text) {
            chord.key = static_cast<Key>(code);
            return chord;
        }
    return std::nullopt;
}

namespace {

std::string name_of_first(const Keys& keys, std::variant<Verb, Tool> does) {
    for (const KeyBinding& binding : keys.map.presses())
        if (binding.does == does && binding.key != Key::kNone)
            return name_of(keys.layout, binding.key, binding.with);
    return {};
}

}  // namespace

std::string name_of(const Keys& keys, Verb verb) {
    if (keys.by_pad)
        if (const auto button = pad_name_of(verb); !button.empty()) return std::string(button);
    return name_of_first(keys, verb);
}

std::string name_of(const Keys& keys, Tool tool) {
    return name_of_first(keys, tool);
}

std::string names_of_walking(const Keys& keys) {
    std::string names;
    for (const Held held : {Held::kForward, Held::kLeft, Held::kBack, Held::kRight}) {
        const auto first = std::ranges::find(keys.map.holds(), held, &HeldBinding::held);
        if (!names.empty()) names += ' ';
        names += name_of(keys.layout, first->key);
    }
    return names;
}

}  // namespace game
