#pragma once

#include <memory>
#include <string_view>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/pictures/sheet.h"

namespace game {

// Text on a sheet, without GL, in the font of the panels (ui_font.h).
class Lettering {
  public:
    explicit Lettering(float height_px);
    ~Lettering();
    Lettering(Lettering&&) noexcept;

    float height() const { return height_; }   // px, line spacing
    float width(std::string_view text) const;  // px; one line of UTF-8
    // Writes from the top left corner. `colour` as in Sheet, sRGB 0 to 255.
    void write(render::Sheet& sheet, glm::vec2 at, std::string_view text, const glm::vec3& colour) const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
    float height_;
};

}  // namespace game
