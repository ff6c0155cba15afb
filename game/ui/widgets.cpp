#include "game/ui/widgets.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <utility>

#include "game/words/words.h"

namespace game::ui {
namespace {

constexpr double kTooltipAfter = 0.4;  // s
constexpr float kTooltipWidth = 20;    // em, at most
constexpr float kLabelShare = 0.42f;   // of a row's width

ImU32 plate_colour(bool on) {
    const bool hovered = ImGui::IsItemHovered();
    if (on) return hovered ? kAccent : faded(kAccent, 0.88f);
    return ImGui::IsItemActive() ? palette().control_held
           : hovered             ? palette().control_hovered
                                 : palette().control;
}

// Applies BeginDisabled, which ImDrawList ignores.
ImU32 alive(ImU32 colour) {
    return faded(colour, ImGui::GetStyle().Alpha);
}

bool enabled() {
    return ImGui::GetStyle().Alpha >= 1;
}

// A text of limited length, which always ends with 0.
class CutText {
  public:
    explicit CutText(std::span<char> room) : left_(room) { left_[0] = 0; }
    void add(std::string_view part) {
        part = part.substr(0, left_.size() - 1);
        std::copy(part.begin(), part.end(), left_.begin());
        left_ = left_.subspan(part.size());
        left_[0] = 0;
    }
    // A number, with blanks between its thousands in place of commas.
    void add_grouped(std::string_view number) {
        const std::string_view whole = number.substr(0, number.find('.'));
        std::size_t digits = whole.size() - static_cast<std::size_t>(std::ranges::count(whole, ','));
        for (std::size_t i = 0; i < whole.size(); ++i) {
            if (whole[i] == ',') continue;
            add(whole.substr(i, 1));
            if (--digits > 0 && digits % 3 == 0) add(" ");
        }
        add(number.substr(whole.size()));
    }

  private:
    std::span<char> left_;
};

// Of the words of a text, px: what wrapping cannot make narrower.
float widest_word(std::string_view text) {
    float widest = 0;
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(' '));
        widest = std::max(widest, ImGui::CalcTextSize(word.data(), word.data() + word.size()).x);
        text.remove_prefix(std::min(word.size() + 1, text.size()));
    }
    return widest;
}

// Of words and icons; light on the accent too once that is greyed.
ImU32 colour_on_plate(bool on) {
    return on && enabled() ? kAccentText : palette().text;
}

}  // namespace

void Places::note(std::string_view label) {
    const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
    const ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 seen_from = list.GetClipRectMin(), seen_to = list.GetClipRectMax();
    const float x = (from.x + to.x) / 2, y = (from.y + to.y) / 2;
    if (x > seen_from.x && x < seen_to.x && y > seen_from.y && y < seen_to.y) note(label, from, to);
}

void Places::note(std::string_view label, ImVec2 from, ImVec2 to) {
    if (size_ == kMost) return;
    Place& place = places_[size_++] = {.from = from, .to = to};
    CutText(place.label).add(label);
}

void Places::note_cut(std::string_view words) {
    if (cut_ < cut_words_.size()) CutText(cut_words_[cut_++]).add(words);
}

const Places::Place* Places::find(std::string_view label) const {
    const auto end = places_.rend(), last = end - static_cast<std::ptrdiff_t>(size_);
    const auto found = std::find_if(last, end, [label](const Place& place) {
        return std::string_view(place.label.data()) == label.substr(0, place.label.size() - 1);
    });
    return found == end ? nullptr : &*found;
}

void Widgets::begin_frame(double elapsed_s) {
    places_.clear();
    occupied_ = std::exchange(occupied_next_, {});
    elapsed_s_ = elapsed_s;
    types_name_ = std::exchange(types_name_next_, false);
    if (!std::exchange(hovering_, false)) hovered_s_ = 0;
}

void Widgets::tooltip(const char* text) {
    text = tr(text);
    if (!text || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    const ImVec2 at = ImGui::GetItemRectMin();
    hovered_s_ = at.x == hovered_.x && at.y == hovered_.y ? hovered_s_ + elapsed_s_ : 0;
    hovered_ = at;
    hovering_ = true;
    if (hovered_s_ < kTooltipAfter || ImGui::IsItemActive()) return;
    const float width = em * kTooltipWidth;
    const ImVec2 words = ImGui::CalcTextSize(text, nullptr, false, width),
                 pad = ImGui::GetStyle().WindowPadding;
    const ImVec2 size{words.x + 2 * pad.x, words.y + 2 * pad.y}, window = ImGui::GetWindowPos(),
                                                                 extent = ImGui::GetWindowSize();
    const ImVec2 to = beside({ImGui::GetItemRectMin(), ImGui::GetItemRectMax()},
                             {window, {window.x + extent.x, window.y + extent.y}}, size);
    ImGui::SetNextWindowPos(to);
    const float alpha = ImGui::GetStyle().Alpha;
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, std::max(alpha, 1.f));  // readable over a greyed widget
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(pad.x + width);
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
    places_.note("Tooltip", to, {to.x + size.x, to.y + size.y});
}

// The place for a tooltip that is nearest to its item: below, above or beside its panel and clear of all others.
// If there is none, below the item or above it.
ImVec2 Widgets::beside(const Box& item, const Box& panel, ImVec2 size) const {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float gap = em * 0.3f;
    // Of a wide item, where the cursor is.
    const bool wide = item.to.x - item.from.x > em * kTooltipWidth / 2;
    const float x = wide ? ImGui::GetIO().MousePos.x : (item.from.x + item.to.x) / 2;
    const float centred = std::clamp(x - size.x / 2, 0.f, std::max(screen.x - size.x, 0.f));
    ImVec2 best{centred, item.to.y + gap};
    if (best.y + size.y > screen.y) best.y = item.from.y - gap - size.y;
    float least = FLT_MAX;
    const auto consider = [&](float left, float top) {
        const float right = left + size.x, bottom = top + size.y;
        if (left < 0 || top < 0 || right > screen.x || bottom > screen.y) return;
        const auto hides = [&](const Box& box) {
            return left < box.to.x && right > box.from.x && top < box.to.y && bottom > box.from.y;
        };
        const auto boxes = occupied_.boxes.begin();
        if (hides(panel) || std::any_of(boxes, boxes + static_cast<std::ptrdiff_t>(occupied_.size), hides))
            return;
        const float away = std::hypot(left - centred, top - item.from.y);
        if (away >= least) return;
        least = away;
        best = {left, top};
    };
    for (const float top : {panel.to.y + gap, panel.from.y - gap - size.y, item.from.y}) {
        for (const float left : {centred, panel.to.x + gap, panel.from.x - gap - size.x}) consider(left, top);
        for (std::size_t i = 0; i < occupied_.size; ++i) {
            consider(occupied_.boxes[i].to.x + gap, top);
            consider(occupied_.boxes[i].from.x - gap - size.x, top);
        }
    }
    for (std::size_t i = 0; i < occupied_.size; ++i) consider(centred, occupied_.boxes[i].to.y + gap);
    return best;
}

void Widgets::keep_clear(const Box& box) {
    Boxes& next = occupied_next_;
    if (next.size < next.boxes.size()) next.boxes[next.size++] = box;
}

void Widgets::keep_window_clear(const char* label) {
    const ImVec2 from = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    const Box box{from, {from.x + size.x, from.y + size.y}};
    keep_clear(box);
    places_.note(label, box.from, box.to);
}

bool Widgets::plate(const char* label, ImVec2 size, bool on) {
    const bool pressed = ImGui::InvisibleButton(label, size);
    ImGui::GetWindowDrawList()->AddRectFilled(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                              alive(plate_colour(on)), ImGui::GetStyle().FrameRounding);
    places_.note(label);
    return pressed;
}

bool Widgets::button(const char* label, const char* text, bool on, float width) {
    const char* const words = tr(label);
    const ImVec2 size = ImGui::CalcTextSize(words), padding = ImGui::GetStyle().FramePadding;
    const float wide = width > 0 ? width : size.x + 2 * padding.x;
    const bool pressed = plate(label, {wide, ImGui::GetFrameHeight()}, on);
    const ImVec2 from = ImGui::GetItemRectMin();
    ImGui::GetWindowDrawList()->AddText({from.x + (wide - size.x) / 2, from.y + padding.y},
                                        alive(colour_on_plate(on)), words);
    if (size.x > wide) places_.note_cut(words);
    tooltip(text);
    return pressed;
}

bool Widgets::long_button(const char* label, bool on) {
    const char* const words = tr(label);
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    const float width = ImGui::GetContentRegionAvail().x, room = width - 2 * padding.x;
    const float height = ImGui::CalcTextSize(words, nullptr, false, room).y;
    const bool pressed = plate(label, {width, height + 2 * padding.y}, on);
    const ImVec2 from = ImGui::GetItemRectMin();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {from.x + padding.x, from.y + padding.y},
                 alive(colour_on_plate(on)), words, nullptr, room);
    return pressed;
}

bool Widgets::icon_button(const char* label, Icon icon, const char* text, bool on) {
    const float side = ImGui::GetFrameHeight();
    const bool pressed = plate(label, {side * 1.2f, side}, on);
    const ImVec2 from = ImGui::GetItemRectMin();
    draw_icon(*ImGui::GetWindowDrawList(), icon, {from.x + side * 0.6f, from.y + side * 0.5f}, em * 0.8f,
              alive(colour_on_plate(on)));
    tooltip(text);
    return pressed;
}

float Widgets::tool_button_width(const char* label, const char* key, bool narrow) const {
    const float gap = em * 0.45f;
    const float small = letters.small->FontSize;
    const float word = narrow ? 0 : ImGui::CalcTextSize(tr(label)).x + gap;
    if (key[0] == 0) return em * 0.5f * 2 + em * 0.9f + word;
    return em * 0.6f * 2 + em * 0.9f + gap + word + letters.small->CalcTextSizeA(small, 1e6f, 0, key).x;
}

bool Widgets::tool_button(const char* label, std::span<const IconPart> icon, const char* key,
                          const char* text, bool on, bool narrow, float width) {
    const float gap = em * 0.45f, side = ImGui::GetFrameHeight();
    const bool pressed = plate(label, {width, side}, on);
    const ImVec2 from = ImGui::GetItemRectMin();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    float x = from.x + em * (key[0] == 0 ? 0.5f : 0.6f);
    draw_icon(list, icon, {x + em * 0.45f, from.y + side / 2}, em * 0.9f, alive(colour_on_plate(on)));
    x += em * 0.9f + gap;
    if (!narrow)
        list.AddText({x, from.y + ImGui::GetStyle().FramePadding.y}, alive(colour_on_plate(on)), tr(label));
    const float small = letters.small->FontSize;
    x = from.x + width - em * 0.6f - letters.small->CalcTextSizeA(small, FLT_MAX, 0, key).x;
    list.AddText(letters.small, small, {x, from.y + (side - small) / 2},
                 alive(on && enabled() ? faded(kAccentText, 0.7f) : palette().dim_text), key);
    tooltip(text);
    return pressed;
}

bool Widgets::menu_button(const char* label, const char* note, bool on, ImVec2 size) {
    constexpr float kWithNote = 2.3f;  // em
    const float small = letters.small->FontSize, left = em * 0.9f, gap = em * 0.1f,
                below = size.y >= kWithNote * em ? gap + small : 0;
    const bool pressed = plate(label, size, on);
    const ImVec2 from = ImGui::GetItemRectMin();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float top = from.y + (size.y - em - below) / 2;
    list.PushClipRect(from, {from.x + size.x - left / 2, from.y + size.y}, true);
    list.AddText({from.x + left, top}, alive(colour_on_plate(on)), tr(label));
    if (ImGui::CalcTextSize(tr(label)).x > size.x - left * 1.5f) places_.note_cut(tr(label));
    if (below > 0)
        list.AddText(letters.small, small, {from.x + left, top + em + gap},
                     alive(on ? faded(kAccentText, 0.8f) : palette().dim_text), tr(note));
    list.PopClipRect();
    return pressed;
}

bool Widgets::card(const Card& card, ImVec2 size, bool on) {
    const float rounding = ImGui::GetStyle().FrameRounding, small = letters.small->FontSize, pad = em * 0.5f,
                high = size.x * 9 / 16;
    const bool pressed = plate(card.label, size, on);
    const ImVec2 from = ImGui::GetItemRectMin(), to{from.x + size.x, from.y + size.y},
                 picture_to{to.x, from.y + high};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (card.picture)
        list.AddImageRounded(card.picture, from, picture_to, card.from, card.to,
                             alive(card.is_closed ? IM_COL32(110, 115, 125, 255) : IM_COL32_WHITE), rounding,
                             ImDrawFlags_RoundCornersTop);
    if (card.is_closed)
        draw_icon(list, Icon::kLock, {(from.x + to.x) / 2, from.y + high / 2}, em * 1.6f,
                  alive(palette().text));
    const ImU32 colour = alive(colour_on_plate(on));
    list.PushClipRect(from, {to.x - pad / 2, to.y}, true);
    list.AddText(nullptr, 0, {from.x + pad, picture_to.y + pad * 0.6f}, colour, tr(card.label), nullptr,
                 size.x - 2 * pad);
    const float middle = to.y - em * 0.75f;
    if (card.medal >= 0) draw_stars(list, card.medal, {from.x + pad, middle}, em, colour);
    list.AddText(letters.small, small,
                 {from.x + pad + (card.medal >= 0 ? (kStarsWidth + 0.4f) * em : 0), middle - small / 2},
                 faded(colour, 0.8f), tr(card.note));
    list.PopClipRect();
    if (on) list.AddRect(from, to, kAccent, rounding, 0, std::max(2.f, em / 8));
    return pressed;
}

bool Widgets::text_field(const char* label, const char* hint, std::span<char> text, float width) {
    std::array<char, 64> id;
    std::snprintf(id.data(), id.size(), "##%s", label);
    ImGui::SetNextItemWidth(width);
    const bool ended = ImGui::InputTextWithHint(id.data(), tr(hint), text.data(), text.size(),
                                                ImGuiInputTextFlags_EnterReturnsTrue);
    types_name_next_ |= ImGui::IsItemActive();
    places_.note(label);
    return ended;
}

bool Widgets::toggle(const char* label, bool& on, const char* text) {
    row(label);
    const float side = ImGui::GetFrameHeight(), radius = em * 0.5f;
    const bool pressed = ImGui::InvisibleButton(label, {em * 2.2f, side});
    if (pressed) on = !on;
    const ImVec2 from = ImGui::GetItemRectMin();
    const float y = from.y + side / 2;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({from.x, y - radius}, {from.x + em * 2, y + radius}, alive(plate_colour(on)), radius);
    list.AddCircleFilled({from.x + (on ? em * 2 - radius : radius), y}, radius * 0.72f,
                         alive(colour_on_plate(on)));
    places_.note(label);
    tooltip(text);
    return pressed;
}

// Draws the fill of a slider, from its left to its value.
void Widgets::fill(const Slide& slide, double value, float width) {
    const double part = slide.logarithmic ? std::log(value / slide.least) / std::log(slide.most / slide.least)
                                          : (value - slide.least) / (slide.most - slide.least);
    const ImVec2 from = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled(
        from,
        {from.x + width * static_cast<float>(std::clamp(part, 0.0, 1.0)), from.y + ImGui::GetFrameHeight()},
        alive(faded(kAccent, 0.4f)), ImGui::GetStyle().FrameRounding);
}

bool Widgets::slider(const char* label, double& value, const Slide& slide, const char* text) {
    ImGui::PushID(label);
    const ImGuiID id = ImGui::GetID("##slide");
    double shown = changing_ == id ? slid_ : value;
    const float width = slide.width > 0 ? slide.width : ImGui::GetContentRegionAvail().x;
    fill(slide, shown, width);
    ImGui::SetNextItemWidth(width);
    const ImGuiSliderFlags flags = slide.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
    bool changed = ImGui::SliderScalar("##slide", ImGuiDataType_Double, &shown, &slide.least, &slide.most,
                                       tr(slide.format), flags);
    places_.note(label);
    if (slide.when_released) changed = ImGui::IsItemDeactivatedAfterEdit();
    if (ImGui::IsItemActive()) {
        changing_ = id;
        slid_ = shown;
    } else if (changing_ == id) {
        changing_ = 0;
    }
    tooltip(text);
    if (changed) value = std::clamp(shown, slide.least, slide.most);
    ImGui::PopID();
    return changed;
}

bool Widgets::begin_choice(const char* label, const char* shown, const char* text, float width) {
    std::array<char, 64> id;  // no PushID: an open list is a window of its own, with other ids
    std::snprintf(id.data(), id.size(), "##%s", label);
    ImGui::SetNextItemWidth(width > 0 ? width : -FLT_MIN);
    const bool open = ImGui::BeginCombo(id.data(), tr(shown));
    const float room =
        ImGui::GetItemRectSize().x - ImGui::GetFrameHeight() - ImGui::GetStyle().FramePadding.x;
    if (ImGui::CalcTextSize(tr(shown)).x > room) places_.note_cut(tr(shown));
    if (!open) {
        places_.note(label);
        tooltip(text);
    } else if (std::exchange(closing_choice_, false)) {
        ImGui::CloseCurrentPopup();
    }
    return open;
}

bool Widgets::choice_item(const char* name, int index, bool chosen) {
    ImGui::PushID(index);
    const bool pressed = ImGui::Selectable(tr(name), chosen);
    places_.note(name);
    ImGui::PopID();
    return pressed;
}

void Widgets::row(const char* label) {
    const float from = ImGui::GetCursorPosX(), wide = ImGui::GetContentRegionAvail().x;
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, palette().dim_text);
    ImGui::PushTextWrapPos(from + wide * kLabelShare);
    ImGui::TextUnformatted(tr(label));
    if (widest_word(tr(label)) > wide * kLabelShare) places_.note_cut(tr(label));
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::SameLine(from + wide * kLabelShare);
}

void Widgets::heading(const char* text) {
    ImGui::Dummy({0, em * 0.3f});
    ImGui::PushStyleColor(ImGuiCol_Text, kAccent);
    ImGui::PushFont(letters.small);
    ImGui::TextUnformatted(tr(text));
    ImGui::PopFont();
    ImGui::PopStyleColor();
}

void Widgets::caption(const char* text, float width) {
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float high = letters.small->FontSize;
    ImGui::Dummy({width, high});  // a text would stand on the line of the widget before
    ImGui::GetWindowDrawList()->AddText(letters.small, high, from, palette().dim_text, tr(text));
    if (letters.small->CalcTextSizeA(high, FLT_MAX, 0, tr(text)).x > width) places_.note_cut(tr(text));
}

void Widgets::dim(const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    ImGui::PushFont(letters.small);
    ImGui::PushStyleColor(ImGuiCol_Text, palette().dim_text);
    ImGui::PushTextWrapPos(0);
    ImGui::TextV(tr(format), arguments);
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::PopFont();
    va_end(arguments);
}

void Widgets::plain(const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    ImGui::TextWrappedV(tr(format), arguments);
    va_end(arguments);
}

void Widgets::fact(const char* label, const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    row(label);
    ImGui::PushTextWrapPos(0);
    ImGui::TextV(tr(format), arguments);
    ImGui::PopTextWrapPos();
    places_.note(label);
    va_end(arguments);
}

void Widgets::warn_over_foot(const char* label, const char* text) {
    const ImVec2 window = ImGui::GetWindowPos(), size = ImGui::GetWindowSize(),
                 pad = ImGui::GetStyle().WindowPadding;
    const float width = size.x - 2 * pad.x;
    const ImVec2 words = ImGui::CalcTextSize(text, nullptr, false, width);
    const ImVec2 to{window.x + size.x, window.y + size.y};
    const ImVec2 from{window.x, to.y - words.y - 2 * pad.y};
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    list.AddRectFilled(from, to, palette().notice_plate, ImGui::GetStyle().WindowRounding);
    list.AddRectFilled(from, {from.x + em * 0.2f, to.y}, kWarning);
    list.AddText(letters.usual, em, {from.x + pad.x, from.y + pad.y}, kWarning, text, nullptr, width);
    places_.note(label, from, to);
    places_.note(text, from, to);
}

double round_length(double most) {
    const double power = std::pow(10, std::floor(std::log10(most)));
    for (const double times : {5., 2.})
        if (times * power <= most) return times * power;
    return power;
}

const char* write_number(std::span<char> text, const char* format, double value) {
    std::snprintf(text.data(), text.size(), format, value);
    // Groups digits in threes, from the decimal point to the left.
    const std::string_view digits(text.data(), std::min(std::strcspn(text.data(), ". "), text.size()));
    const std::ptrdiff_t first = digits.starts_with('-') || digits.starts_with('+') ? 1 : 0;
    for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > first; at -= 3) {
        const std::size_t length = std::strlen(text.data());
        if (length + 2 > text.size()) break;
        std::memmove(text.data() + at + 1, text.data() + at, length + 1 - static_cast<std::size_t>(at));
        text[static_cast<std::size_t>(at)] = ' ';
    }
    return text.data();
}

const char* write_volume(std::span<char> text, double cubic_metres) {
    const char* format = cubic_metres == 0     ? "%.0f m³"
                         : cubic_metres < 10   ? "%.2f m³"
                         : cubic_metres < 1000 ? "%.1f m³"
                                               : "%.0f m³";
    return write_number(text, format, cubic_metres);
}

const char* write_with_volumes(std::span<char> text, std::string_view from) {
    constexpr std::string_view kUnit = " m3";
    CutText to(text);
    for (std::size_t at = from.find(kUnit); at != std::string_view::npos; at = from.find(kUnit)) {
        const std::string_view before = from.substr(0, at);
        const std::size_t begin = before.find_last_not_of("0123456789,.") + 1;  // 0 if there is none
        to.add(before.substr(0, begin));
        to.add_grouped(before.substr(begin));
        to.add(" m³");
        from.remove_prefix(at + kUnit.size());
    }
    to.add(from);
    return text.data();
}

}  // namespace game::ui
