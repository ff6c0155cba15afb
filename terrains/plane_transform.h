#pragma once

#include <memory>
#include <span>
#include <string>

#include <tl/expected.hpp>

namespace terrains {

// The way between two coordinate systems for many points at once, through PROJ. x is always the east-like
// axis (longitude, easting) and y the north-like one, whatever order the systems declare. Offline: no grid is
// downloaded. Move-only; not to be shared between threads.
class PlaneTransform {
  public:
    // Errors: a WKT that cannot be read, or systems that cannot be joined (a site's own engineering grid).
    static tl::expected<PlaneTransform, std::string> between(const std::string& from_wkt,
                                                             const std::string& to_wkt);

    // In place. False where at least one point could not be expressed; such points become NaN.
    bool apply(std::span<double> x, std::span<double> y) const;

    static void destroy(void* transform);  // what a PlaneTransform holds

  private:
    struct Destroy {
        void operator()(void* transform) const { destroy(transform); }
    };
    explicit PlaneTransform(void* transform) : transform_(transform) {}
    std::unique_ptr<void, Destroy> transform_;
};

}  // namespace terrains
