#include "render/passes/spindrift_pass.h"

#include <cmath>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/shaders/slots.glsl"
#include "render/base/ramp.h"
#include "render/gl/program.h"
#include "render/gl/scoped_state.h"

namespace render {
namespace {

// As in spindrift.vert.
constexpr double kFine = 44, kCoarse = 97, kGust = 430;  // m along the wind, after which its patterns repeat
constexpr double kFastest = 1.25;  // speed of the fine pattern, of that of the coarse one
constexpr float kAside = 18;       // m beside its line that a ribbon may cover

// The greatest length of a ribbon, m.
float longest(const Wind& wind) {
    return 1.76f * (28 + 4.5f * static_cast<float>(wind.speed));
}

float share(double x) {
    return static_cast<float>(x - std::floor(x));
}

}  // namespace

tl::expected<SpindriftPass, std::string> SpindriftPass::create(const std::filesystem::path& shaders) {
    auto program = link_program(
        shaders, {{GL_VERTEX_SHADER, {"slots.glsl", "frame.glsl", "light.glsl", "spindrift.vert"}},
                  {GL_FRAGMENT_SHADER, {"slots.glsl", "frame.glsl", "scene_depth.glsl", "spindrift.frag"}}});
    if (!program) return tl::unexpected(program.error());
    SpindriftPass pass;
    pass.program_ = std::move(*program);
    pass.vertex_array_ = make_vertex_array();
    pass.instances_ = make_buffer();
    glNamedBufferStorage(pass.instances_.name(), Ridges::kMost * sizeof(SpindriftPlace), nullptr,
                         GL_DYNAMIC_STORAGE_BIT);
    const GLuint array = pass.vertex_array_.name();
    glVertexArrayVertexBuffer(array, 0, pass.instances_.name(), 0, sizeof(SpindriftPlace));
    glVertexArrayBindingDivisor(array, 0, 1);
    static_assert(sizeof(SpindriftPlace) == 6 * sizeof(float));
    for (const auto& [location, components, offset] :
         {std::tuple<GLuint, GLint, std::size_t>{0, 3, offsetof(SpindriftPlace, at)},
          std::tuple<GLuint, GLint, std::size_t>{1, 3, offsetof(SpindriftPlace, strength)}}) {
        glEnableVertexArrayAttrib(array, location);
        glVertexArrayAttribFormat(array, location, components, GL_FLOAT, GL_FALSE,
                                  static_cast<GLuint>(offset));
        glVertexArrayAttribBinding(array, location, 0);
    }
    pass.drawn_.reserve(Ridges::kMost);
    pass.seen_.reserve(Ridges::kMost);
    return pass;
}

bool SpindriftPass::find(const Surroundings& around, const Wind& wind, double seconds,
                         const FrameBlock& frame, const OnScreen& screen) {
    const bool is_new = known_ != around.fingerprint() || known_wind_ != wind;
    if (is_new) {
        known_ = around.fingerprint();
        known_wind_ = wind;
        ridges_ = Ridges(around, wind);
    }
    if (is_new || known_sun_ != frame.sun) {
        known_sun_ = frame.sun;
        ridges_.light(around, glm::vec3(frame.sun));
    }
    drawn_.clear();
    seen_.clear();
    const glm::vec2 along = glm::normalize(velocity(wind));
    const glm::vec3 line(longest(wind) * along, 0.02f * longest(wind));
    for (const SpindriftPlace& place : ridges_.places()) {
        const glm::vec3 end = place.at + line;
        const Rectangle seen = screen.box(glm::min(place.at, end) - kAside, glm::max(place.at, end) + kAside);
        if (seen.empty()) continue;
        drawn_.push_back(place);
        seen_.push_back(seen);
    }
    if (drawn_.empty()) return false;
    glNamedBufferSubData(instances_.name(), 0, static_cast<GLsizeiptr>(drawn_.size() * sizeof drawn_[0]),
                         drawn_.data());
    const double gone = seconds * wind.speed;  // m
    wind_ = {along, static_cast<float>(wind.speed), 0};
    phase_ = {share(gone * kFastest / kFine), share(gone / kCoarse), share(0.5 * gone / kGust), 0};
    return true;
}

void SpindriftPass::draw() const {
    const Enabled blend(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glUseProgram(program_.name());
    glUniform4fv(0, 1, &wind_.x);
    glUniform4fv(1, 1, &phase_.x);
    glBindVertexArray(vertex_array_.name());
    glDrawArraysInstanced(GL_TRIANGLES, 0, 6, static_cast<GLsizei>(drawn_.size()));
    glBlendFunc(GL_ONE, GL_ZERO);
}

}  // namespace render
