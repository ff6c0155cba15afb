#include "game/compare/lettering.h"

#include <cmath>

#include <imgui.h>
#include <imgui_internal.h>

#include "game/files/ui_font.h"

namespace game {
namespace {

// Covers Latin-1, dashes and minus.
constexpr ImWchar kGlyphs[] = {0x0020, 0x00ff, 0x2010, 0x2027, 0x2190, 0x2193,
                               0x2212, 0x2212, 0x2264, 0x2265, 0};

}  // namespace

struct Lettering::Parts {
    ImFontAtlas atlas;
    ImFont* font = nullptr;
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;

    // Calls each(glyph, its pen) for the letters of a line; returns the pen at the end.
    template <class Each>
    float go_along(std::string_view text, const Each& each) const {
        float pen = 0;
        for (const char *at = text.data(), *end = at + text.size(); at < end;) {
            unsigned letter = 0;
            at += ImTextCharFromUtf8(&letter, at, end);
            const ImFontGlyph* glyph = font->FindGlyph(static_cast<ImWchar>(letter));
            each(*glyph, std::round(pen));
            pen += glyph->AdvanceX;
        }
        return pen;
    }
};

Lettering::Lettering(float height_px) : parts_(std::make_unique<Parts>()), height_(height_px) {
    ImFontConfig config;
    config.SizePixels = height_px;
    config.OversampleH = 1;  // an atlas pixel is a sheet pixel
    std::error_code error;
    if (const auto file = ui_font(); file && std::filesystem::is_regular_file(*file, error))
        parts_->font = parts_->atlas.AddFontFromFileTTF(file->c_str(), height_px, &config, kGlyphs);
    if (!parts_->font) {
        parts_->font = parts_->atlas.AddFontDefault(&config);
    }
    parts_->atlas.GetTexDataAsAlpha8(&parts_->pixels, &parts_->width, &parts_->height);
}
Lettering::~Lettering() = default;
Lettering::Lettering(Lettering&&) noexcept = default;

float Lettering::width(std::string_view text) const {
    return parts_->go_along(text, [](const ImFontGlyph&, float) {});
}

void Lettering::write(render::Sheet& sheet, glm::vec2 at, std::string_view text,
                      const glm::vec3& colour) const {
    const Parts& p = *parts_;
    const glm::vec2 from(std::round(at.x), std::round(at.y));
    p.go_along(text, [&](const ImFontGlyph& glyph, float pen) {
        const glm::vec2 corner = from + glm::vec2(pen + std::round(glyph.X0), std::round(glyph.Y0));
        const int u = static_cast<int>(std::lround(glyph.U0 * static_cast<float>(p.width)));
        const int v = static_cast<int>(std::lround(glyph.V0 * static_cast<float>(p.height)));
        const int width = static_cast<int>(std::lround(glyph.U1 * static_cast<float>(p.width))) - u;
        const int height = static_cast<int>(std::lround(glyph.V1 * static_cast<float>(p.height))) - v;
        if (width <= 0 || height <= 0) return;
        sheet.paint(
            corner, corner + glm::vec2(width - 1, height - 1),
            [&](const glm::vec2& pixel) {
                const int x = u + static_cast<int>(pixel.x - corner.x);
                const int y = v + static_cast<int>(pixel.y - corner.y);
                return static_cast<float>(p.pixels[y * p.width + x]) / 255.f;
            },
            colour);
    });
}

}  // namespace game
