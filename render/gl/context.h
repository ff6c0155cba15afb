#pragma once

#include <memory>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace render {

// Describes the current context: "llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Core Profile) Mesa 22.3.6".
std::string renderer_name();
// Whether the current context draws on the CPU (llvmpipe, softpipe, swrast), where resolution and quality are
// expensive.
bool is_software_renderer();

// Creates an OpenGL 4.5 core context without a window, through EGL, current on the thread that creates it.
class HeadlessContext {
  public:
    // `which`: "auto" (a hardware device if there is one, else surfaceless), "surfaceless", "device" or
    // "device:N". An error is one sentence that says what was tried and what is missing.
    static tl::expected<HeadlessContext, std::string> create(std::string_view which);
    ~HeadlessContext();
    HeadlessContext(HeadlessContext&&) noexcept;
    HeadlessContext& operator=(HeadlessContext&&) noexcept;

    std::string renderer_name() const;

  private:
    struct Handles;
    explicit HeadlessContext(std::unique_ptr<Handles> handles);
    std::unique_ptr<Handles> handles_;
};

}  // namespace render
