#include "tests/terrains/memory_files.h"

#include <string>

#include <cpl_string.h>
#include <cpl_vsi.h>

#include "tests/terrains/files.h"

namespace terrains::test {

std::vector<std::filesystem::path> unload(const char* memory, const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> written;
    char** names = VSIReadDir(memory);
    for (int i = 0; names != nullptr && names[i] != nullptr; ++i) {
        vsi_l_offset size = 0;
        const GByte* bytes =
            VSIGetMemFileBuffer((std::string(memory) + "/" + names[i]).c_str(), &size, FALSE);
        written.push_back(folder / names[i]);
        write_text(written.back(), std::string(reinterpret_cast<const char*>(bytes), size));
    }
    CSLDestroy(names);
    VSIRmdirRecursive(memory);
    return written;
}

}  // namespace terrains::test
