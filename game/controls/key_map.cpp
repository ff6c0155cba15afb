#include "game/controls/key_map.h"

#include <algorithm>
#include <array>

namespace game {
namespace {

constexpr Modifiers kAlone{}, kShift{true, false, false}, kControl{false, true, false},
    kControlShift{true, true, false};

// In the order of the help panel.
constexpr std::array kKeyBindings{
    KeyBinding{Key::kLeftBracket, kAlone, true, Verb::kSmallerBrush, "smaller brush"},
    KeyBinding{Key::kRightBracket, kAlone, true, Verb::kLargerBrush, "larger brush"},
    KeyBinding{Key::kLeftBracket, kShift, true, Verb::kWeakerBrush, "weaker brush"},
    KeyBinding{Key::kRightBracket, kShift, true, Verb::kStrongerBrush, "stronger brush"},
    KeyBinding{key('L'), kAlone, false, Verb::kPourStandingOrRolling,
               "pour onto the standing or into the rolling layer"},
    KeyBinding{Key::kSpace, kAlone, false, Verb::kPauseOrGoOn, "pause or resume; tools act in a pause too"},
    KeyBinding{Key::kPeriod, kAlone, true, Verb::kStepOnce, "step one tick"},
    KeyBinding{Key::kComma, kAlone, true, Verb::kStepBack, "step one tick back"},
    KeyBinding{Key::kBackspace, kAlone, false, Verb::kRunBack, "rewind, or run forward again"},
    KeyBinding{Key::kEnter, kAlone, false, Verb::kTakeOver, "continue from here, in the past or a recording"},
    KeyBinding{Key::kMinus, kAlone, false, Verb::kSlower, "half the speed"},
    KeyBinding{Key::kEqual, kAlone, false, Verb::kFaster, "twice the speed"},
    KeyBinding{key('0'), kAlone, false, Verb::kUsualSpeed, "normal speed"},
    KeyBinding{key('Z'), kControl, false, Verb::kUndo, "undo the last action"},
    KeyBinding{key('Y'), kControl, false, Verb::kRedo, "redo what was undone last"},
    KeyBinding{key('Z'), kControlShift, false, Verb::kRedo, "redo what was undone last"},
    KeyBinding{key('R'), kControl, false, Verb::kReset, "restart the scene"},
    KeyBinding{Key::kHome, kAlone, false, Verb::kOverview, "show the whole terrain"},
    KeyBinding{key('T'), kAlone, false, Verb::kTopDown, "top view on or off"},
    KeyBinding{key('F'), kAlone, false, Verb::kFly, "fly mode on or off"},
    KeyBinding{key('V'), kAlone, false, Verb::kChase, "follow the front of a slide, or stop that"},
    KeyBinding{function_key(1), kAlone, false, Verb::kToggleHelp, "this help"},
    KeyBinding{function_key(2), kAlone, false, Verb::kToggleScene, "scene panel"},
    KeyBinding{function_key(3), kAlone, false, Verb::kTogglePhysics, "physics panel"},
    KeyBinding{function_key(4), kAlone, false, Verb::kToggleDisplay, "display panel"},
    KeyBinding{function_key(5), kAlone, false, Verb::kTogglePerformance, "performance panel"},
    KeyBinding{Key::kEscape, kAlone, false, Verb::kClosePanel, "close a list or a panel"},
    KeyBinding{Key::kTab, kAlone, false, Verb::kTogglePanels, "show or hide all panels"},
    KeyBinding{function_key(10), kAlone, false, Verb::kShare, "share this slide as a web page"},
    KeyBinding{function_key(11), kAlone, false, Verb::kFullscreen, "full screen on or off"},
    KeyBinding{key('M'), kAlone, false, Verb::kMute, "sound on or off"},
    KeyBinding{function_key(12), kAlone, false, Verb::kScreenshot, "take a screenshot"},
    KeyBinding{key('Q'), kControl, false, Verb::kQuit, "quit"},
};

constexpr std::array kHeldBindings{
    HeldBinding{key('W'), Held::kForward, "move forward"},
    HeldBinding{Key::kUp, Held::kForward, "move forward"},
    HeldBinding{key('S'), Held::kBack, "move back"},
    HeldBinding{Key::kDown, Held::kBack, "move back"},
    HeldBinding{key('A'), Held::kLeft, "move left"},
    HeldBinding{Key::kLeft, Held::kLeft, "move left"},
    HeldBinding{key('D'), Held::kRight, "move right"},
    HeldBinding{Key::kRight, Held::kRight, "move right"},
    HeldBinding{key('E'), Held::kUp, "move up"},
    HeldBinding{Key::kPageUp, Held::kUp, "move up"},
    HeldBinding{key('Q'), Held::kDown, "move down"},
    HeldBinding{Key::kPageDown, Held::kDown, "move down"},
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
            return "Space";
        case Key::kEscape:
            return "Esc";
        case Key::kEnter:
            return "Enter";
        case Key::kTab:
            return "Tab";
        case Key::kBackspace:
            return "Backspace";
        case Key::kDelete:
            return "Delete";
        case Key::kLeft:
            return "Left";
        case Key::kRight:
            return "Right";
        case Key::kUp:
            return "Up";
        case Key::kDown:
            return "Down";
        case Key::kHome:
            return "Home";
        case Key::kEnd:
            return "End";
        case Key::kPageUp:
            return "PageUp";
        case Key::kPageDown:
            return "PageDown";
        case Key::kShift:
            return "Shift";
        case Key::kControl:
            return "Ctrl";
        case Key::kAlt:
            return "Alt";
        default:
            return {};
    }
}

}  // namespace

std::span<const KeyBinding> key_bindings() {
    static const auto all = [] {
        std::array<KeyBinding, kTools + kKeyBindings.size()> bindings{};
        auto next = bindings.begin();
        for (const ToolInfo& tool : tool_infos())
            *next++ = {tool.key, kAlone, false, tool.tool, tool.plain->purpose};
        std::copy(kKeyBindings.begin(), kKeyBindings.end(), next);
        return bindings;
    }();
    return all;
}

std::span<const HeldBinding> held_bindings() {
    return kHeldBindings;
}

std::span<const GestureBinding> gesture_bindings() {
    return kGestureBindings;
}

std::string name_of(const KeyboardLayout& layout, Key key, Modifiers with) {
    std::string name;
    if (with.control) name += "Ctrl+";
    if (with.alt) name += "Alt+";
    if (with.shift) name += "Shift+";
    const int code = static_cast<int>(key), function = code - static_cast<int>(Key::kF1) + 1;
    if (function >= 1 && function <= 12) {
        name += 'F';
        if (function >= 10) name += '1';
        name += static_cast<char>('0' + function % 10);
    } else if (const std::string_view word = bare_name(key); !word.empty()) {
        name += word;
    } else {
        name += layout.name_of(key);
    }
    return name;
}

std::string name_of(const KeyboardLayout& layout, Verb verb) {
    for (const KeyBinding& binding : kKeyBindings)
        if (std::get<Verb>(binding.does) == verb) return name_of(layout, binding.key, binding.with);
    return {};
}

std::string names_of_walking(const KeyboardLayout& layout) {
    std::string names;
    for (const Held held : {Held::kForward, Held::kLeft, Held::kBack, Held::kRight}) {
        const auto* const first = std::ranges::find(kHeldBindings, held, &HeldBinding::held);
        if (!names.empty()) names += ' ';
        names += layout.name_of(first->key);
    }
    return names;
}

}  // namespace game
