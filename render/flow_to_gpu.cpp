#include "render/flow_to_gpu.h"

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

template <class Values>
void send(const Buffer& buffer, const Values& values) {
    glNamedBufferSubData(buffer.name(), 0, static_cast<GLsizeiptr>(values.size() * sizeof(*values.data())),
                         values.data());
}

}  // namespace

void FlowToGpu::upload(const sim::front::FlowView& flow) {
    const TextureLayers& layers = flow.layers();
    const std::size_t vertices = layers.offsets().size(), beside = layers.beside_front().size();
    if (vertices != vertices_) {
        vertices_ = vertices;
        offsets_ = make_storage(vertices * sizeof(TextureLayers::Offsets));
        mixes_ = make_storage(vertices * sizeof(TextureLayers::Mix));
        vertex_buffer_ = make_storage(vertices * sizeof(FlowVertex));
        of_vertex_.resize(vertices);
        changed_.clear();
        for (std::size_t i = 0; i < vertices; ++i) changed_.push_back(static_cast<int>(i));
    }
    if (beside > gradients_fit_ || gradients_fit_ == 0) {  // with room for fronts to grow
        gradients_fit_ = std::max(2 * beside, kLeastGradients);
        gradients_ = make_storage(gradients_fit_ * sizeof(TextureLayers::Gradients));
    }
    describe(flow, of_vertex_);
    send(offsets_, layers.offsets());
    send(mixes_, layers.mix());
    send(vertex_buffer_, of_vertex_);
    if (beside > 0) send(gradients_, layers.gradients());
}

void FlowToGpu::bind() const {
    bind_storage(SLOT_FLOW_OFFSETS, offsets_);
    bind_storage(SLOT_FLOW_MIX, mixes_);
    bind_storage(SLOT_FLOW_VERTICES, vertex_buffer_);
    bind_storage(SLOT_FLOW_GRADIENTS, gradients_);
}

}  // namespace render
