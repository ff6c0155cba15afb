#pragma once

namespace game {

extern const char* const kVersionNumber;  // "0.1.0"
extern const char* const kProgram;        // "couloir 0.1.0"
extern const char* const kCommit;         // "unknown" outside a checkout
extern const char* const kCompiler;       // name, version and flags

}  // namespace game
