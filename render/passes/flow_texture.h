#pragma once

#include <filesystem>
#include <string>

#include <glm/vec3.hpp>
#include <tl/expected.hpp>

#include "render/gl/gl_handle.h"
#include "render/view/flow_pattern.h"

namespace render {

// A pattern as the shaders read it.
struct FlowTexture {
    Texture grain;    // slopes and height
    Texture colours;  // its own, or one for each height
    // True: copies are blended by height before they are coloured. False: one copy shows at each place.
    bool stochastic = false;
    glm::vec3 mean{0};  // colour, linear light

    // `assets` is the folder that holds textures/. Fails if a file is missing or is not such an image.
    static tl::expected<FlowTexture, std::string> load(const std::filesystem::path& assets,
                                                       FlowPattern pattern);
    void bind() const;
};

}  // namespace render
