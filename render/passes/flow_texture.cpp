#include "render/passes/flow_texture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

#include "assets/shaders/slots.glsl"
#include "render/pictures/png.h"

namespace render {
namespace {

// Maps −1 … 1 so that 0 is exactly a byte: level ground stays level.
std::uint8_t slope_to_byte(float share) {
    return static_cast<std::uint8_t>(128 + std::lround(127 * std::clamp(share, -1.f, 1.f)));
}

// Slopes and height of each texel, from a map of normals and one of heights.
std::vector<std::uint8_t> grain_of(const Texels& normal, const Texels& height) {
    std::vector<std::uint8_t> grain(4 * normal.size());
    for (std::size_t i = 0; i < normal.size(); ++i) {
        const auto along = [&](int axis) {
            return (static_cast<float>(normal.values[3 * i + static_cast<std::size_t>(axis)]) - 128) / 127;
        };
        const float up = std::max(along(2), 0.05f);
        for (const int axis : {0, 1})
            grain[4 * i + static_cast<std::size_t>(axis)] =
                slope_to_byte(-along(axis) / up / static_cast<float>(STEEPEST_GRAIN));
        grain[4 * i + 2] = height.values[i];
    }
    return grain;
}

// Creates a texture that repeats and has mipmaps.
Texture texture_of(GLenum format, GLenum layout, int width, int height,
                   const std::vector<std::uint8_t>& texels) {
    const int levels = 1 + static_cast<int>(std::floor(std::log2(std::max(width, height))));
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &name);
    Texture texture(name);
    glTextureStorage2D(name, levels, format, width, height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(name, 0, 0, 0, width, height, layout, GL_UNSIGNED_BYTE, texels.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glGenerateTextureMipmap(name);
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    return texture;
}

float linear(std::uint8_t srgb) {
    const float c = static_cast<float>(srgb) / 255;
    return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
}

glm::vec3 mean_of(const Texels& albedo) {
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < albedo.size(); ++i)
        for (int c = 0; c < 3; ++c) sum[c] += linear(albedo.values[3 * i + static_cast<std::size_t>(c)]);
    return glm::vec3(sum / static_cast<double>(albedo.size()));
}

}  // namespace

tl::expected<FlowTexture, std::string> FlowTexture::load(const std::filesystem::path& assets,
                                                         FlowPattern pattern) {
    const std::filesystem::path folder = assets / "textures";
    const std::string name(to_string(pattern));
    const auto albedo = read_png(folder / (name + ".png"), 3);
    if (!albedo) return tl::unexpected(albedo.error());
    const auto normal = read_png(folder / (name + "-normal.png"), 3);
    if (!normal) return tl::unexpected(normal.error());
    const auto height = read_png(folder / (name + "-height.png"), 1);
    if (!height) return tl::unexpected(height.error());
    for (const Texels* texels : {&*normal, &*height})
        if (texels->width != albedo->width || texels->height != albedo->height)
            return tl::unexpected(fmt::format("{}: pictures of {} differ in size", folder.string(), name));

    FlowTexture texture;
    texture.mean = mean_of(*albedo);
    texture.grain = texture_of(GL_RGBA8, GL_RGBA, normal->width, normal->height, grain_of(*normal, *height));
    texture.stochastic = is_stochastic(pattern);
    if (texture.stochastic) {
        const auto colours = read_png(folder / (name + "-colours.png"), 3);
        if (!colours) return tl::unexpected(colours.error());
        texture.colours = texture_of(GL_SRGB8, GL_RGB, colours->width, colours->height, colours->values);
        glTextureParameteri(texture.colours.name(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    } else {
        texture.colours = texture_of(GL_SRGB8, GL_RGB, albedo->width, albedo->height, albedo->values);
    }
    return texture;
}

void FlowTexture::bind() const {
    glBindTextureUnit(SLOT_GRAIN, grain.name());
    glBindTextureUnit(SLOT_PAINT, colours.name());
}

}  // namespace render
