// What the module has instead of Zstandard's compressor, which would be a sixth of it: frames whose blocks are stored as they
// are, or as one byte and how often it comes (RFC 8878, 3.1.1). Any reader unpacks them.
#include <algorithm>
#include <cstdint>
#include <cstring>

#include <zstd.h>

namespace {

constexpr std::size_t kBlock = 4096;  // bytes: what is constant comes in runs of this length
constexpr std::size_t kFrameHeader = 4 + 1 + 8, kBlockHeader = 3;
constexpr std::uint32_t kMagic = 0xFD2FB528;
constexpr std::uint8_t kWithSizeOf8Bytes = 0xE0;  // and in one segment
enum BlockKind : std::uint32_t { kRaw = 0, kRun = 1 };

}  // namespace

extern "C" std::size_t ZSTD_compressBound(std::size_t size) {
    return kFrameHeader + size + kBlockHeader * (size / kBlock + 1);
}

extern "C" std::size_t ZSTD_compress(void* to, std::size_t /*room*/, const void* from, std::size_t size,
                                     int /*level*/) {
    auto* out = static_cast<std::uint8_t*>(to);
    const auto* in = static_cast<const std::uint8_t*>(from);
    const auto put = [&](std::uint64_t value, std::size_t bytes) {
        std::memcpy(out, &value, bytes);  // little-endian, as WebAssembly is
        out += bytes;
    };
    put(kMagic, 4), put(kWithSizeOf8Bytes, 1), put(size, 8);
    std::size_t at = 0;
    do {
        const std::size_t block = std::min(kBlock, size - at);
        const bool is_last = at + block == size;
        const bool is_run = block > 1 && std::all_of(in + at, in + at + block,
                                                     [&](std::uint8_t byte) { return byte == in[at]; });
        put((block << 3) | (is_run ? kRun : kRaw) << 1 | (is_last ? 1u : 0u), kBlockHeader);
        const std::size_t written = is_run ? 1 : block;
        std::memcpy(out, in + at, written);
        out += written;
        at += block;
    } while (at < size);
    return static_cast<std::size_t>(out - static_cast<std::uint8_t*>(to));
}
