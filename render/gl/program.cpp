#include "render/gl/program.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

namespace render {
namespace {

using std::filesystem::path;

tl::expected<std::string, std::string> read_text(const path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    if (!in || !(text << in.rdbuf())) return tl::unexpected(fmt::format("{}: cannot be read", file.string()));
    return text.str();
}

// Lines are numbered through all files of a stage, file i from i · kFileStride + 1, because not every
// compiler keeps the file number of #line.
constexpr int kFileStride = 100000;

// A location in a compiler's log: Mesa writes "0:300014(5): error: …", others "0(300014) : error …".
struct Place {
    int line = 0;
    std::string_view fact;
};

bool parse_place(std::string_view text, Place& place) {
    const char* end = text.data() + text.size();
    int source = 0;
    auto [after_source, source_error] = std::from_chars(text.data(), end, source);
    if (source_error != std::errc{} || after_source == end || (*after_source != ':' && *after_source != '('))
        return false;
    auto [after_line, line_error] = std::from_chars(after_source + 1, end, place.line);
    if (line_error != std::errc{}) return false;
    const std::string_view rest(after_line, static_cast<std::size_t>(end - after_line));
    const std::size_t error = rest.find("error");
    if (error == std::string_view::npos) return false;
    const std::size_t fact = rest.find(": ", error);
    place.fact = rest.substr(fact == std::string_view::npos ? error : fact + 2);
    return true;
}

// Returns the first error of a log with our file and line, or the whole log if it names no known location.
std::string explain(std::string_view log, const path& folder, const ShaderStage& stage) {
    for (std::size_t begin = 0; begin < log.size();) {
        const std::size_t end = std::min(log.find('\n', begin), log.size());
        Place place;
        if (parse_place(log.substr(begin, end - begin), place)) {
            const auto file = static_cast<std::size_t>(place.line / kFileStride);
            if (file < stage.files.size())
                return fmt::format("{}:{}: {}", (folder / stage.files[file]).string(),
                                   place.line % kFileStride, place.fact);
        }
        begin = end + 1;
    }
    return fmt::format("{}: does not compile: {}", (folder / stage.files.back()).string(), log);
}

std::string shader_log(GLuint shader) {
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    glGetShaderInfoLog(shader, length, &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return log;
}

std::string program_log(GLuint program) {
    GLint length = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    glGetProgramInfoLog(program, length, &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return log;
}

tl::expected<ShaderName, std::string> compile(const path& folder, const ShaderStage& stage) {
    std::string source = "#version 450 core\n";
    for (std::size_t i = 0; i < stage.files.size(); ++i) {
        const auto text = read_text(folder / stage.files[i]);
        if (!text) return tl::unexpected(text.error());
        source += fmt::format("#line {}\n{}", i * kFileStride + 1, *text);
    }
    ShaderName shader(glCreateShader(stage.kind));
    const char* begin = source.c_str();
    glShaderSource(shader.name(), 1, &begin, nullptr);
    glCompileShader(shader.name());
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_FALSE) return tl::unexpected(explain(shader_log(shader.name()), folder, stage));
    return shader;
}

}  // namespace

tl::expected<ProgramName, std::string> link_program(const path& folder,
                                                    const std::vector<ShaderStage>& stages) {
    ProgramName program(glCreateProgram());
    for (const ShaderStage& stage : stages) {
        const auto shader = compile(folder, stage);
        if (!shader) return tl::unexpected(shader.error());
        glAttachShader(program.name(), shader->name());
    }
    glLinkProgram(program.name());
    GLint linked = GL_FALSE;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    if (linked == GL_FALSE)
        return tl::unexpected(fmt::format("{}: does not link: {}",
                                          (folder / stages.back().files.back()).string(),
                                          program_log(program.name())));
    return program;
}

}  // namespace render
