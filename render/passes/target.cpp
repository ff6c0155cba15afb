#include "render/passes/target.h"

#include <algorithm>

#include "assets/shaders/slots.glsl"
#include "render/gl/scissor.h"
#include "sim/core/check.h"

namespace render {
namespace {

int quarter(int samples) {
    return (samples + 3) / 4;
}

void copy(const Texture& from, const Texture& to, std::span<const Rectangle> parts) {
    for (const Rectangle& part : parts)
        glCopyImageSubData(from.name(), GL_TEXTURE_2D, 0, part.left, part.bottom, 0, to.name(), GL_TEXTURE_2D,
                           0, part.left, part.bottom, 0, part.width(), part.height(), 1);
}

}  // namespace

bool Target::resize(int width, int height, int samples) {
    CHECK(width > 0 && height > 0 && (samples == 1 || samples == 2));
    if (width == width_ && height == height_ && samples == samples_) return false;
    width_ = width;
    height_ = height;
    samples_ = samples;
    const int across = samples_across(), up = samples_up();
    depth_ = make_texture(GL_DEPTH_COMPONENT32F, across, up, GL_NEAREST);
    ground_depth_ = make_texture(GL_DEPTH_COMPONENT32F, across, up, GL_NEAREST);
    scene_colour_ = make_texture(GL_RGBA16F, across, up, GL_LINEAR);
    air_colour_ = Texture();  // until there is anything in the air
    averaged_colour_ = samples > 1 ? make_texture(GL_RGBA16F, width, height, GL_NEAREST) : Texture();
    sky_colour_ = make_texture(GL_RGBA16F, quarter(across), quarter(up), GL_LINEAR);
    stepped_ = make_texture(GL_SRGB8_ALPHA8, width, height, GL_LINEAR);
    stepped_codes_ = make_view(stepped_, GL_RGBA8, GL_LINEAR);
    picture_ = make_texture(GL_SRGB8_ALPHA8, width, height, GL_LINEAR);
    edge_marks_ = make_texture(GL_STENCIL_INDEX8, width, height, GL_NEAREST);
    for (Framebuffer* framebuffer : {&scene_, &air_, &sky_, &averaged_, &stepped_output_, &output_})
        *framebuffer = make_framebuffer();
    glNamedFramebufferTexture(scene_.name(), GL_DEPTH_ATTACHMENT, depth_.name(), 0);
    glNamedFramebufferTexture(scene_.name(), GL_COLOR_ATTACHMENT0, scene_colour_.name(), 0);
    glNamedFramebufferTexture(sky_.name(), GL_COLOR_ATTACHMENT0, sky_colour_.name(), 0);
    if (samples > 1)
        glNamedFramebufferTexture(averaged_.name(), GL_COLOR_ATTACHMENT0, averaged_colour_.name(), 0);
    glNamedFramebufferTexture(stepped_output_.name(), GL_COLOR_ATTACHMENT0, stepped_.name(), 0);
    glNamedFramebufferTexture(output_.name(), GL_COLOR_ATTACHMENT0, picture_.name(), 0);
    glNamedFramebufferTexture(output_.name(), GL_STENCIL_ATTACHMENT, edge_marks_.name(), 0);
    return true;
}

void Target::begin_scene(Parts parts) const {
    constexpr GLfloat kFarthest = 0;  // depth is reversed
    glBindFramebuffer(GL_FRAMEBUFFER, scene_.name());
    glViewport(0, 0, samples_across(), samples_up());
    within(parts, [&] { glClearNamedFramebufferfv(scene_.name(), GL_DEPTH, 0, &kFarthest); });
}

void Target::lend_depth(GLuint framebuffer) const {
    glNamedFramebufferTexture(framebuffer, GL_DEPTH_ATTACHMENT, depth_.name(), 0);
}

void Target::begin_shading() const {
    glBindFramebuffer(GL_FRAMEBUFFER, scene_.name());
    glViewport(0, 0, samples_across(), samples_up());
    glTextureBarrier();
    glBindTextureUnit(SLOT_SCENE_DEPTH, depth_.name());
}

void Target::bind_scene(GLuint colour, GLuint depth) const {
    glBindTextureUnit(colour, scene_colour_.name());
    glBindTextureUnit(depth, depth_.name());
}

void Target::bind_depth(GLuint slot) const {
    glBindTextureUnit(slot, depth_.name());
}

void Target::keep_ground(Parts parts) const {
    copy(depth_, ground_depth_, parts);
    glBindTextureUnit(SLOT_SCENE_DEPTH, ground_depth_.name());
}

void Target::begin_sky() const {
    glBindFramebuffer(GL_FRAMEBUFFER, sky_.name());
    glViewport(0, 0, quarter(samples_across()), quarter(samples_up()));
}

void Target::begin_backdrop() const {
    glBindFramebuffer(GL_FRAMEBUFFER, scene_.name());
    glViewport(0, 0, samples_across(), samples_up());
    glBindTextureUnit(SLOT_SKY, sky_colour_.name());
}

void Target::begin_air(Parts parts) {
    if (air_colour_.name() == 0) {
        air_colour_ =
            make_texture(GL_RGBA16F, samples_across(), samples_up(), samples_ > 1 ? GL_LINEAR : GL_NEAREST);
        glNamedFramebufferTexture(air_.name(), GL_COLOR_ATTACHMENT0, air_colour_.name(), 0);
    }
    copy(scene_colour_, air_colour_, parts);
    glBindFramebuffer(GL_FRAMEBUFFER, air_.name());
    glViewport(0, 0, samples_across(), samples_up());
    glBindTextureUnit(SLOT_SCENE_DEPTH, depth_.name());
}

GLuint Target::average(Parts parts, bool in_air) const {
    if (samples_ > 1)  // the linear filter samples halfway between samples and so averages them
        within(parts, [&] {
            glBlitNamedFramebuffer((in_air ? air_ : scene_).name(), averaged_.name(), 0, 0, samples_across(),
                                   samples_up(), 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_LINEAR);
        });
    return (samples_ > 1 ? averaged_colour_ : in_air ? air_colour_ : scene_colour_).name();
}

void Target::begin_picture(GLuint colour) const {
    glBindFramebuffer(GL_FRAMEBUFFER, (samples_ > 1 ? output_ : stepped_output_).name());
    glViewport(0, 0, width_, height_);
    glBindTextureUnit(SLOT_COLOUR, colour);
}

void Target::begin_edges(Parts parts) const {
    copy(stepped_, picture_, parts);
    constexpr GLint kNoEdge = 0;
    within(parts, [&] { glClearNamedFramebufferiv(output_.name(), GL_STENCIL, 0, &kNoEdge); });
    glBindFramebuffer(GL_FRAMEBUFFER, output_.name());
    glBindTextureUnit(SLOT_PICTURE, stepped_codes_.name());
}

Picture Target::read_back() const {
    CHECK(width_ > 0);
    const auto row = 3 * static_cast<std::ptrdiff_t>(width_);
    Picture picture{width_, height_, std::vector<std::uint8_t>(static_cast<std::size_t>(row * height_))};
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(picture_.name(), 0, GL_RGB, GL_UNSIGNED_BYTE,
                      static_cast<GLsizei>(picture.pixels.size()), picture.pixels.data());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    for (int y = 0; y < height_ / 2; ++y) {  // GL stores the lowest row first
        const auto top = picture.pixels.begin() + y * row;
        std::swap_ranges(top, top + row, picture.pixels.begin() + (height_ - 1 - y) * row);
    }
    return picture;
}

void Target::copy_to(GLuint framebuffer, int width, int height) const {
    glBlitNamedFramebuffer(output_.name(), framebuffer, 0, 0, width_, height_, 0, 0, width, height,
                           GL_COLOR_BUFFER_BIT,
                           width == width_ && height == height_ ? GL_NEAREST : GL_LINEAR);
}

}  // namespace render
