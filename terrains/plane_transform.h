#pragma once

#include <memory>
#include <span>
#include <string>

#include <tl/expected.hpp>

namespace terrains {

// Transforms many points between two coordinate systems, through PROJ. x is always the east-like axis
// (longitude, easting) and y the north-like one, whatever order the systems declare. Offline: no grid is
// downloaded. Move-only; not to be shared between threads.
class PlaneTransform {
  public:
    // Fails if a WKT cannot be read, or no transform exists (a site's own engineering grid).
    static tl::expected<PlaneTransform, std::string> between(const std::string& from_wkt,
                                                             const std::string& to_wkt);

    // Transforms in place. Returns false if a point could not be expressed; such points become NaN.
    bool apply(std::span<double> x, std::span<double> y) const;

    static void destroy(void* transform);  // deletes the handle

  private:
    struct Destroy {
        void operator()(void* transform) const { destroy(transform); }
    };
    explicit PlaneTransform(void* transform) : transform_(transform) {}
    std::unique_ptr<void, Destroy> transform_;
};

}  // namespace terrains
