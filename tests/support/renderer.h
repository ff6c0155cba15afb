#pragma once

#include <optional>
#include <utility>

#include <gtest/gtest.h>

#include "render/frame.h"
#include "tests/support/places.h"

namespace support {

// Makes a renderer that has what a world of one material without a date needs. Call it as ASSERT_NO_FATAL_FAILURE(...).
inline void make_renderer(std::optional<render::Renderer>& into, render::Quality quality) {
    auto made = render::Renderer::create(source_dir() / "assets", quality);
    ASSERT_TRUE(made) << made.error();
    const auto loaded = made->load({}, false);
    ASSERT_TRUE(loaded) << loaded.error();
    into.emplace(std::move(*made));
}

}  // namespace support
