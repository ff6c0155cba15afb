#include "render/passes/fields_to_gpu.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "assets/shaders/slots.glsl"
#include "render/base/same_inside.h"
#include "render/mountain/drawn_mixture.h"
#include "sim/core/check.h"

namespace render {
namespace {

static_assert(SITE_DRAIN == static_cast<int>(sim::Site::kDrain));

template <class T>
void send(const Texture& texture, const sim::Field<T>& field, int first_row, int last_row, GLenum format,
          GLenum type) {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, field.stride());  // a field's rows include halo and padding
    glTextureSubImage2D(texture.name(), 0, 0, first_row, field.nx(), last_row - first_row + 1, format, type,
                        field.row(first_row));
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

// Returns whether they were others.
bool remember_if_new(std::span<const float> values, std::vector<float>& known) {
    if (known.size() == values.size() &&
        (values.empty() || std::memcmp(known.data(), values.data(), values.size_bytes()) == 0))
        return false;
    known.assign(values.begin(), values.end());
    return true;
}

}  // namespace

FieldsToGpu::Ground FieldsToGpu::upload_ground(const sim::View& world, std::span<const float> first_depth,
                                               std::span<const float> undisturbed) {
    Ground changed;
    moved_.clear();
    // Only where there are things does bedrock change while a world runs.
    if (world.things && grid_ == world.grid && same_inside(site_, world.site))
        send_moved(world);
    else
        changed.terrain = !is_known(world);
    if (changed.terrain) {
        if (!(grid_ == world.grid)) allocate(world.grid);
        remember(world);
        send(bedrock_texture_, bedrock_, 0, grid_.ny - 1, GL_RED, GL_FLOAT);
        if (world.things) send_moved(world);
        moved_.clear();
        send(site_texture_, world.site, 0, grid_.ny - 1, GL_RED_INTEGER, GL_UNSIGNED_BYTE);
    }
    changed.moved = moved_;
    changed.first_depth = remember_if_new(first_depth, first_depth_);
    changed.undisturbed = send_undisturbed(undisturbed.empty() ? first_depth : undisturbed);
    return changed;
}

// Sends the rows between which bedrock or earth changed.
void FieldsToGpu::send_moved(const sim::View& world) {
    const sim::Field<float>& earth = world.things->earth;
    if (earth_.nx() == 0) {
        earth_ = sim::Field<float>(grid_);
        send(earth_texture_, earth_, 0, grid_.ny - 1, GL_RED, GL_FLOAT);
    }
    const auto columns = static_cast<std::size_t>(grid_.nx);
    for (int y = 0; y < grid_.ny; ++y) {
        if (same_row(bedrock_, world.bedrock, y) && same_row(earth_, earth, y)) continue;
        for (int x = 0; x < grid_.nx; ++x)
            if (bedrock_(x, y) != world.bedrock(x, y) || earth_(x, y) != earth(x, y))
                moved_.emplace_back(x, y);
        std::copy_n(world.bedrock.row(y), columns, bedrock_.row(y));
        std::copy_n(earth.row(y), columns, earth_.row(y));
    }
    if (moved_.empty()) return;
    const int first = moved_.front().y, last = moved_.back().y;
    send(bedrock_texture_, bedrock_, first, last, GL_RED, GL_FLOAT);
    send(earth_texture_, earth_, first, last, GL_RED, GL_FLOAT);
    heights_ = height_range(world);
}

bool FieldsToGpu::send_undisturbed(std::span<const float> undisturbed) {
    CHECK(undisturbed.empty() || undisturbed.size() == grid_.size());
    if (!remember_if_new(undisturbed, undisturbed_)) return false;
    if (!undisturbed.empty())
        glTextureSubImage2D(undisturbed_texture_.name(), 0, 0, 0, grid_.nx, grid_.ny, GL_RED, GL_FLOAT,
                            undisturbed_.data());
    return true;
}

void FieldsToGpu::upload_layers(const sim::View& world, int first_row, int last_row) const {
    if (first_row > last_row) return;
    send(depth_texture_, world.depth, first_row, last_row, GL_RED, GL_FLOAT);
    send(rolling_texture_, world.rolling, first_row, last_row, GL_RED, GL_FLOAT);
    send(velocity_x_texture_, world.velocity_x, first_row, last_row, GL_RED, GL_FLOAT);
    send(velocity_y_texture_, world.velocity_y, first_row, last_row, GL_RED, GL_FLOAT);
    if (mixture_.empty()) return;
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(
        mixture_texture_.name(), 0, 0, first_row, grid_.nx, last_row - first_row + 1, GL_RG, GL_UNSIGNED_BYTE,
        &mixture_[2 * static_cast<std::size_t>(first_row) * static_cast<std::size_t>(grid_.nx)]);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

std::span<const std::uint8_t> FieldsToGpu::find_mixture(const sim::View& world) {
    drawn_mixture(world, mixture_);
    return mixture_;
}

void FieldsToGpu::bind() const {
    glBindTextureUnit(SLOT_BEDROCK, bedrock_texture_.name());
    glBindTextureUnit(SLOT_DEPTH, depth_texture_.name());
    glBindTextureUnit(SLOT_ROLLING, rolling_texture_.name());
    glBindTextureUnit(SLOT_VELOCITY_X, velocity_x_texture_.name());
    glBindTextureUnit(SLOT_VELOCITY_Y, velocity_y_texture_.name());
    glBindTextureUnit(SLOT_SITE, site_texture_.name());
    glBindTextureUnit(SLOT_MIXTURE, mixture_texture_.name());
    glBindTextureUnit(SLOT_UNDISTURBED, undisturbed_texture_.name());
    glBindTextureUnit(SLOT_EARTH, earth_texture_.name());
}

bool FieldsToGpu::is_known(const sim::View& world) const {
    return grid_ == world.grid && same_inside(bedrock_, world.bedrock) && same_inside(site_, world.site);
}

void FieldsToGpu::allocate(const sim::Grid& grid) {
    for (Texture* texture :
         {&bedrock_texture_, &depth_texture_, &rolling_texture_, &velocity_x_texture_, &velocity_y_texture_})
        *texture = make_texture(GL_R32F, grid.nx, grid.ny, GL_NEAREST);
    undisturbed_texture_ = make_texture(GL_R32F, grid.nx, grid.ny, GL_LINEAR);
    glClearTexImage(undisturbed_texture_.name(), 0, GL_RED, GL_FLOAT,
                    nullptr);  // read also while it is unknown
    first_depth_.clear();
    undisturbed_.clear();
    earth_texture_ = make_texture(GL_R32F, grid.nx, grid.ny, GL_LINEAR);
    earth_ = {};
    site_texture_ = make_texture(GL_R8UI, grid.nx, grid.ny, GL_NEAREST);
    mixture_texture_ = make_texture(GL_RG8, grid.nx, grid.ny, GL_LINEAR);
}

void FieldsToGpu::remember(const sim::View& world) {
    grid_ = world.grid;
    bedrock_ = world.bedrock;
    site_ = world.site;
    heights_ = height_range(world);
}

}  // namespace render
