#pragma once

namespace game {

extern const char* const kProgram;
extern const char* const kCommit;    // "unknown" outside a checkout
extern const char* const kCompiler;  // name, version and flags

}  // namespace game
