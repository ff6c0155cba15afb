#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "game/base/outcome.h"

namespace game {

// All files that a subcommand reads and writes, declared before the first output is
// opened, so that no output replaces an input or another output. Two names are the same
// file if they lead to it by hard or symbolic links, by ".." or by another folder's
// name, or by a descriptor (/dev/fd/N, /dev/stdout). Standard output and standard error are outputs too: what
// the subcommand prints goes there, and nothing else may. Only a character device, such as a terminal or
// /dev/null, may be several outputs.
class FileUse {
  public:
    FileUse& reads(const std::filesystem::path& file);
    FileUse& reads(const std::optional<std::filesystem::path>& file);
    FileUse& reads(const std::vector<std::filesystem::path>& files);
    // `option`: as the user gives it, "--record".
    FileUse& writes(std::string option, const std::optional<std::filesystem::path>& file);
    // Files of these names in a folder; * stands for any characters.
    FileUse& writes_into(std::string option, const std::optional<std::filesystem::path>& folder,
                         std::vector<std::string> names);
    // Declares that the subcommand itself prints nothing to standard output, so that one output may go there.
    FileUse& leaves_standard_output();

    // Errors (status 2): an output is also an input or another output, or its name is empty.
    Outcome<void> check() const;

  private:
    struct Output {
        std::string option;
        std::filesystem::path path;
    };
    struct Folder {
        std::string option;
        std::filesystem::path path;
        std::vector<std::string> names;
    };
    Outcome<void> check_named() const;
    Outcome<void> check_outputs() const;
    Outcome<void> check_streams() const;
    Outcome<void> check_folder(const Folder& folder) const;

    std::vector<std::filesystem::path> inputs_;
    std::vector<Output> outputs_;
    std::vector<Folder> folders_;
    bool prints_ = true;  // to standard output
};

}  // namespace game
