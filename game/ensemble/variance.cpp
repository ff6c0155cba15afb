// Of members with the variables x_i and a number y, with Legendre's polynomials P_d of x_i scaled to -1 … 1:
//
//     y ≈ c + Σ_i f_i(x_i),   f_i = Σ_d a_id P_d(x_i),   share_i = variance of f_i / variance of y

#include "game/ensemble/variance.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "sim/core/check.h"

namespace game {
namespace {

constexpr std::size_t kParts = 16;  // of the jackknife
constexpr std::size_t kDegree = 5;

using Matrix = std::vector<std::vector<double>>;

// Solves A x = b, A symmetric with no negative eigenvalue, by Cholesky's method. What cannot be told from A is 0 in x.
std::vector<double> solved(Matrix a, std::vector<double> b) {
    constexpr double kLeastPivot = 1e-9;
    const std::size_t size = b.size();
    std::vector<double> first(size);
    for (std::size_t i = 0; i < size; ++i) first[i] = a[i][i];
    for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            double sum = a[i][j];
            for (std::size_t k = 0; k < j; ++k) sum -= a[i][k] * a[j][k];
            if (i == j)
                a[i][i] = sum > kLeastPivot * first[i] ? std::sqrt(sum) : 0;
            else
                a[i][j] = a[j][j] > 0 ? sum / a[j][j] : 0;
        }
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t k = 0; k < i; ++k) b[i] -= a[i][k] * b[k];
        b[i] = a[i][i] > 0 ? b[i] / a[i][i] : 0;
    }
    for (std::size_t i = size; i-- > 0;) {
        for (std::size_t k = i + 1; k < size; ++k) b[i] -= a[k][i] * b[k];
        b[i] = a[i][i] > 0 ? b[i] / a[i][i] : 0;
    }
    return b;
}

// The polynomials of all variables, and which of them are whose.
struct Terms {
    struct Of {
        double least, most;  // of the variable
        std::size_t first, end;
    };
    std::vector<Of> of;  // the terms of a variable; before all, term 0 is 1
    std::size_t size = 1;

    explicit Terms(const std::vector<std::vector<double>>& samples) {
        for (std::size_t v = 0; v < samples.front().size(); ++v) {
            std::set<double> seen;  // few values of a list allow a low degree only
            double least = samples.front()[v], most = least;
            for (const std::vector<double>& sample : samples) {
                least = std::min(least, sample[v]), most = std::max(most, sample[v]);
                if (seen.size() <= kDegree) seen.insert(sample[v]);
            }
            const std::size_t end = size + std::min(kDegree, seen.size() - 1);
            of.push_back({least, most, size, end});
            size = end;
        }
    }

    // The values of all terms for a member.
    std::vector<double> at(const std::vector<double>& sample) const {
        std::vector<double> terms{1};
        for (std::size_t v = 0; v < of.size(); ++v) {
            const Of& these = of[v];
            if (these.first == these.end) continue;
            const double x = 2 * (sample[v] - these.least) / (these.most - these.least) - 1;
            double before = 1, now = x;
            for (std::size_t degree = 1; degree <= these.end - these.first; ++degree) {
                terms.push_back(now);
                const auto n = static_cast<double>(degree);
                const double next = ((2 * n + 1) * x * now - n * before) / (n + 1);
                before = now, now = next;
            }
        }
        return terms;
    }
};

// Sums of products over some members, of which a fit is made.
struct Sums {
    double members = 0, squares = 0;  // of values
    std::vector<double> values;       // of value times each term
    Matrix terms;                     // of term times term, the lower half

    explicit Sums(std::size_t size) : values(size), terms(size, std::vector<double>(size)) {}
    void add(const std::vector<double>& at, double value) {
        ++members, squares += value * value;
        for (std::size_t i = 0; i < at.size(); ++i) {
            values[i] += value * at[i];
            for (std::size_t j = 0; j <= i; ++j) terms[i][j] += at[i] * at[j];
        }
    }
    void add(const Sums& other, double times) {
        members += times * other.members, squares += times * other.squares;
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] += times * other.values[i];
            for (std::size_t j = 0; j <= i; ++j) terms[i][j] += times * other.terms[i][j];
        }
    }
};

// The share of each variable, then what is left for all together.
std::vector<double> shares_of(const Terms& terms, const Sums& sums) {
    const std::vector<double> fit = solved(sums.terms, sums.values);
    const double variance = sums.squares - sums.values[0] * sums.values[0] / sums.members;
    std::vector<double> shares;
    double together = 1;
    for (const Terms::Of& of : terms.of) {
        double sum = 0, squares = 0;
        for (std::size_t i = of.first; i < of.end; ++i) {
            sum += fit[i] * sums.terms[i][0];
            for (std::size_t j = of.first; j < of.end; ++j)
                squares += fit[i] * fit[j] * sums.terms[std::max(i, j)][std::min(i, j)];
        }
        shares.push_back((squares - sum * sum / sums.members) / variance);
        together -= shares.back();
    }
    shares.push_back(together);
    return shares;
}

}  // namespace

std::size_t least_for_variance(std::size_t variables) {
    constexpr std::size_t kLeast = 64, kPerVariable = 12;
    return std::max(kLeast, kPerVariable * variables);
}

std::optional<VarianceShares> variance_shares(const std::vector<std::vector<double>>& samples,
                                              const std::vector<double>& values) {
    const std::size_t members = values.size();
    CHECK(samples.size() == members);
    if (members == 0 || members < least_for_variance(samples.front().size())) return std::nullopt;
    const auto [least, most] = std::ranges::minmax_element(values);
    if (!(*least < *most)) return std::nullopt;
    const double middle =
        (*least + *most) / 2;  // taken off, so that differences of squares keep their digits

    const Terms terms(samples);
    std::vector<Sums> parts(kParts, Sums(terms.size));
    for (std::size_t i = 0; i < members; ++i)
        parts[i * kParts / members].add(terms.at(samples[i]), values[i] - middle);
    Sums all(terms.size);
    for (const Sums& part : parts) all.add(part, 1);

    const std::vector<double> shares = shares_of(terms, all);
    std::vector<double> sum(shares.size()), squares(shares.size());
    for (const Sums& part : parts) {
        Sums without = all;
        without.add(part, -1);
        const std::vector<double> each = shares_of(terms, without);
        for (std::size_t i = 0; i < each.size(); ++i) sum[i] += each[i], squares[i] += each[i] * each[i];
    }
    VarianceShares result;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const double spread = std::max(0.0, squares[i] - sum[i] * sum[i] / kParts);
        result.of.push_back({shares[i], std::sqrt(spread * (kParts - 1) / kParts)});
    }
    result.together = result.of.back();
    result.of.pop_back();
    return result;
}

}  // namespace game
