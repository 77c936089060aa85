// Values of the dialect as rows (structure of arrays), and the shading library's functions called over them.
#pragma once

#include "field/kernel.h"
#include "graph/library.h"

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace fieldwright::renderer {

// `capacity` values side by side: lane k of value i at lane(k)[i].
class Rows {
public:
    Rows(int lanes, int capacity = field::row_width);

    int lanes() const { return lanes_; }
    float* lane(int k) { return data_.data() + static_cast<std::ptrdiff_t>(k) * capacity_; }
    const float* lane(int k) const { return data_.data() + static_cast<std::ptrdiff_t>(k) * capacity_; }
    glm::vec3 vec3(int first_lane, int i) const
    {
        return {lane(first_lane)[i], lane(first_lane + 1)[i], lane(first_lane + 2)[i]};
    }
    void fill(int k, float value);              // the whole lane
    void copy(int i, const Rows& from, int j);  // value j of `from` becomes value i, in the lanes that both have

private:
    int lanes_, capacity_;
    std::vector<float> data_;
};

// A function of the shading library; arguments and result are rows of field::row_width. The result aliases no argument.
class RowFunction {
public:
    RowFunction(std::string_view name, const field::KernelTable& table);

    template <typename... Arguments>
    void operator()(Rows& result, int count, const Arguments&... arguments) const
    {
        const std::array<const float*, sizeof...(Arguments)> pointers = {data(arguments)...};
        kernel_(result.lane(0), pointers.data(), nullptr, count);
    }

private:
    static const float* data(const Rows& rows) { return rows.lane(0); }
    static const float* data(const float* lanes) { return lanes; }
    field::Kernel kernel_;
};

// First lane of a structure's member.
int member_lane(const graph::Library& library, std::string_view structure, std::string_view member);
int structure_lanes(const graph::Library& library, std::string_view structure);

}  // namespace fieldwright::renderer
