#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace game::test {

// A way to call the program: what it reads, and every option under which it writes.
struct Subcommand {
    std::string name;
    std::vector<std::string> arguments;  // enough to run for a moment; no output but standard output
    std::vector<std::filesystem::path> inputs = {};
    std::vector<std::string> outputs = {};  // options that take a file
    std::vector<std::string> folders = {};  // options that take a folder, and need no GL
    std::vector<std::string> drawn = {};    // the same that need GL
    std::vector<std::string> needed = {};   // of the options above: it does not run without them
    bool only_refused = false;  // it needs a display, or takes long: tests call it only to be refused

    // With each of these options and a path for it, and with those needed somewhere below `folder`.
    std::vector<std::string> with(const std::vector<std::pair<std::string, std::filesystem::path>>& given,
                                  const std::filesystem::path& folder) const;
};

// All subcommands that write files, on small inputs of their own, which it makes in this folder.
std::vector<Subcommand> writing_subcommands(const std::filesystem::path& folder);

// Arguments that make a call of this subcommand refused once its inputs are read, each for another reason.
std::vector<std::vector<std::string>> refusals_of(const Subcommand& subcommand);

// Calls that are refused because of what is in their inputs, before tick 0.
std::vector<Subcommand> subcommands_refused_by_content(const std::filesystem::path& folder);

}  // namespace game::test
