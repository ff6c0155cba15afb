#pragma once

namespace game {

inline constexpr const char* kProgram = "couloir " COULOIR_VERSION;
inline constexpr const char* kCommit = COULOIR_COMMIT;      // "unknown" outside a checkout
inline constexpr const char* kCompiler = COULOIR_COMPILER;  // name, version and flags

}  // namespace game
