#include "game/base/version.h"

namespace game {

const char* const kVersionNumber = COULOIR_VERSION;
const char* const kProgram = "couloir " COULOIR_VERSION;
const char* const kCommit = COULOIR_COMMIT;
const char* const kCompiler = COULOIR_COMPILER;

}  // namespace game
