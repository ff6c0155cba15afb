#include "terrains/raster_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include <cpl_vsi.h>
#include <fmt/format.h>

#include "terrains/lower_case.h"

namespace terrains {
namespace {

using Done = tl::expected<void, std::string>;

// The characters of a file, through GDAL's file system, which knows what may be read.
class Characters {
  public:
    explicit Characters(const std::filesystem::path& path) : file_(VSIFOpenL(path.c_str(), "rb")) {}

    bool opened() const { return file_ != nullptr; }

    // The next character; -1 at the end.
    int peek() {
        if (at_ == end_) {
            end_ = VSIFReadL(buffer_.data(), 1, buffer_.size(), file_.get());
            at_ = 0;
            if (end_ == 0) return -1;
        }
        return static_cast<unsigned char>(buffer_[at_]);
    }
    int next() {
        const int found = peek();
        if (found >= 0) ++at_;
        return found;
    }

  private:
    struct Close {
        void operator()(VSILFILE* file) const { VSIFCloseL(file); }
    };
    std::unique_ptr<VSILFILE, Close> file_;
    std::array<char, 1 << 16> buffer_{};
    std::size_t at_ = 0, end_ = 0;
};

bool is_space(int c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

constexpr std::size_t kLongestWord = 64;  // no number is longer

// Adds what follows to `word` up to a separator; of an overlong word only the beginning, with "..." for the rest.
template <class IsSeparator>
void read_word(Characters& from, std::string& word, IsSeparator is_separator) {
    word.clear();
    bool cut = false;
    for (int c = from.peek(); c >= 0 && !is_separator(c); c = from.peek()) {
        if (word.size() < kLongestWord)
            word += static_cast<char>(c);
        else
            cut = true;
        from.next();
    }
    if (cut) word += "...";
}

// The next word between blanks; false at the end of the file.
bool next_word(Characters& from, std::string& word) {
    while (is_space(from.peek())) from.next();
    read_word(from, word, is_space);
    return !word.empty();
}

bool is_number(std::string_view word) {
    if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size();
}

// What programs write for no data. A word of more signs, "####" or "****", is a number that did not fit.
bool means_no_data(std::string_view word) {
    static constexpr std::array<std::string_view, 19> kWords{
        "nan",  "-nan", "+nan", "na", "n/a",    "#n/a",    "nd",      "null",   "<null>", "none",
        "void", "*",    "-",    "--", "nodata", "no_data", "1.#qnan", "1.#ind", "-1.#ind"};
    const std::string lower = lower_case(word);
    return std::find(kWords.begin(), kWords.end(), lower) != kWords.end();
}

// Which numbers of a file have a decimal comma. "1,588" is 1.588 or 1588, unless others of the file tell.
class Numbers {
  public:
    // Whether the word is a number to its end, perhaps by a decimal comma.
    bool accept(std::string_view word) {
        const std::size_t comma = word.find(',');
        if (comma == std::string_view::npos) {
            points_ = points_ || word.find('.') != std::string_view::npos;
            return is_number(word);
        }
        std::string with_point(word);
        with_point[comma] = '.';
        if (word.find('.') != std::string_view::npos || !is_number(with_point)) return false;
        const std::string_view before = word.substr(word.find_first_not_of("+-"));
        const bool as_thousands = word.size() - comma == 4 && before.find(',') <= 3;
        if (!as_thousands) commas_ = true;
        if (as_thousands && !doubtful_) doubtful_ = std::string(word);
        if (!any_comma_) any_comma_ = std::string(word);
        return true;
    }

    // Once all are seen: whether the commas have one meaning.
    Done decide() const {
        if (any_comma_ && points_)
            return tl::unexpected(fmt::format(
                "'{}' has a comma, and other numbers have a decimal point; use points", *any_comma_));
        if (doubtful_ && !commas_)
            return tl::unexpected(fmt::format(
                "'{}' may be a decimal number or have a comma after its thousands; use decimal points",
                *doubtful_));
        return {};
    }

  private:
    bool points_ = false, commas_ = false;
    std::optional<std::string> doubtful_, any_comma_;
};

std::string no_number(std::uint64_t index, int columns, const std::string& word) {
    return fmt::format("row {}, column {} is '{}', which is no number", index / columns + 1,
                       index % columns + 1, word);
}

// The keys of ESRI and GRASS ASCII before the first value, in `word` then.
Done read_header(Characters& from, std::string& word) {
    Numbers numbers;
    std::string value, corners;
    while (next_word(from, word)) {
        const bool is_key = std::isalpha(static_cast<unsigned char>(word[0])) != 0 && !means_no_data(word) &&
                            lower_case(word) != "inf";
        if (!is_key) break;
        next_word(from, value);
        const std::string key = lower_case(word);
        if (key == "type:") continue;  // of GRASS: int, float, double
        if (!numbers.accept(value) && !means_no_data(value))
            return tl::unexpected(fmt::format("its header says '{} {}', which is no number", word, value));
        if (key == "multiplier:" && value != "1")
            return tl::unexpected(
                fmt::format("its values are to be multiplied by {}; export it without", value));
        if (key.starts_with("xll") || key.starts_with("yll")) corners += key.substr(3);
    }
    // GDAL places a file at 0, 0 that has one of each.
    if (corners == "centercorner" || corners == "cornercenter")
        return tl::unexpected<std::string>(
            "its header has a corner along one axis and a centre along the other");
    return numbers.decide();
}

// Values after a header, `word` being the first one.
template <class MeansNoData>
tl::expected<std::vector<bool>, std::string> check_values(Characters& from, std::string& word, int columns,
                                                          int rows, MeansNoData means_no_data) {
    Numbers numbers;
    const auto promised = static_cast<std::uint64_t>(columns) * static_cast<std::uint64_t>(rows);
    std::vector<bool> voids;
    std::uint64_t found = 0;
    for (; !word.empty(); ++found) {
        if (means_no_data(word)) {
            if (found < promised) {
                voids.resize(promised);
                voids[found] = true;
            }
        } else if (!numbers.accept(word)) {
            return tl::unexpected(no_number(found, columns, word));
        }
        if (!next_word(from, word)) word.clear();
    }
    if (found != promised)
        return tl::unexpected(fmt::format(
            "damaged or cut short: it has {} numbers where its header promises {}", found, promised));
    if (auto clear = numbers.decide(); !clear) return tl::unexpected(clear.error());
    return voids;
}

tl::expected<std::vector<bool>, std::string> check_grid(Characters& from, int columns, int rows, bool grass) {
    std::string word;
    if (auto header = read_header(from, word); !header) return tl::unexpected(header.error());
    // GDAL takes "null" in GRASS ASCII for a key of the header wherever it stands: what follows is no data to it.
    return check_values(from, word, columns, rows, [grass](std::string_view value) {
        return means_no_data(value) && !(grass && lower_case(value) == "null");
    });
}

tl::expected<std::vector<bool>, std::string> check_surfer(Characters& from, int columns, int rows) {
    constexpr int kHeaderWords = 9;  // DSAA, counts and ranges
    std::string word;
    for (int i = 0; i <= kHeaderWords; ++i)
        if (!next_word(from, word)) word.clear();
    return check_values(from, word, columns, rows, [](std::string_view) { return false; });
}

// A line of XYZ, by its columns. Commas part them, unless other signs do.
struct Line {
    std::vector<std::string> columns;

    // False at the end of the file. An empty line has no columns.
    bool read(Characters& from) {
        constexpr std::size_t kMostColumns = 64;
        columns.clear();
        const auto ends = [](int c) { return is_space(c) || c == ';'; };
        bool any = false;
        for (int c = from.peek(); c >= 0; c = from.peek()) {
            any = true;
            if (c == '\n' || c == '\r') {
                from.next();
                break;
            }
            if (ends(c)) {
                from.next();
                continue;
            }
            std::string word;
            read_word(from, word, ends);
            if (word.size() > 1 && word.ends_with(',')) word.pop_back();
            if (columns.size() < kMostColumns) columns.push_back(std::move(word));
        }
        if (columns.size() == 1) split_at_commas();
        return any;
    }

  private:
    void split_at_commas() {
        std::string whole = std::move(columns[0]);
        columns.clear();
        for (std::size_t first = 0; first <= whole.size();) {
            const std::size_t comma = std::min(whole.find(',', first), whole.size());
            columns.push_back(whole.substr(first, comma - first));
            first = comma + 1;
        }
    }
};

tl::expected<std::vector<bool>, std::string> check_points(Characters& from) {
    Numbers numbers;
    std::vector<bool> numeric;  // by column, in the first line of values
    Line line;
    for (std::uint64_t at = 1; line.read(from); ++at) {
        const auto& columns = line.columns;
        if (columns.empty() || columns[0].starts_with('#')) continue;
        if (numeric.empty()) {
            const bool header = !numbers.accept(columns[0]);
            for (const std::string& column : columns)
                if (!header) numeric.push_back(numbers.accept(column));
            continue;
        }
        if (columns.size() != numeric.size())
            return tl::unexpected(
                fmt::format("line {} has {} columns and others have {}", at, columns.size(), numeric.size()));
        for (std::size_t i = 0; i < columns.size(); ++i)
            if (numeric[i] && !numbers.accept(columns[i]))
                return tl::unexpected(
                    fmt::format("line {}, column {} is '{}', which is no number", at, i + 1, columns[i]));
    }
    if (auto clear = numbers.decide(); !clear) return tl::unexpected(clear.error());
    return std::vector<bool>();
}

tl::expected<std::vector<bool>, std::string> check_usgs(Characters& from) {
    constexpr std::uint64_t kFirstRecord = 1024;  // names and dates
    constexpr std::string_view kOfNumbers = "0123456789+-.DEde";
    for (std::uint64_t at = 0; from.peek() >= 0; ++at) {
        const int c = from.next();
        if (at < kFirstRecord || is_space(c) || c == 0 ||
            kOfNumbers.find(static_cast<char>(c)) < kOfNumbers.size())
            continue;
        return tl::unexpected(fmt::format("byte {} is '{}', which is of no number", at + 1,
                                          c < 127 ? static_cast<char>(c) : '?'));
    }
    return std::vector<bool>();
}

}  // namespace

tl::expected<std::vector<bool>, std::string> check_words(GDALDatasetH dataset,
                                                         const std::filesystem::path& path) {
    const std::string_view format = GDALGetDriverShortName(GDALGetDatasetDriver(dataset));
    const int columns = GDALGetRasterXSize(dataset), rows = GDALGetRasterYSize(dataset);
    const bool grid = format == "AAIGrid" || format == "GRASSASCIIGrid";
    const bool surfer = format == "GSAG", points = format == "XYZ", usgs = format == "USGSDEM";
    if (!grid && !surfer && !points && !usgs) return std::vector<bool>();
    Characters from(path);
    if (!from.opened()) return tl::unexpected<std::string>("cannot be read a second time");
    if (grid) return check_grid(from, columns, rows, format == "GRASSASCIIGrid");
    if (surfer) return check_surfer(from, columns, rows);
    return points ? check_points(from) : check_usgs(from);
}

}  // namespace terrains
