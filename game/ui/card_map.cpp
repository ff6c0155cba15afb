#include "game/ui/card_map.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

#include "game/ui/style.h"

namespace game::ui {
namespace {

// Houses are squares and what the user did is a ring; what became of a house shows by shape too.
void draw_mark(ImDrawList& list, ImVec2 at, SlideMap::Mark::Kind kind, float em) {
    using Kind = SlideMap::Mark::Kind;
    const float half = 0.28f * em;
    const ImVec2 from{at.x - half, at.y - half}, to{at.x + half, at.y + half};
    constexpr ImU32 kInk = IM_COL32(20, 22, 28, 255);
    const ImU32 colour = mark_colour(kind);
    if (kind == Kind::kCommand) {
        list.AddCircle(at, half * 1.2f, kInk, 0, 0.32f * em);
        return list.AddCircle(at, half * 1.2f, colour, 0, 0.16f * em);
    }
    if (kind == Kind::kDestroyed) {
        for (const auto& [ink, width] : {std::pair(kInk, 0.32f), std::pair(colour, 0.18f)}) {
            list.AddLine(from, to, ink, width * em);
            list.AddLine({from.x, to.y}, {to.x, from.y}, ink, width * em);
        }
        return;
    }
    list.AddRectFilled(from, to, colour);
    list.AddRect(from, to, kInk, 0, 0, 0.1f * em);
    if (kind == Kind::kDamaged) list.AddLine(from, to, kInk, 0.1f * em);
}

}  // namespace

void CardMap::show(Widgets& widgets, const std::shared_ptr<const SlideMap>& map, float most_height,
                   Actions& actions) {
    shown_ = map;
    constexpr float kHighest = 12;  // em
    const float aspect = static_cast<float>(map->width) / static_cast<float>(map->height),
                room = ImGui::GetContentRegionAvail().x,
                height = std::min({room / aspect, kHighest * widgets.em, most_height}),
                width = height * aspect;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + (room - width) / 2);
    const ImVec2 from = ImGui::GetCursorScreenPos(), to{from.x + width, from.y + height};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImGui::InvisibleButton("Map", {width, height});
    widgets.note("Map");
    if (uploaded_ == map)
        list.AddImage(std::bit_cast<ImTextureID>(std::uintptr_t{texture_.name()}), from, to);
    const glm::dvec2 size = map->north_east - map->south_west;
    list.PushClipRect(from, to, true);
    for (const SlideMap::Mark& mark : map->marks) {
        const glm::vec2 share((mark.at - map->south_west) / size);
        draw_mark(list, {from.x + share.x * width, to.y - share.y * height}, mark.kind, widgets.em);
    }
    list.PopClipRect();
    if (!ImGui::IsItemClicked()) return;
    const ImVec2 cursor = ImGui::GetIO().MousePos;
    const glm::dvec2 share((cursor.x - from.x) / width, (to.y - cursor.y) / height);
    actions.emplace_back(LookAt{map->south_west + share * size});
}

void CardMap::upload_if_new() {
    if (!shown_ || shown_ == uploaded_) return;
    texture_ = render::make_texture(GL_RGB8, shown_->width, shown_->height, GL_LINEAR);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(texture_.name(), 0, 0, 0, shown_->width, shown_->height, GL_RGB, GL_UNSIGNED_BYTE,
                        shown_->texels.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    uploaded_ = shown_;
}

}  // namespace game::ui
