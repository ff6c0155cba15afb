#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "game/recording/format.h"

namespace game::test {

// Undoes gzip, by zlib. Empty if the bytes are no gzip file.
std::string unzipped(const std::string& bytes);

// What a page carries, unpacked by the words of docs/web.md and by nothing of the program.
class UnpackedPage {
  public:
    // Of a whole page.
    explicit UnpackedPage(const std::string& html);
    // Of a stream alone.
    UnpackedPage(const Json& parts, const Json& arrays, const std::string& plain);

    const Json& info() const { return info_; }
    const std::string& part(const std::string& name) const { return parts_.at(name); }
    bool has(const std::string& name) const { return parts_.contains(name); }
    std::vector<double> array(const std::string& name) const;

    // A moving field as it is in a frame: whole quanta, one per vertex. `before`: as it is before the first frame.
    std::vector<std::uint16_t> moving(const std::string& name, int nx, int ny, std::int64_t frame,
                                      std::vector<std::uint16_t> before) const;

  private:
    void split(const Json& parts, const std::string& plain);

    Json info_;
    std::map<std::string, std::string> parts_;
};

// The text of an element of a page, between its opening tag with this attribute and the next closing tag of a script.
std::string script_of(const std::string& html, std::string_view id);

}  // namespace game::test
