#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace game {

// Appends a whole number, the lowest byte first, on every processor.
template <class Number>
void put(Number number, std::string& bytes) {
    for (std::size_t i = 0; i < sizeof(Number); ++i)
        bytes += static_cast<char>(static_cast<unsigned char>(number >> (8 * i)));
}

// Takes such numbers from the front of bytes. Of bytes that have ended it takes 0.
class ByteTaker {
  public:
    explicit ByteTaker(std::string_view bytes) : bytes_(bytes) {}
    template <class Number>
    Number next() {
        Number number = 0;
        const std::string_view taken = take(sizeof(Number));
        for (std::size_t i = 0; i < taken.size(); ++i)
            number |=
                static_cast<Number>(static_cast<Number>(static_cast<unsigned char>(taken[i])) << (8 * i));
        return number;
    }
    std::string_view take(std::size_t many) {
        if (bytes_.size() < many) {
            has_failed_ = true;
            bytes_ = {};
            return {};
        }
        const std::string_view taken = bytes_.substr(0, many);
        bytes_.remove_prefix(many);
        return taken;
    }
    std::size_t left() const { return bytes_.size(); }
    bool has_failed() const { return has_failed_; }  // asked for more than there was

  private:
    std::string_view bytes_;
    bool has_failed_ = false;
};

}  // namespace game
