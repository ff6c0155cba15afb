#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace game {

// The hashes that tie the lines of a recording together: each line closes with "chain", the hash of what
// stands before it and of the line before (XXH3).
class Chain {
  public:
    // Closes `line`, a JSON object without a line break. Allocates only where the string must grow.
    void close(std::string& line);
    // Takes the next line. Errors: it is not what stood there when the lines before it were written.
    tl::expected<void, std::string> read(std::string_view line);

  private:
    std::uint64_t link(std::string_view body) const;
    std::uint64_t last_ = 0;
};

}  // namespace game
