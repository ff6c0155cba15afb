#pragma once

#include <string>
#include <string_view>

#include "sim/core/grid.h"
#include "sim/simd/rows.h"

// A model lists the fields that its stages work on once, in its fields.h: as a struct template on what stands
// for a field, and as a function each_field() below it that visits every member with its name. Storage, rows
// and names derive from that list.

namespace sim {

// The name of a field in two parts, joined only for a report: rows are made in every sub-step.
struct FieldName {
    std::string_view prefix, name;  // "u0." or nothing; "depth"

    FieldName(std::string_view its_prefix, std::string_view its_name) : prefix(its_prefix), name(its_name) {}
    FieldName(const char* whole) : name(whole) {}
    std::string text() const { return std::string(prefix) + std::string(name); }
};

// Visits with "u0." before each name.
template <class Visit>
auto with_prefix(std::string_view prefix, Visit& visit) {
    return [prefix, &visit](std::string_view name, auto&... fields) {
        visit(FieldName(prefix, name), fields...);
    };
}

// How many members a function like each_field() visits. A list that forgets a member of its struct does not
// compile: static_assert(members_visited(…) == sizeof(List<char>)).
template <class List, class Each>
constexpr std::size_t members_visited(Each&& each) {
    List list{};
    std::size_t count = 0;
    each([&](std::string_view, char&) { ++count; }, list);
    return count;
}

template <template <class> class List, class Number>
void allocate(List<Field<Number>>& fields, const Grid& grid) {
    each_field([&](FieldName, Field<Number>& field) { field = Field<Number>(grid); }, fields);
}

// Rows of whole fields, for a stage that goes over all of them.
template <template <class> class List, class Number>
List<Rows<Number>> rows_of(List<Field<Number>>& fields) {
    List<Rows<Number>> rows;
    each_field([](FieldName, Rows<Number>& its, Field<Number>& field) { its = Rows<Number>(field); }, rows,
               fields);
    return rows;
}

}  // namespace sim
