#include "render/passes/flow_to_gpu.h"

#include <algorithm>

#include "assets/shaders/slots.glsl"

namespace render {
namespace {

using sim::front::TextureLayers;

// The layout that flow.vert expects.
static_assert(sizeof(TextureLayers::Offsets) == 6 * 2 * sizeof(float));
static_assert(sizeof(TextureLayers::Mix) == 4 * sizeof(float));
static_assert(sizeof(TextureLayers::Gradients) == 6 * 4 * sizeof(float));
static_assert(sizeof(FlowVertex) == 16);

constexpr std::size_t kLeastGradients = 256;

template <class T>
void send(const Buffer& buffer, std::span<const T> values, std::size_t first, std::size_t last) {
    glNamedBufferSubData(buffer.name(), static_cast<GLintptr>(first * sizeof(T)),
                         static_cast<GLsizeiptr>((last - first) * sizeof(T)), values.data() + first);
}

}  // namespace

void FlowToGpu::upload(const sim::front::FlowView& flow) {
    const TextureLayers& layers = flow.layers();
    const std::size_t vertices = layers.offsets().size(), beside = layers.beside_front().size();
    bool all_gradients = false;
    if (vertices != vertices_) {
        vertices_ = vertices;
        offsets_ = make_storage(vertices * sizeof(TextureLayers::Offsets));
        mixes_ = make_storage(vertices * sizeof(TextureLayers::Mix));
        vertex_buffer_ = make_storage(vertices * sizeof(FlowVertex));
    }
    if (beside > gradients_fit_ || gradients_fit_ == 0) {  // with room for fronts to grow
        gradients_fit_ = std::max(2 * beside, kLeastGradients);
        gradients_ = make_storage(gradients_fit_ * sizeof(TextureLayers::Gradients));
        all_gradients = true;
    }
    changes_.find(flow);
    for (const auto& [begin, end] : changes_.ranges()) {
        const auto first = static_cast<std::size_t>(begin), last = static_cast<std::size_t>(end);
        send(offsets_, layers.offsets(), first, last);
        send(mixes_, layers.mix(), first, last);
        send(vertex_buffer_, changes_.vertices(), first, last);
    }
    if (beside > 0 && (all_gradients || changes_.gradients_changed()))
        send(gradients_, layers.gradients(), 0, beside);
}

void FlowToGpu::bind() const {
    bind_storage(SLOT_FLOW_OFFSETS, offsets_);
    bind_storage(SLOT_FLOW_MIX, mixes_);
    bind_storage(SLOT_FLOW_VERTICES, vertex_buffer_);
    bind_storage(SLOT_FLOW_GRADIENTS, gradients_);
}

}  // namespace render
