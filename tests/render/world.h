#pragma once

#include <functional>
#include <optional>

#include "render/view/camera.h"
#include "sim/world/state.h"

// Small worlds for the tests of render/, which need a view and no physics.
namespace render::test {

struct World {
    sim::Grid grid;
    sim::Field<float> bedrock, depth, rolling, velocity_x, velocity_y;
    sim::Field<sim::Site> site;
    std::optional<sim::Mixture> mixture;
    std::optional<sim::Things> things;
    sim::Tiles tiles;  // none
    double datum = 0;

    sim::View view() const {
        return {grid,
                bedrock,
                depth,
                rolling,
                velocity_x,
                velocity_y,
                site,
                nullptr,
                mixture ? &*mixture : nullptr,
                things ? &*things : nullptr,
                tiles,
                datum,
                0};
    }
    double side() const { return (grid.nx - 1) * static_cast<double>(grid.dx); }  // m
};

// Square ground with side `squares`, m; heights are a function of position in metres. No layers.
World make_world(int squares, float cell, const std::function<double(double x, double y)>& bedrock);

// A view straight down on a point, north up, the image `height` metres tall.
Camera from_above(glm::dvec3 target, double height);

}  // namespace render::test
