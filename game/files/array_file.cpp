#include "game/files/array_file.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "files/input.h"
#include "game/base/limits.h"
#include "game/base/number.h"

// An own reader, because cnpy, the usual one, asserts on a damaged header and allocates whatever it asks for.

namespace game {
namespace {

static_assert(std::endian::native == std::endian::little, "NPY data is read as little-endian");

constexpr std::string_view kMagic = "\x93NUMPY";

// Returns the text after 'key': in a header such as {'descr':
// '<f4', 'fortran_order': False, 'shape': (3, 4), }
std::string_view value_of(std::string_view header, std::string_view key) {
    const auto at = header.find(fmt::format("'{}'", key));
    if (at == std::string_view::npos) return {};
    std::string_view rest = header.substr(at + key.size() + 2);
    const auto begin = rest.find_first_not_of(" :");
    return begin == std::string_view::npos ? std::string_view{} : rest.substr(begin);
}

std::optional<std::vector<std::int64_t>> shape_of(std::string_view header) {
    std::string_view text = value_of(header, "shape");
    const auto end = text.find(')');
    if (text.empty() || text.front() != '(' || end == std::string_view::npos) return std::nullopt;
    text = text.substr(1, end - 1);
    std::vector<std::int64_t> shape;
    while (true) {
        const auto begin = text.find_first_not_of(" ,");
        if (begin == std::string_view::npos) return shape;
        text.remove_prefix(begin);
        const std::string_view word = text.substr(0, text.find_first_of(" ,"));
        const auto axis = number_from<std::int64_t>(word);
        if (!axis || *axis < 0 || shape.size() == kMostAxes) return std::nullopt;
        shape.push_back(*axis);
        text.remove_prefix(word.size());
    }
}

}  // namespace

Outcome<ArrayFile> ArrayFile::open(const std::filesystem::path& path) {
    const auto bad = [&](const std::string& what) {
        return unusable(fmt::format("{}: {}", path.string(), what));
    };
    ArrayFile array;
    array.path_ = path;
    auto file = files::open_input(path);
    if (!file) return unusable(file.error());
    array.file_ = std::move(*file);
    std::error_code status;
    const auto size = std::filesystem::file_size(path, status);
    if (status) return bad(status.message());

    // Magic, version, and the header's length: two bytes, or four from version 2 on.
    char head[12] = {};
    array.file_.read(head, 8);
    const bool is_array = array.file_ && std::string_view(head, kMagic.size()) == kMagic;
    if (!is_array) return bad("is not a NumPy array: numpy.save() writes files that begin with \\x93NUMPY");
    const int version = static_cast<unsigned char>(head[6]), wide = version == 1 ? 2 : 4;
    if (version < 1 || version > 3)
        return bad(fmt::format("NPY version {} is not supported; 1 to 3 are", version));
    std::uint32_t length = 0;
    array.file_.read(head, wide);
    std::memcpy(&length, head, static_cast<std::size_t>(wide));
    if (!array.file_ || length > kLongestArrayHeader) return bad("byte 8: the header is cut off or too long");
    std::string header(length, '\0');
    array.file_.read(header.data(), length);
    if (!array.file_) return bad(fmt::format("ends in its header, which should be {} bytes long", length));

    const std::string_view type = value_of(header, "descr"), order = value_of(header, "fortran_order");
    const std::string_view descr = type.substr(0, type.find_first_of(",}"));
    if (!type.starts_with("'<f4'") && !type.starts_with("'<f8'"))
        return bad(
            fmt::format("its numbers are {}; only little-endian '<f4' and '<f8' are supported", descr));
    if (!order.starts_with("False")) return bad("it is in Fortran order; only C order is supported");
    const auto shape = shape_of(header);
    if (!shape || shape->empty()) return bad("its header has no shape");

    array.is_double_ = type[3] == '8';
    array.shape_ = *shape;
    const std::uint64_t held = size - 8 - static_cast<std::uint64_t>(wide) - length;
    std::uint64_t wanted = array.is_double_ ? 8 : 4;
    for (const std::int64_t axis : *shape) {
        // Bound the size here, so that the product cannot overflow.
        if (axis != 0 && wanted > (std::uint64_t{1} << 62) / static_cast<std::uint64_t>(axis))
            return bad(fmt::format("its shape {} is larger than any file", array.shape_text()));
        wanted *= static_cast<std::uint64_t>(axis);
    }
    if (held != wanted)
        return bad(
            fmt::format("holds {} bytes of data; its shape {} needs {}", held, array.shape_text(), wanted));
    return array;
}

std::string ArrayFile::shape_text() const {
    return fmt::format("({}{})", fmt::join(shape_, ", "), shape_.size() == 1 ? "," : "");
}

Outcome<void> ArrayFile::read_frame(std::span<float> values) {
    bytes_.resize(values.size() * (is_double_ ? 8 : 4));
    file_.read(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
    if (!file_) return unusable(fmt::format("{}: ends in frame {}", path_.string(), frame_));
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (is_double_) {
            double value = 0;
            std::memcpy(&value, &bytes_[8 * i], 8);
            values[i] = static_cast<float>(value);
        } else {
            std::memcpy(&values[i], &bytes_[4 * i], 4);
        }
        if (!std::isfinite(values[i])) {
            const std::int64_t last = shape_.size() > 2 ? shape_.back() : 1;
            return unusable(fmt::format("{}: frame {}, vertex {}: not a finite number", path_.string(),
                                        frame_, static_cast<std::int64_t>(i) / last));
        }
    }
    ++frame_;
    return {};
}

}  // namespace game
