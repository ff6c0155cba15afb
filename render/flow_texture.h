#pragma once

#include <filesystem>
#include <string>

#include <glm/vec3.hpp>
#include <tl/expected.hpp>

#include "render/flow_pattern.h"
#include "render/gl_handle.h"

namespace render {

// A pattern as shaders ask for it.
struct FlowTexture {
    Texture grain;    // slopes and height
    Texture colours;  // its own, or one for each height
    // True: sheets are blended by height before they get their colour. False: one of them is seen at a place.
    bool stochastic = false;
    glm::vec3 mean{0};  // colour, linear light

    // `assets` is the folder that holds textures/. Errors: a file that is missing or is no such picture.
    static tl::expected<FlowTexture, std::string> load(const std::filesystem::path& assets,
                                                       FlowPattern pattern);
    void bind() const;
};

}  // namespace render
