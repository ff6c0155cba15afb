#include "game/recording/file_hash.h"

#include <fstream>
#include <vector>

#define XXH_STATIC_LINKING_ONLY  // for a digest on the stack
#include <xxhash.h>

#include "game/recording/format.h"

namespace game {

std::string file_hash(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    XXH3_state_t digest;
    XXH3_64bits_reset(&digest);
    std::vector<char> block(1 << 16);
    while (stream.read(block.data(), static_cast<std::streamsize>(block.size())), stream.gcount() > 0)
        XXH3_64bits_update(&digest, block.data(), static_cast<std::size_t>(stream.gcount()));
    return hex(XXH3_64bits_digest(&digest));
}

}  // namespace game
