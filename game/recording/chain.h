#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace game {

// The hash chain of a recording's lines. Each line ends with "chain",
// the XXH3 hash of the text before it and of the line before.
class Chain {
  public:
    // Closes `line`, a JSON object without a line break. Allocates only if the string must grow.
    void close(std::string& line);
    // Takes the next line. Errors: it has changed since it was written, or a line before it has.
    tl::expected<void, std::string> read(std::string_view line);

  private:
    std::uint64_t link(std::string_view body) const;
    std::uint64_t last_ = 0;
};

}  // namespace game
