#pragma once

#include <span>

#include <epoxy/gl.h>

#include "render/base/rectangle.h"
#include "render/gl/scoped_state.h"

namespace render {

inline void scissor(const Rectangle& part) {
    glScissor(part.left, part.bottom, part.width(), part.height());
}

// Draws within one rectangle after the other. Clears obey them too.
template <class Draw>
void within(std::span<const Rectangle> parts, Draw&& draw) {
    const Enabled scissors(GL_SCISSOR_TEST);
    for (const Rectangle& part : parts) {
        scissor(part);
        draw();
    }
}

}  // namespace render
