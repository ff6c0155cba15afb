#include "tests/render/gl_scene.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "render/gl/context.h"
#include "render/gl/gl_handle.h"
#include "tests/support/places.h"
#include "tests/support/renderer.h"

namespace render::test {
namespace {

double to_linear(double srgb) {
    const double c = srgb / 255;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double to_srgb(double c) {
    return 255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055);
}

using Matrix = std::array<std::array<double, 3>, 3>;

Colour product(const Matrix& m, const Colour& c) {
    Colour out{};
    for (std::size_t i = 0; i < 3; ++i) out[i] = m[i][0] * c[0] + m[i][1] * c[1] + m[i][2] * c[2];
    return out;
}

Colour to_lab(const Colour& srgb) {
    constexpr Matrix kToXyz{{{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}};
    const Colour xyz = product(kToXyz, {to_linear(srgb[0]), to_linear(srgb[1]), to_linear(srgb[2])});
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
    const double x = f(xyz[0] / 0.9505), y = f(xyz[1]), z = f(xyz[2] / 1.089);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

}  // namespace

Colour mean_colour(const Picture& picture, int x, int y, int half) {
    Colour sum{};
    for (int row = y - half; row <= y + half; ++row) {
        for (int column = x - half; column <= x + half; ++column) {
            for (std::size_t c = 0; c < 3; ++c)
                sum[c] += picture.pixels[3 * static_cast<std::size_t>(row * picture.width + column) + c];
        }
    }
    for (double& value : sum) value /= (2 * half + 1) * (2 * half + 1);
    return sum;
}

int differing(const Picture& a, const Picture& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); i += 3) count += std::abs(a.pixels[i] - b.pixels[i]) > 3;
    return count;
}

testing::AssertionResult alike(const Picture& a, const Picture& b, int most) {
    if (a.width != b.width || a.height != b.height)
        return testing::AssertionFailure() << "images of " << a.width << " x " << a.height << " and "
                                           << b.width << " x " << b.height << " pixels";
    int count = 0, greatest = 0;
    std::size_t where = 0;
    for (std::size_t i = 0; i < a.pixels.size(); i += 3) {
        int difference = 0;
        for (std::size_t c = i; c < i + 3; ++c)
            difference = std::max(difference, std::abs(int{a.pixels[c]} - int{b.pixels[c]}));
        count += difference > most;
        if (difference > greatest) greatest = difference, where = i / 3;
    }
    if (count == 0) return testing::AssertionSuccess();
    const auto width = static_cast<std::size_t>(a.width);
    return testing::AssertionFailure()
           << count << " of " << a.pixels.size() / 3 << " pixels differ by more than " << most << ", by "
           << greatest << " at most, at (" << where % width << ", " << where / width << ")";
}

double colour_distance(const Colour& a, const Colour& b) {
    const Colour p = to_lab(a), q = to_lab(b);
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

Colour without(Cone cone, const Colour& colour) {
    constexpr Matrix kNoLong{
        {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
    constexpr Matrix kNoMiddle{
        {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
    constexpr Matrix kNoShort{
        {{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}};
    const Matrix& seen_by = cone == Cone::kLong ? kNoLong : cone == Cone::kMiddle ? kNoMiddle : kNoShort;
    Colour seen = product(seen_by, {to_linear(colour[0]), to_linear(colour[1]), to_linear(colour[2])});
    for (double& value : seen) value = to_srgb(std::min(std::max(value, 0.0), 1.0));
    return seen;
}

Look plain_look() {
    Look look;
    look.standing = {0.5f, 0.5f, 0.5f};
    look.detail = 0;
    return look;
}

const HeadlessContext& Gl::context() {
    static const auto context = HeadlessContext::create("auto");
    if (!context) throw std::runtime_error(context.error());
    return *context;
}

int Gl::rounding() {
    return is_software_renderer() ? 0 : 1;
}

void Gl::SetUp() {
    context();
    spoil_new_memory();
    ASSERT_NO_FATAL_FAILURE(support::make_renderer(renderer_, Quality::kFast));
}

Picture Gl::draw(const World& world, const Camera& camera, const Light& light, const Look& look, int width,
                 int height, const Marks& marks) {
    EXPECT_TRUE(renderer_->load(look, world.mixture.has_value()));
    renderer_->draw({world.view(), camera, light, look, marks, nullptr, width, height});
    return renderer_->read_back();
}

}  // namespace render::test
