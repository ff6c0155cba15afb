#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "render/gl/gl_handle.h"

namespace render {

// One stage of a program: the files that it is concatenated from, in order. There is no #include: a file that
// others need precedes them, slots.glsl first.
struct ShaderStage {
    GLenum kind;  // GL_VERTEX_SHADER, GL_FRAGMENT_SHADER or GL_COMPUTE_SHADER
    std::vector<std::string_view> files;
};

// Compiles and links a program from files in `folder`. An error is one sentence with file, line and compiler
// message, as in "assets/shaders/sky.frag:7: 'colou' undeclared", or names the file that cannot be read.
tl::expected<ProgramName, std::string> link_program(const std::filesystem::path& folder,
                                                    const std::vector<ShaderStage>& stages);

}  // namespace render
