#include "render/view/season.h"

#include "render/base/ramp.h"

namespace render {
namespace {

// 0 until a date, 1 from a later one on.
float since(int day, Date from, Date to) {
    return ramp(static_cast<float>(day_of_year(from)), static_cast<float>(day_of_year(to)),
                static_cast<float>(day));
}

}  // namespace

Season season_on(Date date) {
    const int day = day_of_year(date);
    return {.green = since(day, {4, 5}, {5, 25}) * (1 - since(day, {8, 25}, {10, 30})),
            .leaves = since(day, {4, 20}, {5, 25}) * (1 - since(day, {10, 10}, {11, 15})),
            .turned = since(day, {9, 10}, {10, 15})};
}

}  // namespace render
