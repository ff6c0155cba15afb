#include "game/recording/base64.h"

#include <string>
#include <string_view>
#include <utility>

#include <gtest/gtest.h>

namespace game {
namespace {

// RFC 4648, section 10.
constexpr std::pair<std::string_view, std::string_view> kVectors[] = {{"", ""},
                                                                      {"f", "Zg=="},
                                                                      {"fo", "Zm8="},
                                                                      {"foo", "Zm9v"},
                                                                      {"foob", "Zm9vYg=="},
                                                                      {"fooba", "Zm9vYmE="},
                                                                      {"foobar", "Zm9vYmFy"}};

TEST(Base64, is_that_of_the_standard) {
    for (const auto& [bytes, text] : kVectors) {
        EXPECT_EQ(to_base64(bytes), text);
        EXPECT_EQ(from_base64(text), bytes);
    }
}

TEST(Base64, brings_back_every_byte_at_every_place) {
    std::string bytes;
    for (int byte = 0; byte < 256; ++byte)
        for (int place = 0; place < 3; ++place) {
            bytes.assign(static_cast<std::size_t>(place), 'x');
            bytes.push_back(static_cast<char>(byte));
            EXPECT_EQ(from_base64(to_base64(bytes)), bytes) << byte << " at " << place;
        }
}

TEST(Base64, of_any_other_text_is_refused) {
    for (const std::string_view text :
         {"Z", "Zg", "Zg=", "Zg===", "Z===", "====", "Zm9=v===", "Zm 9", "Zm9v\n", "Zm9-", "Zh==", "Zm9="})
        EXPECT_FALSE(from_base64(text)) << text;
}

}  // namespace
}  // namespace game
