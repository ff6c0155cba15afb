// The picture of a gamepad with what each of its parts does.

#include <algorithm>
#include <array>

#include "game/ui/menu_pages.h"
#include "game/words/words.h"

namespace game::ui {
namespace {

// Draws in a frame in which the gamepad reaches from −1 to 1, y down.
class PadPicture {
  public:
    PadPicture(ImDrawList& list, ImVec2 middle, float half, float em)
        : list_(list), middle_(middle), half_(half), width_(std::max(1.5f, em / 9)) {}

    ImVec2 at(glm::vec2 point) const { return {middle_.x + point.x * half_, middle_.y + point.y * half_}; }

    void draw() const {
        outline();
        for (const glm::vec2 stick : {glm::vec2(-0.56f, -0.14f), glm::vec2(0.26f, 0.08f)}) {
            ring(stick, 0.15f);
            ring(stick, 0.09f);
        }
        for (const glm::vec2 button : {glm::vec2(0.58f, -0.02f), glm::vec2(0.7f, -0.14f),
                                       glm::vec2(0.46f, -0.14f), glm::vec2(0.58f, -0.26f)})
            ring(button, 0.055f);
        for (const float x : {-0.16f, 0.16f}) ring({x, -0.14f}, 0.035f);
        box({-0.3f, -0.04f}, {-0.22f, 0.2f});
        box({-0.38f, 0.04f}, {-0.14f, 0.12f});
        for (const float side : {-1.f, 1.f}) {
            box({side * 0.58f - 0.16f, -0.6f}, {side * 0.58f + 0.16f, -0.53f});
            box({side * 0.58f - 0.11f, -0.76f}, {side * 0.58f + 0.11f, -0.64f});
        }
    }

    void point_at(glm::vec2 part, ImVec2 label_end) const {
        list_.AddLine(label_end, at(part), faded(kAccent, 0.6f), width_ * 0.7f);
        list_.AddCircleFilled(at(part), width_ * 1.6f, kAccent);
    }

  private:
    // The right half as curves from the middle of the upper edge to that of the lower one, and its mirror image back.
    void outline() const {
        struct Curve {
            glm::vec2 by, and_by, to;
        };
        constexpr std::array<Curve, 4> kRight{{{{0.35f, -0.42f}, {0.4f, -0.5f}, {0.62f, -0.48f}},
                                               {{0.86f, -0.44f}, {0.98f, 0.2f}, {0.96f, 0.5f}},
                                               {{0.94f, 0.78f}, {0.7f, 0.7f}, {0.56f, 0.42f}},
                                               {{0.46f, 0.24f}, {0.3f, 0.24f}, {0, 0.24f}}}};
        constexpr glm::vec2 kFrom{0, -0.42f};
        const auto mirrored = [&](glm::vec2 point) { return at({-point.x, point.y}); };
        list_.PathLineTo(at(kFrom));
        for (const Curve& curve : kRight)
            list_.PathBezierCubicCurveTo(at(curve.by), at(curve.and_by), at(curve.to));
        for (std::size_t i = kRight.size(); i-- > 0;)
            list_.PathBezierCubicCurveTo(mirrored(kRight[i].and_by), mirrored(kRight[i].by),
                                         mirrored(i > 0 ? kRight[i - 1].to : kFrom));
        list_.PathStroke(palette().dim_text, ImDrawFlags_Closed, width_);
    }
    void ring(glm::vec2 centre, float radius) const {
        list_.AddCircle(at(centre), radius * half_, palette().dim_text, 0, width_);
    }
    void box(glm::vec2 from, glm::vec2 to) const {
        list_.AddRect(at(from), at(to), palette().dim_text, half_ * 0.02f, 0, width_);
    }

    ImDrawList& list_;
    ImVec2 middle_;
    float half_, width_;
};

// A label beside the picture, and the part of it that it is about.
struct Callout {
    std::string_view name;
    glm::vec2 part;
};
constexpr std::array kLeftCallouts{
    Callout{"Left trigger, held", {-0.58f, -0.7f}},
    Callout{"Left bumper, held", {-0.58f, -0.565f}},
    Callout{"Back", {-0.16f, -0.14f}},
    Callout{"Left stick", {-0.65f, -0.14f}},
    Callout{"Left stick pressed", {-0.56f, -0.14f}},
    Callout{"D-pad up, down", {-0.26f, 0.02f}},
    Callout{"D-pad left, right", {-0.34f, 0.08f}},
};
constexpr std::array kRightCallouts{
    Callout{"Right trigger", {0.58f, -0.7f}},
    Callout{"Right bumper, held", {0.58f, -0.565f}},
    Callout{"Start", {0.16f, -0.14f}},
    Callout{"Y", {0.58f, -0.26f}},
    Callout{"X", {0.46f, -0.14f}},
    Callout{"B", {0.7f, -0.14f}},
    Callout{"A", {0.58f, -0.02f}},
    Callout{"Right stick", {0.34f, 0.08f}},
    Callout{"Right stick pressed", {0.26f, 0.08f}},
};

std::string_view meaning_of(std::string_view name) {
    for (const PadPart& part : pad_parts())
        if (part.name == name) return part.meaning;
    for (const PadBinding& binding : pad_bindings())
        if (binding.name == name) return binding.meaning;
    return {};
}

// Labels of one side in a column of this width, from `from` down.
void callouts(Desk& desk, std::span<const Callout> all, ImVec2 from, ImVec2 size, bool at_right,
              const PadPicture& picture) {
    const float em = desk.em(), each = size.y / static_cast<float>(all.size()),
                small = desk.widgets.letters.small->FontSize;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    float top = from.y;
    for (const Callout& callout : all) {
        const std::string_view name = tr(callout.name), meaning = tr(meaning_of(callout.name));
        list.AddText(desk.widgets.letters.small, small, {from.x, top}, kAccent, name.data(),
                     name.data() + name.size());
        list.AddText(desk.widgets.letters.usual, em, {from.x, top + small + em * 0.1f}, palette().text,
                     meaning.data(), meaning.data() + meaning.size(), size.x);
        desk.widgets.note(callout.name, {from.x, top}, {from.x + size.x, top + each});
        picture.point_at(callout.part, {at_right ? from.x - em * 0.4f : from.x + size.x, top + small * 0.6f});
        top += each;
    }
}

}  // namespace

void pad_page(Desk& desk, const Facts& facts) {
    desk.widgets.dim(facts.gamepad ? "Buttons have the names of an Xbox controller; others have theirs at "
                                     "the same places."
                                   : "No gamepad is connected. Plug one in at any time.");
    const float em = desk.em(), width = ImGui::GetContentRegionAvail().x,
                height = std::max(ImGui::GetContentRegionAvail().y - em, 20 * em);
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float words = std::min(width * 0.27f, 15 * em), between = width - 2 * words;
    const PadPicture picture(*ImGui::GetWindowDrawList(), {from.x + width / 2, from.y + height * 0.52f},
                             std::min(between * 0.42f, height * 0.5f), em);
    picture.draw();
    callouts(desk, kLeftCallouts, from, {words - em, height}, false, picture);
    callouts(desk, kRightCallouts, {from.x + width - words, from.y}, {words, height}, true, picture);
    ImGui::Dummy({width, height});
}

}  // namespace game::ui
