#include "game/files/file_use.h"

#include <algorithm>
#include <array>
#include <cctype>

#include <fnmatch.h>
#include <unistd.h>

#include <fmt/format.h>

#include "files/destination.h"

namespace game {
namespace {

namespace fs = std::filesystem;
using files::Identity;
using files::identity_of;

// Files that GDAL reads beside a raster or a shapefile: HILL.prj of HILL.asc, HILL.tif.aux.xml of HILL.tif.
constexpr std::array kCompanionExtensions{".prj", ".hdr", ".tfw", ".wld", ".aux", ".rrd", ".ige", ".stx",
                                          ".clr", ".shp", ".shx", ".dbf", ".cpg", ".qpj", ".imd", ".rpb"};
constexpr std::array kCompanionSuffixes{".aux.xml", ".ovr", ".msk"};

constexpr std::array kStreams{std::pair{STDOUT_FILENO, "standard output"},
                              std::pair{STDERR_FILENO, "standard error"}};

std::string upper(std::string text) {
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

std::vector<fs::path> with_companions(const fs::path& file) {
    std::vector<fs::path> all{file};
    std::error_code error;
    const auto add = [&](const fs::path& each) {
        if (fs::exists(each, error)) all.push_back(each);
    };
    for (const std::string extension : kCompanionExtensions) {
        add(fs::path(file).replace_extension(extension));
        add(fs::path(file).replace_extension(upper(extension)));
    }
    for (const char* extension : kCompanionSuffixes) add(fs::path(file) += extension);
    return all;
}

bool is_one_of(const std::string& name, const std::vector<std::string>& patterns) {
    return std::any_of(patterns.begin(), patterns.end(), [&](const std::string& pattern) {
        return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
    });
}

bool same(const std::optional<Identity>& a, const std::optional<Identity>& b) {
    return a && b && *a == *b;
}

}  // namespace

FileUse& FileUse::reads(const fs::path& file) {
    for (fs::path& each : with_companions(file)) inputs_.push_back(std::move(each));
    return *this;
}
FileUse& FileUse::reads(const std::optional<fs::path>& file) {
    return file ? reads(*file) : *this;
}
FileUse& FileUse::reads(const std::vector<fs::path>& files) {
    for (const fs::path& file : files) reads(file);
    return *this;
}

FileUse& FileUse::writes(std::string option, const std::optional<fs::path>& file) {
    if (file) outputs_.push_back({std::move(option), *file});
    return *this;
}

FileUse& FileUse::writes_into(std::string option, const std::optional<fs::path>& folder,
                              std::vector<std::string> names) {
    if (folder) folders_.push_back({std::move(option), *folder, std::move(names)});
    return *this;
}

FileUse& FileUse::leaves_standard_output() {
    prints_ = false;
    return *this;
}

Outcome<void> FileUse::check() const {
    if (auto named = check_named(); !named) return named;
    if (auto apart = check_outputs(); !apart) return apart;
    if (auto apart = check_streams(); !apart) return apart;
    for (const Folder& folder : folders_)
        if (auto apart = check_folder(folder); !apart) return apart;
    return {};
}

Outcome<void> FileUse::check_named() const {
    for (const Output& output : outputs_)
        if (output.path.empty()) return unusable(fmt::format("{} needs a file name", output.option));
    for (const Folder& folder : folders_)
        if (folder.path.empty()) return unusable(fmt::format("{} needs a folder name", folder.option));
    return {};
}

Outcome<void> FileUse::check_outputs() const {
    for (auto output = outputs_.begin(); output != outputs_.end(); ++output) {
        const auto identity = identity_of(output->path);
        for (const fs::path& input : inputs_)
            if (same(identity, identity_of(input)))
                return unusable(fmt::format("{} {}: is also an input, {}; choose another file",
                                            output->option, output->path.string(), input.string()));
        for (auto other = outputs_.begin(); other != output; ++other)
            if (same(identity, identity_of(other->path)))
                return unusable(fmt::format("{} and {} are the same file, {}; choose two", other->option,
                                            output->option, output->path.string()));
    }
    return {};
}

Outcome<void> FileUse::check_streams() const {
    for (const auto& [descriptor, name] : kStreams) {
        const auto identity = identity_of(descriptor);
        for (const Output& output : outputs_)
            if ((prints_ || descriptor != STDOUT_FILENO) && same(identity, identity_of(output.path)))
                return unusable(
                    fmt::format("{} {}: what is printed to {} goes there too; choose another file",
                                output.option, output.path.string(), name));
        for (const fs::path& input : inputs_)
            if (same(identity, identity_of(input)))
                return unusable(fmt::format("{}: is an input, and {} goes there; redirect it elsewhere",
                                            input.string(), name));
    }
    return {};
}

// Checks every file in the folder that has one of the names, or would get it.
Outcome<void> FileUse::check_folder(const Folder& folder) const {
    std::error_code error;
    fs::path canonical = fs::weakly_canonical(fs::absolute(folder.path, error), error);
    if (!canonical.has_filename()) canonical = canonical.parent_path();  // "frames/"
    std::vector<std::pair<fs::path, std::optional<Identity>>> there;
    for (fs::directory_iterator entry(folder.path, error), end; !error && entry != end;
         entry.increment(error))
        if (is_one_of(entry->path().filename().string(), folder.names))
            there.emplace_back(entry->path(), identity_of(entry->path()));
    const auto meets = [&](const fs::path& file) {
        const auto identity = identity_of(file);
        if (!identity) return false;
        const fs::path& name = identity->free_name;
        if (!name.empty() && (name == canonical || (name.parent_path() == canonical &&
                                                    is_one_of(name.filename().string(), folder.names))))
            return true;
        return std::any_of(there.begin(), there.end(),
                           [&](const auto& each) { return same(identity, each.second); });
    };
    for (const fs::path& input : inputs_)
        if (meets(input))
            return unusable(fmt::format("{} {}: would replace the input {}; choose another folder",
                                        folder.option, folder.path.string(), input.string()));
    for (const auto& [descriptor, name] : kStreams) {
        const auto identity = identity_of(descriptor);
        if (std::any_of(there.begin(), there.end(),
                        [&, &of = identity](const auto& each) { return same(of, each.second); }))
            return unusable(
                fmt::format("{} {}: would replace the file that {} goes to; choose another folder",
                            folder.option, folder.path.string(), name));
    }
    for (const Output& output : outputs_)
        if (meets(output.path))
            return unusable(fmt::format("{} {} and {} {}: would replace each other; choose another name",
                                        folder.option, folder.path.string(), output.option,
                                        output.path.string()));
    return {};
}

}  // namespace game
