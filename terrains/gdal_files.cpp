#include "terrains/gdal_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include <cpl_conv.h>
#include <cpl_http.h>
#include <cpl_string.h>
#include <cpl_vsi.h>

#include "terrains/lower_case.h"

namespace terrains {
namespace {

namespace fs = std::filesystem;

// Permissions are process-wide, because GDAL has one file system and its worker threads open files too.
struct Allowed {
    std::mutex mutex;
    std::vector<RasterFiles*> rasters;
    fs::path data;  // GDAL's data tables
};

Allowed& allowed() {
    static Allowed made;
    return made;
}

bool is_allowed(const fs::path& file) {
    Allowed& all = allowed();
    const std::lock_guard lock(all.mutex);
    if (!all.data.empty() && file.parent_path() == all.data) return true;
    return std::any_of(all.rasters.begin(), all.rasters.end(),
                       [&file](const RasterFiles* raster) { return raster->includes(file); });
}

// An open file, read from `at`.
struct OpenFile {
    int descriptor;
    vsi_l_offset at = 0;
    bool ended = false;
};

OpenFile& file_of(void* handle) {
    return *static_cast<OpenFile*>(handle);
}

int stat_file(void*, const char* name, VSIStatBufL* result, int) {
    struct stat found {};
    if (!is_allowed(name) || stat(name, &found) != 0 || !(S_ISREG(found.st_mode) || S_ISDIR(found.st_mode))) {
        errno = ENOENT;
        return -1;
    }
    *result = {};
    result->st_mode = found.st_mode;
    result->st_size = found.st_size;
    result->st_mtime = found.st_mtime;
    return 0;
}

void* open_file(void*, const char* name, const char* access) {
    if (std::string_view(access).find_first_of("wa+") != std::string_view::npos || !is_allowed(name)) {
        errno = EACCES;
        return nullptr;
    }
    const int descriptor = open(name, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) return nullptr;
    struct stat found {};
    if (fstat(descriptor, &found) != 0 || !S_ISREG(found.st_mode)) {
        close(descriptor);
        errno = EACCES;
        return nullptr;
    }
    note_read(name);
    return new OpenFile{descriptor};
}

vsi_l_offset tell(void* handle) {
    return file_of(handle).at;
}

int seek(void* handle, vsi_l_offset offset, int whence) {
    OpenFile& file = file_of(handle);
    struct stat found {};
    if (whence == SEEK_END && fstat(file.descriptor, &found) != 0) return -1;
    if (whence == SEEK_END) offset += static_cast<vsi_l_offset>(found.st_size);
    if (whence == SEEK_CUR) offset += file.at;
    file.at = offset;
    file.ended = false;
    return 0;
}

std::size_t read(void* handle, void* into, std::size_t size, std::size_t count) {
    OpenFile& file = file_of(handle);
    if (size == 0) return 0;
    const std::size_t wanted = size * count;
    std::size_t done = 0;
    while (done < wanted) {
        const ssize_t got = pread(file.descriptor, static_cast<char*>(into) + done, wanted - done,
                                  static_cast<off_t>(file.at + done));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) break;
        done += static_cast<std::size_t>(got);
    }
    file.ended = done < wanted;
    file.at += done;
    return done / size;
}

int has_ended(void* handle) {
    return file_of(handle).ended ? 1 : 0;
}

int close_file(void* handle) {
    OpenFile& file = file_of(handle);
    const int result = close(file.descriptor);
    delete &file;
    return result;
}

// Lists the names in a raster's folder that belong to it.
char** list_folder(void*, const char* folder, int) {
    char** names = static_cast<char**>(CPLCalloc(1, sizeof(char*)));  // an empty list
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (is_allowed(entry->path())) names = CSLAddString(names, entry->path().filename().c_str());
    return names;
}

int refuse_stat(void*, const char*, VSIStatBufL*, int) {
    errno = ENOENT;
    return -1;
}

void* refuse_open(void*, const char*, const char*) {
    errno = EACCES;
    return nullptr;
}

CPLHTTPResult* refuse_request(const char*, CSLConstList, GDALProgressFunc, void*, CPLHTTPFetchWriteFunc,
                              void*, void*) {
    auto* result = static_cast<CPLHTTPResult*>(CPLCalloc(1, sizeof(CPLHTTPResult)));
    result->nStatus = 1;
    result->pszErrBuf = CPLStrdup("nothing is read from the network");
    return result;
}

}  // namespace

void note_read(const fs::path& file) {
    Allowed& all = allowed();
    const std::lock_guard lock(all.mutex);
    for (RasterFiles* raster : all.rasters) raster->note(file);
}

bool close_file_system_to_gdal() {
    if (const char* table = CPLFindFile("gdal", "gdalvrt.xsd"))
        allowed().data = fs::path(table).parent_path();

    VSIFilesystemPluginCallbacksStruct* callbacks = VSIAllocFilesystemPluginCallbacksStruct();
    callbacks->tell = tell;
    callbacks->seek = seek;
    callbacks->read = read;
    callbacks->eof = has_ended;
    callbacks->close = close_file;
    callbacks->stat = refuse_stat;
    callbacks->open = refuse_open;
    // Block all prefixes: servers, archives, pipes and others.
    static char** const prefixes = VSIGetFileSystemsPrefixes();  // GDAL keeps pointers to them
    for (int i = 0; prefixes[i] != nullptr; ++i)
        if (prefixes[i] != std::string_view("/vsimem/")) VSIInstallPluginHandler(prefixes[i], callbacks);
    VSIInstallPluginHandler("/vsicurl?", callbacks);  // not in that list
    callbacks->stat = stat_file;
    callbacks->open = open_file;
    callbacks->read_dir = list_folder;
    VSIInstallPluginHandler("", callbacks);
    VSIFreeFilesystemPluginCallbacksStruct(callbacks);

    CPLHTTPSetFetchCallback(refuse_request, nullptr);
    CPLSetConfigOption("SQLITE_USE_OGR_VFS", "YES");  // otherwise SQLite opens files by itself

    VSILFILE* around = VSIFOpenL("/", "rb");  // only another file system could open this
    if (around != nullptr) VSIFCloseL(around);
    return around == nullptr;
}

RasterFiles::RasterFiles(const fs::path& named, References references) : references_(references) {
    std::error_code error;
    raster_ = fs::canonical(named, error);
    const bool is_folder = fs::is_directory(raster_, error);
    is_binary_grid_ = is_folder || lower_case(raster_.extension().string()) == ".adf";
    folder_ = is_folder ? raster_ : raster_.parent_path();
    folder_of_link_ = is_folder ? raster_ : fs::canonical(fs::absolute(named, error).parent_path(), error);
    beginning_ = lower_case(named.stem().string()) + '.';
    const std::lock_guard lock(allowed().mutex);
    allowed().rasters.push_back(this);
}

RasterFiles::~RasterFiles() {
    const std::lock_guard lock(allowed().mutex);
    std::erase(allowed().rasters, this);
}

bool RasterFiles::is_own_folder(const fs::path& folder) const {
    return folder == folder_ || folder == folder_of_link_;
}

bool RasterFiles::includes(const fs::path& file) const {
    std::error_code error;
    const fs::path real = fs::canonical(file, error);
    if (error) return false;
    if (real == raster_ || references_ == References::kAllowed) return true;
    if (is_binary_grid_ && real == folder_) return true;
    const fs::path folder = fs::canonical(fs::absolute(file, error).parent_path(), error);
    if (error || !is_own_folder(folder) || !is_own_folder(real.parent_path())) return false;
    const std::string name = lower_case(file.filename().string());
    return is_binary_grid_ ? name.ends_with(".adf") : name.starts_with(beginning_);
}

void RasterFiles::note(const fs::path& file) {
    std::error_code error;
    if (includes(file)) read_.insert(fs::canonical(file, error));
}

std::vector<fs::path> RasterFiles::read() const {
    const std::lock_guard lock(allowed().mutex);
    return {read_.begin(), read_.end()};
}

}  // namespace terrains
