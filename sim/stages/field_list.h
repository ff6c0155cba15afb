#pragma once

#include <string>
#include <string_view>

#include "sim/core/grid.h"
#include "sim/simd/rows.h"

// A model lists the fields that its stages work on once, in its fields.h: as a struct template on what stands
// for a field, and as a function each_field() below it that visits every member with its name. Storage, rows
// and names derive from that list.

namespace sim {

// Visits with "u0." before each name.
template <class Visit>
constexpr auto with_prefix(std::string_view prefix, Visit& visit) {
    return [prefix, &visit](std::string_view name, auto&... fields) {
        visit(std::string(prefix) + std::string(name), fields...);
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
    each_field([&](std::string_view, Field<Number>& field) { field = Field<Number>(grid); }, fields);
}

// Rows of whole fields, for a stage that goes over all of them.
template <template <class> class List, class Number>
List<Rows<Number>> rows_of(List<Field<Number>>& fields) {
    List<Rows<Number>> rows;
    each_field([](std::string_view, Rows<Number>& its, Field<Number>& field) { its = Rows<Number>(field); },
               rows, fields);
    return rows;
}

}  // namespace sim
